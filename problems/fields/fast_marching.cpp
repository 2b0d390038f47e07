// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/fields/fast_marching.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "problems/mesh/surface_walk.hpp"

namespace leastcost {

/// Vertex v gets its distance from those of a and b, seen at the lengths and the angle of a (real or virtual) triangle.
struct MarchingStencil {
  std::int32_t v, a, b;
  double to_a, to_b, cosine;
};

namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();
/// Faces that are unfolded behind an obtuse corner before the corner is left undivided.
constexpr int kMostUnfolded = 50;
/// Looks at the stop request once in so many vertices.
constexpr int kBetweenLooks = 256;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The distance at v of a plane wave that passes a and b; infinite where it does not come through between them.
double wave(const MarchingStencil& s, double at_a, double at_b) {
  const double squared_sine = 1 - s.cosine * s.cosine;
  const double determinant = s.to_a * s.to_a * s.to_b * s.to_b * squared_sine;
  if (!(determinant > 0)) return kUnreached;
  // (M' M)^-1 for M = [a - v, b - v]
  Eigen::Matrix2d q;
  q << s.to_b * s.to_b, -s.to_a * s.to_b * s.cosine, -s.to_a * s.to_b * s.cosine, s.to_a * s.to_a;
  q /= determinant;
  const double base = std::min(at_a, at_b);
  const Eigen::Vector2d one(1, 1), d(at_a - base, at_b - base);
  const Eigen::Vector2d q_one = q * one;
  const double square = one.dot(q_one), linear = d.dot(q_one), constant = d.dot(q * d) - 1;
  const double root = linear * linear - square * constant;
  if (root < 0) return kUnreached;
  const double t = (linear + std::sqrt(root)) / square;
  const Eigen::Vector2d towards = q * (t * one - d);  // against the gradient, in terms of a - v and b - v
  if (towards.minCoeff() < 0) return kUnreached;
  return base + t;
}

struct VirtualCorner {
  std::int32_t vertex;
  Eigen::Vector2d place;
};

/// The first vertex that lies at acute angles from both sides of the obtuse corner of face h / 3 opposite to h, in the
/// plane where the corner is the origin and the ends of h lie at a (its tail) and b.
std::optional<VirtualCorner> divide(const TriangleMesh& mesh, std::int32_t h, Eigen::Vector2d a, Eigen::Vector2d b) {
  const Eigen::Vector2d side_a = a, side_b = b;
  std::int32_t at_a = mesh.tail(h);
  for (int i = 0; i < kMostUnfolded; ++i) {
    const std::int32_t g = mesh.across(h);
    if (g < 0) return {};
    const std::int32_t third = mesh.head(TriangleMesh::next(g));
    const std::int32_t tail = mesh.tail(g), head = mesh.head(g);
    const Eigen::Vector3d edge = mesh.position(head) - mesh.position(tail);
    const Eigen::Vector3d to_third = mesh.position(third) - mesh.position(tail);
    const double length = edge.norm();
    if (!(length > 0)) return {};
    const double along = edge.dot(to_third) / length;
    const double off = std::sqrt(std::max(0.0, to_third.squaredNorm() - along * along));
    const bool tail_at_a = tail == at_a;
    const Eigen::Vector2d from = tail_at_a ? a : b, to = tail_at_a ? b : a;
    const Eigen::Vector2d direction = (to - from) / length;
    Eigen::Vector2d normal(-direction.y(), direction.x());
    if (normal.dot(from) < 0) normal = -normal;  // away from the corner at the origin
    const Eigen::Vector2d place = from + along * direction + off * normal;
    const bool beyond_a = place.dot(side_a) <= 0, beyond_b = place.dot(side_b) <= 0;
    if (!beyond_a && !beyond_b) return VirtualCorner{third, place};
    // The door of the section that is left: beyond the right angle from a, the vertex replaces b, and the other way.
    const bool replaces_b = beyond_a;
    (replaces_b ? b : a) = place;
    const std::int32_t kept = replaces_b ? at_a : (tail_at_a ? head : tail);
    if (!replaces_b) at_a = third;
    const std::int32_t first = TriangleMesh::next(g), second = TriangleMesh::previous(g);
    h = mesh.tail(first) == kept || mesh.head(first) == kept ? first : second;
  }
  return {};
}

void add_stencils(const TriangleMesh& mesh, std::int32_t h, std::vector<MarchingStencil>& all) {
  const std::int32_t a = mesh.tail(h), b = mesh.head(h), v = mesh.head(TriangleMesh::next(h));
  const Eigen::Vector3d va = mesh.position(a) - mesh.position(v), vb = mesh.position(b) - mesh.position(v);
  const double to_a = va.norm(), to_b = vb.norm();
  if (!(to_a > 0) || !(to_b > 0)) return;
  const double cosine = std::clamp(va.dot(vb) / (to_a * to_b), -1.0, 1.0);
  if (cosine < 0) {
    const Eigen::Vector2d place_a(to_a, 0), place_b(to_b * cosine, to_b * std::sqrt(1 - cosine * cosine));
    if (const auto middle = divide(mesh, h, place_a, place_b)) {
      const double to_m = middle->place.norm();
      if (cross(place_a, middle->place) > 0 && cross(middle->place, place_b) > 0) {
        all.push_back({v, a, middle->vertex, to_a, to_m, place_a.dot(middle->place) / (to_a * to_m)});
        all.push_back({v, middle->vertex, b, to_m, to_b, middle->place.dot(place_b) / (to_m * to_b)});
        return;
      }
    }
  }
  all.push_back({v, a, b, to_a, to_b, cosine});
}

}  // namespace

struct FastMarching::Tables {
  const TriangleMesh* mesh;
  std::vector<MarchingStencil> stencils;
  std::vector<std::int32_t> begin, of_vertex;  // stencils that vertex w passes a distance on through
};

FastMarching::FastMarching(const TriangleMesh& mesh) {
  auto tables = std::make_unique<Tables>();
  tables->mesh = &mesh;
  tables->stencils.reserve(3 * at(mesh.face_count()));
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) add_stencils(mesh, h, tables->stencils);
  std::vector<std::int32_t>& begin = tables->begin;
  begin.assign(at(mesh.vertex_count()) + 1, 0);
  for (const MarchingStencil& s : tables->stencils) ++begin[at(s.a) + 1], ++begin[at(s.b) + 1];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
  tables->of_vertex.resize(2 * tables->stencils.size());
  for (std::size_t i = 0; i < tables->stencils.size(); ++i)
    for (const std::int32_t w : {tables->stencils[i].a, tables->stencils[i].b})
      tables->of_vertex[at(next[at(w)]++)] = static_cast<std::int32_t>(i);
  tables_ = std::move(tables);
}

FastMarching::~FastMarching() = default;
FastMarching::FastMarching(FastMarching&&) noexcept = default;
FastMarching& FastMarching::operator=(FastMarching&&) noexcept = default;

std::vector<double> FastMarching::distances(const SurfacePoint& source, const FastMarchingOptions& options) const {
  const TriangleMesh& mesh = *tables_->mesh;
  std::vector<double> distance(at(mesh.vertex_count()), kUnreached);
  std::vector<char> known(distance.size(), 0);
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto offer = [&](std::int32_t v, double d) {
    if (known[at(v)] || !(d < distance[at(v)])) return;
    distance[at(v)] = d;
    open.emplace(d, v);
  };
  const Place start = place_of(mesh, source);
  std::vector<std::int32_t> faces;
  faces_at(mesh, start, faces);
  if (start.vertex >= 0) offer(start.vertex, 0);
  for (const std::int32_t f : faces)  // all around the source distances are straight
    for (const std::int32_t v : mesh.face(f)) offer(v, (mesh.position(v) - start.position).norm());
  for (int count = 1; !open.empty(); ++count) {
    const auto [d, w] = open.top();
    open.pop();
    if (known[at(w)]) continue;
    known[at(w)] = 1;
    if (w == options.target || (count % kBetweenLooks == 0 && options.stop && options.stop())) break;
    for (std::int32_t i = tables_->begin[at(w)]; i < tables_->begin[at(w) + 1]; ++i) {
      const MarchingStencil& s = tables_->stencils[at(tables_->of_vertex[at(i)])];
      if (known[at(s.v)]) continue;
      offer(s.v, d + (w == s.a ? s.to_a : s.to_b));
      if (known[at(s.a)] && known[at(s.b)]) offer(s.v, wave(s, distance[at(s.a)], distance[at(s.b)]));
    }
  }
  return distance;
}

std::vector<double> fast_marching_distances(const TriangleMesh& mesh, const SurfacePoint& source,
                                            const FastMarchingOptions& options) {
  return FastMarching(mesh).distances(source, options);
}

}  // namespace leastcost
