// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/drawing/level_samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leastcost {
namespace {

/// Calls visit(node) for every node of a grid of `count` nodes along each axis.
template <class Visit>
void for_each_node(const Eigen::VectorXi& count, Visit visit) {
  Eigen::VectorXi node = Eigen::VectorXi::Zero(count.size());
  while (node[node.size() - 1] < count[node.size() - 1]) {
    visit(node);
    for (Index i = 0; i < node.size(); ++i) {
      if (++node[i] < count[i] || i == node.size() - 1) break;
      node[i] = 0;
    }
  }
}

std::size_t index_in(const Eigen::VectorXi& count, const Eigen::VectorXi& node) {
  std::size_t index = 0;
  for (Index i = node.size(); i-- > 0;)
    index = index * static_cast<std::size_t>(count[i]) + static_cast<std::size_t>(node[i]);
  return index;
}

/// Corner `c` of the cell at `node`: bit i says whether it is the upper one along axis i.
Eigen::VectorXi corner(const Eigen::VectorXi& node, int c) {
  Eigen::VectorXi at = node;
  for (Index i = 0; i < at.size(); ++i) at[i] += c >> i & 1;
  return at;
}

double evaluate(const ConstraintFunction& function, const Eigen::VectorXd& x) {
  Eigen::VectorXd value(1);
  Points gradient(x.size(), 1);
  function.evaluate(x, value, gradient);
  return value[0];
}

bool changes(double a, double b) { return std::isfinite(a) && std::isfinite(b) && (a < 0) != (b < 0); }

}  // namespace

LevelSamples::LevelSamples(const ConstraintFunction& function, const Surroundings& box, int cells)
    : origin_(box.lower), count_(box.lower.size()), cell_(box.extent().maxCoeff() / cells) {
  for (Index i = 0; i < count_.size(); ++i) {
    const int blocks = std::max(1, static_cast<int>(std::ceil(box.extent()[i] / (cell_ * kBlock) - 1e-9)));
    count_[i] = blocks * kBlock + 1;
  }
  evaluate_near_zeros(function);
}

std::size_t LevelSamples::index(const Eigen::VectorXi& node) const { return index_in(count_, node); }

bool LevelSamples::crossed(const Eigen::VectorXi& a, const Eigen::VectorXi& b) const {
  return changes(value(a), value(b));
}

std::vector<char> LevelSamples::active_blocks(const ConstraintFunction& function, const Eigen::VectorXi& blocks) const {
  const Eigen::VectorXi corners = blocks.array() + 1;
  std::vector<double> coarse(static_cast<std::size_t>(corners.prod()));
  for_each_node(corners, [&](const Eigen::VectorXi& node) {
    coarse[index_in(corners, node)] = evaluate(function, position(node * kBlock));
  });
  std::vector<char> active(static_cast<std::size_t>(blocks.prod()), 0);
  for_each_node(blocks, [&](const Eigen::VectorXi& block) {
    const double first = coarse[index_in(corners, block)];
    bool any = false;
    for (int c = 1; c < 1 << block.size(); ++c)
      any = any || changes(first, coarse[index_in(corners, corner(block, c))]);
    if (!any) return;
    for_each_node(Eigen::VectorXi::Constant(block.size(), 3), [&](const Eigen::VectorXi& step) {
      const Eigen::VectorXi at = block.array() + step.array() - 1;
      if ((at.array() >= 0).all() && (at.array() < blocks.array()).all()) active[index_in(blocks, at)] = 1;
    });
  });
  return active;
}

void LevelSamples::evaluate_near_zeros(const ConstraintFunction& function) {
  values_.assign(static_cast<std::size_t>(count_.prod()), std::numeric_limits<double>::quiet_NaN());
  const Eigen::VectorXi blocks = (count_.array() - 1) / kBlock;
  const std::vector<char> active = active_blocks(function, blocks);
  for_each_node(blocks, [&](const Eigen::VectorXi& block) {
    if (active[index_in(blocks, block)] == 0) return;
    for_each_node(Eigen::VectorXi::Constant(block.size(), kBlock + 1), [&](const Eigen::VectorXi& step) {
      const Eigen::VectorXi node = block * kBlock + step;
      double& value = values_[index(node)];
      if (std::isnan(value)) value = evaluate(function, position(node));
    });
  });
}

LevelSamples::Net LevelSamples::net() const {
  Net net;
  net.point_of_cell.assign(values_.size(), -1);
  const Eigen::VectorXi cells = count_.array() - 1;
  const int corners = 1 << dimension();
  for_each_node(cells, [&](const Eigen::VectorXi& cell) {
    if (std::isnan(value(cell))) return;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(origin_.size());
    int crossings = 0;
    for (int c = 0; c < corners; ++c) {
      const Eigen::VectorXi a = corner(cell, c);
      for (int axis = 0; axis < dimension(); ++axis) {
        if ((c >> axis & 1) != 0) continue;
        const Eigen::VectorXi b = corner(cell, c | 1 << axis);
        if (!crossed(a, b)) continue;
        const double t = value(a) / (value(a) - value(b));
        sum += (1 - t) * position(a) + t * position(b);
        ++crossings;
      }
    }
    if (crossings == 0) return;
    net.point_of_cell[index(cell)] = static_cast<int>(net.points.size());
    net.points.emplace_back(sum / crossings);
    net.cells.push_back(cell);
  });
  return net;
}

LevelRegion level_region(const ConstraintFunction& function, const Surroundings& path) {
  constexpr int kCoarse = 28;
  const Surroundings near = path.enlarged(0.45);
  for (const double growth : {1.0, 2.0, 4.0, 8.0}) {
    const Eigen::VectorXd half = growth * near.extent() / 2;
    // Towards a cube: a path around a closed surface may be flat.
    const Eigen::VectorXd reach = half.cwiseMax(0.6 * half.maxCoeff());
    const Surroundings box{near.centre() - reach, near.centre() + reach};
    const LevelSamples samples(function, box, kCoarse);
    const LevelSamples::Net net = samples.net();
    if (net.points.empty()) continue;
    Surroundings tight{net.points[0], net.points[0]};
    bool inside = true;
    for (std::size_t p = 0; p < net.points.size(); ++p) {
      tight.lower = tight.lower.cwiseMin(net.points[p]);
      tight.upper = tight.upper.cwiseMax(net.points[p]);
      for (int i = 0; i < samples.dimension(); ++i)
        inside = inside && net.cells[p][i] > 0 && net.cells[p][i] < samples.nodes(i) - 2;
    }
    if (!inside) continue;
    tight.lower.array() -= 2 * samples.cell();
    tight.upper.array() += 2 * samples.cell();
    return {{tight.lower.cwiseMin(path.lower), tight.upper.cwiseMax(path.upper)}, true};
  }
  return {near, false};
}

std::vector<char> settle(const ConstraintManifold& manifold, std::vector<Eigen::VectorXd>& points, double reach) {
  if (points.empty()) return {};
  CoordinatePath path{Points(points[0].size(), static_cast<Index>(points.size())), {}, true};
  for (std::size_t i = 0; i < points.size(); ++i) path.u.col(static_cast<Index>(i)) = points[i];
  const Projection projection = manifold.project(path);
  std::vector<char> keep(points.size(), 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::VectorXd moved = path.u.col(static_cast<Index>(i));
    keep[i] = moved.allFinite() && (moved - points[i]).norm() <= reach ? 1 : 0;
    if (keep[i] != 0) points[i] = moved;
  }
  for (const Index failed : projection.failed) keep[static_cast<std::size_t>(failed)] = 0;
  return keep;
}

}  // namespace leastcost
