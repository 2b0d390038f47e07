// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include <leastcost/urdf/urdf_options.hpp>
#include "urdf/srdf_model.hpp"
#include "urdf/urdf_model.hpp"

namespace leastcost {

/// Which joints move, and where the others are held.
struct JointChoice {
  std::vector<int> coordinates;    ///< of the joints of the file; -1: it has none
  std::vector<double> values;      ///< of the joints of the file, where they are held
  std::vector<std::string> names;  ///< of the coordinates: their joints
  Eigen::VectorXd lower, upper;    ///< of the coordinates
};

/// `srdf` may be null. Throws OptionError("group"), ("file"), ("hold"), ("hold_state").
JointChoice choose_joints(const UrdfRobotOptions& options, const UrdfModel& urdf, const SrdfModel* srdf);

}  // namespace leastcost
