// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/layers/fastest_ray.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "problems/layers/ray_bound.hpp"

namespace leastcost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool holds(const std::vector<int>& layers, int layer) {
  return std::find(layers.begin(), layers.end(), layer) != layers.end();
}

/// What both searches share: the best path so far, and how many words it took.
class Search {
 public:
  Search(const LayerStack& stack, const Eigen::VectorXd& source, const Eigen::VectorXd& target,
         const FastestRayOptions& options)
      : stack_(stack),
        source_(source),
        target_(target),
        options_(options),
        lowest_(std::max(0, options.lowest)),
        highest_(std::min(stack.layers() - 1, options.highest)),
        at_source_(stack.layers_at(source)),
        at_target_(stack.layers_at(target)) {}

  FastestRay run() {
    if (at_source_.empty() || at_target_.empty()) return std::move(found_);
    if (stack_.is_parallel())
      among_excursions();
    else
      best_first();
    return std::move(found_);
  }

 private:
  bool out_of_budget() const { return found_.words >= options_.max_words || options_.stop(); }
  double best_cost() const { return found_.best ? found_.best->cost : kInfinity; }

  RefractedRay solve(const LayerWord& word, std::optional<double> last_index = {}) {
    ++found_.words;
    return refracted_ray(stack_, source_, target_, word, last_index);
  }
  void offer(RefractedRay ray) {
    if (ray.cost < best_cost() && is_in_its_layers(stack_, ray) && options_.allowed(ray.x))
      found_.best = std::move(ray);
  }

  // Parallel interfaces.

  /// From the source to the layer `far` and from there to the target, without legs of length zero.
  LayerWord word_over(int far) const {
    LayerWord word;
    const int from = far >= at_source_.back() ? at_source_.back() : std::max(far, at_source_.front());
    const int to = far >= at_target_.back() ? at_target_.back() : std::max(far, at_target_.front());
    for (int layer = from; layer != far; layer += far > layer ? 1 : -1) word.push_back(layer);
    for (int layer = far; layer != to; layer += to > layer ? 1 : -1) word.push_back(layer);
    word.push_back(to);
    return word;
  }

  void consider(const Excursion& excursion, const LayerWord& word, double& lower) {
    const double bound = excursion_bound(stack_, source_, target_, excursion);
    lower = std::min(lower, bound);
    if (bound < best_cost()) offer(solve(word));
  }

  void among_excursions() {
    double lower = kInfinity;
    const bool rises = at_source_.front() + at_source_.back() < at_target_.front() + at_target_.back();
    const std::vector<int>&low = rises ? at_source_ : at_target_, &high = rises ? at_target_ : at_source_;
    const int bottom = low.back(), top = high.front();  // the layers between the ends; none where both are on one plane
    double least = kInfinity;
    for (int layer = bottom; layer <= top; ++layer) least = std::min(least, stack_.index(layer));
    if (bottom <= top) consider({bottom, top}, word_over(rises ? top : bottom), lower);
    const auto look = [&](int layer, double& least_so_far) {
      if (stack_.index(layer) < least_so_far) consider({bottom, top, layer}, word_over(layer), lower);
      least_so_far = std::min(least_so_far, stack_.index(layer));
    };
    double above = least, below = least;
    int up = top + 1, down = bottom - 1;
    for (; up <= highest_ && !out_of_budget(); ++up) look(up, above);
    for (; down >= lowest_ && !out_of_budget(); --down) look(down, below);
    found_.finished = up > highest_ && down < lowest_;
    if (found_.finished) found_.lower_bound = lower;
  }

  // Interfaces that dip.

  /// The beginning of a word, and what no path that begins like that costs less than; or a whole word.
  struct Beginning {
    double bound;
    LayerWord word;
    bool whole;
    bool operator<(const Beginning& other) const { return bound > other.bound; }  // the least first
  };

  void add(const LayerWord& word) {
    const int last = word.back();
    if (holds(at_target_, last)) {
      RefractedRay ray = solve(word);
      queue_.push({word_bound(stack_, ray, ray.cost), word, true});
      offer(std::move(ray));
    }
    const double rest = stack_.indices().segment(lowest_, highest_ - lowest_ + 1).minCoeff();
    const RefractedRay begun = solve(word, std::min(rest, stack_.index(last)));
    const double bound = word_bound(stack_, begun, std::min(best_cost(), kFar * begun.cost), rest);
    queue_.push({bound, word, false});
  }

  void go_on(const LayerWord& word) {
    for (const int layer : {word.back() - 1, word.back() + 1}) {
      if (layer < lowest_ || layer > highest_ || !may_go_on(stack_, word, layer)) continue;
      LayerWord next = word;
      next.push_back(layer);
      add(next);
    }
  }

  /// Whole words that may not be delivered (interfaces cross there, or a box ends) stay below as bounds.
  void best_first() {
    double left = kInfinity;  // the least bound of what was not looked at any further
    for (const int layer : at_source_) add({layer});
    while (!queue_.empty() && !out_of_budget()) {
      const Beginning next = queue_.top();
      if (next.bound >= best_cost() * (1 - options_.tolerance)) break;
      queue_.pop();
      if (next.whole)
        left = std::min(left, next.bound);
      else
        go_on(next.word);
    }
    found_.finished = queue_.empty() || queue_.top().bound >= best_cost() * (1 - options_.tolerance);
    found_.lower_bound = std::min({left, best_cost(), queue_.empty() ? kInfinity : queue_.top().bound});
  }

  static constexpr double kFar = 2;  ///< farther paths cost so many times what they must

  const LayerStack& stack_;
  const Eigen::VectorXd &source_, &target_;
  const FastestRayOptions& options_;
  const int lowest_, highest_;
  const std::vector<int> at_source_, at_target_;
  FastestRay found_;
  std::priority_queue<Beginning> queue_;
};

}  // namespace

bool is_in_its_layers(const LayerStack& stack, const RefractedRay& ray) {
  for (std::size_t i = 0; i < ray.word.size(); ++i)
    for (const Index end : {static_cast<Index>(i), static_cast<Index>(i) + 1})
      if (!holds(stack.layers_at(ray.x.col(end)), ray.word[i])) return false;
  return true;
}

FastestRay fastest_ray(const LayerStack& stack, const Eigen::VectorXd& source, const Eigen::VectorXd& target,
                       const FastestRayOptions& options) {
  return Search(stack, source, target, options).run();
}

}  // namespace leastcost
