// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/layers/refracted_ray.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/energy/chain_system.hpp>

namespace leastcost {
namespace {

constexpr double kFirstRounding = 0.3;   ///< e of the first stage, of the size of the problem
constexpr double kLastRounding = 1e-15;  ///< and of the last one
constexpr double kRoundingFalls = 0.1;   ///< from stage to stage
constexpr double kSameCost = 8 * std::numeric_limits<double>::epsilon();
constexpr double kAgree = 1e-3;     ///< where slownesses differ by more of the index, a stage has failed
constexpr int kSteps = 40;          ///< of Newton in a stage
constexpr int kLastSteps = 10;      ///< more, where the value sees no more of them
constexpr double kDecrease = 1e-4;  ///< of the slope, by Armijo's rule

/// The crossings of one word as unknowns.
class Crossings {
 public:
  Crossings(const LayerStack& stack, const Eigen::VectorXd& source, const Eigen::VectorXd& target,
            const LayerWord& word, double last_index)
      : stack_(stack), count_(static_cast<Index>(word.size()) - 1), x_(stack.dimension(), count_ + 2) {
    index_.resize(count_ + 1);
    for (Index i = 0; i < count_; ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      plane_.push_back(interface_between(word[k], word[k + 1]));
      index_[i] = stack.index(word[k]);
    }
    index_[count_] = last_index;
    place_first(source, target);
    size_ = 0;
    for (Index i = 0; i <= count_; ++i) size_ = std::max(size_, (x_.col(i + 1) - x_.col(0)).norm());
    system_.resize(stack.dimension() - 1, count_, false);
  }

  /// The places of the stage with the lowest cost, the last one of the same; the slownesses of the one from which the
  /// best bound follows: where a leg has no length, or is as short as the coordinates are rounded, that is not the last
  /// one.
  void solve() {
    if (count_ == 0) {
      value(x_, 0);
      return;
    }
    Points x, slowness;
    double least_cost = std::numeric_limits<double>::max(), least_gap = least_cost;
    for (double e = kFirstRounding; e > kLastRounding; e *= kRoundingFalls) {
      const double off = minimise(e * size_), gap = (off + e * index_.sum()) * size_;
      if (cost() <= least_cost * (1 + kSameCost)) {
        least_cost = std::min(least_cost, cost());
        x = x_;
      }
      if (!(gap >= least_gap)) {
        least_gap = gap;
        slowness = slowness_;
      }
      if (!(off <= kAgree * index_.maxCoeff())) break;
    }
    x_ = std::move(x);
    slowness_ = std::move(slowness);
  }

  const Points& x() const { return x_; }
  const Points& slowness() const { return slowness_; }
  double cost() const {
    double sum = 0;
    for (Index i = 0; i <= count_; ++i) sum += index_[i] * (x_.col(i + 1) - x_.col(i)).norm();
    return sum;
  }

 private:
  /// The sum, each length rounded off by e; sets the slowness of all legs.
  double value(const Points& x, double e) {
    slowness_.resize(x.rows(), count_ + 1);
    rho_.resize(count_ + 1);
    double sum = 0;
    for (Index i = 0; i <= count_; ++i) {
      slowness_.col(i) = x.col(i + 1) - x.col(i);
      rho_[i] = std::hypot(slowness_.col(i).norm(), e);
      slowness_.col(i) *= rho_[i] > 0 ? index_[i] / rho_[i] : 0;
      sum += index_[i] * rho_[i];
    }
    return sum;
  }

  /// Along the straight line from end to end, each on its plane.
  void place_first(const Eigen::VectorXd& source, const Eigen::VectorXd& target) {
    x_.col(0) = source;
    x_.col(count_ + 1) = target;
    for (Index i = 0; i < count_; ++i) {
      const double t = static_cast<double>(i + 1) / static_cast<double>(count_ + 1);
      x_.col(i + 1) = (1 - t) * source + t * target;
      onto_plane(x_, i);
    }
  }
  void onto_plane(Points& x, Index i) const {
    const int k = plane_[static_cast<std::size_t>(i)];
    x.col(i + 1) -= stack_.height(k, x.col(i + 1)) * stack_.normal(k);
  }
  const Eigen::MatrixXd& tangents(Index i) const { return stack_.tangents(plane_[static_cast<std::size_t>(i)]); }

  Eigen::VectorXd gradient() const {
    const Index k = system_.block();
    Eigen::VectorXd g(k * count_);
    for (Index i = 0; i < count_; ++i)
      g.segment(k * i, k) = tangents(i).transpose() * (slowness_.col(i) - slowness_.col(i + 1));
    return g;
  }

  /// Second derivatives at the place of the last value().
  bool factor() {
    system_.set_zero();
    const Index d = x_.rows();
    for (Index j = 0; j <= count_; ++j) {
      const Eigen::VectorXd u = slowness_.col(j) / index_[j];
      const Eigen::MatrixXd p = index_[j] / rho_[j] * (Eigen::MatrixXd::Identity(d, d) - u * u.transpose());
      if (j > 0) system_.diagonal(j - 1) += tangents(j - 1).transpose() * p * tangents(j - 1);
      if (j < count_) system_.diagonal(j) += tangents(j).transpose() * p * tangents(j);
      if (j > 0 && j < count_) system_.coupling(j - 1) -= tangents(j - 1).transpose() * p * tangents(j);
    }
    if (system_.factor()) return true;
    // Convex, so that only rounding can make it singular: by far the largest entries are those of the shortest legs.
    for (Index i = 0; i < count_; ++i)
      system_.diagonal(i).diagonal().array() += 1e-12 * system_.diagonal(i).diagonal().maxCoeff();
    return system_.factor();
  }

  Points moved(const Eigen::VectorXd& step, double t) const {
    Points x = x_;
    const Index k = system_.block();
    for (Index i = 0; i < count_; ++i) {
      x.col(i + 1) += t * (tangents(i) * step.segment(k * i, k));
      onto_plane(x, i);
    }
    return x;
  }

  /// By what the slownesses differ in the end; the largest number where it did not end.
  double minimise(double e) {
    double best = value(x_, e);
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * best;
    for (int i = 0; i < kSteps; ++i) {
      const Eigen::VectorXd g = gradient();
      if (!factor()) break;
      Eigen::VectorXd step = -g;
      system_.solve(step);
      const double slope = step.dot(g);
      if (!(-slope > rounding)) return finish(std::move(step), g.norm(), e);  // the value sees no more of it
      double t = 1;
      Points trial = moved(step, t);
      double next = value(trial, e);
      while (!(next <= best + kDecrease * t * slope + rounding) && t > 1e-10) {
        t /= 2;
        trial = moved(step, t);
        next = value(trial, e);
      }
      if (!(t > 1e-10)) break;
      x_ = std::move(trial);
      best = next;
    }
    value(x_, e);
    return std::numeric_limits<double>::max();
  }

  /// Whole steps, as long as the slownesses agree better after them.
  double finish(Eigen::VectorXd step, double off, double e) {
    for (int i = 0; i < kLastSteps; ++i) {
      Points trial = moved(step, 1);
      value(trial, e);
      const Eigen::VectorXd g = gradient();
      if (!(g.norm() < off)) break;
      off = g.norm();
      x_ = std::move(trial);
      if (!factor()) break;
      step = -g;
      system_.solve(step);
    }
    value(x_, e);
    return off;
  }

  const LayerStack& stack_;
  const Index count_;
  std::vector<int> plane_;
  Eigen::VectorXd index_, rho_;
  Points x_, slowness_;
  double size_ = 1;
  ChainSystem system_;
};

}  // namespace

RefractedRay refracted_ray(const LayerStack& stack, const Eigen::VectorXd& source, const Eigen::VectorXd& target,
                           LayerWord word, std::optional<double> last_index) {
  Crossings crossings(stack, source, target, word, last_index.value_or(stack.index(word.back())));
  crossings.solve();
  return {std::move(word), crossings.x(), crossings.slowness(), crossings.cost()};
}

}  // namespace leastcost
