// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "tests/adversarial/planning/judge/grid_passage.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/adversarial/planning/judge/exact.hpp"

namespace judge {
namespace {

class Grid {
 public:
  Grid(const Scene& scene, int nodes) : scene_(scene), lower_(scene.source), count_(scene.source.size()) {
    Place upper = scene.source;
    for (std::size_t k = 0; k < lower_.size(); ++k) {
      const auto cover = [&](double from, double to) {
        lower_[k] = std::min(lower_[k], from), upper[k] = std::max(upper[k], to);
      };
      cover(scene.target[k], scene.target[k]);
      for (const Thing& thing : scene.things)
        for (const Place& x : thing.corners)
          cover(x[k] - thing.radius - scene.clearance, x[k] + thing.radius + scene.clearance);
    }
    cell_ = scene.diameter() / (nodes - 5);
    std::size_t all = 1;
    for (std::size_t k = 0; k < lower_.size(); ++k) {
      lower_[k] -= 2 * cell_;  // a way around everything
      count_[k] = static_cast<std::size_t>(std::ceil((upper[k] - lower_[k]) / cell_)) + 3;
      all *= count_[k];
    }
    state_.resize(all, State::unknown);
  }

  bool joins() {
    std::vector<std::size_t> open;
    for (const std::size_t node : around(scene_.source))
      if (sees(scene_.source, node) && take(node)) open.push_back(node);
    std::vector<char> goal(state_.size(), 0);
    bool any = false;
    for (const std::size_t node : around(scene_.target))
      if (sees(scene_.target, node)) goal[node] = 1, any = true;
    while (any && !open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      if (goal[at] != 0) return true;
      std::size_t stride = 1, rest = at;
      for (const std::size_t n : count_) {
        const std::size_t i = rest % n;
        rest /= n;
        if (i > 0 && take(at - stride)) open.push_back(at - stride);
        if (i + 1 < n && take(at + stride)) open.push_back(at + stride);
        stride *= n;
      }
    }
    return false;
  }

 private:
  enum class State : char { unknown, taken, blocked };

  Place place(std::size_t node) const {
    Place x = lower_;
    for (std::size_t k = 0; k < count_.size(); ++k, node /= count_[k - 1])
      x[k] += cell_ * static_cast<double>(node % count_[k]);
    return x;
  }

  bool keeps(const Place& a, const Place& b, double more) const {
    return std::all_of(scene_.things.begin(), scene_.things.end(), [&](const Thing& thing) {
      return about_distance(thing, a, b) >= thing.radius + scene_.clearance + more;
    });
  }

  /// Whether a node is free and new. Every point of an edge is at most half a cell from one of its nodes.
  bool take(std::size_t node) {
    if (state_[node] != State::unknown) return false;
    const Place x = place(node);
    state_[node] = keeps(x, x, cell_ / 2) ? State::taken : State::blocked;
    return state_[node] == State::taken;
  }

  /// An end may be in contact, to rounding.
  bool sees(const Place& end, std::size_t node) const { return keeps(end, place(node), -1e-12 * scene_.diameter()); }

  /// The nodes within two cells of x.
  std::vector<std::size_t> around(const Place& x) const {
    std::vector<std::size_t> found = {0};
    std::size_t stride = 1;
    for (std::size_t k = 0; k < count_.size(); ++k) {
      const auto middle = static_cast<std::size_t>((x[k] - lower_[k]) / cell_);
      std::vector<std::size_t> more;
      for (std::size_t i = middle < 2 ? 0 : middle - 2; i < std::min(middle + 4, count_[k]); ++i)
        for (const std::size_t node : found) more.push_back(node + i * stride);
      found = more;
      stride *= count_[k];
    }
    return found;
  }

  const Scene& scene_;
  Place lower_;
  double cell_ = 0;
  std::vector<std::size_t> count_;
  std::vector<State> state_;
};

}  // namespace

bool grid_confirms(const Scene& scene, int nodes) { return Grid(scene, nodes).joins(); }

}  // namespace judge
