// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/polygon.hpp>

#include <algorithm>
#include <limits>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

using Point2 = Eigen::Vector2d;
using Corners = Eigen::Matrix2Xd;

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The point of the segment a -> b nearest to x, as its place between them.
double nearest_place(const Point2& a, const Point2& b, const Point2& x) {
  const double square = (b - a).squaredNorm();
  return square > 0 ? std::clamp((x - a).dot(b - a) / square, 0.0, 1.0) : 0;
}

/// Whether two segments meet; where they do, the place on the first. Ends on the other count as meeting.
bool meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d, double& t) {
  const double ab_c = cross(b - a, c - a), ab_d = cross(b - a, d - a);
  const double cd_a = cross(d - c, a - c), cd_b = cross(d - c, b - c);
  if (ab_c * ab_d > 0 || cd_a * cd_b > 0 || cd_a == cd_b) return false;  // parallel ones meet, if at all, at an end
  t = cd_a / (cd_a - cd_b);
  return true;
}

class Polygon final : public Obstacle {
 public:
  explicit Polygon(Corners corners) : corners_(std::move(corners)), convex_(turns_left()) {}

  std::string name() const override {
    return "the polygon with a corner at " + point_text(corners_.col(0)) + " (" + std::to_string(corners_.cols()) +
           " corners)";
  }
  Box core_bounds() const override { return {corners_.rowwise().minCoeff(), corners_.rowwise().maxCoeff()}; }
  double radius() const override { return 0; }
  bool convex() const override { return convex_; }
  Eigen::MatrixXd corners() const override { return corners_; }

  double distance(const Vector& x, Eigen::Ref<Vector> away) const override {
    double least = std::numeric_limits<double>::infinity();
    Point2 foot = corners_.col(0), edge = Point2::Zero();
    for (Eigen::Index i = 0; i < corners_.cols(); ++i) {
      const Point2 a = corners_.col(i), b = next(i), p = a + nearest_place(a, b, x) * (b - a);
      const double distance = (x - p).norm();
      if (distance >= least) continue;
      least = distance;
      foot = p;
      edge = b - a;
    }
    const bool within = contains(x);
    if (least > 0)
      away = (within ? -1 : 1) / least * (x - foot);
    else  // on an edge: out of the polygon at a right angle to it
      away = Point2(edge.y(), -edge.x()).normalized();
    return within ? -least : least;
  }

  double distance_of_segment(const Vector& a, const Vector& b, double& t) const override {
    t = 0;
    if (contains(a)) return 0;
    double least = std::numeric_limits<double>::infinity();
    const Point2 from = a, to = b;
    const auto take = [&](double place, const Point2& other) {
      const double distance = (from + place * (to - from) - other).norm();
      if (distance >= least) return;
      least = distance;
      t = place;
    };
    for (Eigen::Index i = 0; i < corners_.cols(); ++i) {
      const Point2 c = corners_.col(i), d = next(i);
      double place = 0;
      if (meet(from, to, c, d, place)) {
        t = least > 0 ? place : std::min(t, place);
        least = 0;
      }
      take(nearest_place(from, to, c), c);
      take(0, c + nearest_place(c, d, from) * (d - c));
      take(1, c + nearest_place(c, d, to) * (d - c));
    }
    return least;
  }

 private:
  Point2 next(Eigen::Index i) const { return corners_.col((i + 1) % corners_.cols()); }

  bool contains(const Point2& x) const {
    bool within = false;
    for (Eigen::Index i = 0; i < corners_.cols(); ++i) {
      const Point2 a = corners_.col(i), b = next(i);
      if ((a.y() > x.y()) == (b.y() > x.y())) continue;
      if ((cross(b - a, x - a) > 0) == (b.y() > a.y())) within = !within;
    }
    return within;
  }

  /// It turns left at every corner, hence around once: its edges do not cross.
  bool turns_left() const {
    for (Eigen::Index i = 0; i < corners_.cols(); ++i) {
      const Point2 here = corners_.col(i), after = next(i), then = next((i + 1) % corners_.cols());
      if (cross(after - here, then - after) < 0) return false;
    }
    return true;
  }

  Corners corners_;  ///< counterclockwise
  bool convex_;
};

/// Twice the area, negative where the corners go round clockwise.
double doubled_area(const Corners& corners) {
  double sum = 0;
  for (Eigen::Index i = 0; i < corners.cols(); ++i)
    sum += cross(corners.col(i) - corners.col(0), corners.col((i + 1) % corners.cols()) - corners.col(0));
  return sum;
}

void refuse_crossing(const Corners& corners) {
  const Eigen::Index m = corners.cols();
  const auto corner = [&](Eigen::Index i) -> Point2 { return corners.col(i % m); };
  double t = 0;
  for (Eigen::Index i = 0; i < m; ++i) {
    if (corner(i) == corner(i + 1))
      throw OptionError("corners", "has the corner " + point_text(corner(i)) + " twice in a row");
    for (Eigen::Index j = i + 2; j < m; ++j)
      if (!(i == 0 && j == m - 1) && meet(corner(i), corner(i + 1), corner(j), corner(j + 1), t))
        throw OptionError("corners", "the edges after corners " + std::to_string(i) + " and " + std::to_string(j) +
                                         " cross, so the polygon has no inside");
  }
}

}  // namespace

void PolygonOptions::fields(FieldVisitor& visit) {
  visit.field("corners", corners, {.help = "Corners in order, [x, y] each.", .unit = "length", .required = true});
}

std::shared_ptr<const Obstacle> make_polygon(const PolygonOptions& options) {
  if (options.corners.cols() != 2 || options.corners.rows() < 3 || !options.corners.allFinite())
    throw OptionError("corners", "must be at least three points of the plane, with finite coordinates");
  Corners corners = options.corners.transpose();
  refuse_crossing(corners);
  if (doubled_area(corners) < 0) corners = corners.rowwise().reverse().eval();
  return std::make_shared<Polygon>(std::move(corners));
}

}  // namespace leastcost
