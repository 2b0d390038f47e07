// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

inline constexpr int kEndReach = 2;  ///< cells of a lattice around an end that it is joined to

/// The box of coordinates over which a lattice is laid.
struct LatticeBox {
  Eigen::VectorXd lower, upper;
  std::vector<bool> open_lower, open_upper;  ///< a side that nobody has given: a wider box may help

  /// As stated, else that of the domain (HasBox), else the ends and as much around them as they are apart. Throws
  /// OptionError ("lower", "upper") for what does not fit the domain.
  static LatticeBox of(const Problem& problem, const std::optional<Eigen::VectorXd>& lower,
                       const std::optional<Eigen::VectorXd>& upper);
  /// Half as much again on the sides that nobody has given.
  void widen();
};

}  // namespace leastcost
