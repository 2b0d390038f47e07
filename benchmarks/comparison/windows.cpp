// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/windows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/mesh/surface_walk.hpp"

namespace leastcost::comparison {
namespace {

/// Windows that one query may make: 0.8 GB of them.
constexpr std::size_t kMostWindows = 10'000'000;
/// Parts of an edge: what a window may miss a corner by and still see it, and what is too narrow to go on.
constexpr double kCrack = 1e-9, kNarrow = 1e-12;

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

double PlainWindow::distance_at(double along) const { return sigma + std::hypot(along - x, height); }
double PlainWindow::key() const { return distance_at(std::clamp(x, begin, end)); }

void WindowTables::begin(std::int32_t source) {
  source_ = source;
  pool_.clear();
  reach_.assign(at(edges_.mesh().vertex_count()), {std::numeric_limits<double>::infinity(), -1, -1});
  reach_[at(source)].distance = 0;
}

bool WindowTables::full() const { return pool_.size() >= kMostWindows; }

std::int32_t WindowTables::add(const PlainWindow& w) {
  pool_.push_back(w);
  return static_cast<std::int32_t>(pool_.size()) - 1;
}

WindowTables::Corner WindowTables::corner(const PlainWindow& w) const {
  const Side<double>& side = edges_.side(w.halfedge);
  Corner c{edges_.head(TriangleMesh::next(w.halfedge)), 0, 0, false};
  const double rise = w.height + side.y;
  c.crossing = rise > 0 ? w.x + (side.x - w.x) * w.height / rise : w.x;
  c.distance = w.sigma + std::hypot(side.x - w.x, rise);
  const double crack = kCrack * side.length;
  c.seen = c.crossing >= w.begin - crack && c.crossing <= w.end + crack;
  return c;
}

bool WindowTables::reach(std::int32_t v, double distance, std::int32_t window, std::int32_t from_vertex) {
  Reach& r = reach_[at(v)];
  if (!(distance < r.distance * (1 - kWindowTie))) return false;
  r = {distance, window, from_vertex};
  return true;
}

bool WindowTables::bends(std::int32_t v) const {
  const VertexKind kind = edges_.kind(v);
  return kind != VertexKind::convex && kind != VertexKind::flat;
}

bool WindowTables::window_from(std::int32_t v, std::int32_t opposite, PlainWindow& out) const {
  const std::int32_t g = edges_.across(opposite);
  if (g < 0) return false;
  const Side<double>& side = edges_.side(opposite);
  if (!(side.length > 0)) return false;
  out = {};
  out.halfedge = g;
  out.root = v;
  out.sigma = distance(v);
  out.end = side.length;
  out.x = edges_.tail(g) == edges_.tail(opposite) ? side.x : side.back;
  out.height = side.y;
  return true;
}

bool WindowTables::go_on(std::int32_t id, int side_of_exit, bool filtered, PlainWindow& out) const {
  const PlainWindow& w = window(id);
  const std::int32_t h = w.halfedge;
  const std::int32_t exit = side_of_exit == 0 ? TriangleMesh::previous(h) : TriangleMesh::next(h);
  const std::int32_t g = edges_.across(exit);
  if (g < 0) return false;
  const Side<double>& side = edges_.side(h);
  const double crossing = corner(w).crossing;
  const double from = side_of_exit == 0 ? w.begin : std::max(w.begin, crossing);
  const double to = side_of_exit == 0 ? std::min(w.end, crossing) : w.end;
  if (!(from < to)) return false;
  const Eigen::Vector2d p(side_of_exit == 0 ? 0 : side.length, 0), other(side_of_exit == 0 ? side.length : 0, 0);
  const Eigen::Vector2d image(w.x, -w.height), c(side.x, side.y);
  const double length = (c - p).norm();
  if (!(length > 0)) return false;
  const Eigen::Vector2d u = (c - p) / length;
  const auto hit = [&](double b) {
    const Eigen::Vector2d ray = Eigen::Vector2d(b, 0) - image;
    const double across = turn(u, ray);
    if (across == 0) return b == from ? 0.0 : length;
    return std::clamp(-turn(p - image, ray) / across, 0.0, length);
  };
  double s0 = hit(from), s1 = hit(to);
  if (to == crossing && side_of_exit == 0) s1 = length;
  if (from == crossing && side_of_exit == 1) s0 = length;
  if (s0 > s1) std::swap(s0, s1);
  if (!(s1 - s0 > kNarrow * length)) return false;
  const double along = (image - p).dot(u), off = std::abs(turn(image - p, u));

  out = {};
  out.halfedge = g;
  out.parent = id;
  out.level = w.level + 1;
  out.root = w.root;
  out.sigma = w.sigma;
  const bool same = edges_.tail(g) == (side_of_exit == 0 ? edges_.tail(h) : edges_.head(h));
  out.begin = same ? s0 : length - s1;
  out.end = same ? s1 : length - s0;
  out.x = same ? along : length - along;
  out.height = off;
  if (!filtered) return true;

  const double at_end = out.distance_at(out.end), at_begin = out.distance_at(out.begin);
  if (distance(edges_.tail(g)) + out.end < at_end * (1 - kWindowTie)) return false;
  if (distance(edges_.head(g)) + (length - out.begin) < at_begin * (1 - kWindowTie)) return false;
  // The corner behind, which the paths pass on one side of: the end of the part that is nearer to that side.
  const std::int32_t behind = side_of_exit == 0 ? edges_.head(h) : edges_.tail(h);
  const Eigen::Vector2d near = p + s0 * u;
  return !(distance(behind) + (near - other).norm() < (w.sigma + (near - image).norm()) * (1 - kWindowTie));
}

Eigen::Vector2d WindowTables::place(std::int32_t h, std::int32_t v) const {
  const Side<double>& side = edges_.side(h);
  if (v == edges_.tail(h)) return {0, 0};
  if (v == edges_.head(h)) return {side.length, 0};
  return {side.x, side.y};
}

SurfacePath WindowTables::path(std::int32_t target) const {
  const TriangleMesh& mesh = edges_.mesh();
  SurfacePath backwards;
  if (!(distance(target) < std::numeric_limits<double>::infinity())) return {};
  backwards.points.push_back(mesh.position(target));
  std::int32_t v = target;
  while (v != source_) {
    const Reach& r = reach_[at(v)];
    std::int32_t next = r.vertex;
    if (r.window < 0) {
      std::int32_t face = -1;
      for (const std::int32_t f : mesh.faces_of_vertex(v)) {
        const auto& corners = mesh.face(f);
        if (std::find(corners.begin(), corners.end(), next) != corners.end()) face = f;
      }
      append_point(backwards, mesh.position(next), face);
      v = next;
      continue;
    }
    // From window to window: the straight line from the image to the point reached so far.
    std::int32_t h = window(r.window).halfedge;
    Eigen::Vector2d towards = place(h, v);
    std::int32_t face = h / 3;
    for (std::int32_t id = r.window; id >= 0; id = window(id).parent) {
      const PlainWindow& w = window(id);
      h = w.halfedge;
      const double length = edges_.side(h).length, rise = w.height + towards.y();
      const double crossing = rise > 0 ? w.x + (towards.x() - w.x) * w.height / rise : w.x;
      const double part = std::clamp(crossing, 0.0, length) / length;
      const std::int32_t tail = edges_.tail(h), head = edges_.head(h);
      append_point(backwards, mesh.position(tail) + part * (mesh.position(head) - mesh.position(tail)), h / 3);
      face = edges_.across(h) / 3;
      if (w.parent >= 0) {
        const std::int32_t before = window(w.parent).halfedge;
        towards = place(before, tail) + part * (place(before, head) - place(before, tail));
      }
      next = w.root;
    }
    append_point(backwards, mesh.position(next), face);
    v = next;
  }
  return reversed(backwards);
}

}  // namespace leastcost::comparison
