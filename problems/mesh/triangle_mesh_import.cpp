// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Construction of TriangleMesh: from polygons to triangles, welding, subdivision. The tables that follow from the
// triangles alone are made in triangle_mesh_adjacency.cpp.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include "framework/base/point_text.hpp"
#include "framework/base/sound_size.hpp"
#include "problems/mesh/edge_table.hpp"
#include "problems/mesh/polygon_triangulation.hpp"
#include "problems/mesh/weld.hpp"

namespace leastcost {
namespace {

/// Halfedges are numbered in 32 bits.
constexpr std::int64_t kMaxFaces = std::numeric_limits<std::int32_t>::max() / 3;

std::string place(const PolygonSoup& soup) { return (soup.source.empty() ? std::string("mesh") : soup.source) + ": "; }

std::string counted(std::size_t n, const std::string& thing) {
  return std::to_string(n) + " " + thing + (n == 1 ? "" : "s");
}

void check_positions(const PolygonSoup& soup) {
  if (soup.positions.size() > static_cast<std::size_t>(kMaxFaces)) {
    throw InputError(place(soup) + "too many vertices for 32-bit numbers");
  }
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    if (soup.positions[v].allFinite() && soup.positions[v].cwiseAbs().maxCoeff() <= kGreatestSize) continue;
    throw InputError(
        place(soup) + "vertex " + std::to_string(v) +
        " has a coordinate that is not finite or is beyond 1e75; use finite coordinates in sensible units");
  }
}

void check_polygons(const PolygonSoup& soup) {
  const std::vector<std::int32_t>& begin = soup.polygon_begin;
  if (begin.size() < 2) throw InputError(place(soup) + "no faces; a surface needs at least one");
  // A polygon of m corners becomes m - 2 triangles.
  if (soup.corners.size() > static_cast<std::size_t>(kMaxFaces) + 2 * (begin.size() - 1)) {
    throw InputError(place(soup) + "too many faces for 32-bit numbers");
  }
  if (begin.front() != 0 || static_cast<std::size_t>(begin.back()) != soup.corners.size()) {
    throw InputError(place(soup) + "polygon_begin must run from 0 to the number of corners");
  }
  const std::int32_t vertex_count = static_cast<std::int32_t>(soup.positions.size());
  for (std::size_t p = 0; p + 1 < begin.size(); ++p) {
    if (begin[p + 1] - static_cast<std::int64_t>(begin[p]) < 3) {
      throw InputError(place(soup) + "face " + std::to_string(p) + " has fewer than 3 corners");
    }
  }
  for (std::size_t i = 0; i < soup.corners.size(); ++i) {
    if (soup.corners[i] >= 0 && soup.corners[i] < vertex_count) continue;
    const auto polygon = std::upper_bound(begin.begin(), begin.end(), static_cast<std::int32_t>(i)) - begin.begin() - 1;
    throw InputError(place(soup) + "face " + std::to_string(polygon) + " uses vertex " +
                     std::to_string(soup.corners[i]) + ", but there are " + std::to_string(vertex_count) +
                     " vertices (numbered from 0)");
  }
}

/// The corners of polygon p as places in soup.corners, without those that repeat the corner before them.
void distinct_corners(const PolygonSoup& soup, std::size_t p, const std::vector<std::int32_t>& same_as,
                      std::vector<std::int32_t>& result) {
  const auto vertex = [&](std::int32_t i) {
    return same_as[static_cast<std::size_t>(soup.corners[static_cast<std::size_t>(i)])];
  };
  result.clear();
  for (std::int32_t i = soup.polygon_begin[p]; i < soup.polygon_begin[p + 1]; ++i) {
    if (result.empty() || vertex(result.back()) != vertex(i)) result.push_back(i);
  }
  while (result.size() > 1 && vertex(result.back()) == vertex(result.front())) result.pop_back();
}

/// Cuts polygons into triangles, of places in the corner list.
class PolygonCutter {
 public:
  explicit PolygonCutter(const PolygonSoup& soup) : soup_(soup) {}

  const std::vector<std::array<std::int32_t, 3>>& cut(std::size_t polygon, const std::vector<std::int32_t>& places) {
    triangles_.clear();
    if (places.size() < 3) return triangles_;
    if (places.size() == 3) {
      triangles_.push_back({places[0], places[1], places[2]});
      return triangles_;
    }
    points_.clear();
    for (const std::int32_t i : places) {
      points_.push_back(soup_.positions[static_cast<std::size_t>(soup_.corners[static_cast<std::size_t>(i)])]);
    }
    const Triangulation triangulation = triangulate(polygon);
    const auto place_of = [&](std::int32_t corner) { return places[static_cast<std::size_t>(corner)]; };
    for (const auto& [a, b, c] : triangulation.triangles) triangles_.push_back({place_of(a), place_of(b), place_of(c)});
    ++polygons_;
    made_ += triangles_.size();
    crossing_ += triangulation.simple ? 0 : 1;
    return triangles_;
  }

  void note(std::vector<std::string>& notes) const {
    if (polygons_ > 0) notes.push_back(counted(polygons_, "polygon") + " cut into " + counted(made_, "triangle"));
    if (crossing_ > 0)
      notes.push_back(counted(crossing_, "polygon") + " intersected themselves, so some triangles overlap");
  }

 private:
  Triangulation triangulate(std::size_t polygon) const {
    try {
      return triangulate_polygon(points_);
    } catch (const InputError& error) {
      throw InputError(place(soup_) + "face " + std::to_string(polygon) + " " + error.what());
    }
  }

  const PolygonSoup& soup_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<std::array<std::int32_t, 3>> triangles_;
  std::size_t polygons_ = 0, made_ = 0, crossing_ = 0;
};

void check_subdivision(std::size_t base_faces, int levels) {
  if (levels < 0) throw OptionError("subdivide", "must not be negative, got " + std::to_string(levels));
  std::int64_t faces = static_cast<std::int64_t>(base_faces);
  for (int level = 0; level < levels; ++level) {
    faces *= 4;
    if (faces <= kMaxFaces) continue;
    throw OptionError("subdivide", std::to_string(levels) + " levels of " + std::to_string(base_faces) +
                                       " faces make more than " + std::to_string(kMaxFaces) + " faces; at most " +
                                       std::to_string(level) + " levels are possible");
  }
}

}  // namespace

TriangleMesh::TriangleMesh(const PolygonSoup& soup, const MeshOptions& options) : source_(soup.source) {
  check_positions(soup);
  check_polygons(soup);
  std::vector<std::int32_t> same_as;
  if (!(options.weld_within >= 0) || !std::isfinite(options.weld_within))
    throw OptionError("weld", "must be true, false or a distance above 0");
  if (options.weld_within > 0) {
    same_as = lowest_within(soup.positions, options.weld_within);
  } else if (options.weld) {
    same_as = lowest_equal(soup.positions);
  } else {
    same_as.resize(soup.positions.size());
    std::iota(same_as.begin(), same_as.end(), 0);
  }
  const Deadline& deadline = options.deadline;
  import_polygons(soup, same_as, deadline);
  check_subdivision(faces_.size(), options.subdivide);
  for (int level = 0; level < options.subdivide; ++level) {
    look_at_clock(deadline);
    subdivide_once();
  }
  measure_diameter();
  build_adjacency(deadline);
  const std::vector<double> angles = corner_angles(deadline);
  build_vertex_tables(angles, deadline);
  build_normals(angles, deadline);
  look_at_clock(deadline);
  build_components();
}

void TriangleMesh::import_polygons(const PolygonSoup& soup, const std::vector<std::int32_t>& same_as,
                                   const Deadline& deadline) {
  const std::size_t polygon_count = soup.polygon_begin.size() - 1;
  const auto corner = [&](std::int32_t i) { return soup.corners[static_cast<std::size_t>(i)]; };
  const auto vertex = [&](std::int32_t i) { return same_as[static_cast<std::size_t>(corner(i))]; };
  faces_.reserve(polygon_count);
  base_file_vertices_.reserve(polygon_count);
  base_file_face_.reserve(polygon_count);
  base_begin_.reserve(polygon_count + 1);
  base_begin_.push_back(0);
  PolygonCutter cutter(soup);
  std::vector<std::int32_t> places;
  std::size_t dropped = 0;
  for (std::size_t p = 0; p < polygon_count; ++p) {
    look_at_clock(deadline, static_cast<std::int64_t>(p));
    distinct_corners(soup, p, same_as, places);
    for (const auto& [a, b, c] : cutter.cut(p, places)) {
      // A vertex that a polygon visits twice can make a triangle without area.
      if (vertex(a) == vertex(b) || vertex(b) == vertex(c) || vertex(c) == vertex(a)) continue;
      faces_.push_back({vertex(a), vertex(b), vertex(c)});
      base_file_vertices_.push_back({corner(a), corner(b), corner(c)});
      base_file_face_.push_back(static_cast<std::int32_t>(p));
    }
    dropped += base_begin_.back() == static_cast<std::int32_t>(faces_.size()) ? 1 : 0;
    base_begin_.push_back(static_cast<std::int32_t>(faces_.size()));
  }
  cutter.note(notes_);
  if (dropped > 0)
    notes_.push_back(counted(dropped, "degenerate face") + " left out (fewer than three different corners)");
  if (faces_.empty())
    throw InputError(place(soup) + "no face with three different corners; a surface needs at least one");
  look_at_clock(deadline);
  number_vertices(soup, same_as);
}

void TriangleMesh::number_vertices(const PolygonSoup& soup, const std::vector<std::int32_t>& same_as) {
  std::vector<std::int32_t> number(soup.positions.size(), -1);
  for (const auto& corners : faces_) {
    for (const std::int32_t v : corners) number[static_cast<std::size_t>(v)] = 0;
  }
  const auto used = static_cast<std::size_t>(std::count(number.begin(), number.end(), 0));
  positions_.reserve(used);
  file_vertex_.reserve(used);
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<std::int32_t>(positions_.size());
    positions_.push_back(soup.positions[v]);
    file_vertex_.push_back(static_cast<std::int32_t>(v));
  }
  for (auto& corners : faces_) {
    for (std::int32_t& v : corners) v = number[static_cast<std::size_t>(v)];
  }
  std::size_t merged = 0, unused = 0;
  double farthest = 0;
  vertex_of_file_.resize(number.size());
  for (std::size_t v = 0; v < number.size(); ++v) {
    vertex_of_file_[v] = number[static_cast<std::size_t>(same_as[v])];
    merged += same_as[v] != static_cast<std::int32_t>(v) ? 1 : 0;
    farthest = std::max(farthest, (soup.positions[v] - soup.positions[static_cast<std::size_t>(same_as[v])]).norm());
    unused += vertex_of_file_[v] < 0 ? 1 : 0;
  }
  if (merged > 0)
    notes_.push_back(std::to_string(merged) + " vertices merged into others " +
                     (farthest > 0 ? "up to " + short_number(farthest) + " away" : "at the same position"));
  if (unused > 0)
    notes_.push_back(std::to_string(unused) + " vertices of the file are not in any face and were left out");
}

void TriangleMesh::subdivide_once() {
  const EdgeTable edges = make_edge_table(faces_, vertex_count());
  const std::int32_t old_count = vertex_count();
  std::vector<std::int32_t> middle(3 * faces_.size());  // per halfedge, its new vertex
  positions_.reserve(positions_.size() + edges.ends.size());
  for (std::int32_t e = 0; e < edges.size(); ++e) {
    const auto& [a, b] = edges.ends[static_cast<std::size_t>(e)];
    positions_.emplace_back(0.5 * position(a) + 0.5 * position(b));
    for (const std::int32_t h : edges.of(e)) middle[static_cast<std::size_t>(h)] = old_count + e;
  }
  file_vertex_.resize(positions_.size(), -1);
  std::vector<std::array<std::int32_t, 3>> fine;
  fine.reserve(4 * faces_.size());
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const std::array<std::int32_t, 3>& v = faces_[f];
    const std::int32_t m01 = middle[3 * f], m12 = middle[3 * f + 1], m20 = middle[3 * f + 2];
    // Child k keeps corner k in place k; in the middle child, corner k lies opposite to corner k. locate() relies on
    // it.
    fine.push_back({v[0], m01, m20});
    fine.push_back({m01, v[1], m12});
    fine.push_back({m20, m12, v[2]});
    fine.push_back({m12, m20, m01});
  }
  faces_ = std::move(fine);
  ++subdivisions_;
}

void TriangleMesh::measure_diameter() {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : positions_) box.extend(p);
  const double extent = box.sizes().maxCoeff();
  if (extent > 0) check_sound_size((source_.empty() ? std::string("mesh") : source_) + ": the extent", extent);
  diameter_ = box.diagonal().norm();
}

}  // namespace leastcost
