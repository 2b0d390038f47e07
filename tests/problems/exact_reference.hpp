// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdint>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost::test {

/// 120 bits: what double cancels is still there.
using Long =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<120, boost::multiprecision::digit_base_2>,
                                  boost::multiprecision::et_off>;

/// Shortest distances by brute force, in other numbers and by another way than the library's: all straight lines
/// between points of a small mesh, over every row of faces, without any pruning but by length, and the shortest routes
/// over these lines. Costs what the rows are: meshes of a few dozen faces.
class ExactReference {
 public:
  /// Points: all vertices, then `extra`.
  ExactReference(const TriangleMesh& mesh, const std::vector<SurfacePoint>& extra);
  /// Between points i and j; infinite where there is no path.
  const Long& distance(std::size_t i, std::size_t j) const { return distance_[i * count_ + j]; }
  std::size_t count() const { return count_; }
  /// False: too many rows of faces for brute force; the distances are upper bounds then.
  bool complete() const { return complete_; }

 private:
  using Point3 = std::array<Long, 3>;
  using Point2 = std::array<Long, 2>;
  struct Row {  // a bundle of straight lines from the origin that is about to enter a face over the edge a - b
    std::int32_t across;        // half-edge of that face
    std::size_t first, second;  // points: the ends of the edge
    Point2 a, b, low, high;     // their places; the bundle lies counterclockwise from `low` to `high`
  };
  void shoot(std::size_t from, const Long& longest);
  void enter(std::size_t from, const Row& row, const Long& longest, std::vector<Row>& open);
  void start(std::size_t from, std::int32_t face, std::vector<Row>& open) const;
  void keep(std::size_t from, std::size_t to, const Long& length);
  bool in_face(std::size_t point, std::int32_t face) const;
  std::vector<std::int32_t> behind(std::int32_t h) const;
  Point2 beyond(const Row& row, std::size_t point) const;

  const TriangleMesh* mesh_;
  std::size_t count_;
  bool complete_ = true;
  std::vector<Point3> place_;
  std::vector<std::vector<std::int32_t>> faces_;  // of each point
  std::vector<std::vector<std::size_t>> inside_;  // extra points of each face
  std::vector<Long> distance_;
};

}  // namespace leastcost::test
