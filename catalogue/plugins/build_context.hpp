// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/distance/build_progress.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// What a factory may look at besides its own options.
struct BuildContext {
  std::filesystem::path folder;                             ///< of the configuration; files are relative to it
  int dimension = 0;                                        ///< of the ambient space; 0 while the manifold is made
  std::optional<Eigen::VectorXd> source = {};               ///< projected onto the manifold, ambient; none in a ring
  std::optional<Eigen::VectorXd> target = {};               ///< the same; none where there are many
  std::vector<std::string> coordinates = {};                ///< names of the coordinates in which points are given
  int seed = 0;                                             ///< master seed of the run
  std::shared_ptr<const ConstraintManifold> manifold = {};  ///< null while it is made, or waits for its files
  std::shared_ptr<const Robot> robot = {};                  ///< null where there is none, or it waits for its files
  BuildProgress progress = {};                              ///< told how far a long build is; may throw to stop
  std::function<void(std::string)> note = {};               ///< told what belongs beside every result
};

/// What has to be there before an object can be made.
enum class WaitsFor {
  nothing,  ///< its options are enough; making it is quick
  robot,    ///< the robot of the run
  domain,   ///< the manifold and the placed source
  files     ///< its own, or it takes a while to make
};

}  // namespace leastcost
