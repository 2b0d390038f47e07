// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/study/grid/study_config.hpp"

namespace leastcost::app {

/// A problem of a study with its configuration read: the tree that the axes then change.
struct ProblemBase {
  std::string name;
  ConfigNode tree;  ///< `set` of the study and of the problem included
  std::filesystem::path folder;
  std::filesystem::path file;  ///< empty: written in the study
  Place place;                 ///< where it stands in the study
};

/// One value of an axis. `node` goes into the configuration at the key of the axis.
struct AxisValue {
  std::string name;
  ConfigNode node;
};

/// An axis other than `problem`.
struct Axis {
  std::string name;  ///< as in tables: "solver", "path.cascade"
  std::string key;   ///< of a run's configuration
  std::vector<AxisValue> values;
  bool given() const { return !values.empty(); }
};

/// The problems of a study; their errors go to `study.errors`.
std::vector<ProblemBase> read_problems(LoadedStudy& study);
/// The axes solver, kernel, points, seed, without values where the study gives none, and one per swept key. Names are
/// unique.
std::vector<Axis> read_axes(LoadedStudy& study);

}  // namespace leastcost::app
