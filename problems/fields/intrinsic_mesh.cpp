// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/intrinsic_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

/// Below this sum of two cotangents, an edge is not Delaunay; rounding alone flips nothing.
constexpr double kNotDelaunay = -1e-9;
/// Flips between two looks at the stop request.
constexpr std::int64_t kFlipsBetweenLooks = 4096;

std::size_t index_of(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Twice the area of a triangle, by Kahan's order of Heron's formula: good on needles; 0 where rounding leaves none.
double double_area(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  if (b < c) std::swap(b, c);
  if (a < b) std::swap(a, b);
  const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return product > 0 ? 0.5 * std::sqrt(product) : 0;
}

}  // namespace

IntrinsicMesh::IntrinsicMesh(const TriangleMesh& mesh) {
  if (!mesh.non_manifold_edges().empty()) {
    const auto [a, b] = mesh.non_manifold_edges().front();
    throw InputError(mesh.source() + ": the edge between vertices " + std::to_string(mesh.file_vertex(a)) + " and " +
                     std::to_string(mesh.file_vertex(b)) +
                     " has three or more faces; heat distances need a mesh whose edges have at most two");
  }
  vertices_ = mesh.faces();
  lengths_.resize(vertices_.size());
  across_.resize(3 * vertices_.size());
  turned_.assign(across_.size(), 0);
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    length(h) = (mesh.position(mesh.head(h)) - mesh.position(mesh.tail(h))).norm();
    across_[index_of(h)] = mesh.across(h);
  }
  for (const std::int32_t h : mesh.flipped_halfedges()) turned_[index_of(h)] = 1;
}

double IntrinsicMesh::area(std::int32_t f) const {
  const auto& [a, b, c] = lengths(f);
  return 0.5 * double_area(a, b, c);
}

std::array<double, 3> IntrinsicMesh::cotangents(std::int32_t f) const {
  const auto& l = lengths(f);
  const double four_areas = 4 * area(f);
  std::array<double, 3> result{0, 0, 0};
  if (!(four_areas > 0)) return result;
  for (std::size_t k = 0; k < 3; ++k) {
    const double own = l[k], p = l[(k + 1) % 3], q = l[(k + 2) % 3];
    result[k] = (p * p + q * q - own * own) / four_areas;
  }
  return result;
}

double IntrinsicMesh::mean_length() const {
  double sum = 0;
  for (const auto& l : lengths_) sum += l[0] + l[1] + l[2];
  return sum / (3 * static_cast<double>(lengths_.size()));
}

double IntrinsicMesh::cotangent_sum(std::int32_t h) const {
  const std::int32_t g = across_[index_of(h)];
  return cotangents(h / 3)[index_of(h % 3)] + cotangents(g / 3)[index_of(g % 3)];
}

void IntrinsicMesh::glue(std::int32_t h, std::int32_t g) {
  across_[index_of(h)] = g;
  if (g >= 0) across_[index_of(g)] = h;
}

bool IntrinsicMesh::flip(std::int32_t h) {
  const std::int32_t g = across_[index_of(h)];
  const std::int32_t f = h / 3, e = g / 3;
  if (f == e) return false;
  const std::int32_t h1 = TriangleMesh::next(h), h2 = TriangleMesh::previous(h);
  const std::int32_t g1 = TriangleMesh::next(g), g2 = TriangleMesh::previous(g);
  const auto corner = [&](std::int32_t x) { return vertices_[index_of(x / 3)][index_of(x % 3)]; };
  // h: a -> b with c beyond; g: b -> a with d beyond. Laid out with a at the origin and b on the x axis.
  const std::int32_t a = corner(h), b = corner(h1), c = corner(h2), d = corner(g2);
  const double ab = length(h), bc = length(h1), ca = length(h2), ad = length(g1), db = length(g2);
  if (!(ab > 0)) return false;
  const double cx = (ab * ab + ca * ca - bc * bc) / (2 * ab), cy = double_area(ab, bc, ca) / ab;
  const double dx = (ab * ab + ad * ad - db * db) / (2 * ab), dy = -double_area(ab, ad, db) / ab;
  const double between = cy - dy;
  if (!(between > 0)) return false;
  const double crossing = cx + (dx - cx) * cy / between;
  if (!(crossing > 0 && crossing < ab)) return false;  // not convex: rounding on needles
  const double cd = std::hypot(cx - dx, cy - dy);
  struct Outer {
    std::int32_t across;
    char turned;
    double length;
  };
  const auto outer = [&](std::int32_t x) { return Outer{across_[index_of(x)], turned_[index_of(x)], length(x)}; };
  const Outer ob = outer(h1), oc = outer(h2), oa = outer(g1), od = outer(g2);
  // f becomes d -> c -> a: sides dc, ca, ad. e becomes c -> d -> b: sides cd, db, bc.
  vertices_[index_of(f)] = {d, c, a};
  vertices_[index_of(e)] = {c, d, b};
  const std::int32_t f0 = 3 * f, e0 = 3 * e;
  const std::array<std::pair<std::int32_t, std::int32_t>, 4> moved = {
      {{h2, f0 + 1}, {g1, f0 + 2}, {g2, e0 + 1}, {h1, e0 + 2}}};
  const auto place = [&](std::int32_t x, const Outer& o) {
    std::int32_t other = o.across;
    for (const auto& [before, after] : moved)
      if (other == before) {  // two of the four sides are one edge
        other = after;
        break;
      }
    across_[index_of(x)] = other;
    turned_[index_of(x)] = o.turned;
    length(x) = o.length;
    if (other >= 0) across_[index_of(other)] = x;
  };
  length(f0) = length(e0) = cd;
  turned_[index_of(f0)] = turned_[index_of(e0)] = 0;
  glue(f0, e0);
  place(f0 + 1, oc);
  place(f0 + 2, oa);
  place(e0 + 1, od);
  place(e0 + 2, ob);
  return true;
}

std::int64_t IntrinsicMesh::make_delaunay(const std::function<bool()>& stop) {
  std::vector<std::int32_t> open;
  for (std::int32_t h = 0; h < 3 * face_count(); ++h)
    if (across_[index_of(h)] > h) open.push_back(h);
  std::int64_t flips = 0;
  // Each flip lowers the Dirichlet energy, so that this ends; the bound is for what rounding may do.
  const std::int64_t most = 1000 * static_cast<std::int64_t>(open.size()) + 1000;
  while (!open.empty() && flips < most) {
    const std::int32_t h = open.back();
    open.pop_back();
    if (across_[index_of(h)] < 0 || turned_[index_of(h)] != 0 || !(cotangent_sum(h) < kNotDelaunay)) continue;
    const std::int32_t f = h / 3, e = across_[index_of(h)] / 3;
    if (!flip(h)) continue;
    for (const std::int32_t x : {3 * f + 1, 3 * f + 2, 3 * e + 1, 3 * e + 2}) open.push_back(x);
    if (++flips % kFlipsBetweenLooks == 0 && stop && stop()) break;
  }
  return flips;
}

}  // namespace leastcost
