// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Obstacles from OctoMap files, written here byte by byte, and a robot among many of them.
#include <Eigen/Core>
#include <cmath>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/catalogue/catalogue.hpp>
#include <leastcost/octomap/octomap_obstacles.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;
using Eigen::Vector3d;

enum OctreeChild : unsigned { unknown = 0, free = 1, occupied = 2, inner = 3 };

/// A node of a .bt file: 2 bits a child, the first child lowest. OctreeChild i is above the middle in x for bit 0 of i,
/// in y for bit 1, in z for bit 2.
std::string node(const std::vector<std::pair<int, OctreeChild>>& children) {
  unsigned bits = 0;
  for (const auto& [number, child] : children) bits |= static_cast<unsigned>(child) << (2 * number);
  return {static_cast<char>(bits & 0xFF), static_cast<char>(bits >> 8)};
}

/// With as many nodes as there are.
std::string file_of(const std::string& nodes, const std::string& resolution = "0.5") {
  int count = 1;
  for (const char byte : nodes)
    for (int k = 0; k < 8; k += 2) count += ((static_cast<unsigned char>(byte) >> k) & 3) != 0 ? 1 : 0;
  return "# Octomap OcTree binary file\nid OcTree\nsize " + std::to_string(count) + "\nres " + resolution + "\ndata\n" +
         nodes;
}

/// From the root down to the block of 2^levels cells along each axis whose lowest corner is the origin; `last`: its
/// nodes.
std::string chain(int levels, const std::string& last) {
  std::string nodes = node({{7, inner}});                                         // x, y, z > 0
  for (int level = 1; level < 16 - levels; ++level) nodes += node({{0, inner}});  // towards the origin
  return nodes + last;
}

std::vector<std::shared_ptr<const Obstacle>> read(const std::string& bytes, OctomapOptions options = {}) {
  const ScratchDir dir;
  options.file = "map.bt";
  std::ofstream(dir / options.file, std::ios::binary) << bytes;
  return read_octomap(options, dir.path());
}

double distance(const std::vector<std::shared_ptr<const Obstacle>>& all, const Vector3d& x) {
  double least = 1e300;
  Eigen::VectorXd away(3);
  for (const auto& one : all) least = std::min(least, one->distance(x, away));
  return least;
}

std::string refusal(const std::string& bytes) {
  try {
    read(bytes);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("octomap: leaves of two sizes are where the file says, free and unknown ones are not there") {
  // Of the block of 4 x 4 x 4 cells at the origin: one leaf of 2 x 2 x 2 cells, and in another octant single cells.
  const std::string nodes = chain(2, node({{1, occupied}, {2, inner}, {4, free}}) +  // at x > 2, y > 2, z > 2 cells
                                         node({{0, occupied}, {3, occupied}, {5, free}}));  // in that of y > 2
  const auto all = read(file_of(nodes));
  CHECK(all.size() == 3);
  CHECK(distance(all, {1.5, 0.5, 0.5}) < 0);  // [1, 2] x [0, 1] x [0, 1]
  CHECK(distance(all, {3, 0.5, 0.5}) == Approx(1));
  CHECK(distance(all, {0.25, 1.25, 0.25}) == Approx(-0.25));        // a cell of 0.5 at (0, 1, 0)
  CHECK(distance(all, {0.75, 1.75, 0.25}) == Approx(-0.25));        // and at (0.5, 1.5, 0)
  CHECK(distance(all, {0.25, 1.75, 0.25}) == Approx(0.25));         // not between them
  CHECK(distance(all, {0.5, 0.5, 1.5}) == Approx(std::sqrt(0.5)));  // free
  const auto moved =
      read(file_of(nodes), {.pose = {.position = Vector3d(10, 0, 0), .rpy = Vector3d(0, 0, 3.14159265358979324 / 2)}});
  CHECK(distance(moved, {9.5, 1.5, 0.5}) == Approx(-0.5));
}

TEST_CASE("octomap: neighbours are merged, with the same union") {
  const std::vector<std::pair<int, OctreeChild>> full = {{0, occupied}, {1, occupied}, {2, occupied}, {3, occupied},
                                                         {4, occupied}, {5, occupied}, {6, occupied}, {7, occupied}};
  const auto one = read(file_of(chain(1, node(full))));
  REQUIRE(one.size() == 1);
  CHECK(one[0]->core_bounds().max() == Vector3d(1, 1, 1));
  CHECK(one[0]->core_bounds().min() == Vector3d(0, 0, 0));
  const std::vector<std::pair<int, OctreeChild>> floor(full.begin(), full.begin() + 4);
  CHECK(read(file_of(chain(1, node(floor)))).size() == 1);
}

TEST_CASE("octomap: files that are none are refused in words") {
  const std::string whole = file_of(chain(2, node({{1, occupied}})));
  CHECK(refusal(whole) == "");
  CHECK_THAT(refusal("ply\n"), Contains("map.bt: is not an OctoMap file"));
  CHECK_THAT(refusal(""), Contains("is not an OctoMap file"));
  for (std::size_t cut = 1; cut < 29; cut += 3)
    CHECK_THAT(refusal(whole.substr(0, whole.size() - cut)), Contains("broken or cut off"));
  CHECK_THAT(refusal(whole.substr(0, 50)), Contains("header of the octomap is cut off"));
  CHECK_THAT(refusal(file_of(chain(2, node({{1, free}})))), Contains("no occupied leaf"));
  for (const char* wrong : {"0", "-1", "nan", "much"})
    CHECK_THAT(refusal(file_of(chain(2, node({{1, occupied}})), wrong)), Contains("the octomap"));
  std::string deep;
  for (int k = 0; k < 100000; ++k) deep += node({{0, inner}});
  CHECK_THAT(refusal(file_of(deep)), Contains("broken or cut off"));  // deeper than a tree can be
}

TEST_CASE("octomap: a certified plan in space around its boxes") {
  const ScratchDir dir;
  std::ofstream(dir / "map.bt", std::ios::binary) << file_of(chain(2, node({{0, occupied}})));  // [0, 1]^3
  const std::string text =
      "manifold: {type: euclidean, dimension: 3}\nobstacles: [{type: octomap, file: " + (dir / "map.bt").string() +
      "}]\nclearance: 0.1\ncost: euclidean\n"
      "ends: {source: {point: [-1, 0.4, 0.8]}, target: {point: [2, 0.6, 0.7]}}\n";
  const RunOutcome outcome = solve(parse_run(text, "a.yaml", dir.path()));
  CHECK(outcome.result.status == Status::certified);
  REQUIRE(outcome.result.certificate.clearance.has_value());
  CHECK(outcome.result.certificate.clearance->lower >= -1e-9);
  CHECK(outcome.result.path.u.row(2).maxCoeff() > 1.05);  // over the box
  CHECK_THAT(outcome.result.certificate.clearance->obstacle, Contains("the octomap map.bt"));
}

}  // namespace leastcost::test
