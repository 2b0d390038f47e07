// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// Walls between the parts of a robot and what they may touch, pair by pair: for whoever knows which pairs are near.
class PairWalls : public Walls {
 public:
  /// A part and an obstacle, or another capsule, from whose link it is seen.
  struct Pair {
    int number = 0;         ///< of the wall that the pair makes
    int part = 0;           ///< of the robot, by its number
    int other = 0;          ///< number of the obstacle, or of the other part
    bool self = false;      ///< whether the other is a part of the robot
    double required = 0;    ///< of the distance between the cores: the axis or triangle, the obstacle's or another axis
    double steepest = 0;    ///< length units that the part moves at most as the configuration moves by 1
    bool branches = false;  ///< the other's link does not carry that of the part: both move
  };
  /// A pair and the distance between its parts.
  struct PairGap {
    Pair pair;       ///< what is near what
    double gap = 0;  ///< or a bound of what is asked for
  };

  /// The pairs whose gap at x is below `reach`, and their gaps.
  virtual void gaps_within(const Vector& x, double reach, std::vector<PairGap>& found) const = 0;
  /// As near(), along() and room(), of these pairs; `found` gets more.
  virtual void near_among(const std::vector<Pair>& pairs, const Vector& x, double reach,
                          std::vector<Wall>& found) const = 0;
  /// As along(), of these pairs.
  virtual void along_among(const std::vector<Pair>& pairs, const Vector& a, const Vector& b, double reach,
                           std::vector<Wall>& found) const = 0;
  /// As room(), of these pairs.
  virtual double room_among(const std::vector<PairGap>& pairs, const Vector& a, const Vector& b,
                            double reach) const = 0;
};

}  // namespace leastcost
