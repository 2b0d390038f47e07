// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include <leastcost/problems/bracket/coordinate_cost.hpp>

namespace leastcost::bracket {

/// Norms F at numbered places by their values in equally spaced directions, and their dual norms
/// H(p) = max { p.v : F(v) <= 1 } by parabolas through the largest of p.e / F(e).
class SampledNorms {
 public:
  static constexpr int kDirections = 64;  ///< a multiple of 8, so that neighbours on a grid are among them

  bool empty() const { return row_.empty(); }
  /// For so many places, of none of which anything is known yet.
  void reset(std::size_t places);
  bool knows(std::size_t place) const { return row_[place] >= 0; }
  void learn(std::size_t place, const CoordinateCost::Element& element);

  /// F in the direction 2 pi k / kDirections, k any number of it.
  double cost(std::size_t place, int k) const {
    return values_[static_cast<std::size_t>(row_[place]) * kDirections + static_cast<std::size_t>(k) % kDirections];
  }
  /// H(p), and 0 where there are no moves.
  double dual(std::size_t place, const Eigen::Vector2d& p) const;
  /// The move v with F(v) = 1 and p.v = H(p), the slope of H.
  Eigen::Vector2d steepest(std::size_t place, const Eigen::Vector2d& p) const;

  static Eigen::Vector2d direction(int k);

 private:
  struct Peak {
    double height = 0;  ///< of p.e / F(e)
    double angle = 0;   ///< of e
  };
  Peak peak(std::size_t place, const Eigen::Vector2d& p) const;

  std::vector<int> row_;
  std::vector<float> values_;
};

/// H(p) of one place by a search that begins at the angle of a direction: p.e / F(e) has a single peak, for F is
/// convex. 0 where there are no moves.
double dual_norm(const CoordinateCost::Element& element, const Eigen::Vector2d& p, double angle);

}  // namespace leastcost::bracket
