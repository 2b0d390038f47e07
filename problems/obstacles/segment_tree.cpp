// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/obstacles/segment_tree.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>

#include "problems/obstacles/triangle_foot.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr std::ptrdiff_t kTrianglesOfLeaf = 4;
constexpr double kOutwards = 1 + 1e-12;

/// Where on a segment something is nearest.
struct Nearest {
  double square = std::numeric_limits<double>::infinity();  ///< of the distance
  double t = 0;
  void offer(double other_square, double other_t) {
    if (other_square < square || (other_square == square && other_t < t)) square = other_square, t = other_t;
  }
};

/// Ericson, Real-Time Collision Detection (2005), Sec. 5.1.9.
void offer_edge(const Vector3d& a, const Vector3d& b, const Vector3d& p, const Vector3d& q, Nearest& best) {
  const Vector3d d = b - a, e = q - p, r = a - p;
  const double dd = d.squaredNorm(), ee = e.squaredNorm(), er = e.dot(r), dr = d.dot(r), de = d.dot(e);
  double s = 0, t = 0;  // along a b, along p q
  if (dd > 0 && ee > 0) {
    const double across = dd * ee - de * de;
    s = across > 0 ? std::clamp((de * er - dr * ee) / across, 0.0, 1.0) : 0;
    t = (de * s + er) / ee;
    if (t < 0) t = 0, s = std::clamp(-dr / dd, 0.0, 1.0);
    if (t > 1) t = 1, s = std::clamp((de - dr) / dd, 0.0, 1.0);
  } else if (ee > 0) {
    t = std::clamp(er / ee, 0.0, 1.0);
  } else if (dd > 0) {
    s = std::clamp(-dr / dd, 0.0, 1.0);
  }
  best.offer((a + s * d - p - t * e).squaredNorm(), s);
}

/// An end of the segment against the inside of a triangle.
void offer_end(const Vector3d& x, double at, const SegmentTree::Triangle& c, Nearest& best) {
  const Vector3d u = c[1] - c[0], v = c[2] - c[0], w = x - c[0], normal = u.cross(v);
  const double area = normal.squaredNorm();
  if (!(area > 0)) return;
  const double wv = w.cross(v).dot(normal) / area, wu = u.cross(w).dot(normal) / area;
  if (wv < 0 || wu < 0 || wv + wu > 1) return;  // nearest to an edge
  const double off = w.dot(normal);
  best.offer(off * off / area, at);
}

/// Whether the segment goes through a triangle, and where.
void offer_crossing(const Vector3d& a, const Vector3d& b, const SegmentTree::Triangle& c, Nearest& best) {
  const Vector3d normal = (c[1] - c[0]).cross(c[2] - c[0]);
  const double from = normal.dot(a - c[0]), to = normal.dot(b - c[0]);
  if (from == to || (from > 0) == (to > 0)) return;
  const Vector3d way = b - a;
  const auto side = [&](std::size_t i, std::size_t j) { return way.dot((c[i] - a).cross(c[j] - a)); };
  const double s = side(0, 1), t = side(1, 2), r = side(2, 0);
  if (!((s >= 0 && t >= 0 && r >= 0) || (s <= 0 && t <= 0 && r <= 0))) return;
  best.offer(0, std::clamp(from / (from - to), 0.0, 1.0));
}

void offer_triangle(const Vector3d& a, const Vector3d& b, const SegmentTree::Triangle& c, Nearest& best) {
  offer_crossing(a, b, c, best);
  for (std::size_t k = 0; k < 3; ++k) offer_edge(a, b, c[k], c[(k + 1) % 3], best);
  offer_end(a, 0, c, best);
  offer_end(b, 1, c, best);
}

/// What the plane of a triangle says about another: where all of that is on one side, it is nowhere nearer than its
/// lowest corner, and just as near where that corner is above the inside.
struct OverPlane {
  double square = 0;  ///< of a lower bound of the distance
  std::size_t corner = 0;
  bool attained = false;
};

OverPlane over_plane(const SegmentTree::Triangle& base, const SegmentTree::Triangle& other) {
  const Vector3d u = base[1] - base[0], v = base[2] - base[0], normal = u.cross(v);
  const double area = normal.squaredNorm();
  const double heights[3] = {normal.dot(other[0] - base[0]), normal.dot(other[1] - base[0]),
                             normal.dot(other[2] - base[0])};
  const bool above = heights[0] > 0 && heights[1] > 0 && heights[2] > 0;
  if (!above && !(heights[0] < 0 && heights[1] < 0 && heights[2] < 0)) return {};
  OverPlane out;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(heights[k]) < std::abs(heights[out.corner])) out.corner = k;
  out.square = heights[out.corner] * heights[out.corner] / area;
  const Vector3d w = other[out.corner] - base[0];
  const double of_u = w.cross(v).dot(normal), of_v = u.cross(w).dot(normal);
  out.attained = of_u >= 0 && of_v >= 0 && of_u + of_v <= area;
  return out;
}

/// Either an edge of the first is nearest to the second, or a corner of the second to the inside of the first, or an
/// edge of the second goes through it.
void offer_pair(const SegmentTree::Triangle& first, const SegmentTree::Triangle& second, double& square,
                Vector3d& nearest) {
  const auto take = [&](const Nearest& found, const Vector3d& place) {
    if (found.square < square) square = found.square, nearest = place;
  };
  const OverPlane below = over_plane(second, first);
  if (below.square >= square) return;
  if (below.attained) return take({below.square, 0}, first[below.corner]);
  const OverPlane above = over_plane(first, second);
  if (above.square >= square) return;
  if (above.attained) return take({above.square, 0}, foot_on_triangle(first, second[above.corner]));
  for (std::size_t k = 0; k < 3; ++k) {
    Nearest edge;
    const Vector3d &a = first[k], &b = first[(k + 1) % 3];
    offer_triangle(a, b, second, edge);
    take(edge, a + edge.t * (b - a));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    Nearest corner, crossing;
    const Vector3d &p = second[k], &q = second[(k + 1) % 3];
    offer_end(p, 0, first, corner);
    if (corner.square < square) take(corner, foot_on_triangle(first, p));
    offer_crossing(p, q, first, crossing);
    take(crossing, p + crossing.t * (q - p));
  }
}

}  // namespace

SegmentTree::SegmentTree(std::vector<Triangle> triangles)
    : tree_(std::move(triangles), kTrianglesOfLeaf, std::identity{}, ball_around) {}

SegmentTree::Ball SegmentTree::ball_around(std::span<const Triangle> triangles) {
  Vector3d low = triangles[0][0], high = low;
  for (const Triangle& t : triangles)
    for (const Vector3d& p : t) low = low.cwiseMin(p).eval(), high = high.cwiseMax(p).eval();
  Ball ball{(low + high) / 2};
  for (const Triangle& t : triangles)
    for (const Vector3d& p : t) ball.radius = std::max(ball.radius, (p - ball.centre).norm() * kOutwards);
  return ball;
}

double SegmentTree::distance(const Vector3d& a, const Vector3d& b, double& t) const {
  const Vector3d way = b - a;
  const double length = way.squaredNorm();
  Nearest best;
  tree_.visit_nearest(
      [&](const Ball& ball) {  // no triangle in it is nearer to the segment
        const double s = length > 0 ? std::clamp((ball.centre - a).dot(way) / length, 0.0, 1.0) : 0;
        return std::max(0.0, (a + s * way - ball.centre).norm() / kOutwards - ball.radius);
      },
      [&](const Triangle& triangle) { offer_triangle(a, b, triangle, best); }, [&] { return std::sqrt(best.square); });
  t = best.t;
  return std::sqrt(best.square);
}

double SegmentTree::distance(const Triangle& triangle, Vector3d& nearest) const {
  double square = std::numeric_limits<double>::infinity();
  tree_.visit_nearest(
      [&](const Ball& ball) {
        const double off = (foot_on_triangle(triangle, ball.centre) - ball.centre).norm();
        return std::max(0.0, off / kOutwards - ball.radius);
      },
      [&](const Triangle& other) { offer_pair(triangle, other, square, nearest); }, [&] { return std::sqrt(square); });
  return std::sqrt(square);
}

}  // namespace leastcost
