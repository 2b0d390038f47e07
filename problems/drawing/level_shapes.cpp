// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Level sets: a surface net in space, polylines in the plane.
#include <algorithm>

#include "problems/drawing/domain_shapes.hpp"
#include "problems/drawing/level_samples.hpp"

namespace leastcost {
namespace {

constexpr int kCellsInSpace = 64, kCellsInPlane = 240;

Eigen::VectorXi unit(int dimension, int axis) {
  Eigen::VectorXi e = Eigen::VectorXi::Zero(dimension);
  e[axis] = 1;
  return e;
}

/// The point of a cell that is kept, or -1.
int kept_point(const LevelSamples& samples, const LevelSamples::Net& net, const std::vector<char>& keep,
               const Eigen::VectorXi& cell) {
  for (int i = 0; i < samples.dimension(); ++i)
    if (cell[i] < 0 || cell[i] >= samples.nodes(i) - 1) return -1;
  const int p = net.point_of_cell[samples.index(cell)];
  return p >= 0 && keep[static_cast<std::size_t>(p)] != 0 ? p : -1;
}

/// The two triangles around the edge from `node` along `axis`, where the surface crosses it.
void add_quad(const LevelSamples& samples, const LevelSamples::Net& net, const std::vector<char>& keep,
              const Eigen::VectorXi& node, int axis, TriangleSoup& out) {
  const int first = (axis + 1) % 3, second = (axis + 2) % 3;
  const Eigen::VectorXi upper = node + unit(3, axis);
  if (!samples.crossed(node, upper)) return;
  const std::array<Eigen::VectorXi, 4> cells = {node, node - unit(3, first), node - unit(3, first) - unit(3, second),
                                                node - unit(3, second)};
  std::array<int, 4> p{};
  for (std::size_t k = 0; k < 4; ++k) {
    p[k] = kept_point(samples, net, keep, cells[k]);
    if (p[k] < 0) return;
  }
  if (samples.value(node) > 0) std::swap(p[1], p[3]);  // outward is where the function is positive
  out.triangles.push_back({p[0], p[1], p[2]});
  out.triangles.push_back({p[0], p[2], p[3]});
}

/// Walks along the links of the points (at most two each) and takes what it passes off them.
std::vector<int> chain_from(int start, std::vector<std::vector<int>>& links) {
  std::vector<int> chain = {start};
  for (int at = start; !links[static_cast<std::size_t>(at)].empty();) {
    const int next = links[static_cast<std::size_t>(at)].back();
    links[static_cast<std::size_t>(at)].pop_back();
    auto& back = links[static_cast<std::size_t>(next)];
    back.erase(std::find(back.begin(), back.end(), at));
    chain.push_back(next);
    at = next;
  }
  return chain;
}

/// Which points lie in cells on both sides of a crossed edge.
std::vector<std::vector<int>> links_of(const LevelSamples& samples, const LevelSamples::Net& net,
                                       const std::vector<char>& keep) {
  std::vector<std::vector<int>> links(net.points.size());
  for (std::size_t p = 0; p < net.points.size(); ++p) {
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::VectorXi node = net.cells[p] + unit(2, 1 - axis);
      if (!samples.crossed(node, node + unit(2, axis))) continue;
      const int q = kept_point(samples, net, keep, node);
      if (q < 0 || keep[p] == 0) continue;
      links[p].push_back(q);
      links[static_cast<std::size_t>(q)].push_back(static_cast<int>(p));
    }
  }
  return links;
}

}  // namespace

TriangleSoup level_surface(const ConstraintManifold& manifold, const ConstraintFunction& function,
                           const Surroundings& path, const Surroundings* whole, std::vector<std::string>& notes) {
  const LevelRegion region = whole != nullptr ? LevelRegion{*whole, true} : level_region(function, path);
  if (!region.whole) notes.emplace_back("the surface extends beyond the part that is drawn");
  const LevelSamples samples(function, region.box, kCellsInSpace);
  LevelSamples::Net net = samples.net();
  const std::vector<char> keep = settle(manifold, net.points, 1.8 * samples.cell());
  TriangleSoup out;
  for (const Eigen::VectorXd& x : net.points) out.vertices.emplace_back(x);
  for (const Eigen::VectorXi& cell : net.cells)
    for (int axis = 0; axis < 3; ++axis) add_quad(samples, net, keep, cell, axis, out);
  return out;
}

std::vector<Points> level_curves(const ConstraintManifold& manifold, const ConstraintFunction& function,
                                 const Surroundings& path) {
  const LevelSamples samples(function, level_region(function, path).box, kCellsInPlane);
  LevelSamples::Net net = samples.net();
  const std::vector<char> keep = settle(manifold, net.points, 1.8 * samples.cell());
  std::vector<std::vector<int>> links = links_of(samples, net, keep);
  std::vector<Points> curves;
  for (const bool open : {true, false}) {  // ends of open pieces first, then what is left: closed ones
    for (std::size_t p = 0; p < links.size(); ++p) {
      if (links[p].empty() || (open && links[p].size() != 1)) continue;
      const std::vector<int> chain = chain_from(static_cast<int>(p), links);
      Points curve(2, static_cast<Index>(chain.size()));
      for (std::size_t i = 0; i < chain.size(); ++i)
        curve.col(static_cast<Index>(i)) = net.points[static_cast<std::size_t>(chain[i])];
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

}  // namespace leastcost
