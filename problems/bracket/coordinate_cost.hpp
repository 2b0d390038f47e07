// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>

#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// What moves in the two coordinates u of a domain cost: F(u, v), the line element of a cost at x(u) along dx/du v.
/// Known by its values only, so that whatever rests on it is sampled.
class CoordinateCost {
 public:
  /// The coordinates are those of a chart (HasChart), or positions in the plane.
  CoordinateCost(std::shared_ptr<const ConstraintManifold> domain, std::shared_ptr<const SegmentCost> cost);

  /// x(u) and dx/du of each column of u, side by side: ambient x 3 per place. Not finite off the domain.
  Points places(const Eigen::Ref<const Eigen::Matrix2Xd>& u) const;

  /// F at one place.
  class Element {
   public:
    explicit Element(const CoordinateCost& cost) : cost_(*cost.cost_) {}
    Element(const CoordinateCost& cost, const Eigen::Vector2d& u) : Element(cost) { move_to(cost.places(u)); }
    /// `place`: ambient x 3, of places().
    void move_to(const Eigen::Ref<const Points>& place);
    /// Greater than 0, or infinite where there is no such move or none of a length.
    double operator()(const Eigen::Vector2d& v) const;
    /// Whether there are moves in some direction.
    bool is_inside() const { return inside_; }

   private:
    const SegmentCost& cost_;
    Eigen::VectorXd x_;
    Points jacobian_;
    mutable Eigen::VectorXd velocity_;
    bool inside_ = false;
  };

 private:
  std::shared_ptr<const ConstraintManifold> domain_;
  std::shared_ptr<const SegmentCost> cost_;
};

/// Cost of a polyline in the coordinates, 2 x m, m >= 2: by Simpson's rule in pieces of at most 1/512 of its length.
double polyline_cost(const CoordinateCost& cost, const Eigen::Ref<const Eigen::Matrix2Xd>& polyline);

}  // namespace leastcost
