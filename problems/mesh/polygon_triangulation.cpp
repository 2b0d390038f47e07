// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/polygon_triangulation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

/// Bounds the quadratic time of ear clipping to a few seconds.
constexpr std::int32_t kMaxClippedCorners = 20000;

using Point2 = Eigen::Vector2d;

/// Twice the signed area of the triangle a, b, c.
double area2(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The corners in the plane of the area vector (Newell), where the polygon runs counterclockwise; all zero when its
/// area is.
std::vector<Point2> flatten(std::span<const Eigen::Vector3d> corners) {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i) area += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
  std::vector<Point2> flat(corners.size(), Point2::Zero());
  const double norm = area.norm();
  if (!(norm > 0)) return flat;
  const Eigen::Vector3d normal = area / norm;
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross(u);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d p = corners[i] - corners[0];
    flat[i] = Point2(p.dot(u), p.dot(v));
  }
  return flat;
}

/// Convex and run around once: no right turn, and every triangle of the fan of corner 0 has positive area.
bool is_convex(const std::vector<Point2>& p) {
  const std::size_t m = p.size();
  for (std::size_t i = 0; i < m; ++i) {
    if (area2(p[i], p[(i + 1) % m], p[(i + 2) % m]) < 0) return false;
  }
  for (std::size_t i = 2; i < m; ++i) {
    if (!(area2(p[0], p[i - 1], p[i]) > 0)) return false;
  }
  return true;
}

Triangulation fan(std::int32_t corner_count) {
  Triangulation result;
  for (std::int32_t i = 2; i < corner_count; ++i) result.triangles.push_back({0, i - 1, i});
  return result;
}

/// The diagonal whose worse triangle is larger: on a non-convex quad this is the one inside.
Triangulation cut_quad(const std::vector<Point2>& p) {
  const double first = std::min(area2(p[0], p[1], p[2]), area2(p[0], p[2], p[3]));
  const double second = std::min(area2(p[1], p[2], p[3]), area2(p[1], p[3], p[0]));
  Triangulation result = fan(4);
  if (second > first) result.triangles = {{1, 2, 3}, {1, 3, 0}};
  result.simple = std::max(first, second) >= 0;
  return result;
}

/// Ear flags are kept and only those beside a cut are renewed: quadratic time.
class EarClipper {
 public:
  explicit EarClipper(const std::vector<Point2>& points)
      : points_(points), next_(points.size()), previous_(points.size()), ear_(points.size()), left_(points.size()) {
    for (std::size_t i = 0; i < left_; ++i) {
      next_[i] = (i + 1) % left_;
      previous_[(i + 1) % left_] = i;
    }
    for (std::size_t i = 0; i < left_; ++i) ear_[i] = is_ear(i);
  }

  Triangulation run() {
    Triangulation result;
    std::size_t at = 0;
    while (left_ > 3) {
      at = next_ear(at, result.simple);
      result.triangles.push_back(triangle(at));
      remove(at);
      // Going on two corners further spreads the cuts, which avoids slivers around one corner.
      at = next_[next_[at]];
    }
    result.triangles.push_back(triangle(at));
    return result;
  }

 private:
  std::array<std::int32_t, 3> triangle(std::size_t i) const {
    return {static_cast<std::int32_t>(previous_[i]), static_cast<std::int32_t>(i), static_cast<std::int32_t>(next_[i])};
  }

  /// The first ear from `at` on. When there is none the polygon crosses itself: then any corner is cut off, so that at
  /// least every side of the polygon stays the side of a triangle.
  std::size_t next_ear(std::size_t at, bool& simple) const {
    for (std::size_t tried = 0; simple && tried < left_; ++tried, at = next_[at]) {
      if (ear_[at]) return at;
    }
    simple = false;
    return at;
  }

  void remove(std::size_t i) {
    next_[previous_[i]] = next_[i];
    previous_[next_[i]] = previous_[i];
    --left_;
    ear_[previous_[i]] = is_ear(previous_[i]);
    ear_[next_[i]] = is_ear(next_[i]);
  }

  bool is_ear(std::size_t i) const {
    const Point2& a = points_[previous_[i]];
    const Point2& b = points_[i];
    const Point2& c = points_[next_[i]];
    if (!(area2(a, b, c) > 0)) return false;
    for (std::size_t j = next_[next_[i]]; j != previous_[i]; j = next_[j]) {
      const Point2& p = points_[j];
      // A corner at the same place as one of the ear (a slit that leads to a hole) does not block it.
      if (p == a || p == b || p == c) continue;
      if (area2(a, b, p) >= 0 && area2(b, c, p) >= 0 && area2(c, a, p) >= 0) return false;
    }
    return true;
  }

  const std::vector<Point2>& points_;
  std::vector<std::size_t> next_, previous_;
  std::vector<char> ear_;
  std::size_t left_;
};

}  // namespace

Triangulation triangulate_polygon(std::span<const Eigen::Vector3d> corners) {
  const std::int32_t count = static_cast<std::int32_t>(corners.size());
  if (count == 3) return fan(count);
  const std::vector<Point2> flat = flatten(corners);
  if (is_convex(flat)) return fan(count);
  if (std::all_of(flat.begin(), flat.end(), [](const Point2& p) { return p.isZero(0); })) {
    // No area, no plane: on a line, or as much turned one way as the other.
    Triangulation result = fan(count);
    result.simple = false;
    return result;
  }
  if (count == 4) return cut_quad(flat);
  if (count > kMaxClippedCorners) {
    throw InputError("has " + std::to_string(count) +
                     " corners and is not convex; cut it into triangles beforehand (at most " +
                     std::to_string(kMaxClippedCorners) + " corners can be cut here)");
  }
  return EarClipper(flat).run();
}

}  // namespace leastcost
