// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/edge_query.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <new>

#include <leastcost/problems/mesh/surface_path.hpp>

namespace leastcost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kStopInterval = 32;  // settled nodes between two questions to the stop predicate: a move may be dear

/// The crossing point of edge ab on the straight line from c (one side) to d (other side) in the unfolding, if it is
/// strictly inside the edge.
bool unfolded_crossing(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                       const Eigen::Vector3d& d, Eigen::Vector3d& crossing) {
  const Eigen::Vector3d e = b - a;
  const double squared = e.squaredNorm();
  const double hc = e.cross(c - a).norm(), hd = e.cross(d - a).norm();
  if (!(squared > 0) || !(hc + hd > 0)) return false;
  const double t = ((c - a).dot(e) * hd + (d - a).dot(e) * hc) / (squared * (hc + hd));
  crossing = a + t * e;
  return t > 0 && t < 1;
}

/// The vertices and the two ends of a search.
std::size_t node_count(const TriangleMesh& mesh) { return static_cast<std::size_t>(mesh.vertex_count()) + 2; }

std::int32_t face_along(const TriangleMesh& mesh, std::int32_t a, std::int32_t b) {
  for (const std::int32_t f : mesh.faces_of_vertex(a)) {
    const std::array<std::int32_t, 3>& c = mesh.face(f);
    if (std::find(c.begin(), c.end(), b) != c.end()) return f;
  }
  return -1;
}

}  // namespace

void Free::operator()(NodeRecord* records) const { std::free(records); }

EdgeQuery::EdgeQuery(const TriangleMesh& mesh)
    : mesh_(&mesh), records_(static_cast<NodeRecord*>(std::calloc(node_count(mesh), sizeof(NodeRecord)))) {
  if (!records_) throw std::bad_alloc();
}

void EdgeQuery::begin(const SurfacePoint& source, const SurfacePoint& target, const MoveCost& cost,
                      const EdgePathOptions& options) {
  if (++stamp_ == 0) {  // wrapped around after four thousand million queries
    std::fill_n(records_.get(), node_count(*mesh_), NodeRecord{});
    stamp_ = 1;
  }
  source_point_ = source;
  target_point_ = target;
  const std::int32_t s = vertex_at(*mesh_, source), t = vertex_at(*mesh_, target);
  source_ = s >= 0 ? s : mesh_->vertex_count();
  target_ = t >= 0 ? t : mesh_->vertex_count() + 1;
  target_corners_ = t >= 0 ? std::array<std::int32_t, 3>{-1, -1, -1} : mesh_->face(target.face);
  cost_ = &cost;
  options_ = &options;
  settled_ = 0;
}

Eigen::Vector3d EdgeQuery::position(std::int32_t node) const {
  if (is_vertex(node)) return mesh_->position(node);
  return mesh_->point(node == mesh_->vertex_count() ? source_point_ : target_point_);
}

double EdgeQuery::bound(std::int32_t node) const {
  return options_->lower_bound ? options_->lower_bound(position(node)) : 0.0;
}

bool EdgeQuery::settle() {
  ++settled_;
  return settled_ % kStopInterval == 0 && options_->stop && options_->stop();
}

void EdgeQuery::try_move(std::int32_t from, const Eigen::Vector3d& a, std::int32_t to) {
  if (record(to).state == NodeState::settled) return;  // a consistent bound never opens it again
  const double cost = (*cost_)(a, position(to));
  if (cost < kInfinity) moves_.push_back({from, to, cost});
}

template <class Visit>
void EdgeQuery::for_diagonals(std::int32_t from, Visit visit) const {
  for (const std::int32_t f : mesh_->faces_of_vertex(from)) {
    std::int32_t h = 3 * f;
    while (mesh_->tail(h) == from || mesh_->head(h) == from) ++h;
    const std::int32_t other = mesh_->across(h);
    if (other < 0) continue;
    Diagonal diagonal{h, mesh_->tail(TriangleMesh::previous(other))};
    if (diagonal.to != from) visit(diagonal);
  }
}

bool EdgeQuery::cross_straight(const Eigen::Vector3d& a, Diagonal& diagonal) const {
  const std::int32_t h = diagonal.across_edge;
  return unfolded_crossing(mesh_->position(mesh_->tail(h)), mesh_->position(mesh_->head(h)), a,
                           mesh_->position(diagonal.to), diagonal.crossing);
}

double EdgeQuery::cost_of(const Eigen::Vector3d& a, const Diagonal& diagonal) const {
  return (*cost_)(a, diagonal.crossing) + (*cost_)(diagonal.crossing, mesh_->position(diagonal.to));
}

void EdgeQuery::try_diagonals(std::int32_t from, const Eigen::Vector3d& a) {
  for_diagonals(from, [&](Diagonal& diagonal) {
    if (record(diagonal.to).state == NodeState::settled || !cross_straight(a, diagonal)) return;
    const double cost = cost_of(a, diagonal);
    if (cost < kInfinity) moves_.push_back({from, diagonal.to, cost});
  });
}

const std::vector<Move>& EdgeQuery::moves_from(std::int32_t node) {
  moves_.clear();
  const Eigen::Vector3d a = position(node);
  if (!is_vertex(node)) {  // the source, inside a face
    for (const std::int32_t corner : mesh_->face(source_point_.face)) try_move(node, a, corner);
    if (!is_vertex(target_) && target_point_.face == source_point_.face) try_move(node, a, target_);
    return moves_;
  }
  for (const std::int32_t w : mesh_->neighbours(node)) try_move(node, a, w);
  if (options_->diagonals) try_diagonals(node, a);
  if (std::find(target_corners_.begin(), target_corners_.end(), node) != target_corners_.end())
    try_move(node, a, target_);
  return moves_;
}

/// Appends the piece from -> to: through the edge it crosses where the search found that cheapest.
void EdgeQuery::append_move(std::int32_t from, std::int32_t to, SurfacePath& path) const {
  const Eigen::Vector3d a = position(from), b = position(to);
  const auto add = [&path](const Eigen::Vector3d& p, std::int32_t face) {
    path.points.push_back(p);
    path.faces.push_back(face);
  };
  if (!is_vertex(from)) return add(b, source_point_.face);
  if (!is_vertex(to)) return add(b, target_point_.face);
  const std::int32_t face = face_along(*mesh_, from, to);
  double best = face >= 0 ? (*cost_)(a, b) : kInfinity;
  Diagonal chosen;
  if (options_->diagonals) {
    for_diagonals(from, [&](Diagonal& diagonal) {
      if (diagonal.to != to || !cross_straight(a, diagonal)) return;
      const double cost = cost_of(a, diagonal);
      if (cost >= best) return;
      best = cost;
      chosen = diagonal;
    });
  }
  if (chosen.across_edge < 0) return add(b, face);
  add(chosen.crossing, chosen.across_edge / 3);
  add(b, mesh_->across(chosen.across_edge) / 3);
}

SurfacePath EdgeQuery::path_found(std::vector<std::int32_t>& vertices) const {
  std::vector<std::int32_t> nodes{target_};
  while (nodes.back() != source_) nodes.push_back(records_[static_cast<std::size_t>(nodes.back())].predecessor);
  std::reverse(nodes.begin(), nodes.end());
  SurfacePath path;
  path.points.push_back(position(source_));
  for (std::size_t i = 1; i < nodes.size(); ++i) append_move(nodes[i - 1], nodes[i], path);
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(vertices),
               [this](std::int32_t n) { return is_vertex(n); });
  return path;
}

}  // namespace leastcost
