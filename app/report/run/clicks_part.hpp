// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/report/run/run_files.hpp"

namespace leastcost::app {

/// Whether the page answers clicks with shortest paths: the run left clicks.json, and the program can.
bool answers_clicks(const RunFiles& files);
/// Whether it also has the mesh of the run, which a 3D view then draws.
bool has_clicked_mesh(const RunFiles& files);

/// Below the picture: fields for two ends, and the answer. Or why there is none, or nothing where nobody expects it.
std::string clicks_panel(const RunFiles& files);
/// At the end of the page: the data, the searches and what asks them; before the script of a 3D view.
std::string clicks_scripts(const RunFiles& files);

/// Whole numbers in few bytes, base 64: of each the difference from the one `stride` before, its sign in the lowest
/// bit, in groups of seven bits, lowest first, the eighth saying that more follow.
std::string packed(std::span<const std::int64_t> numbers, std::size_t stride);
/// With so many decimals, at most twelve, all numbers are whole and exact again after a division; -1: with none.
int common_decimals(const std::vector<double>& numbers);

}  // namespace leastcost::app
