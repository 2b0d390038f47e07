// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
//
// Shares nothing with the straightener but the mesh: the path is developed from its points with a frame per face, and
// the angles at a vertex are read off a fan that is put in order there.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <leastcost/problems/straighten/straighten.hpp>
#include "problems/straighten/plane_vectors.hpp"

namespace leastcost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kAtVertex = 1e-14;  // diameters
constexpr double kTogether = 1e-6;   // diameters: points nearer than this are judged together
constexpr double kRoundings = 16;    // units in the last place of the largest coordinate

/// Maps directions in the plane of a face to the plane of the development.
struct Frame {
  Eigen::Vector3d u = Eigen::Vector3d::Zero(), w = Eigen::Vector3d::Zero();
  Eigen::Vector2d operator()(const Eigen::Vector3d& d) const { return {d.dot(u), d.dot(w)}; }
};

/// A stretch of path between two vertices (or ends), developed: steps in one common plane, and the frames of the first
/// and last face in that plane.
struct Stretch {
  std::vector<Eigen::Vector2d> steps;
  Frame first, last;
  std::int32_t first_face = -1, last_face = -1;
  bool begins_path = false, ends_path = false;
};

/// Faces around a vertex in order, each with the vertex on the edge where it begins and the angle up to there.
struct Fan {
  struct Sector {
    std::int32_t face, spoke;
    double begin;
  };
  std::vector<Sector> sectors;
  double total = 0;
  bool closed = false;
  bool ends_are_edges[2] = {false, false};  ///< begin, end: at an edge with three or more faces, not at a border
};

class StraightnessChecker {
 public:
  StraightnessChecker(const TriangleMesh& mesh, const SurfacePath& path, const MetricRoot& metric);
  double worst() const;

 private:
  Eigen::Vector3d vertex(std::int32_t v) const { return root_ * mesh_.position(v); }
  std::int32_t vertex_at_point(std::size_t i) const;
  std::int32_t edge_at_point(std::size_t i) const;
  Eigen::Vector3d into_face(std::int32_t halfedge) const;
  Frame first_frame(std::int32_t face) const;
  std::int32_t side_at(std::int32_t face, std::int32_t halfedge) const;
  Frame carried_over(const Frame& frame, std::int32_t halfedge, std::int32_t beyond) const;
  bool develop(std::size_t begin, std::size_t end, Stretch& stretch) const;
  Eigen::Vector2d chord(const Stretch& stretch, bool from_end) const;
  bool is_no_way(const Stretch& stretch, bool is_before, const Eigen::Vector2d& chord) const;
  double allowance(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
  double worst_turn(const Stretch& stretch) const;
  std::int32_t neighbour(std::int32_t face, std::int32_t v, std::int32_t spoke) const;
  std::int32_t other_spoke(std::int32_t face, std::int32_t v, std::int32_t spoke) const;
  Fan fan_around(std::int32_t v, std::int32_t face) const;
  double place_in_fan(const Fan& fan, std::int32_t v, std::int32_t face, const Frame& frame,
                      const Eigen::Vector2d& direction) const;
  double narrowest_side(std::int32_t v, const Stretch& before, const Stretch& after) const;

  const TriangleMesh& mesh_;
  const SurfacePath& path_;
  Eigen::Matrix3d root_;
  double rounding_, together_;  // length units
};

StraightnessChecker::StraightnessChecker(const TriangleMesh& mesh, const SurfacePath& path, const MetricRoot& metric)
    : mesh_(mesh), path_(path), root_(metric ? *metric : Eigen::Matrix3d::Identity()) {
  double largest = 0;
  for (const Eigen::Vector3d& p : path.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  rounding_ = kRoundings * std::numeric_limits<double>::epsilon() * largest * root_.norm();
  together_ = kTogether * mesh.diameter() * root_.norm();
}

/// The vertex at point i, or -1; of several at one place one that both faces have.
std::int32_t StraightnessChecker::vertex_at_point(std::size_t i) const {
  const std::array<std::int32_t, 3>& after = mesh_.face(path_.faces[i]);
  std::int32_t found = -1;
  for (const std::int32_t v : mesh_.face(path_.faces[i - 1])) {
    if ((mesh_.position(v) - path_.points[i]).norm() > kAtVertex * mesh_.diameter()) continue;
    if (std::find(after.begin(), after.end(), v) != after.end()) return v;
    found = v;
  }
  return found;
}

/// The side of a face at the edge of a halfedge, of two faces or more; -1: it is not at that edge.
std::int32_t StraightnessChecker::side_at(std::int32_t face, std::int32_t halfedge) const {
  const std::int32_t across = mesh_.across(halfedge);
  if (across >= 0) return across / 3 == face ? across : -1;
  for (std::int32_t g = 3 * face; across == TriangleMesh::kNonManifold && g < 3 * face + 3; ++g)
    if (std::minmax(mesh_.tail(g), mesh_.head(g)) == std::minmax(mesh_.tail(halfedge), mesh_.head(halfedge))) return g;
  return -1;
}

/// The halfedge by which the path leaves a face at point i, or -1 (it stays on the face), or -2 (it jumps).
std::int32_t StraightnessChecker::edge_at_point(std::size_t i) const {
  const std::int32_t f = path_.faces[i - 1], g = path_.faces[i];
  if (f == g) return -1;
  std::int32_t best = -2;
  double nearest = kInfinity;
  for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
    if (side_at(g, h) < 0) continue;
    const Eigen::Vector3d a = mesh_.position(mesh_.tail(h));
    const Eigen::Vector3d e = (mesh_.position(mesh_.head(h)) - a).normalized();
    const double distance = e.cross(path_.points[i] - a).norm();
    if (distance < nearest) nearest = distance, best = h;
  }
  return best;
}

/// Unit vector in the face of a halfedge, perpendicular to the edge, towards the face's third corner.
Eigen::Vector3d StraightnessChecker::into_face(std::int32_t halfedge) const {
  const Eigen::Vector3d a = vertex(mesh_.tail(halfedge)), b = vertex(mesh_.head(halfedge));
  const Eigen::Vector3d c = vertex(mesh_.tail(TriangleMesh::previous(halfedge)));
  const Eigen::Vector3d e = (b - a).normalized();
  const Eigen::Vector3d& near = (c - a).squaredNorm() < (c - b).squaredNorm() ? a : b;
  const Eigen::Vector3d across = (c - near) - (c - near).dot(e) * e;
  return across.norm() > 0 ? Eigen::Vector3d(across.normalized()) : e.unitOrthogonal();
}

Frame StraightnessChecker::first_frame(std::int32_t face) const {
  std::int32_t longest = 3 * face;
  for (std::int32_t h = 3 * face; h < 3 * face + 3; ++h)
    if ((vertex(mesh_.head(h)) - vertex(mesh_.tail(h))).norm() >
        (vertex(mesh_.head(longest)) - vertex(mesh_.tail(longest))).norm())
      longest = h;
  return {(vertex(mesh_.head(longest)) - vertex(mesh_.tail(longest))).normalized(), into_face(longest)};
}

/// The frame of the face whose side `beyond` is, such that it lies beside that of the halfedge in the plane.
Frame StraightnessChecker::carried_over(const Frame& frame, std::int32_t halfedge, std::int32_t beyond) const {
  const Eigen::Vector3d e = (vertex(mesh_.head(halfedge)) - vertex(mesh_.tail(halfedge))).normalized();
  const Eigen::Vector3d out = into_face(beyond);
  const Eigen::Vector2d along = frame(e), away = -frame(into_face(halfedge));
  return {along.x() * e + away.x() * out, along.y() * e + away.y() * out};
}

/// Segments [begin, end) of the path. False: it is no connected path on the mesh.
bool StraightnessChecker::develop(std::size_t begin, std::size_t end, Stretch& stretch) const {
  stretch.steps.clear();
  stretch.first_face = path_.faces[begin];
  stretch.last_face = path_.faces[end - 1];
  stretch.begins_path = begin == 0;
  stretch.ends_path = end == path_.faces.size();
  stretch.first = stretch.last = first_frame(stretch.first_face);
  for (std::size_t i = begin; i < end; ++i) {
    if (i > begin) {
      const std::int32_t h = edge_at_point(i);
      if (h == -2) return false;
      if (h >= 0) stretch.last = carried_over(stretch.last, h, side_at(path_.faces[i], h));
    }
    stretch.steps.push_back(stretch.last(root_ * (path_.points[i + 1] - path_.points[i])));
  }
  return true;
}

/// Direction of a stretch at its start, or backwards at its end, over a length that rounding leaves a direction.
Eigen::Vector2d StraightnessChecker::chord(const Stretch& stretch, bool from_end) const {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  const std::size_t n = stretch.steps.size();
  for (std::size_t i = 0; i < n && sum.norm() < together_; ++i)
    sum += from_end ? Eigen::Vector2d(-stretch.steps[n - 1 - i]) : stretch.steps[i];
  return sum;
}

/// Whether a stretch that is no longer than rounding lies between a vertex and an end of the path. `is_before`: the
/// vertex is at its end.
bool StraightnessChecker::is_no_way(const Stretch& stretch, bool is_before, const Eigen::Vector2d& chord) const {
  return chord.norm() <= rounding_ && (is_before ? stretch.begins_path : stretch.ends_path);
}

double StraightnessChecker::allowance(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  return 2 * rounding_ / std::max(rounding_, std::min(a.norm(), b.norm()));
}

/// Minus the largest turn at the points inside a stretch.
double StraightnessChecker::worst_turn(const Stretch& stretch) const {
  double worst = 0;
  Eigen::Vector2d before = Eigen::Vector2d::Zero(), current = Eigen::Vector2d::Zero();
  const auto judge = [&] {
    if (before.squaredNorm() > 0) worst = std::min(worst, allowance(before, current) - angle_between(before, current));
  };
  for (const Eigen::Vector2d& step : stretch.steps) {
    current += step;
    if (current.norm() < together_) continue;
    judge();
    before = current;
    current.setZero();
  }
  if (current.squaredNorm() > 0) judge();
  return worst;
}

/// The halfedge across the edge v-spoke of a face (or kBorder, kNonManifold).
std::int32_t StraightnessChecker::neighbour(std::int32_t face, std::int32_t v, std::int32_t spoke) const {
  for (std::int32_t h = 3 * face; h < 3 * face + 3; ++h)
    if (std::minmax(mesh_.tail(h), mesh_.head(h)) == std::minmax(v, spoke)) return mesh_.across(h);
  return TriangleMesh::kBorder;
}

std::int32_t StraightnessChecker::other_spoke(std::int32_t face, std::int32_t v, std::int32_t spoke) const {
  for (const std::int32_t c : mesh_.face(face))
    if (c != v && c != spoke) return c;
  return -1;
}

Fan StraightnessChecker::fan_around(std::int32_t v, std::int32_t face) const {
  Fan fan;
  const std::array<std::int32_t, 3>& c = mesh_.face(face);
  std::int32_t f = face, spoke = c[0] == v ? c[1] : c[0];
  for (;;) {  // backwards to where the fan begins, or once around
    const std::int32_t h = neighbour(f, v, spoke);
    fan.ends_are_edges[0] = h == TriangleMesh::kNonManifold;
    if (h < 0) break;
    f = h / 3;
    spoke = other_spoke(f, v, spoke);
    if (f == face) {
      fan.closed = true;
      break;
    }
  }
  const std::int32_t first = f;
  do {
    fan.sectors.push_back({f, spoke, fan.total});
    const std::int32_t last_spoke = other_spoke(f, v, spoke);
    const Eigen::Vector3d a = vertex(spoke) - vertex(v), b = vertex(last_spoke) - vertex(v);
    fan.total += std::atan2(a.cross(b).norm(), a.dot(b));
    const std::int32_t h = neighbour(f, v, last_spoke);
    fan.ends_are_edges[1] = h == TriangleMesh::kNonManifold;
    if (h < 0) break;
    f = h / 3;
    spoke = last_spoke;
  } while (f != first);
  return fan;
}

/// Angle from the beginning of the fan to a direction in one of its faces; -1: the face is not in this fan.
double StraightnessChecker::place_in_fan(const Fan& fan, std::int32_t v, std::int32_t face, const Frame& frame,
                                         const Eigen::Vector2d& direction) const {
  for (const Fan::Sector& s : fan.sectors)
    if (s.face == face) return s.begin + angle_between(direction, frame(vertex(s.spoke) - vertex(v)));
  return -1;
}

/// Smallest side angle minus pi at a vertex between two stretches.
double StraightnessChecker::narrowest_side(std::int32_t v, const Stretch& before, const Stretch& after) const {
  const Eigen::Vector2d back = chord(before, true), ahead = chord(after, false);
  // A first or last segment without length: the path ends at the vertex, but for rounding.
  if (is_no_way(before, true, back) || is_no_way(after, false, ahead)) return 0;
  if (std::min(back.norm(), ahead.norm()) <= rounding_) return -kInfinity;  // an edge without length: no direction
  const Fan fan = fan_around(v, before.last_face);
  const double arrives = place_in_fan(fan, v, before.last_face, before.last, back);
  const double leaves = place_in_fan(fan, v, after.first_face, after.first, ahead);
  double angle = kInfinity;  // leaves < 0: through a vertex where two sheets meet there is no other way
  const double low = leaves < 0 ? arrives : std::min(arrives, leaves),
               high = leaves < 0 ? arrives : std::max(arrives, leaves);
  if (leaves >= 0) angle = high - low;
  if (leaves >= 0 && fan.closed) angle = std::min(angle, fan.total - angle);
  // What lies behind an edge of three faces is unknown: only the surface up to it counts.
  if (!fan.closed && fan.ends_are_edges[0]) angle = std::min(angle, low);
  if (!fan.closed && fan.ends_are_edges[1]) angle = std::min(angle, fan.total - high);
  return std::min(0.0, angle - std::numbers::pi + allowance(back, ahead));
}

double StraightnessChecker::worst() const {
  double worst = 0;
  Stretch before, current;
  std::int32_t vertex_before = -1;
  std::size_t begin = 0;
  const std::size_t count = path_.faces.size();
  for (std::size_t i = 1; i <= count; ++i) {
    const std::int32_t v = i < count ? vertex_at_point(i) : -1;
    if (i < count && v < 0) continue;
    if (!develop(begin, i, current)) return -kInfinity;
    worst = std::min(worst, worst_turn(current));
    if (vertex_before >= 0) worst = std::min(worst, narrowest_side(vertex_before, before, current));
    std::swap(before, current);
    vertex_before = v;
    begin = i;
  }
  return worst;
}

}  // namespace

double check_straight(const TriangleMesh& mesh, const SurfacePath& path, const MetricRoot& metric) {
  if (path.points.size() != path.faces.size() + 1) return -kInfinity;
  if (path.faces.empty()) return 0;
  return StraightnessChecker(mesh, path, metric).worst();
}

}  // namespace leastcost
