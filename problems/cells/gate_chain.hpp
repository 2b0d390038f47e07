// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// A side of a cell that a path has to meet.
struct Gate {
  int axis = 0;              ///< along which it runs
  double line = 0;           ///< its place along the other axis
  double low = 0, high = 0;  ///< its ends

  Eigen::Vector2d at(double s) const { return axis == 0 ? Eigen::Vector2d(s, line) : Eigen::Vector2d(line, s); }
};

/// Paths from one place to another by gates in turn, straight between them.
struct GateChain {
  Eigen::Vector2d from, to;
  std::vector<Gate> gates;
  std::vector<double> units;  ///< cost of a unit of length before each gate, and after the last one

  Eigen::Vector2d place(const std::vector<double>& s, std::size_t i) const {
    return i == 0 ? from : i > gates.size() ? to : gates[i - 1].at(s[i - 1]);
  }
  double cost(const std::vector<double>& s) const;
};

/// Minimises the cost over the places on the gates, which is convex: Newton with a barrier at the ends of the gates,
/// from lengths sqrt(l^2 + e^2) that are rounded off by e; barrier and e fall to rounding together. What is left is
/// about 1e-10 of the cost, and polish() takes it.
std::vector<double> least_places(const GateChain& chain, std::vector<double> start);

/// Newton steps on the cost itself; a place that reaches an end of its gate stays there. `s` is changed only where that
/// costs less, but for rounding.
void polish(const GateChain& chain, std::vector<double>& s);

/// No path by these gates costs less than that of `s` less this: from the dual, the slownesses of the legs, which is
/// the cost but for what the slownesses along a gate differ by.
double excess_above_least(const GateChain& chain, const std::vector<double>& s);

}  // namespace leastcost
