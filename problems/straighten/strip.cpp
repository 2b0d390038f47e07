// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/straighten/strip.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "problems/straighten/plane_vectors.hpp"

namespace leastcost {
namespace {

/// Counterclockwise by a right angle.
Eigen::Vector2d turned(const Eigen::Vector2d& d) { return {-d.y(), d.x()}; }

/// Product of complex numbers: d turned by the unit vector `by`.
Eigen::Vector2d rotated(const Eigen::Vector2d& d, const Eigen::Vector2d& by) {
  return {d.x() * by.x() - d.y() * by.y(), d.x() * by.y() + d.y() * by.x()};
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// p seen from edge a -> b: x along the edge, measured from a, and y >= 0 off it. A short edge has no direction of its
/// own only when it has no length at all; then p is put straight ahead.
struct EdgeCoordinates {
  EdgeCoordinates(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p) {
    const Eigen::Vector3d e = b - a, da = p - a, db = p - b;
    length = e.norm();
    const bool near_a = da.squaredNorm() <= db.squaredNorm();
    if (length == 0) {
      y = da.norm();
      return;
    }
    from_a = da.dot(e) / length;  // both differences are formed directly: no cancellation on needles
    from_b = db.dot(e) / length;
    y = e.cross(near_a ? da : db).norm() / length;
    if (near_a)
      from_b = from_a - length;
    else
      from_a = from_b + length;
  }
  double length = 0, from_a = 0, from_b = 0, y = 0;
};

}  // namespace

bool on_door(const TriangleMesh& mesh, const StripEnd& p, std::int32_t halfedge) {
  if (p.vertex >= 0) return mesh.tail(halfedge) == p.vertex || mesh.head(halfedge) == p.vertex;
  return p.edge >= 0 && (p.edge == halfedge || mesh.across(halfedge) == p.edge);
}

void trim(const TriangleMesh& mesh, const StripEnd& from, const StripEnd& to, Strip& strip) {
  std::size_t first = 0;
  while (first < strip.doors.size() && on_door(mesh, from, strip.doors[first].halfedge)) ++first;
  if (first > 0) strip.first_face = mesh.across(strip.doors[first - 1].halfedge) / 3;
  strip.doors.erase(strip.doors.begin(), strip.doors.begin() + static_cast<std::ptrdiff_t>(first));
  while (!strip.doors.empty() && on_door(mesh, to, strip.doors.back().halfedge)) strip.doors.pop_back();
}

Door Unfolding::turn(std::int32_t previous, std::int32_t halfedge) const {
  const std::int32_t a = mesh_->tail(previous), b = mesh_->head(previous);
  const std::int32_t tail = mesh_->tail(halfedge), head = mesh_->head(halfedge);
  const bool keeps_tail = tail == a || tail == b;
  Door door{halfedge, previous, keeps_tail ? tail : head, keeps_tail ? head : tail};
  measure(door.kept == a ? b : a, door);
  return door;
}

void Unfolding::measure(std::int32_t last, Door& door) const {
  const Eigen::Vector3d kept = vertex(door.kept);
  const Eigen::Vector3d to_last = vertex(last) - kept, to_tip = vertex(door.tip) - kept;
  const double dot = to_last.dot(to_tip), squared_cross = to_last.cross(to_tip).squaredNorm();
  const double scale = std::sqrt(dot * dot + squared_cross);
  door.length = to_tip.norm();
  if (scale > 0) door.cosine = dot / scale, door.sine = std::sqrt(squared_cross) / scale;
}

void Unfolding::append(const Door& door, Strip& strip) const {
  if (strip.doors.empty()) {
    strip.doors.push_back(Door{door.halfedge});
  } else if (mesh_->across(strip.doors.back().halfedge) == door.halfedge) {
    strip.doors.pop_back();
  } else if (const std::int32_t last = strip.doors.back().halfedge; door.previous == last) {
    strip.doors.push_back(door);
  } else {
    strip.doors.push_back(turn(last, door.halfedge));
  }
}

double Unfolding::corner_angle(std::int32_t face, int corner) const {
  const std::array<std::int32_t, 3>& c = mesh_->face(face);
  const Eigen::Vector3d at = vertex(c[static_cast<std::size_t>(corner)]);
  const Eigen::Vector3d a = vertex(c[static_cast<std::size_t>((corner + 1) % 3)]) - at;
  const Eigen::Vector3d b = vertex(c[static_cast<std::size_t>((corner + 2) % 3)]) - at;
  // An edge without length has any direction; a right angle at either end keeps the sum of the angles.
  if (a.squaredNorm() == 0 || b.squaredNorm() == 0) return std::numbers::pi / 2;
  return angle_between(a, b);
}

Eigen::Vector2d Unfolding::place(const UnfoldedDoor& door, const Eigen::Vector3d& p, double sign) const {
  const EdgeCoordinates c(vertex(door.left_vertex), vertex(door.right_vertex), p);
  const Eigen::Vector2d off = sign * c.y * turned(door.along);
  if (std::abs(c.from_a) <= std::abs(c.from_b)) return door.left + c.from_a * door.along + off;
  return door.right + c.from_b * door.along + off;
}

void Unfolding::lay_out(const StripEnd& from, std::span<const Door> doors, const StripEnd& to) {
  doors_.resize(doors.size());
  if (doors.empty()) {
    end_ = {(position(to.position) - position(from.position)).norm(), 0.0};
    return;
  }
  const std::int32_t h = doors.front().halfedge;
  UnfoldedDoor first{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), Eigen::Vector2d(1, 0), mesh_->tail(h),
                     mesh_->head(h)};
  const EdgeCoordinates start(vertex(first.left_vertex), vertex(first.right_vertex), position(from.position));
  first.left = {-start.from_a, start.y};
  first.right = {-start.from_b, start.y};
  doors_[0] = first;
  DoorInPlane behind(first);
  for (std::size_t i = 1; i < doors.size(); ++i) {
    behind.go_on(doors[i]);
    doors_[i] = behind.door();
  }
  end_ = place(doors_.back(), position(to.position), 1.0);
}

CornerAngles Unfolding::angles_at_door(std::size_t i, std::int32_t door, bool ahead, const Eigen::Vector2d& d) const {
  const UnfoldedDoor& u = doors_[i];
  const std::int32_t inner = ahead ? mesh_->across(door) : door;  // the door as a side of the vertex's own face
  CornerAngles angles;
  angles.face = inner / 3;
  if (d.squaredNorm() == 0) return angles;
  const Eigen::Vector3d tip = vertex(mesh_->tail(TriangleMesh::previous(inner)));
  const EdgeCoordinates c(vertex(u.left_vertex), vertex(u.right_vertex), tip);
  const double y = ahead ? c.y : -c.y;
  const Eigen::Vector2d local = rotated(d, {u.along.x(), -u.along.y()});
  const double to_left = angle_between(local, Eigen::Vector2d(-c.from_a, -y));
  const double to_right = angle_between(local, Eigen::Vector2d(-c.from_b, -y));
  const bool tail_is_left = mesh_->tail(inner) == u.left_vertex;
  angles.to_next = tail_is_left ? to_left : to_right;
  angles.to_previous = tail_is_left ? to_right : to_left;
  return angles;
}

CornerAngles Unfolding::angles_in_face(std::int32_t face, std::int32_t v, const StripEnd& towards) const {
  CornerAngles angles;
  angles.face = face;
  const std::array<std::int32_t, 3>& c = mesh_->face(face);
  const int k = c[0] == v ? 0 : c[1] == v ? 1 : 2;
  const std::int32_t next = c[static_cast<std::size_t>((k + 1) % 3)],
                     previous = c[static_cast<std::size_t>((k + 2) % 3)];
  if (towards.vertex == next || towards.vertex == previous) {  // along an edge, which may have no length
    angles.to_next = towards.vertex == next ? 0.0 : corner_angle(face, k);
    angles.to_previous = towards.vertex == next ? corner_angle(face, k) : 0.0;
    return angles;
  }
  const Eigen::Vector3d d = position(towards.position) - vertex(v);
  if (d.squaredNorm() == 0) return angles;
  angles.to_next = angle_between(d, Eigen::Vector3d(vertex(next) - vertex(v)));
  angles.to_previous = angle_between(d, Eigen::Vector3d(vertex(previous) - vertex(v)));
  return angles;
}

}  // namespace leastcost
