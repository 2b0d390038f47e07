// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include <leastcost/framework/base/options.hpp>

namespace leastcost {

/// Where an end of the path is: exactly one of vertex, face + barycentric, point, lonlat, state.
struct EndOptions {
  std::optional<int> vertex = {};                   ///< of the file
  std::optional<int> face = {};                     ///< of the file
  std::optional<Eigen::VectorXd> barycentric = {};  ///< three numbers
  std::optional<Eigen::VectorXd> point = {};
  std::optional<Eigen::VectorXd> lonlat = {};  ///< on the Earth: longitude, latitude, degrees
  std::optional<std::string> state = {};       ///< of the robot, by its name
  std::optional<double> tolerance = {};        ///< of a point, length units; else the default of the manifold
  void fields(FieldVisitor& visit);
};

}  // namespace leastcost
