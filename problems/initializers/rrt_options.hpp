// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/base/options.hpp>

namespace leastcost {

struct RrtOptions {
  std::optional<double> step =
      {};  ///< length units; else a sixteenth of the distance of the ends, or of a robot's limits
  std::optional<double> shell = {};  ///< length units; else a quarter of the step
  double goal_bias = 0.1;
  double reach = 1;
  int max_nodes = 20000;
  int shortcuts = 200;
  std::optional<int> paths = {};  ///< else among obstacles 8 in space, 4 to 12 in more dimensions; 1 elsewhere
  std::optional<int> seed = {};   ///< else the seed of the run
  void fields(FieldVisitor& visit);
};

}  // namespace leastcost
