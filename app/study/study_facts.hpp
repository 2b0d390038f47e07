// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/study/grid/grid.hpp"
#include "app/study/rows/journal.hpp"

namespace leastcost::app {

/// What a grid is, with the content of its data files. Files are known by what they hold, not by their names or places;
/// one that is not there counts as missing, and its cells will say so.
StudyFacts facts_of(const StudyGrid& grid);

/// The study with everything given, as YAML that reads back as the same one when it lies in `output`.
std::string resolved_study(const StudyGrid& grid, const std::filesystem::path& output);

}  // namespace leastcost::app
