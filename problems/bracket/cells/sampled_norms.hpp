// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include <leastcost/problems/bracket/coordinate_cost.hpp>

namespace leastcost::bracket {

/// How many directions suffice to interpolate F between them, by what it is at some places of a box: a multiple of 32.
int directions_for(const CoordinateCost& cost, const Eigen::AlignedBox2d& box);

/// Norms F at numbered places by their values in equally spaced directions, and their dual norms
/// H(p) = max { p.v : F(v) <= 1 } by cubics through the largest of p.e / F(e).
class SampledNorms {
 public:
  bool empty() const { return row_.empty(); }
  /// For so many places, of none of which anything is known yet.
  void reset(std::size_t places, int directions);
  int directions() const { return static_cast<int>(unit_.size()); }
  bool knows(std::size_t place) const { return row_[place] >= 0; }
  void learn(std::size_t place, const CoordinateCost::Element& element);
  /// As at another place, that is known.
  void take_over(std::size_t place, std::size_t from) { row_[place] = row_[from]; }

  /// Unit vector at the angle 2 pi k / directions(), k any number of it from 0 on.
  const Eigen::Vector2d& direction(int k) const { return unit_[static_cast<std::size_t>(k) % unit_.size()]; }
  /// F of it.
  double cost(std::size_t place, int k) const {
    return values_[static_cast<std::size_t>(row_[place]) * unit_.size() + static_cast<std::size_t>(k) % unit_.size()];
  }
  /// The least of it in all directions.
  double least_cost(std::size_t place) const { return least_[static_cast<std::size_t>(row_[place])]; }
  /// H(p), and 0 where there are no moves; NaN where nothing is known.
  double dual(std::size_t place, const Eigen::Vector2d& p) const;
  /// The move v with F(v) = 1 and p.v = H(p), the slope of H.
  Eigen::Vector2d steepest(std::size_t place, const Eigen::Vector2d& p) const;

 private:
  struct Peak {
    double height = 0;  ///< of p.e / F(e)
    double angle = 0;   ///< of e
  };
  Peak peak(std::size_t place, const Eigen::Vector2d& p) const;

  std::vector<int> row_;
  std::vector<float> values_, least_;
  std::vector<Eigen::Vector2d> unit_;
};

/// H(p) of one place by a search that begins at the angle of a direction: p.e / F(e) has a single peak, for F is
/// convex. 0 where there are no moves.
double dual_norm(const CoordinateCost::Element& element, const Eigen::Vector2d& p, double angle);

}  // namespace leastcost::bracket
