// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>

#include <leastcost/framework/base/ability.hpp>

namespace leastcost {

/// An open set that no path may enter: all points nearer than `radius` to a closed core (a point, a box, a polygon).
/// Distances are to the core; they need not be convex in the place, nor the core. Immutable.
class Obstacle : public HasAbilities<Obstacle> {
 public:
  using Vector = Eigen::VectorXd;
  using Box = Eigen::AlignedBox<double, Eigen::Dynamic>;

  /// For messages: "the ball at (1, 2)".
  virtual std::string name() const = 0;
  /// The box of the core; its dimension is that of the space. Infinite on all sides around a half-space.
  virtual Box core_bounds() const = 0;
  virtual double radius() const = 0;  ///< by which it is thicker than its core, length units
  /// Whether the core is known to be convex.
  virtual bool convex() const { return false; }
  /// Whether pictures show it; else something else of the domain does.
  virtual bool drawn() const { return true; }
  /// Corners of the core in the plane, 2 x m, counterclockwise (one: a point; none: a half-space). In space, for
  /// pictures: points whose hull looks like the core, 3 x m; none: as its box does.
  virtual Eigen::MatrixXd corners() const = 0;
  /// Distance of x from the core, negative within it, and its derivative: the direction in which it grows fastest, of
  /// length one. What is sampled may say less than the distance, nowhere more, and grow at a rate of less than one.
  virtual double distance(const Vector& x, Eigen::Ref<Vector> away) const = 0;
  /// The least distance of a point a + t (b - a) from the core, and that t; 0 where the segment meets it, and the t of
  /// where it does so first.
  virtual double distance_of_segment(const Vector& a, const Vector& b, double& t) const = 0;
};

/// Ability of an obstacle in space: how far triangles are from it is known, so that bodies made of them can meet it.
class MeetsTriangles {
 public:
  virtual ~MeetsTriangles() = default;
  /// The least distance of a point of the triangle from the core, and such a point; 0 where they meet, and where. A
  /// degenerate triangle counts as the segment or point that it is.
  virtual double distance_of_triangle(const std::array<Eigen::Vector3d, 3>& corners,
                                      Eigen::Vector3d& nearest) const = 0;
  /// False in the plane.
  bool present() const { return measures_triangles(); }

 private:
  virtual bool measures_triangles() const { return true; }
};

/// A box in space that may be turned; a segment or a point where half edges are 0. In the plane z is 0.
struct OrientedBox {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();    ///< place of its middle
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< of its edges, one a column, of length one
  Eigen::Vector3d half = Eigen::Vector3d::Zero();      ///< edges
};

/// Ability of an obstacle whose core is such a box: how far it is may be computed without asking it.
class HasCoreBox {
 public:
  virtual ~HasCoreBox() = default;
  bool present() const { return has_core_box(); }
  virtual OrientedBox core_box() const = 0;  ///< the box around its core

 private:
  virtual bool has_core_box() const { return true; }
};

}  // namespace leastcost
