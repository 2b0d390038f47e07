// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "tests/problems/exact_reference.hpp"

#include <algorithm>

#include "problems/mesh/surface_walk.hpp"

namespace leastcost::test {
namespace {

const Long kNever = std::numeric_limits<Long>::infinity();
const Long kGrazing = Long("1e-28");  // relative: rays through a vertex count as seeing it, and as passing it

constexpr std::size_t kLongestList = 20000;  // rows from one point

Long cross_of(const std::array<Long, 2>& a, const std::array<Long, 2>& b) { return a[0] * b[1] - a[1] * b[0]; }
Long dot_of(const std::array<Long, 2>& a, const std::array<Long, 2>& b) { return a[0] * b[0] + a[1] * b[1]; }
Long dot3(const std::array<Long, 3>& a, const std::array<Long, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
std::array<Long, 3> minus3(const std::array<Long, 3>& a, const std::array<Long, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

}  // namespace

ExactReference::ExactReference(const TriangleMesh& mesh, const std::vector<SurfacePoint>& extra)
    : mesh_(&mesh), inside_(static_cast<std::size_t>(mesh.face_count())) {
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Eigen::Vector3d& p = mesh.position(v);
    place_.push_back({Long(p.x()), Long(p.y()), Long(p.z())});
    const auto faces = mesh.faces_of_vertex(v);
    faces_.emplace_back(faces.begin(), faces.end());
  }
  for (const SurfacePoint& p : extra) {
    Point3 at = {0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        at[i] +=
            Long(p.barycentric[static_cast<int>(k)]) * Long(mesh.position(mesh.face(p.face)[k])[static_cast<int>(i)]);
    std::vector<std::int32_t> faces;
    faces_at(mesh, place_of(mesh, p), faces);
    for (const std::int32_t f : faces) inside_[static_cast<std::size_t>(f)].push_back(place_.size());
    place_.push_back(at);
    faces_.push_back(faces);
  }
  count_ = place_.size();
  distance_.assign(count_ * count_, kNever);
  const auto close = [&] {
    for (std::size_t k = 0; k < count_; ++k)
      for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t j = 0; j < count_; ++j)
          if (distance(i, k) + distance(k, j) < distance(i, j))
            distance_[i * count_ + j] = distance(i, k) + distance(k, j);
  };
  for (std::size_t i = 0; i < count_; ++i) {
    keep(i, i, 0);
    for (std::size_t j = 0; j < count_; ++j)
      for (const std::int32_t f : faces_[i])
        if (in_face(j, f)) {
          const Point3 d = minus3(place_[i], place_[j]);
          keep(i, j, sqrt(dot3(d, d)));
        }
  }
  close();
  for (std::size_t i = 0; i < count_; ++i) {
    Long longest = 0;
    for (std::size_t j = 0; j < count_; ++j)
      if (distance(i, j) < kNever) longest = std::max(longest, distance(i, j));
    shoot(i, longest);
    if (!complete_) return;
  }
  close();
}

bool ExactReference::in_face(std::size_t point, std::int32_t face) const {
  return std::find(faces_[point].begin(), faces_[point].end(), face) != faces_[point].end();
}

void ExactReference::keep(std::size_t from, std::size_t to, const Long& length) {
  if (!(length < distance(from, to))) return;
  distance_[from * count_ + to] = length;
  distance_[to * count_ + from] = length;
}

/// A point of the face entered, in the plane: on the other side of the edge than the origin.
ExactReference::Point2 ExactReference::beyond(const Row& row, std::size_t point) const {
  const Point3 edge = minus3(place_[row.second], place_[row.first]), to = minus3(place_[point], place_[row.first]);
  const Long squared = dot3(edge, edge), along = dot3(edge, to) / squared;
  const Long off = dot3(to, to) / squared - along * along;
  const Point2 e = {row.b[0] - row.a[0], row.b[1] - row.a[1]};
  Long height = off > 0 ? Long(sqrt(off)) : Long(0);
  if (cross_of(e, {-row.a[0], -row.a[1]}) > 0) height = -height;  // the origin is on the left
  return {row.a[0] + along * e[0] - height * e[1], row.a[1] + along * e[1] + height * e[0]};
}

/// The sides of all other faces at the edge of h: two and more of them where sheets meet.
std::vector<std::int32_t> ExactReference::behind(std::int32_t h) const {
  std::vector<std::int32_t> sides;
  const auto ends = std::minmax({mesh_->tail(h), mesh_->head(h)});
  for (std::int32_t g = 0; g < 3 * mesh_->face_count(); ++g)
    if (g != h && ends == std::minmax({mesh_->tail(g), mesh_->head(g)})) sides.push_back(g);
  return sides;
}

void ExactReference::start(std::size_t from, std::int32_t face, std::vector<Row>& open) const {
  for (std::int32_t h = 3 * face; h < 3 * face + 3; ++h)
    for (const std::int32_t other : behind(h)) {
      if (in_face(from, face) && in_face(from, other / 3)) continue;  // from the edge itself
      Row row{other, static_cast<std::size_t>(mesh_->tail(h)), static_cast<std::size_t>(mesh_->head(h)), {}, {}, {},
              {}};
      if (from == row.first || from == row.second) continue;
      const Point3 edge = minus3(place_[row.second], place_[row.first]), to = minus3(place_[from], place_[row.first]);
      const Long length = sqrt(dot3(edge, edge)), along = dot3(edge, to) / length;
      const Long off = dot3(to, to) - along * along;
      if (!(off > 0)) continue;
      row.a = {-along, -Long(sqrt(off))};
      row.b = {length - along, row.a[1]};
      row.low = row.a;
      row.high = row.b;
      open.push_back(row);
    }
}

void ExactReference::shoot(std::size_t from, const Long& longest) {
  std::vector<Row> open;
  for (const std::int32_t f : faces_[from]) start(from, f, open);
  for (std::size_t rows = 0; !open.empty(); ++rows) {
    if (rows > kLongestList) {
      complete_ = false;
      return;
    }
    const Row row = open.back();
    open.pop_back();
    enter(from, row, longest, open);
  }
}

void ExactReference::enter(std::size_t from, const Row& row, const Long& longest, std::vector<Row>& open) {
  const std::int32_t h = row.across;
  const auto sees = [&row](const Point2& p) {
    const Long length = sqrt(dot_of(p, p));
    return cross_of(row.low, p) >= -kGrazing * length * sqrt(dot_of(row.low, row.low)) &&
           cross_of(p, row.high) >= -kGrazing * length * sqrt(dot_of(row.high, row.high));
  };
  const std::size_t corner = static_cast<std::size_t>(mesh_->tail(TriangleMesh::previous(h)));
  const Point2 c = beyond(row, corner);
  if (sees(c)) keep(from, corner, sqrt(dot_of(c, c)));
  for (const std::size_t extra : inside_[static_cast<std::size_t>(h / 3)]) {
    const Point2 p = beyond(row, extra);
    if (sees(p)) keep(from, extra, sqrt(dot_of(p, p)));
  }
  for (const std::int32_t out : {TriangleMesh::next(h), TriangleMesh::previous(h)}) {
    const bool keeps_first = static_cast<std::size_t>(mesh_->tail(out)) == row.first ||
                             static_cast<std::size_t>(mesh_->head(out)) == row.first;
    Row next{-1, keeps_first ? row.first : row.second, corner, keeps_first ? row.a : row.b, c, {}, {}};
    Point2 low = next.a, high = next.b;
    if (cross_of(low, high) < 0) std::swap(low, high);
    next.low = cross_of(row.low, low) > 0 ? low : row.low;
    next.high = cross_of(high, row.high) > 0 ? high : row.high;
    if (!(cross_of(next.low, next.high) > 0)) continue;
    const Point2 d = {next.b[0] - next.a[0], next.b[1] - next.a[1]};
    Long s = -dot_of(next.a, d) / dot_of(d, d);
    s = s < 0 ? Long(0) : s > 1 ? Long(1) : s;
    const Point2 near = {next.a[0] + s * d[0], next.a[1] + s * d[1]};
    if (dot_of(near, near) > longest * longest) continue;
    for (const std::int32_t entered : behind(out)) {
      next.across = entered;
      open.push_back(next);
    }
  }
}

}  // namespace leastcost::test
