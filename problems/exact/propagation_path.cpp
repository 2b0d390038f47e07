// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/propagation.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "problems/exact/propagation_parts.hpp"

namespace leastcost {
using exact::kInfinity;

/// The side of the face that a window's paths come from, at the edge that it is on.
template <class Real>
std::int32_t Propagation<Real>::side_left(const Taken& w, std::int32_t parent) const {
  const std::int32_t across = mesh_->across(w.halfedge);
  if (across >= 0) return across;
  const std::int32_t root = w.root >= 0 ? w.root : source_->vertex;
  for (const std::int32_t g : forks_.sides(w.halfedge)) {
    if (g == w.halfedge) continue;
    if (parent >= 0 ? taken_[at(parent)].halfedge / 3 == g / 3
        : root >= 0 ? mesh_->tail(TriangleMesh::previous(g)) == root
                    : std::find(source_->faces.begin(), source_->faces.end(), g / 3) != source_->faces.end())
      return g;
  }
  return w.halfedge;
}

template <class Real>
void Propagation<Real>::trace_back(std::int32_t window, Point2 towards, SurfacePath& reversed) const {
  while (window >= 0) {
    const Taken& w = taken_[at(window)];
    const std::int32_t h = w.halfedge;
    const double length = mesh_->side(h).length, x = w.x, height = w.height;
    const double depth = height + towards.y;
    const double at_edge = std::clamp(depth > 0 ? x + (towards.x - x) * height / depth : x, w.begin, w.end);
    const std::int32_t parent = parent_at(w, at_edge), g = side_left(w, parent);
    const Eigen::Vector3d &a = mesh_->position(mesh_->tail(h)), &b = mesh_->position(mesh_->head(h));
    reversed.faces.push_back(h / 3);
    const double share = at_edge / length;
    reversed.points.push_back(share < 0.5 ? Eigen::Vector3d(a + share * (b - a))
                                          : Eigen::Vector3d(b + (1 - share) * (a - b)));
    if (parent >= 0) {
      // The same point in the frame of the edge before, one of whose face's other sides g is.
      const std::int32_t entered = taken_[at(parent)].halfedge;
      const Side<double>& s = mesh_->side(entered);
      const bool on_left = g == TriangleMesh::previous(entered);
      const std::int32_t near = on_left ? mesh_->tail(entered) : mesh_->head(entered);
      const double t = mesh_->tail(h) == near ? at_edge : length - at_edge;
      towards = on_left ? Point2{t * s.x / length, t * s.y / length}
                        : Point2{s.length - t * s.back / length, t * s.y / length};
    } else {
      reversed.faces.push_back(g / 3);  // from the root to the first crossing
    }
    window = parent;
  }
}

/// A face that a straight piece from vertex v runs in: to a vertex, or (-1) to an end of the query.
template <class Real>
std::int32_t Propagation<Real>::face_between(std::int32_t v, std::int32_t other, const EndPoint& end) const {
  const TriangleMesh& mesh = mesh_->mesh();
  const auto has = [&mesh](std::int32_t f, std::int32_t corner) {
    const auto& c = mesh.face(f);
    return c[0] == corner || c[1] == corner || c[2] == corner;
  };
  if (other >= 0) {
    for (const std::int32_t f : mesh.faces_of_vertex(v))
      if (has(f, other)) return f;
  }
  for (const std::int32_t f : end.faces)
    if (has(f, v)) return f;
  return mesh.faces_of_vertex(v).front();
}

/// From vertex to vertex back to the source.
template <class Real>
void Propagation<Real>::trace_to_source(std::int32_t vertex, SurfacePath& reversed) const {
  while (vertex >= 0 && vertex != source_->vertex) {
    const VertexReach& reach = reached(vertex);
    std::int32_t before = reach.from_vertex;
    if (reach.from_window >= 0) {
      const Side<double>& s = mesh_->side(taken_[at(reach.from_window)].halfedge);
      trace_back(reach.from_window, {s.x, s.y}, reversed);
      before = root_of(reach.from_window);
    } else {
      reversed.faces.push_back(face_between(vertex, before, *source_));
    }
    reversed.points.push_back(before >= 0 ? mesh_->position(before) : source_->position);
    vertex = before;
  }
}

template <class Real>
SurfacePath Propagation<Real>::path_to(std::int32_t vertex) const {
  SurfacePath back;
  if (!(reached(vertex).at_most < kInfinity)) return back;
  back.points.push_back(mesh_->position(vertex));
  trace_to_source(vertex, back);
  return reversed(back);
}

template <class Real>
SurfacePath Propagation<Real>::path() const {
  SurfacePath back;
  if (target_ == nullptr || !(target_at_most_ < kInfinity)) return back;
  back.points.push_back(target_->position);
  std::int32_t vertex = target_vertex_;
  if (target_window_ >= 0) {
    const std::int32_t h = taken_[at(target_window_)].halfedge;
    const Eigen::Vector3d a = mesh_->position(mesh_->tail(h)), edge = mesh_->position(mesh_->head(h)) - a;
    const Eigen::Vector3d from_a = target_->position - a;
    const double length = mesh_->side(h).length;
    trace_back(target_window_, {edge.dot(from_a) / length, edge.cross(from_a).norm() / length}, back);
    vertex = root_of(target_window_);
    back.points.push_back(vertex >= 0 ? mesh_->position(vertex) : source_->position);
  } else if (vertex >= 0 && vertex != target_->vertex) {
    back.faces.push_back(face_between(vertex, -1, *target_));
    back.points.push_back(mesh_->position(vertex));
  } else if (vertex < 0) {  // straight from the source
    std::int32_t face = -1;
    if (source_->vertex >= 0) face = face_between(source_->vertex, target_->vertex, *target_);
    for (const std::int32_t f : source_->faces)
      if (std::find(target_->faces.begin(), target_->faces.end(), f) != target_->faces.end()) face = f;
    if (source_->vertex >= 0 && source_->vertex == target_->vertex) return back;
    back.faces.push_back(face);
    back.points.push_back(source_->position);
    return reversed(back);
  }
  trace_to_source(vertex, back);
  return reversed(back);
}

template SurfacePath Propagation<double>::path_to(std::int32_t) const;
template SurfacePath Propagation<DoubleDouble>::path_to(std::int32_t) const;
template SurfacePath Propagation<double>::path() const;
template SurfacePath Propagation<DoubleDouble>::path() const;

}  // namespace leastcost
