// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/straighten/string_shot.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "problems/mesh/surface_walk.hpp"
#include "problems/straighten/plane_vectors.hpp"

namespace leastcost {
namespace {

constexpr double kWorstMiss = 0.25;  // of the distance flown: beyond, the walk to the end would undo the gain

std::int32_t halfedge_between(const TriangleMesh& mesh, std::int32_t face, std::int32_t v, std::int32_t w) {
  for (std::int32_t h = 3 * face; h < 3 * face + 2; ++h)
    if (std::minmax(mesh.tail(h), mesh.head(h)) == std::minmax(v, w)) return h;
  return 3 * face + 2;
}

bool ends_at(const UnfoldedDoor& door, std::int32_t v) { return door.left_vertex == v || door.right_vertex == v; }

/// Whether p lies behind the door.
bool behind(const UnfoldedDoor& door, const Eigen::Vector2d& p) { return cross(door.along, p - door.left) > 0; }

}  // namespace

/// Of the two edges by which the face behind the last door can be left: the one that ends at `rim`.
Door StringShot::exit(std::int32_t rim) const {
  const TriangleMesh& mesh = unfolding_.mesh();
  const std::int32_t next = TriangleMesh::next(entry_), previous = TriangleMesh::previous(entry_);
  const std::int32_t tail = mesh.tail(entry_), head = mesh.tail(next), tip = mesh.tail(previous);
  Door door{head == rim ? next : previous, out_->doors.empty() ? entry_ : out_->doors.back().halfedge, rim, tip};
  unfolding_.measure(head == rim ? tail : head, door);
  return door;
}

bool StringShot::go_through(const Door& door, const UnfoldedDoor& unfolded) {
  entry_ = unfolding_.mesh().across(door.halfedge);
  if (entry_ < 0 || out_->doors.size() >= limit_) return false;
  unfolding_.append(door, *out_);
  door_ = unfolded;
  return true;
}

/// Turns from the strip's first face around the start until the line to the goal lies in the face.
bool StringShot::turn_around_start(bool left) {
  const TriangleMesh& mesh = unfolding_.mesh();
  const UnfoldedDoor& first = unfolding_.doors().front();
  UnfoldedDoor spoke =
      left ? UnfoldedDoor{origin_, first.left, first.left.normalized(), from_.vertex, first.left_vertex}
           : UnfoldedDoor{first.right, origin_, -first.right.normalized(), first.right_vertex, from_.vertex};
  Door door{halfedge_between(mesh, strip_->first_face, from_.vertex, left ? first.left_vertex : first.right_vertex)};
  for (std::size_t turns = 0; turns < mesh.faces_of_vertex(from_.vertex).size(); ++turns) {
    if (!go_through(door, spoke)) return false;
    const Door opposite = exit(left ? spoke.right_vertex : spoke.left_vertex);
    const UnfoldedDoor ahead = beyond(opposite);
    const double side = side_of(left ? ahead.left : ahead.right);
    if (left ? side >= 0 : side <= 0) return go_through(opposite, ahead);
    door = exit(from_.vertex);
    spoke = beyond(door);
  }
  return false;
}

/// From a start inside the first face (or on an edge of it) through the edge to the left or right of the first door.
bool StringShot::leave_first_face(bool left) {
  if (from_.vertex >= 0) return turn_around_start(left);
  const TriangleMesh& mesh = unfolding_.mesh();
  const UnfoldedDoor& first = unfolding_.doors().front();
  const std::int32_t h = strip_->doors.front().halfedge;
  const std::int32_t back = mesh.tail(TriangleMesh::previous(h));
  const Eigen::Vector2d at = unfolding_.place(first, unfolding_.vertex(back), -1.0);
  const UnfoldedDoor side =
      left ? UnfoldedDoor{at, first.left, (first.left - at).normalized(), back, first.left_vertex}
           : UnfoldedDoor{first.right, at, (at - first.right).normalized(), first.right_vertex, back};
  if (side_of(side.left) < 0 || side_of(side.right) > 0) return false;  // back through the third edge
  return go_through(Door{halfedge_between(mesh, strip_->first_face, side.left_vertex, side.right_vertex)}, side);
}

/// Goes through the strip's own doors [first, last) as far as the line does; true when through all of them.
bool StringShot::leave_strip(std::size_t first, std::size_t last) {
  const std::vector<UnfoldedDoor>& doors = unfolding_.doors();
  std::size_t i = first;
  while (i < last && side_of(doors[i].left) > 0 && side_of(doors[i].right) < 0) ++i;
  out_->doors.assign(strip_->doors.begin(), strip_->doors.begin() + static_cast<std::ptrdiff_t>(i));
  if (i > 0) {
    door_ = doors[i - 1];
    entry_ = unfolding_.mesh().across(strip_->doors[i - 1].halfedge);
  }
  return i == last;
}

/// Straight on until the face that holds the goal's place in the plane.
bool StringShot::fly() {
  for (bool left = true;; left = !left) {  // a line tends to leave by either side in turn
    Door door = exit(left ? door_.left_vertex : door_.right_vertex);
    UnfoldedDoor ahead = beyond(door);
    const bool tip_is_left = side_of(left ? ahead.right : ahead.left) > 0;  // the face's third corner
    if (tip_is_left == left) {
      left = !left;
      door = exit(left ? door_.left_vertex : door_.right_vertex);
      ahead = beyond(door);
    }
    if (!behind(ahead, goal_)) return true;  // the goal comes before this door
    if (!go_through(door, ahead)) return false;
  }
}

/// Where the line ended, in the face behind the last door.
SurfacePoint StringShot::landing() const {
  const std::int32_t face = entry_ / 3;
  const Eigen::Vector2d tip = beyond(exit(door_.left_vertex)).right;
  const Eigen::Vector2d a = door_.left - tip, b = door_.right - tip, p = goal_ - tip;
  const double area = cross(a, b);
  SurfacePoint end{face, Eigen::Vector3d::Constant(1.0 / 3)};
  if (area == 0) return end;
  const double left = cross(p, b) / area, right = cross(a, p) / area;
  for (int k = 0; k < 3; ++k) {
    const std::int32_t v = unfolding_.mesh().face(face)[static_cast<std::size_t>(k)];
    end.barycentric[k] = std::max(0.0, v == door_.left_vertex    ? left
                                       : v == door_.right_vertex ? right
                                                                 : 1 - left - right);
  }
  end.barycentric /= end.barycentric.sum();
  return end;
}

/// From where the line ended to the goal itself; the face of the goal that the strip then ends in, or -1.
std::int32_t StringShot::connect(const SurfacePoint& goal) {
  const TriangleMesh& mesh = unfolding_.mesh();
  const Place here = place_of(mesh, landing()), there = place_of(mesh, goal);
  const double miss = (unfolding_.position(there.position) - unfolding_.position(here.position)).norm();
  if (miss > kWorstMiss * (goal_ - origin_).norm()) return -1;
  SurfacePath walk;
  walk.points.push_back(here.position);
  if (!walk_towards(mesh, here, there, walk)) return -1;
  std::int32_t f = entry_ / 3;
  for (const std::int32_t g : walk.faces) {
    if (g == f) continue;
    std::int32_t h = 3 * f;
    while (h < 3 * f + 3 && (mesh.across(h) < 0 || mesh.across(h) / 3 != g)) ++h;
    if (h == 3 * f + 3) return -1;  // through a vertex
    unfolding_.append(h, *out_);
    f = g;
  }
  return f;
}

void StringShot::aim(const StripEnd& from, const Strip& strip, const StripEnd& to) {
  from_ = from;
  to_ = to;
  strip_ = &strip;
  unfolding_.lay_out(from, strip.doors, to);
  limit_ = 2 * strip.doors.size() + 16;
}

void StringShot::begin(Strip& out) {
  out.first_face = strip_->first_face;
  out.doors.clear();
  out_ = &out;
  origin_.setZero();
  goal_ = unfolding_.end();
}

bool StringShot::shoot(Strip& out) {
  if (strip_->doors.empty()) return false;
  begin(out);
  if (leave_strip(0, strip_->doors.size())) return true;
  const TriangleMesh& mesh = unfolding_.mesh();
  if (out.doors.empty() && !leave_first_face(side_of(unfolding_.doors().front().left) <= 0)) return false;
  if (!fly()) return false;
  const std::array<std::int32_t, 3>& c = mesh.face(entry_ / 3);
  const std::int32_t goal_face = strip_->last_face(mesh);
  if (to_.vertex < 0) return entry_ / 3 == goal_face || connect(point_on_face(mesh, goal_face, to_.position)) >= 0;
  return std::find(c.begin(), c.end(), to_.vertex) != c.end() || connect(vertex_point(mesh, to_.vertex)) >= 0;
}

bool StringShot::cut_corner(std::int32_t vertex, double fraction, Strip& out) {
  begin(out);
  const std::vector<UnfoldedDoor>& doors = unfolding_.doors();
  const std::size_t count = doors.size();
  std::size_t first = 0, last = count;  // doors that end at the vertex: [first, last)
  while (first < count && !ends_at(doors[first], vertex)) ++first;
  while (last > first && !ends_at(doors[last - 1], vertex)) --last;
  if (first == last) return false;
  const Eigen::Vector2d corner = doors[first].left_vertex == vertex ? doors[first].left : doors[first].right;
  origin_ = (1 - fraction) * corner;
  goal_ = corner + fraction * (unfolding_.end() - corner);
  while (first > 0 && !behind(doors[first - 1], origin_)) --first;
  while (last < count && behind(doors[last], goal_)) ++last;
  if (first == 0 || last == count) return false;
  if (!leave_strip(first, last) && !(fly() && return_to(last))) return false;
  for (std::size_t i = last; i < count; ++i) unfolding_.append(strip_->doors[i], out);
  return true;
}

/// From where the line ended to the face before a door of the strip, near the goal.
bool StringShot::return_to(std::size_t door) {
  const TriangleMesh& mesh = unfolding_.mesh();
  const std::int32_t halfedge = strip_->doors[door].halfedge;
  if (entry_ / 3 == halfedge / 3) return true;
  const UnfoldedDoor& d = unfolding_.doors()[door];
  const double t = std::clamp((goal_ - d.left).dot(d.along) / (d.right - d.left).dot(d.along), 0.0, 1.0);
  const Eigen::Vector3d goal = (1 - t) * mesh.position(d.left_vertex) + t * mesh.position(d.right_vertex);
  const std::int32_t face = connect(point_on_face(mesh, halfedge / 3, goal));
  if (face == mesh.across(halfedge) / 3) unfolding_.append(mesh.across(halfedge), *out_);  // back through the door
  return face == halfedge / 3 || face == mesh.across(halfedge) / 3;
}

}  // namespace leastcost
