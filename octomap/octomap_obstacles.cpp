// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/octomap/octomap_obstacles.hpp>

#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include "octomap/merge_boxes.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;
namespace fs = std::filesystem;

/// Blocks of the finest cells, which a leaf is 2^k of along each axis.
template <class Tree>
std::vector<CellBlock> occupied(const Tree& tree) {
  std::vector<CellBlock> blocks;
  for (auto leaf = tree.begin_leafs(), end = tree.end_leafs(); leaf != end; ++leaf) {
    if (!tree.isNodeOccupied(*leaf)) continue;
    const std::int64_t size = std::int64_t{1} << (tree.getTreeDepth() - leaf.getDepth());
    CellBlock block;
    const octomap::OcTreeKey key = leaf.getIndexKey();  // of its lowest cell
    for (unsigned axis = 0; axis < 3; ++axis) {
      block.lower[axis] = std::int64_t{key[axis]} - (std::int64_t{1} << (tree.getTreeDepth() - 1));
      block.upper[axis] = block.lower[axis] + size;
    }
    blocks.push_back(block);
  }
  return blocks;
}

struct Map {
  std::vector<CellBlock> blocks;
  double resolution = 0;
};

/// What a file says before its data.
struct Header {
  bool binary = false;
  std::string type = "OcTree";
  std::int64_t size = 0;  ///< nodes
  double resolution = 0;
};

Header read_header(std::istream& in, const std::string& file) {
  Header header;
  std::string line;
  std::getline(in, line);
  header.binary = line.rfind("# Octomap OcTree binary", 0) == 0;
  if (!header.binary && line.rfind("# Octomap OcTree file", 0) != 0)
    throw InputError(file + ": is not an OctoMap file: the first line of one begins with '# Octomap OcTree'");
  std::string word;
  while (in >> word && word != "data") {
    if (word == "id") in >> header.type;
    if (word == "size") in >> header.size;
    if (word == "res") in >> header.resolution;
    std::getline(in, line);
  }
  in.get();  // the end of the line
  if (!in.good()) throw InputError(file + ": the header of the octomap is cut off");
  if (!(header.resolution > 0) || !std::isfinite(header.resolution))
    throw InputError(file + ": the octomap has no resolution greater than 0");
  if (header.type != "OcTree" && header.type != "ColorOcTree")
    throw InputError(file + ": holds a tree of the type " + header.type + "; give an OcTree or a ColorOcTree");
  return header;
}

/// Whether the nodes end where the file says so: of one that is cut off the library would read what is not there.
bool is_whole(std::istream& in, const Header& header) {
  const int deepest = header.binary ? 15 : 16;  // of what has children; leaves of other files are nodes as well
  const std::streamsize before = header.binary ? 0 : header.type == "OcTree" ? 4 : 7;  // value, and colour
  std::int64_t nodes = 1;
  std::vector<int> depths = {0};  // of the nodes that are still to come
  while (!depths.empty()) {
    const int depth = depths.back();
    depths.pop_back();
    if (depth > deepest) return false;
    in.ignore(before);
    unsigned children = static_cast<unsigned char>(in.get());
    int inner = std::popcount(children), all = inner;
    if (header.binary) {  // two bits for each child: both are set of one that is no leaf
      children |= static_cast<unsigned>(static_cast<unsigned char>(in.get())) << 8;
      inner = std::popcount(children & (children >> 1) & 0x5555U);
      all = std::popcount((children | (children >> 1)) & 0x5555U);
    }
    if (!in.good()) return false;
    nodes += all;
    depths.insert(depths.end(), static_cast<std::size_t>(inner), depth + 1);
  }
  return nodes == header.size;
}

/// Not by the functions for whole files, which write to the standard error what they read.
template <class Tree>
Map read_nodes(std::istream& in, const Header& header) {
  Tree tree(header.resolution);
  if (header.binary)
    tree.readBinaryData(in);
  else
    tree.readData(in);
  return {occupied(tree), header.resolution};
}

Map read_map(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in.good()) throw InputError(file.string() + ": cannot be opened");
  const Header header = read_header(in, file.string());
  if (header.size <= 0) return {{}, header.resolution};
  const std::streampos data = in.tellg();
  if (!is_whole(in, header)) throw InputError(file.string() + ": the octomap is broken or cut off");
  in.clear();
  in.seekg(data);
  return header.type == "OcTree" ? read_nodes<octomap::OcTree>(in, header)
                                 : read_nodes<octomap::ColorOcTree>(in, header);
}

}  // namespace

void OctomapOptions::fields(FieldVisitor& visit) {
  visit.file("file", file, {.help = "OctoMap file, .bt or .ot.", .required = true});
  visit_pose(visit, pose);
}

std::vector<std::shared_ptr<const Obstacle>> read_octomap(const OctomapOptions& options, const fs::path& folder) {
  constexpr std::size_t kMostBoxes = 200000;
  const Eigen::Isometry3d pose = pose_of(options.pose, 3);
  const fs::path file = folder / options.file;
  const Map map = read_map(file);
  if (map.blocks.empty()) throw InputError(file.string() + ": the octomap has no occupied leaf");
  const std::vector<CellBlock> blocks = merged(map.blocks);
  if (blocks.size() > kMostBoxes)
    throw InputError(file.string() + ": the octomap has more than " + std::to_string(kMostBoxes) +
                     " boxes; coarsen it, or cut out the part around the robot");
  const std::string name = "the octomap " + file.filename().string();
  const bool moved = !pose.matrix().isIdentity(0);
  std::vector<std::shared_ptr<const Obstacle>> all;
  all.reserve(blocks.size());
  for (const CellBlock& block : blocks) {
    const auto corner = [&](const std::array<std::int64_t, 3>& cell) {
      return Vector3d(map.resolution * Vector3d(static_cast<double>(cell[0]), static_cast<double>(cell[1]),
                                                static_cast<double>(cell[2])));
    };
    const Vector3d lower = corner(block.lower), upper = corner(block.upper);
    all.push_back(moved ? make_box({.lower = lower, .upper = upper, .pose = options.pose}, name)
                        : make_box_obstacle({lower, upper}, {.name = name}));
  }
  return all;
}

std::string octomap_version() { return LEASTCOST_OCTOMAP_VERSION; }

}  // namespace leastcost
