// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/half_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace leastcost {
namespace {

template <class Real>
using Triple = std::array<Real, 3>;

template <class Real>
Triple<Real> difference(const Eigen::Vector3d& b, const Eigen::Vector3d& a) {
  return {Real(b.x()) - Real(a.x()), Real(b.y()) - Real(a.y()), Real(b.z()) - Real(a.z())};
}

template <class Real>
Real dot(const Triple<Real>& a, const Triple<Real>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
Real norm(const Triple<Real>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

template <class Real>
Triple<Real> cross(const Triple<Real>& a, const Triple<Real>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

template <class Real>
Side<Real> make_side(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Triple<Real> edge = difference<Real>(b, a), from_a = difference<Real>(c, a), from_b = difference<Real>(c, b);
  Side<Real> side;
  side.length = norm(edge);
  if (!(side.length > Real(0.0))) return side;
  side.x = dot(edge, from_a) / side.length;
  side.back = Real(0.0) - dot(edge, from_b) / side.length;
  // The shorter of the two: rounding of the product is relative to it.
  const bool near_a = dot(from_a, from_a) < dot(from_b, from_b);
  const Triple<Real>& shorter = near_a ? from_a : from_b;
  side.y = norm(cross(edge, shorter)) / side.length;
  const double noise = 2 * kSideError * kRoundingOf<Real> * static_cast<double>(norm(shorter));
  if (!(static_cast<double>(side.y) > noise)) side.y = Real(0.0);
  return side;
}

template Side<double> make_side<double>(const Eigen::Vector3d&, const Eigen::Vector3d&, const Eigen::Vector3d&);
template Side<DoubleDouble> make_side<DoubleDouble>(const Eigen::Vector3d&, const Eigen::Vector3d&,
                                                    const Eigen::Vector3d&);

HalfEdges::HalfEdges(const TriangleMesh& mesh, const Deadline& deadline) : mesh_(&mesh) {
  const std::int32_t sides = 3 * mesh.face_count(), vertices = mesh.vertex_count();
  tail_.resize(at(sides));
  across_.resize(at(sides));
  sides_.resize(at(sides));
  for (std::int32_t h = 0; h < sides; ++h) {
    look_at_clock(deadline, h);
    tail_[at(h)] = mesh.tail(h);
    across_[at(h)] = mesh.across(h);
    sides_[at(h)] =
        make_side<double>(position(mesh.tail(h)), position(mesh.head(h)), position(mesh.tail(mesh.previous(h))));
  }
  look_at_clock(deadline);
  for (const Side<double>& s : sides_) {
    mean_edge_ += s.length / static_cast<double>(sides);
    longest_edge_ = std::max(longest_edge_, s.length);
  }
  for (const Eigen::Vector3d& p : mesh.positions()) reach_ = std::max(reach_, p.lpNorm<Eigen::Infinity>());
  begin_.reserve(at(vertices) + 1);
  corners_.reserve(at(sides));
  corner_of_.assign(at(sides), -1);
  kind_.resize(at(vertices));
  angle_.resize(at(vertices));
  turn_error_.resize(at(vertices));
  std::vector<std::int32_t> open;
  for (std::int32_t v = 0; v < vertices; ++v) {
    look_at_clock(deadline, v);
    begin_.push_back(static_cast<std::int32_t>(corners_.size()));
    lay_out(v, open);
  }
  begin_.push_back(static_cast<std::int32_t>(corners_.size()));
}

/// Walks around v, from a border where there is one; what the walk does not reach are other fans.
void HalfEdges::lay_out(std::int32_t v, std::vector<std::int32_t>& open) {
  open.clear();
  for (const std::int32_t f : mesh_->faces_of_vertex(v))
    for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h)
      if (tail(h) == v) open.push_back(h);
  const std::size_t degree = open.size();
  bool joint = false, border = false;
  Corner first{open.front(), 0, 0, true};
  for (const std::int32_t h : open) {
    const std::int32_t by_itself = across(h), by_previous = across(TriangleMesh::previous(h));
    joint = joint || by_itself == TriangleMesh::kNonManifold || by_previous == TriangleMesh::kNonManifold ||
            !(side(h).y > 0);
    if (by_itself >= 0 && by_previous >= 0) continue;
    first = {h, 0, 0, by_itself < 0};
    border = true;
  }
  const std::size_t start = corners_.size();
  Corner next = first;
  double sum = 0;
  std::size_t met = 0;
  while (met < degree) {
    const std::int32_t h = next.halfedge;
    if (corner_of_[at(h)] >= 0) break;  // all around
    const double angle =
        side(h).length > 0 ? std::atan2(side(h).y, side(h).x) : std::numbers::pi / 2;  // a joint: of no use
    next.begin = sum;
    next.end = sum += angle;
    corner_of_[at(h)] = static_cast<std::int32_t>(corners_.size());
    corners_.push_back(next);
    ++met;
    const std::int32_t leaves = next.forward ? TriangleMesh::previous(h) : h;
    const std::int32_t enters = across(leaves);
    if (enters < 0) break;
    const bool by_tail = tail(enters) == v;
    next = {by_tail ? enters : TriangleMesh::next(enters), 0, 0, by_tail};
  }
  if (met < degree) {
    joint = true;
    for (const std::int32_t h : open) {
      if (corner_of_[at(h)] >= 0) continue;
      corner_of_[at(h)] = static_cast<std::int32_t>(corners_.size());
      corners_.push_back({h, 0, std::atan2(side(h).y, side(h).x), true});
    }
  }
  angle_[at(v)] = sum;
  turn_error_[at(v)] = kSideError * kRoundingOf<double> * static_cast<double>(corners_.size() - start + 1);
  const double over = sum - 2 * std::numbers::pi;
  kind_[at(v)] = joint                        ? VertexKind::joint
                 : border                     ? VertexKind::border
                 : over < -turn_error_[at(v)] ? VertexKind::convex
                 : over > turn_error_[at(v)]  ? VertexKind::saddle
                                              : VertexKind::flat;
}

}  // namespace leastcost
