// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/crossings.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>
#include "problems/mesh/surface_walk.hpp"

namespace leastcost::comparison {
namespace {

/// Below pi by less than this, radians, an angle counts as straight.
constexpr double kStraight = 1e-7;

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

bool touches(const TriangleMesh& mesh, std::int32_t f, std::int32_t v) {
  const auto& c = mesh.face(f);
  return c[0] == v || c[1] == v || c[2] == v;
}

/// A row of edges around a vertex, each as the half-edge of the face before it, and the face behind the last.
struct Fan {
  std::vector<std::int32_t> halfedges;
  std::int32_t last_face = -1;
  bool complete = false;
};

/// Of face f, the half-edge at vertex v that is not the edge to w.
std::int32_t other_side(const TriangleMesh& mesh, std::int32_t f, std::int32_t v, std::int32_t w) {
  for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
    const std::int32_t a = mesh.tail(h), b = mesh.head(h);
    if ((a == v && b != w) || (b == v && a != w)) return h;
  }
  return -1;
}

/// Around v from face f, away from the edge to w, until `done(face)`.
template <class Done>
Fan walk(const TriangleMesh& mesh, std::int32_t v, std::int32_t f, std::int32_t w, Done done) {
  Fan fan;
  for (std::size_t i = 0; i <= mesh.faces_of_vertex(v).size(); ++i) {
    fan.last_face = f;
    if (done(f)) {
      fan.complete = true;
      return fan;
    }
    const std::int32_t h = other_side(mesh, f, v, w);
    if (h < 0 || mesh.across(h) < 0) return fan;
    fan.halfedges.push_back(h);
    w = mesh.tail(h) == v ? mesh.head(h) : mesh.tail(h);
    f = mesh.across(h) / 3;
  }
  return fan;
}

double corner_angle(const TriangleMesh& mesh, std::int32_t f, std::int32_t v) {
  const auto& c = mesh.face(f);
  const std::size_t k = c[0] == v ? 0 : (c[1] == v ? 1 : 2);
  const Eigen::Vector3d& x = mesh.position(v);
  return angle_between(mesh.position(c[(k + 1) % 3]) - x, mesh.position(c[(k + 2) % 3]) - x);
}

std::int32_t far_end(const TriangleMesh& mesh, std::int32_t h, std::int32_t v) {
  return mesh.tail(h) == v ? mesh.head(h) : mesh.tail(h);
}

}  // namespace

CrossingPath::CrossingPath(const TriangleMesh& mesh, std::int32_t source, std::int32_t target, double off,
                           const Stop& stop)
    : mesh_(&mesh), source_(source), target_(target) {
  EdgeGraphSearch search(mesh);
  EdgePathOptions options;
  options.stop = stop;
  const EdgePath first = search.shortest(
      vertex_point(mesh, source), vertex_point(mesh, target),
      [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (b - a).norm(); }, options);
  if (!first.found()) throw InputError("first path: " + first.failure());
  const std::vector<std::int32_t>& v = first.vertices;
  std::int32_t face = -1;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    // Both ways around from the edge we come along; the one of the smaller angle.
    Fan best;
    std::int32_t best_start = -1;
    double best_angle = std::numeric_limits<double>::infinity();
    for (const std::int32_t f : mesh.faces_of_vertex(v[i])) {
      if (!touches(mesh, f, v[i - 1])) continue;
      const Fan fan = walk(mesh, v[i], f, v[i - 1], [&](std::int32_t g) { return touches(mesh, g, v[i + 1]); });
      if (!fan.complete) continue;
      double angle = corner_angle(mesh, fan.last_face, v[i]);
      for (const std::int32_t h : fan.halfedges) angle += corner_angle(mesh, h / 3, v[i]);
      if (angle < best_angle) best_angle = angle, best = fan, best_start = f;
    }
    if (best_start < 0) throw InputError("first path: a border leaves no side of a vertex to pass it on");
    if (face >= 0 && face != best_start) {  // to the other side of the edge, anywhere along it
      for (std::int32_t h = 3 * face; h < 3 * face + 3; ++h)
        if (mesh.across(h) >= 0 && mesh.across(h) / 3 == best_start && (mesh.tail(h) == v[i] || mesh.head(h) == v[i]) &&
            far_end(mesh, h, v[i]) == v[i - 1])
          crossings_.push_back({h, 0.5});
    }
    for (const std::int32_t h : best.halfedges) crossings_.push_back({h, mesh.tail(h) == v[i] ? off : 1 - off});
    face = best.last_face;
  }
  drop_returns();
}

Eigen::Vector3d CrossingPath::at(const Crossing& c) const {
  const Eigen::Vector3d& a = mesh_->position(mesh_->tail(c.halfedge));
  return a + c.t * (mesh_->position(mesh_->head(c.halfedge)) - a);
}

Eigen::Vector3d CrossingPath::point(std::size_t i) const {
  if (i == 0) return mesh_->position(source_);
  return i > crossings_.size() ? mesh_->position(target_) : at(crossings_[i - 1]);
}

double CrossingPath::length() const {
  double sum = 0;
  for (std::size_t i = 0; i <= crossings_.size(); ++i) sum += (point(i + 1) - point(i)).norm();
  return sum;
}

SurfacePath CrossingPath::path() const {
  SurfacePath path;
  path.points.push_back(point(0));
  for (std::size_t i = 0; i < crossings_.size(); ++i) append_point(path, point(i + 1), face_before(i));
  std::int32_t last = -1;
  if (!crossings_.empty()) last = face_behind(crossings_.size() - 1);
  for (const std::int32_t f : mesh_->faces_of_vertex(source_))
    if (last < 0 && touches(*mesh_, f, target_)) last = f;
  append_point(path, mesh_->position(target_), last);
  return path;
}

std::vector<CrossingPath::Knot> CrossingPath::knots(double tolerance) const {
  std::vector<Knot> all;
  for (std::size_t i = 0; i < crossings_.size(); ++i) {
    const Crossing& c = crossings_[i];
    const std::int32_t v = c.t <= tolerance       ? mesh_->tail(c.halfedge)
                           : c.t >= 1 - tolerance ? mesh_->head(c.halfedge)
                                                  : -1;
    if (v < 0) continue;
    if (!all.empty() && all.back().last == i && all.back().vertex == v) {
      ++all.back().last;
    } else {
      all.push_back({i, i + 1, v});
    }
  }
  return all;
}

bool CrossingPath::untie(const Knot& knot) {
  const std::int32_t v = knot.vertex;
  if (v == source_ || v == target_) {  // the path starts or ends beyond these edges
    const bool at_start = v == source_;
    if (at_start ? knot.first != 0 : knot.last != crossings_.size()) return false;
    crossings_.erase(crossings_.begin() + static_cast<std::ptrdiff_t>(knot.first),
                     crossings_.begin() + static_cast<std::ptrdiff_t>(knot.last));
    return true;
  }
  const Eigen::Vector3d x = mesh_->position(v);
  const Eigen::Vector3d in = point(knot.first) - x, out = point(knot.last + 1) - x;
  if (!(in.norm() > 0) || !(out.norm() > 0)) return false;
  const std::int32_t first_face = face_before(knot.first), last_face = face_behind(knot.last - 1);
  const auto spoke = [&](std::int32_t h) { return Eigen::Vector3d(mesh_->position(far_end(*mesh_, h, v)) - x); };
  // Angles from the direction we come from to each edge, and to where we go.
  const auto angles = [&](const std::vector<std::int32_t>& halfedges) {
    std::vector<double> result{angle_between(in, spoke(halfedges.front()))};
    for (std::size_t i = 1; i < halfedges.size(); ++i)
      result.push_back(result.back() + angle_between(spoke(halfedges[i - 1]), spoke(halfedges[i])));
    result.push_back(result.back() + angle_between(spoke(halfedges.back()), out));
    return result;
  };
  std::vector<std::int32_t> side;
  for (std::size_t i = knot.first; i < knot.last; ++i) side.push_back(crossings_[i].halfedge);
  std::vector<double> turns = angles(side);
  if (turns.back() >= std::numbers::pi - kStraight) {
    const Fan other =
        walk(*mesh_, v, first_face, far_end(*mesh_, side.front(), v), [&](std::int32_t f) { return f == last_face; });
    if (!other.complete || other.halfedges.empty()) return false;
    side = other.halfedges;
    turns = angles(side);
    if (turns.back() >= std::numbers::pi - kStraight) return false;
  }
  // The straight line from `in` to `out` in the plane: at angle a its distance is 1 / (cos a p + sin a q).
  const double all = turns.back(), r0 = in.norm(), r1 = out.norm();
  std::vector<Crossing> straight;
  for (std::size_t i = 0; i < side.size(); ++i) {
    const double a = turns[i];
    const double weight = r0 * std::sin(a) + r1 * std::sin(all - a);
    const double distance = weight > 0 ? r0 * r1 * std::sin(all) / weight : 0;
    const double part = std::clamp(distance / spoke(side[i]).norm(), 0.0, 1.0);
    straight.push_back({side[i], mesh_->tail(side[i]) == v ? part : 1 - part});
  }
  const auto begin = crossings_.begin() + static_cast<std::ptrdiff_t>(knot.first);
  crossings_.erase(begin, crossings_.begin() + static_cast<std::ptrdiff_t>(knot.last));
  crossings_.insert(crossings_.begin() + static_cast<std::ptrdiff_t>(knot.first), straight.begin(), straight.end());
  return true;
}

bool CrossingPath::untie_all(double tolerance) {
  bool changed = false;
  const std::vector<Knot> all = knots(tolerance);
  std::size_t least = crossings_.size() + 1;                    // first crossing that was touched in this pass
  for (auto knot = all.rbegin(); knot != all.rend(); ++knot) {  // from behind, so that the numbers stay
    if (knot->last >= least) continue;                          // its neighbour has just moved
    if (untie(*knot)) {
      changed = true;
      least = knot->first;
    }
  }
  if (changed) drop_returns();
  return changed;
}

void CrossingPath::drop_returns() {
  std::vector<Crossing> kept;
  for (const Crossing& c : crossings_) {
    if (!kept.empty() && mesh_->across(kept.back().halfedge) == c.halfedge) {
      kept.pop_back();
    } else {
      kept.push_back(c);
    }
  }
  crossings_ = std::move(kept);
}

}  // namespace leastcost::comparison
