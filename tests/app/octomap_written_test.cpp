// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Files that OctoMap itself writes: .ot and .bt, with and without colours.
#include <leastcost/octomap/octomap_obstacles.hpp>

#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>

#include <cmath>
#include <string>

#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

constexpr double kCell = 0.1;
constexpr int kCells = 8;  ///< along each axis, from -4 to 3

/// A block of 2 x 2 x 2 cells that octomap joins into one leaf, a wall, and single cells.
bool is_wall(int x, int y, int z) {
  return (x >= 0 && x < 2 && y >= 0 && y < 2 && z >= 0 && z < 2) || x == -3 || (x + 2 * y + 4 * z) % 11 == 0;
}

octomap::point3d middle(int x, int y, int z) {
  const auto at = [](int k) { return static_cast<float>(kCell * (k + 0.5)); };
  return {at(x), at(y), at(z)};
}

template <class Visit>
void for_each_cell(const Visit& visit) {
  for (int x = -kCells / 2; x < kCells / 2; ++x)
    for (int y = -kCells / 2; y < kCells / 2; ++y)
      for (int z = -kCells / 2; z < kCells / 2; ++z) visit(x, y, z);
}

/// Occupied and free cells; those of an eighth are not known.
template <class Tree>
void fill(Tree& tree) {
  for_each_cell([&](int x, int y, int z) {
    if (is_wall(x, y, z) || (x < 2 && y < 2)) tree.updateNode(middle(x, y, z), is_wall(x, y, z));
  });
}

/// Whether what is read is occupied where the tree says.
void check_read(const std::string& file, const ScratchDir& folder) {
  const auto all = read_octomap({.file = file}, folder.path());
  CAPTURE(file, all.size());
  Eigen::VectorXd away(3);
  int walls = 0;
  for_each_cell([&](int x, int y, int z) {
    const Eigen::Vector3d place = kCell * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
    double least = 1e300;
    for (const auto& one : all) least = std::min(least, one->distance(place, away));
    CAPTURE(x, y, z);
    CHECK((least < 0) == is_wall(x, y, z));
    CHECK(std::abs(least) > 0.4 * kCell);
    walls += is_wall(x, y, z) ? 1 : 0;
  });
  CHECK(walls > 100);
  CHECK(static_cast<int>(all.size()) < walls);
}

}  // namespace

TEST_CASE("octomap: trees that the library wrote with and without colours") {
  const ScratchDir folder;
  octomap::OcTree plain(kCell);
  fill(plain);
  REQUIRE(plain.write((folder / "plain.ot").string()));
  REQUIRE(plain.writeBinary((folder / "plain.bt").string()));
  octomap::ColorOcTree coloured(kCell);
  fill(coloured);
  for_each_cell([&](int x, int y, int z) {
    coloured.setNodeColor(coloured.coordToKey(middle(x, y, z)), static_cast<std::uint8_t>(20 * (x + 4)), 7, 200);
  });
  coloured.updateInnerOccupancy();
  REQUIRE(coloured.write((folder / "coloured.ot").string()));
  for (const char* file : {"plain.ot", "plain.bt", "coloured.ot"}) check_read(file, folder);
}

}  // namespace leastcost::test
