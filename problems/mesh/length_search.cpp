// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/length_search.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <new>

#include <leastcost/problems/mesh/surface_path.hpp>
#include "problems/mesh/edge_landmarks.hpp"

namespace leastcost {
namespace {

constexpr std::size_t kChildren = 4;
constexpr int kLookEvery = 256;  // settled vertices between two questions to the stop predicate
/// Floats of two lengths are off by half of this, relative to the longer.
constexpr float kFloatRounding = 4 * std::numeric_limits<float>::epsilon();

/// The vertices and the two ends of a search.
std::size_t record_count(const TriangleMesh& mesh) { return static_cast<std::size_t>(mesh.vertex_count()) + 2; }

std::int32_t face_with_both(const TriangleMesh& mesh, std::int32_t a, std::int32_t b) {
  for (const std::int32_t f : mesh.faces_of_vertex(a)) {
    const std::array<std::int32_t, 3>& c = mesh.face(f);
    if (std::find(c.begin(), c.end(), b) != c.end()) return f;
  }
  return -1;
}

/// The side of face f that vertex v is not on.
std::int32_t far_side(const TriangleMesh& mesh, std::int32_t f, std::int32_t v) {
  const std::array<std::int32_t, 3>& c = mesh.face(f);
  return 3 * f + (c[0] == v ? 1 : c[1] == v ? 2 : 0);
}

}  // namespace

LengthSearch::LengthSearch(const TriangleMesh& mesh)
    : mesh_(&mesh), records_(static_cast<Record*>(std::calloc(record_count(mesh), sizeof(Record)))) {
  if (!records_) throw std::bad_alloc();
}

LengthSearch::Record& LengthSearch::record(std::int32_t node) {
  Record& r = records_[static_cast<std::size_t>(node)];
  if (r.stamp != stamp_) r = Record{.stamp = stamp_, .predecessor = node, .rest = rest_from(node)};
  return r;
}

Eigen::Vector3d LengthSearch::position(std::int32_t node) const {
  if (is_vertex(node)) return mesh_->position(node);
  return mesh_->point(node == mesh_->vertex_count() ? source_point_ : target_point_);
}

/// Squared length of b - a in the metric, length units squared.
double LengthSearch::squared_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
  if (options_->metric) [[unlikely]]
    return (*options_->metric * (b - a)).squaredNorm();
  return (b - a).squaredNorm();
}

double LengthSearch::length_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
  return std::sqrt(squared_between(a, b));
}

/// The straight line, and what the landmarks leave open.
double LengthSearch::rest_from(std::int32_t node) const {
  if (!aims_) return 0;
  const double straight = length_between(position(node), goal_);
  if (target_fields_.empty() || !is_vertex(node)) return straight;
  float best = 0;
  const std::span<const float> fields = options_->landmarks->of(node);
  for (std::size_t i = 0; i < fields.size(); ++i)
    best = std::max(best,
                    std::abs(fields[i] - target_fields_[i]) - kFloatRounding * std::max(fields[i], target_fields_[i]));
  return std::max(straight, static_cast<double>(best));
}

void LengthSearch::begin(const LengthSearchOptions& options) {
  if (++stamp_ == 0) {  // wrapped around after four thousand million queries
    std::fill_n(records_.get(), record_count(*mesh_), Record{});
    stamp_ = 1;
  }
  options_ = &options;
  open_.clear();
  target_fields_.clear();
  target_corners_ = {-1, -1, -1};
  settled_ = 0;
  aims_ = false;
}

void LengthSearch::aim(const SurfacePoint& source, const SurfacePoint& target) {
  source_point_ = source;
  target_point_ = target;
  const std::int32_t s = vertex_at(*mesh_, source), t = vertex_at(*mesh_, target);
  source_ = s >= 0 ? s : mesh_->vertex_count();
  target_ = t >= 0 ? t : mesh_->vertex_count() + 1;
  if (t < 0) target_corners_ = mesh_->face(target.face);
  goal_ = position(target_);
  aims_ = true;
  if (options_->landmarks != nullptr) look_at_landmarks();
}

/// Their distances to the target: a landmark in another component says nothing, and infinite values only get in the
/// way.
void LengthSearch::look_at_landmarks() {
  const EdgeLandmarks& landmarks = *options_->landmarks;
  target_fields_.assign(static_cast<std::size_t>(landmarks.count()), std::numeric_limits<float>::infinity());
  const auto by_way_of = [&](std::int32_t v, double further) {
    const std::span<const float> fields = landmarks.of(v);
    for (std::size_t i = 0; i < fields.size(); ++i)
      target_fields_[i] = std::min(target_fields_[i], static_cast<float>(static_cast<double>(fields[i]) + further));
  };
  if (is_vertex(target_))
    by_way_of(target_, 0);
  else
    for (const std::int32_t corner : target_corners_) by_way_of(corner, length_between(mesh_->position(corner), goal_));
  if (!std::all_of(target_fields_.begin(), target_fields_.end(), [](float f) { return std::isfinite(f); }))
    target_fields_.clear();
}

// ---------------------------------------------------------------- the heap

void LengthSearch::push(Open entry) {
  std::size_t i = open_.size();
  open_.push_back(entry);
  while (i > 0) {
    const std::size_t parent = (i - 1) / kChildren;
    if (!(entry.key < open_[parent].key)) break;
    open_[i] = open_[parent];
    i = parent;
  }
  open_[i] = entry;
}

LengthSearch::Open LengthSearch::pop() {
  const Open top = open_.front(), last = open_.back();
  open_.pop_back();
  const std::size_t count = open_.size();
  if (count == 0) return top;
  std::size_t i = 0;
  while (true) {
    const std::size_t first = kChildren * i + 1, end = std::min(first + kChildren, count);
    if (first >= count) break;
    std::size_t least = first;
    for (std::size_t c = first + 1; c < end; ++c)
      if (open_[c].key < open_[least].key) least = c;
    if (!(open_[least].key < last.key)) break;
    open_[i] = open_[least];
    i = least;
  }
  open_[i] = last;
  return top;
}

// ---------------------------------------------------------------- the search

void LengthSearch::relax(std::int32_t from, Record& r, std::int32_t to, double length) {
  if (!(length < r.length)) return;
  r.length = length;
  r.predecessor = from;
  push({length + r.rest, to});
}

/// Straight to `to`, the third corner behind the edge of `halfedge`, if that crosses the edge between its ends.
LengthSearch::Diagonal LengthSearch::across(const Eigen::Vector3d& from, std::int32_t halfedge, std::int32_t to) const {
  const Eigen::Vector3d& tail = mesh_->position(mesh_->tail(halfedge));
  Eigen::Vector3d e = mesh_->position(mesh_->head(halfedge)) - tail, a = from - tail, b = mesh_->position(to) - tail;
  if (options_->metric) {
    const Eigen::Matrix3d& root = *options_->metric;
    e = Eigen::Vector3d(root * e);
    a = Eigen::Vector3d(root * a);
    b = Eigen::Vector3d(root * b);
  }
  const double squared = e.squaredNorm(), along_a = a.dot(e), along_b = b.dot(e);
  const double height_a = e.cross(a).norm(), height_b = e.cross(b).norm(), depth = height_a + height_b;
  if (!(squared > 0) || !(depth > 0)) return {};
  const double at = (along_a * height_b + along_b * height_a) / (squared * depth);
  if (!(at > 0) || !(at < 1)) return {};
  return {std::sqrt(((along_b - along_a) * (along_b - along_a) + depth * depth) / squared), at};
}

/// Most moves make nothing shorter: they are found out by squares, before any root.
void LengthSearch::leave_across(std::int32_t node, const Eigen::Vector3d& from, double so_far) {
  for (const std::int32_t f : mesh_->faces_of_vertex(node)) {
    const std::int32_t h = far_side(*mesh_, f, node), other = mesh_->across(h);
    if (other < 0) continue;
    const std::int32_t to = mesh_->tail(TriangleMesh::previous(other));
    Record& r = record(to);
    const double gain = r.length - so_far;
    if (gain > 0 && to != node && squared_between(from, mesh_->position(to)) < gain * gain)
      relax(node, r, to, so_far + across(from, h, to).length);
  }
}

void LengthSearch::leave(std::int32_t node) {
  const Eigen::Vector3d from = position(node);
  const double so_far = record(node).length;
  const auto go = [&](std::int32_t to) { relax(node, record(to), to, so_far + length_between(from, position(to))); };
  if (!is_vertex(node)) {  // the source, inside a face
    for (const std::int32_t corner : mesh_->face(source_point_.face)) go(corner);
    if (!is_vertex(target_) && target_point_.face == source_point_.face) go(target_);
    return;
  }
  for (const std::int32_t to : mesh_->neighbours(node)) {
    Record& r = record(to);
    const double gain = r.length - so_far;
    if (!(gain > 0)) continue;
    const double squared = squared_between(from, mesh_->position(to));
    if (squared < gain * gain) relax(node, r, to, so_far + std::sqrt(squared));
  }
  if (options_->diagonals) leave_across(node, from, so_far);
  if (std::find(target_corners_.begin(), target_corners_.end(), node) != target_corners_.end()) go(target_);
}

EdgePathOutcome LengthSearch::run() {
  record(source_).length = 0;
  push({record(source_).rest, source_});
  while (!open_.empty()) {
    const Open next = pop();
    const Record& r = record(next.node);
    if (next.key > r.length + r.rest) continue;  // a shorter way was found since
    if (next.node == target_) return EdgePathOutcome::found;
    if (++settled_ % kLookEvery == 0 && options_->stop && options_->stop()) return EdgePathOutcome::stopped;
    leave(next.node);
  }
  return EdgePathOutcome::no_finite_route;
}

EdgePath LengthSearch::shortest(const SurfacePoint& source, const SurfacePoint& target,
                                const LengthSearchOptions& options) {
  EdgePath result;
  const std::int32_t from = mesh_->component(mesh_->face(source.face)[0]);
  const std::int32_t to = mesh_->component(mesh_->face(target.face)[0]);
  result.source_component_size = mesh_->component_sizes()[static_cast<std::size_t>(from)];
  result.target_component_size = mesh_->component_sizes()[static_cast<std::size_t>(to)];
  if (from != to) {
    result.outcome = EdgePathOutcome::different_components;
    return result;
  }
  begin(options);
  aim(source, target);
  result.outcome = run();
  result.settled = settled_;
  if (!result.found()) return result;
  result.cost = record(target_).length;
  result.path = path_found(result.vertices);
  return result;
}

std::vector<double> LengthSearch::lengths_from(std::int32_t vertex, const LengthSearchOptions& options) {
  LengthSearchOptions all = options;
  all.diagonals = true;
  begin(all);
  source_ = vertex;
  target_ = -1;
  run();
  std::vector<double> lengths(static_cast<std::size_t>(mesh_->vertex_count()));
  for (std::int32_t v = 0; v < mesh_->vertex_count(); ++v) lengths[static_cast<std::size_t>(v)] = record(v).length;
  return lengths;
}

// ---------------------------------------------------------------- the path

/// Appends the piece from -> to: through the edge it crosses where that is shorter.
void LengthSearch::append_move(std::int32_t from, std::int32_t to, SurfacePath& path) const {
  const Eigen::Vector3d a = position(from), b = position(to);
  const auto add = [&path](const Eigen::Vector3d& p, std::int32_t face) {
    path.points.push_back(p);
    path.faces.push_back(face);
  };
  if (!is_vertex(from)) return add(b, source_point_.face);
  if (!is_vertex(to)) return add(b, target_point_.face);
  const std::int32_t face = face_with_both(*mesh_, from, to);
  double best = face >= 0 ? length_between(a, b) : std::numeric_limits<double>::infinity();
  std::int32_t door = -1;
  double at = 0;
  if (options_->diagonals)
    for (const std::int32_t f : mesh_->faces_of_vertex(from)) {
      const std::int32_t h = far_side(*mesh_, f, from), other = mesh_->across(h);
      if (other < 0 || mesh_->tail(TriangleMesh::previous(other)) != to) continue;
      const Diagonal diagonal = across(a, h, to);
      if (!(diagonal.length < best)) continue;
      best = diagonal.length;
      door = h;
      at = diagonal.at;
    }
  if (door < 0) return add(b, face);
  const Eigen::Vector3d& tail = mesh_->position(mesh_->tail(door));
  add(tail + at * (mesh_->position(mesh_->head(door)) - tail), door / 3);
  add(b, mesh_->across(door) / 3);
}

SurfacePath LengthSearch::path_found(std::vector<std::int32_t>& vertices) const {
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
