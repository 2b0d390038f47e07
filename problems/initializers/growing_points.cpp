// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/initializers/growing_points.hpp"

#include <limits>
#include <utility>

namespace leastcost {

int GrowingPoints::add(const Eigen::VectorXd& x) {
  const int added = size();
  coordinates_.insert(coordinates_.end(), x.data(), x.data() + x.size());
  nodes_.emplace_back();
  if (added == 0) return added;
  for (int i = 0;;) {
    Node& node = nodes_[static_cast<std::size_t>(i)];
    int& child = x[node.axis] < at(i)[node.axis] ? node.below : node.above;
    if (child < 0) {
      child = added;
      nodes_.back().axis = (node.axis + 1) % static_cast<int>(dimension_);
      return added;
    }
    i = child;
  }
}

int GrowingPoints::nearest(const Eigen::VectorXd& x) const {
  double best = std::numeric_limits<double>::infinity();
  int found = 0;
  thread_local std::vector<std::pair<int, double>>
      open;  // nodes to visit, with a lower bound of their squared distance
  open.assign(1, {0, 0.0});
  while (!open.empty()) {
    const auto [i, bound] = open.back();
    open.pop_back();
    if (bound >= best) continue;
    const double* const p = at(i);
    double squared = 0;
    for (std::size_t k = 0; k < dimension_; ++k)
      squared += (p[k] - x[static_cast<Eigen::Index>(k)]) * (p[k] - x[static_cast<Eigen::Index>(k)]);
    if (squared < best) {
      best = squared;
      found = i;
    }
    const Node& node = nodes_[static_cast<std::size_t>(i)];
    const double off = x[node.axis] - p[node.axis];
    const int near = off < 0 ? node.below : node.above, far = off < 0 ? node.above : node.below;
    if (far >= 0) open.emplace_back(far, off * off);
    if (near >= 0) open.emplace_back(near, bound);  // looked at first
  }
  return found;
}

}  // namespace leastcost
