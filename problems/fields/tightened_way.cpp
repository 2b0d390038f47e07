// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/tightened_way.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include <leastcost/framework/domain/manifold.hpp>
#include "problems/fields/grid_search.hpp"

namespace leastcost {
namespace {

constexpr double kBlocked = std::numeric_limits<double>::infinity();

/// At right angles to a direction.
std::array<Eigen::Vector2d, 1> across_of(const Eigen::Vector2d& along) {
  return {Eigen::Vector2d(-along[1], along[0]) / along.norm()};
}
std::array<Eigen::Vector3d, 2> across_of(const Eigen::Vector3d& along) {
  const Eigen::Vector3d first = along.unitOrthogonal();
  return {first, along.cross(first).normalized()};
}

/// In N coordinates.
template <int N>
class WayTightening {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Room = Eigen::AlignedBox<double, N>;

  WayTightening(const Problem& problem, std::vector<Vector> way, double step, const Room& room)
      : problem_(problem), moves_(problem), way_(std::move(way)), step_(step), room_(room) {
    for (const Vector& point : way_) room_.extend(point);
    for (std::size_t i = 0; i + 1 < way_.size(); ++i) costs_.push_back(move(way_[i], way_[i + 1]));
  }

  std::vector<Vector> tightened() {
    constexpr std::size_t kFewMoves = 64;  // fewer are too coarse a polyline
    constexpr int kMostHalvings = 5;
    tighten();
    for (int k = 0; k < kMostHalvings && costs_.size() < kFewMoves && !costs_.empty(); ++k) {
      halve_moves();
      tighten();
    }
    return std::move(way_);
  }

 private:
  static constexpr double kMostSteps = 8;
  static constexpr int kPieces = 4;  ///< of a move, as in cost_of_way()

  /// Rounds of shifts from large to small, until they gain little.
  void tighten() {
    constexpr int kRounds = 6;
    constexpr double kEnough = 1e-5;  // of the cost, for another round
    for (int round = 0; round < kRounds; ++round) {
      const double before = total();
      for (const double size : {1.0, 0.25, 0.0625, 0.015625})  // in steps of the lattice
        for (std::size_t reach = std::bit_floor(std::max<std::size_t>(way_.size() / 2, 1)); reach > 0; reach /= 2) {
          const std::size_t stride = std::max<std::size_t>(reach / 2, 1);
          for (std::size_t i = stride; i + 1 < way_.size(); i += stride)
            shift(i, reach, size * step_ * std::min(double(reach), kMostSteps) / 2);
        }
      if (!(before - total() > kEnough * before)) break;
    }
  }

  void halve_moves() {
    std::vector<Vector> finer = {way_[0]};
    for (std::size_t i = 1; i < way_.size(); ++i) {
      finer.emplace_back((way_[i - 1] + way_[i]) / 2);
      finer.push_back(way_[i]);
    }
    way_ = std::move(finer);
    step_ /= 2;
    costs_.clear();
    for (std::size_t i = 0; i + 1 < way_.size(); ++i) costs_.push_back(move(way_[i], way_[i + 1]));
  }

  double total() const { return std::accumulate(costs_.begin(), costs_.end(), 0.0); }
  Eigen::VectorXd ambient(const Vector& u) const { return positions(*problem_.manifold, {u, {}, true}).col(0); }

  double move(const Vector& from, const Vector& to) const {
    const Eigen::VectorXd a = ambient(from), b = ambient(to);
    double sum = 0;
    Eigen::VectorXd last = a;
    for (int k = 1; k <= kPieces; ++k) {
      const Eigen::VectorXd next = k == kPieces ? b : ambient(from + double(k) / kPieces * (to - from));
      sum += moves_.cost(last, next);
      last = next;
    }
    return sum < kBlocked && moves_.clear(a, b, kBlocked) ? sum : kBlocked;
  }

  /// The points up to `reach` before and after point i across the way by `by`, those farther off by less.
  void shift(std::size_t i, std::size_t reach, double by) {
    const std::size_t low = i > reach ? i - reach : 0, high = std::min(i + reach, way_.size() - 1);
    const Vector along = way_[high] - way_[low];
    if (!(along.norm() > 0) || !(by > 0)) return;
    for (const Vector& across : across_of(along)) shift_along(across, i, low, high, by);
  }

  void shift_along(const Vector& across, std::size_t i, std::size_t low, std::size_t high, double by) {
    const double here =
        std::accumulate(costs_.begin() + std::ptrdiff_t(low), costs_.begin() + std::ptrdiff_t(high), 0.0);
    if (!(here < kBlocked)) return;
    const auto tried = [&](double amount) {
      Trial trial{amount, 0, {}, {}};
      Vector last = way_[low];
      for (std::size_t k = low + 1; k <= high; ++k) {
        const double share = k <= i ? double(k - low) / double(i - low) : double(high - k) / double(high - i);
        const Vector next = way_[k] + amount * share * across;
        trial.costs.push_back(room_.contains(next) ? move(last, next) : kBlocked);
        trial.cost += trial.costs.back();
        if (!(trial.cost < kBlocked)) break;
        trial.points.push_back(next);
        last = next;
      }
      return trial;
    };
    // Where a parabola through three of them is lowest, or at the better side, or nearer where moves may not go.
    const Trial one = tried(by), other = tried(-by);
    Trial best = one.cost < other.cost ? one : other;
    const double bend = one.cost + other.cost - 2 * here;
    if (bend < kBlocked && bend > 0) {
      Trial lowest = tried(std::clamp(by * (other.cost - one.cost) / (2 * bend), -2 * by, 2 * by));
      if (lowest.cost < best.cost) best = std::move(lowest);
    } else if (!(bend < kBlocked)) {
      for (const double nearer : {by / 4, -by / 4, by / 16, -by / 16}) {
        Trial trial = tried(nearer);
        if (trial.cost < best.cost) best = std::move(trial);
      }
    }
    if (!(best.cost < here * (1 - kRounding))) return;
    for (std::size_t k = low + 1; k <= high; ++k) {
      if (k < high) way_[k] = best.points[k - low - 1];
      costs_[k - 1] = best.costs[k - low - 1];
    }
  }

  struct Trial {
    double amount, cost;
    std::vector<Vector> points;
    std::vector<double> costs;
  };
  static constexpr double kRounding = 1e-12;

  const Problem& problem_;
  MoveCheck moves_;
  std::vector<Vector> way_;
  std::vector<double> costs_;  ///< of the moves
  double step_;                ///< of the lattice, halved with the moves
  Room room_;                  ///< that points may be in
};

}  // namespace

std::vector<Eigen::Vector2d> tightened(const Problem& problem, const std::vector<Eigen::Vector2d>& way, double step,
                                       const Eigen::AlignedBox2d& room) {
  return WayTightening<2>(problem, way, step, room).tightened();
}

std::vector<Eigen::Vector3d> tightened(const Problem& problem, const std::vector<Eigen::Vector3d>& way, double step,
                                       const Eigen::AlignedBox3d& room) {
  return WayTightening<3>(problem, way, step, room).tightened();
}

}  // namespace leastcost
