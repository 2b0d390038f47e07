// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// What a path of so many free points takes from the first path to the report, bytes: the sum of what was measured with
/// Newton, which holds most, in the plane and in space. Rather too much than too little.
double bytes_of_path(double points, const Dimensions& dimensions);

/// What this process may have, bytes: the memory of the machine, or less where a limit says so. Infinity where nobody
/// knows.
double memory_of_host();

/// "1.9 GiB".
std::string size_in_words(double bytes);

}  // namespace leastcost
