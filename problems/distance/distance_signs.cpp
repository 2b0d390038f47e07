// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/distance/distance_signs.hpp"

#include <cmath>

namespace leastcost {
namespace {

using Node = std::array<int, 3>;

template <class Visit>
void for_nodes(const GridShape& shape, Visit visit) {
  Node at{};
  for (at[2] = 0; at[2] < shape.count[2]; ++at[2])
    for (at[1] = 0; at[1] < shape.count[1]; ++at[1])
      for (at[0] = 0; at[0] < shape.count[0]; ++at[0]) visit(shape.index(at[0], at[1], at[2]), at);
}

}  // namespace

void sign_by_parts(const GridShape& shape, std::vector<double>& distances,
                   const std::function<bool(const Eigen::Vector3d& x, double distance)>& inside) {
  std::vector<char> seen(distances.size(), 0);
  std::vector<Node> part;
  for_nodes(shape, [&](std::size_t seed, const Node& start) {
    if (seen[seed] != 0) return;
    seen[seed] = 1;
    part.assign(1, start);
    Node farthest = start;
    double most = distances[seed];
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Node at = part[i];
      const double mine = distances[shape.index(at[0], at[1], at[2])];
      if (mine > most) most = mine, farthest = at;
      for_neighbours(shape, at, [&](std::size_t next, const Node& node) {
        if (seen[next] != 0 || !same_side(mine, distances[next], shape.cell)) return;
        seen[next] = 1;
        part.push_back(node);
      });
    }
    if (!inside(shape.node(farthest[0], farthest[1], farthest[2]), most)) return;
    for (const Node& at : part) {
      double& d = distances[shape.index(at[0], at[1], at[2])];
      d = -d;
    }
  });
}

std::optional<Eigen::Vector3d> spread_signs(const GridShape& shape, std::vector<double>& distances,
                                            std::vector<std::int8_t> signs) {
  constexpr double kSlack = 1.1;
  std::optional<Eigen::Vector3d> conflict;
  std::vector<Node> reached;
  for_nodes(shape, [&](std::size_t index, const Node& at) {
    if (signs[index] != 0) reached.push_back(at);
  });
  const auto spread = [&](const Node& at) {
    const std::size_t here = shape.index(at[0], at[1], at[2]);
    for_neighbours(shape, at, [&](std::size_t next, const Node& node) {
      if (!same_side(distances[here], distances[next], kSlack * shape.cell)) return;
      if (signs[next] == 0) {
        signs[next] = signs[here];
        reached.push_back(node);
      } else if (signs[next] != signs[here] && !conflict) {
        conflict = shape.node(node[0], node[1], node[2]);
      }
    });
  };
  std::size_t next = 0;  // more are reached meanwhile
  while (next < reached.size()) spread(Node(reached[next++]));
  for (std::size_t i = 0; i < distances.size(); ++i)
    if (signs[i] < 0) distances[i] = -distances[i];
  return conflict;
}

}  // namespace leastcost
