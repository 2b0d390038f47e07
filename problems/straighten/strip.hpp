// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <leastcost/problems/mesh/surface_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// An end of a straight piece of path: a vertex, or a point inside an edge or a face.
struct StripEnd {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::int32_t vertex = -1;  ///< or -1
  std::int32_t edge = -1;    ///< a halfedge of the edge it is inside of, or -1
};

/// The edge through which a strip leaves a face, and how it lies to the door before it: both share the vertex `kept`,
/// the other end is `tip`. The numbers of the turn are those of the triangle, so they move with the door from strip
/// to strip.
struct Door {
  std::int32_t halfedge = -1;  ///< of the face that is left
  std::int32_t previous = -1;  ///< door before it that the turn refers to, or -1
  std::int32_t kept = -1, tip = -1;
  double cosine = 1, sine = 0;  ///< of the angle at `kept` between the two doors
  double length = 0;            ///< kept to tip
};

/// Faces in a row, told by the doors between them. No orientation of faces is assumed.
struct Strip {
  std::int32_t first_face = -1;
  std::vector<Door> doors;
  std::int32_t last_face(const TriangleMesh& mesh) const {
    return doors.empty() ? first_face : mesh.across(doors.back().halfedge) / 3;
  }
};

/// Takes away the doors at either end that the end itself lies on: a strip from a vertex starts opposite to a door.
void trim(const TriangleMesh& mesh, const StripEnd& from, const StripEnd& to, Strip& strip);
/// True when the point lies on the edge of this halfedge.
bool on_door(const TriangleMesh& mesh, const StripEnd& p, std::int32_t halfedge);

/// Directions of a path that ends at a vertex, in the face it comes from: angles to the two edges of the face there.
/// Infinite where the path has no direction (a piece without length that is no edge).
struct CornerAngles {
  std::int32_t face = -1;
  double to_next = std::numeric_limits<double>::infinity();      ///< edge from the vertex to the face's next corner
  double to_previous = std::numeric_limits<double>::infinity();  ///< to the corner after that
};

/// A strip laid out in the plane, the start at the origin. `along` is carried from door to door as a rotation, so
/// that its rounding error does not grow with the ratio of strip length to edge length.
struct UnfoldedDoor {
  Eigen::Vector2d left, right;  ///< travelling from the start to the end
  Eigen::Vector2d along;        ///< unit vector left -> right
  std::int32_t left_vertex, right_vertex;
};

/// The door that a walk through a strip is at. In numbers of its own, which stay in registers from door to door.
class DoorInPlane {
 public:
  explicit DoorInPlane(const UnfoldedDoor& door)
      : left_x_(door.left.x()),
        left_y_(door.left.y()),
        right_x_(door.right.x()),
        right_y_(door.right.y()),
        x_(door.along.x()),
        y_(door.along.y()),
        left_(door.left_vertex),
        right_(door.right_vertex) {}

  void go_on(const Door& next) {
    const bool keeps_left = next.kept == left_;
    const double sine = keeps_left ? next.sine : -next.sine, x = x_;
    x_ = x * next.cosine - y_ * sine;
    y_ = x * sine + y_ * next.cosine;
    if (keeps_left) {
      right_x_ = left_x_ + next.length * x_;
      right_y_ = left_y_ + next.length * y_;
    } else {
      left_x_ = right_x_ - next.length * x_;
      left_y_ = right_y_ - next.length * y_;
    }
    left_ = keeps_left ? next.kept : next.tip;
    right_ = keeps_left ? next.tip : next.kept;
  }
  UnfoldedDoor door() const { return {{left_x_, left_y_}, {right_x_, right_y_}, {x_, y_}, left_, right_}; }

 private:
  double left_x_, left_y_, right_x_, right_y_, x_, y_;
  std::int32_t left_, right_;
};

/// Lays strips out. Reusable: keeps its memory.
class Unfolding {
 public:
  Unfolding(const TriangleMesh& mesh, const MetricRoot& metric) : mesh_(&mesh), metric_(&metric) {}

  /// Appends a door; one that leads straight back takes the last one away instead. A door that comes from another strip
  /// brings its turn along.
  void append(const Door& door, Strip& strip) const;
  void append(std::int32_t halfedge, Strip& strip) const { append(Door{halfedge}, strip); }

  /// The doors of a trimmed strip; the start is at the origin.
  void lay_out(const StripEnd& from, std::span<const Door> doors, const StripEnd& to);

  const std::vector<UnfoldedDoor>& doors() const { return doors_; }
  const Eigen::Vector2d& end() const { return end_; }

  /// In coordinates A x.
  Eigen::Vector3d position(const Eigen::Vector3d& x) const {
    if (*metric_) return **metric_ * x;
    return x;
  }
  Eigen::Vector3d vertex(std::int32_t v) const { return position(mesh_->position(v)); }
  double corner_angle(std::int32_t face, int corner) const;
  const TriangleMesh& mesh() const { return *mesh_; }
  bool euclidean() const { return !*metric_; }

  /// Angles at a vertex that lies opposite to unfolded door i, in the face before it (`ahead` false) or behind it, of a
  /// path that leaves that vertex in direction d of the plane.
  CornerAngles angles_at_door(std::size_t i, std::int32_t door, bool ahead, const Eigen::Vector2d& d) const;
  /// The same for a path that leaves vertex v inside one face.
  CornerAngles angles_in_face(std::int32_t face, std::int32_t v, const StripEnd& towards) const;
  /// How door `halfedge` lies to the one before it, `previous`.
  Door turn(std::int32_t previous, std::int32_t halfedge) const;
  /// The same for a door whose vertices are known; `last`: the end of the door before it that is not kept.
  void measure(std::int32_t last, Door& door) const;
  static UnfoldedDoor next_door(const UnfoldedDoor& last, const Door& door) {
    DoorInPlane behind(last);
    behind.go_on(door);
    return behind.door();
  }
  /// A point (in coordinates A x) of the face behind the door (sign +1) or before it (-1), in the plane.
  Eigen::Vector2d place(const UnfoldedDoor& door, const Eigen::Vector3d& p, double sign) const;

 private:
  const TriangleMesh* mesh_;
  const MetricRoot* metric_;
  std::vector<UnfoldedDoor> doors_;
  Eigen::Vector2d end_ = Eigen::Vector2d::Zero();
};

}  // namespace leastcost
