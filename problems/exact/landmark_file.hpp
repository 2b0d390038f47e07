// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <leastcost/problems/exact/landmarks.hpp>

namespace leastcost {

/// Landmarks as a binary file, little-endian: "LCLMARKS", version, precision of the distances (bytes), what they were
/// made for (fingerprint), counts, landmarks, widths, distances, and a checksum of all that. Written beside the name
/// and then renamed, so that no reader sees half of it. Throws InputError that names the file.
void write_landmarks(const Landmarks& landmarks, const std::filesystem::path& file);

/// Throws InputError that says what is wrong: no such file, none of these, another version, cut off or changed, or made
/// for another mesh, other positions of it or another metric than those with this fingerprint.
Landmarks read_landmarks(const std::filesystem::path& file, std::uint64_t made_for);

}  // namespace leastcost
