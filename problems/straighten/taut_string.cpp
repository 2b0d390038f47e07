// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/straighten/taut_string.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/straighten/plane_vectors.hpp"

namespace leastcost {
namespace {

constexpr double kSamePoint = 1e-14;   // diameters: nearer to a vertex or edge is on it
constexpr double kLooseVertex = 1e-9;  // diameters: a path through a vertex that is nowhere an edge

/// The metric's longest unit: how much A can stretch a length.
double stretch(const MetricRoot& metric) { return metric ? metric->norm() : 1.0; }

double distance_to_edge(const TriangleMesh& mesh, std::int32_t h, const Eigen::Vector3d& p) {
  const Eigen::Vector3d& a = mesh.position(mesh.tail(h));
  const Eigen::Vector3d e = mesh.position(mesh.head(h)) - a;
  const double squared = e.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(e) / squared, 0.0, 1.0) : 0.0;
  return (a + t * e - p).norm();
}

bool same_edge(const TriangleMesh& mesh, std::int32_t h, std::int32_t k) {
  return std::minmax(mesh.tail(h), mesh.head(h)) == std::minmax(mesh.tail(k), mesh.head(k));
}

std::string vertex_name(const TriangleMesh& mesh, std::int32_t v) {
  const std::int32_t file = mesh.file_vertex(v);
  if (file >= 0) return "vertex " + std::to_string(file);
  const Eigen::Vector3d& p = mesh.position(v);
  std::ostringstream name;
  name << "the vertex that subdivision made at (" << p.x() << ", " << p.y() << ", " << p.z() << ")";
  return name.str();
}

}  // namespace

void throw_non_manifold(const TriangleMesh& mesh, std::int32_t halfedge) {
  throw InputError(
      "straightening: the edge from " + vertex_name(mesh, mesh.tail(halfedge)) + " to " +
      vertex_name(mesh, mesh.head(halfedge)) +
      " has three or more faces and cannot be unfolded; remove the extra faces, or use the path without straightening");
}

double TautString::length() const {
  double sum = 0;
  for (const Piece& piece : pieces) sum += piece.length;
  return sum;
}

StringPuller::StringPuller(const TriangleMesh& mesh, const MetricRoot& metric)
    : mesh_(&mesh),
      tolerance_(kSamePoint * mesh.diameter()),
      touching_(tolerance_ * stretch(metric)),
      unfolding_(mesh, metric),
      funnel_(touching_) {}

void StringPuller::append_piece(const StripEnd& from, const Eigen::Vector2d& from_at, const StripEnd& to,
                                const Eigen::Vector2d& to_at, const Strip& strip, std::size_t begin, std::size_t end,
                                TautString& out) {
  TautString::Piece piece;
  piece.strip.first_face = begin == 0 ? strip.first_face : mesh_->across(strip.doors[begin - 1].halfedge) / 3;
  piece.strip.doors.assign(strip.doors.begin() + static_cast<std::ptrdiff_t>(begin),
                           strip.doors.begin() + static_cast<std::ptrdiff_t>(end));
  const Eigen::Vector2d d = to_at - from_at;
  if (begin < end) {
    piece.length = d.norm();
    if (from.vertex >= 0) piece.start = unfolding_.angles_at_door(begin, strip.doors[begin].halfedge, false, d);
    if (to.vertex >= 0) piece.finish = unfolding_.angles_at_door(end - 1, strip.doors[end - 1].halfedge, true, -d);
  } else {
    const std::int32_t f = piece.strip.first_face;
    piece.length = (unfolding_.position(to.position) - unfolding_.position(from.position)).norm();
    if (from.vertex >= 0) piece.start = unfolding_.angles_in_face(f, from.vertex, to);
    if (to.vertex >= 0) piece.finish = unfolding_.angles_in_face(f, to.vertex, from);
  }
  out.pieces.push_back(std::move(piece));
  out.nodes.push_back({to, true});
}

void StringPuller::pull(const StripEnd& from, Strip& strip, const StripEnd& to, TautString& out) {
  trim(*mesh_, from, to, strip);
  if (strip.doors.empty() && from.vertex >= 0 && from.vertex == to.vertex) return;
  unfolding_.lay_out(from, strip.doors, to);
  const std::vector<Touch>& touched = funnel_.pull(unfolding_.doors(), unfolding_.end());
  StripEnd previous = from;
  Eigen::Vector2d previous_at = Eigen::Vector2d::Zero();
  std::size_t begin = 0;
  for (std::size_t k = 0; k <= touched.size(); ++k) {
    const bool last = k == touched.size();
    const StripEnd next = last ? to : StripEnd{mesh_->position(touched[k].vertex), touched[k].vertex, -1};
    std::size_t end = last ? strip.doors.size() : touched[k].door + 1;
    while (begin < end && on_door(*mesh_, previous, strip.doors[begin].halfedge)) ++begin;
    const std::size_t resume = end;
    while (begin < end && on_door(*mesh_, next, strip.doors[end - 1].halfedge)) --end;
    end = std::max(begin, end);  // both ends on the door just passed: a piece along an edge
    const Eigen::Vector2d at = last ? unfolding_.end() : touched[k].at;
    append_piece(previous, previous_at, next, at, strip, begin, end, out);
    begin = std::max(begin, resume);
    previous = next;
    previous_at = at;
  }
}

/// The vertex of face f that p is, or -1; of several at one place one that face g has too.
std::int32_t StringPuller::vertex_near(const Eigen::Vector3d& p, std::int32_t f, std::int32_t g) const {
  std::int32_t found = -1;
  for (const std::int32_t v : mesh_->face(f)) {
    if ((mesh_->position(v) - p).norm() > tolerance_) continue;
    const std::array<std::int32_t, 3>& c = mesh_->face(g);
    if (std::find(c.begin(), c.end(), v) != c.end()) return v;
    found = v;
  }
  return found;
}

StripEnd StringPuller::end_at(const Eigen::Vector3d& p, std::int32_t face) const {
  const std::int32_t v = vertex_near(p, face, face);
  if (v >= 0) return {mesh_->position(v), v, -1};
  for (std::int32_t h = 3 * face; h < 3 * face + 3; ++h)
    if (distance_to_edge(*mesh_, h, p) <= tolerance_) return {p, -1, h};
  return {p, -1, -1};
}

/// The door from face f to face g at point p, or -1. Two faces may share more than one edge.
std::int32_t StringPuller::door_between(std::int32_t f, std::int32_t g, const Eigen::Vector3d& p) const {
  std::int32_t best = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
    const std::int32_t other = mesh_->across(h);
    if (other < 0 || other / 3 != g) continue;
    const double d = distance_to_edge(*mesh_, h, p);
    if (d < nearest) nearest = d, best = h;
  }
  return best;
}

/// The vertex through which a path goes from f to g where it crosses no edge between the two.
std::int32_t StringPuller::shared_vertex(std::int32_t f, std::int32_t g, const Eigen::Vector3d& p) const {
  for (const std::int32_t v : mesh_->face(f)) {
    const std::array<std::int32_t, 3>& c = mesh_->face(g);
    if (std::find(c.begin(), c.end(), v) == c.end()) continue;
    if ((mesh_->position(v) - p).norm() <= kLooseVertex * mesh_->diameter()) return v;
  }
  for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h)
    for (std::int32_t k = 3 * g; k < 3 * g + 3; ++k)
      if (same_edge(*mesh_, h, k)) throw_non_manifold(*mesh_, h);
  throw InputError("straightening: the path jumps from face " + std::to_string(mesh_->file_face(f)) + " to face " +
                   std::to_string(mesh_->file_face(g)) + ", which have no common point there");
}

TautString StringPuller::from_path(const SurfacePath& path) {
  TautString string;
  if (path.faces.empty()) return string;
  Strip strip{path.faces.front(), {}};
  StripEnd from = end_at(path.points.front(), path.faces.front());
  string.nodes.push_back({from, true});
  for (std::size_t i = 1; i < path.faces.size(); ++i) {
    const Eigen::Vector3d& p = path.points[i];
    const std::int32_t f = path.faces[i - 1], g = path.faces[i];
    std::int32_t v = vertex_near(p, f, g);
    if (v < 0) {
      if (f == g) continue;
      const std::int32_t door = door_between(f, g, p);
      if (door >= 0) {
        unfolding_.append(door, strip);
        continue;
      }
      v = shared_vertex(f, g, p);
    }
    const StripEnd to{mesh_->position(v), v, -1};
    pull(from, strip, to, string);
    from = to;
    strip = Strip{g, {}};
  }
  pull(from, strip, end_at(path.points.back(), path.faces.back()), string);
  return string;
}

void StringPuller::crossings(const StripEnd& from, const Strip& strip, const StripEnd& to,
                             std::vector<double>& parameters) {
  parameters.clear();
  unfolding_.lay_out(from, strip.doors, to);
  for (std::size_t i = 0; i < strip.doors.size(); ++i) {
    const UnfoldedDoor& u = unfolding_.doors()[i];
    const double left = std::max(0.0, cross(unfolding_.end(), u.left)),
                 right = std::max(0.0, cross(u.right, unfolding_.end()));
    const bool tail_is_left = mesh_->tail(strip.doors[i].halfedge) == u.left_vertex;
    const double t = left + right > 0 ? (tail_is_left ? left : right) / (left + right) : 0.5;
    parameters.push_back(t);
  }
}

SurfacePath StringPuller::to_path(const TautString& string) {
  SurfacePath path;
  if (string.nodes.empty()) return path;
  path.points.push_back(string.nodes.front().end.position);
  const auto add = [&path](const Eigen::Vector3d& p, std::int32_t face) {
    if (p == path.points.back()) return;
    path.points.push_back(p);
    path.faces.push_back(face);
  };
  std::vector<double> parameters;
  for (std::size_t i = 0; i < string.pieces.size(); ++i) {
    const Strip& strip = string.pieces[i].strip;
    crossings(string.nodes[i].end, strip, string.nodes[i + 1].end, parameters);
    for (std::size_t k = 0; k < strip.doors.size(); ++k) {
      const std::int32_t h = strip.doors[k].halfedge;
      const Eigen::Vector3d& a = mesh_->position(mesh_->tail(h));
      const Eigen::Vector3d& b = mesh_->position(mesh_->head(h));
      const double t = parameters[k];
      const Eigen::Vector3d p = t < 0.5 ? Eigen::Vector3d(a + t * (b - a)) : Eigen::Vector3d(b + (1 - t) * (a - b));
      add(p, h / 3);
    }
    // Pieces without length stay, between vertices at one place: the faces would not join without them.
    path.points.push_back(string.nodes[i + 1].end.position);
    path.faces.push_back(strip.last_face(*mesh_));
  }
  return path;
}

}  // namespace leastcost
