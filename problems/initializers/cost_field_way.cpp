// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The way down a field of least costs.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/problems/initializers/cost_field.hpp>
#include "problems/initializers/arrival_field.hpp"
#include "problems/initializers/grid_search.hpp"
#include "problems/initializers/lattice_box.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kLost = std::numeric_limits<double>::infinity();

/// Between four values in a row, a cubic through the two in the middle (Catmull, Rom).
double cubic(const std::array<double, 4>& v, double t) {
  return v[1] +
         0.5 * t * (v[2] - v[0] + t * (2 * v[0] - 5 * v[1] + 4 * v[2] - v[3] + t * (3 * (v[1] - v[2]) + v[3] - v[0])));
}

class FieldDescent {
 public:
  FieldDescent(const CostField& field, const Problem& problem) : field_(field), problem_(problem), moves_(problem) {}

  /// From the place on to the nearest of those of the field; without points where it is lost on the way.
  std::vector<Vector2d> way(const Vector2d& place) const {
    std::vector<Vector2d> way = {place};
    const std::size_t most = 8 * (field_.values.size() + 100);
    double here = kLost;
    while (way.size() < most) {
      const Step end = last_step(way.back()), next = next_step(way.back(), here);
      if (!(std::min(end.total, next.total) < kLost)) break;
      if (end.total < kLost && (end.total <= next.total || end.total <= (1 + kRounding) * here)) {
        if (end.to != way.back() || way.size() == 1) way.push_back(end.to);
        return way;
      }
      way.push_back(next.to);
      here = next.value;
    }
    return {};
  }

  /// Some node that a move from there could end at has a value.
  bool is_reached(const Vector2d& x) const {
    const Vector2d at = in_steps(x);
    for (std::int32_t j = first(at, 1); j <= last(at, 1); ++j)
      for (std::int32_t i = first(at, 0); i <= last(at, 0); ++i)
        if (std::isfinite(field_.value(i, j))) return true;
    return false;
  }

 private:
  static constexpr double kReach = 2, kRounding = 1e-9;  ///< of a step, in steps of the lattice
  struct Step {
    double total = kLost;  ///< of the whole way
    double value = kLost;  ///< of the field where the step ends
    Vector2d to = Vector2d::Zero();
  };

  Eigen::VectorXd ambient(const Vector2d& u) const { return positions(*problem_.manifold, {u, {}, true}).col(0); }
  double move(const Vector2d& from, const Vector2d& to) const {
    const Eigen::VectorXd a = ambient(from), b = ambient(to);
    const double cost = field_.to_places ? moves_.cost(a, b) : moves_.cost(b, a);
    return cost < kLost && moves_.clear(a, b, kLost) ? cost : kLost;
  }

  Vector2d in_steps(const Vector2d& x) const { return (x - field_.lower).cwiseQuotient(field_.step); }

  /// Straight to a place of the field that is near.
  Step last_step(const Vector2d& x) const {
    Step best;
    for (const Eigen::VectorXd& place : field_.places) {
      if (in_steps(x - place + field_.lower).norm() > 2 * kReach) continue;
      const double cost = move(x, place);
      if (cost < best.total) best = {cost, 0, place};
    }
    return best;
  }

  /// NaN where a value is missing.
  double value_at(const Vector2d& x) const {
    const Vector2d at = in_steps(x);
    std::array<std::int32_t, 2> low{};
    for (std::size_t d = 0; d < 2; ++d) {
      const double along = at[static_cast<Eigen::Index>(d)];
      if (!(along >= 0) || !(along <= field_.count[d] - 1.0)) return std::nan("");
      low[d] = std::min(static_cast<std::int32_t>(along), field_.count[d] - 2);
    }
    const double s = at[0] - low[0], t = at[1] - low[1];
    if (low[0] > 0 && low[1] > 0 && low[0] + 2 < field_.count[0] && low[1] + 2 < field_.count[1]) {
      std::array<double, 4> rows{};
      for (std::int32_t j = 0; j < 4; ++j) {
        std::array<double, 4> row{};
        for (std::int32_t i = 0; i < 4; ++i)
          row[static_cast<std::size_t>(i)] = field_.value(low[0] + i - 1, low[1] + j - 1);
        rows[static_cast<std::size_t>(j)] = cubic(row, s);
      }
      const double value = cubic(rows, t);
      if (std::isfinite(value)) return value;
    }
    const auto corner = [&](std::int32_t i, std::int32_t j) { return field_.value(low[0] + i, low[1] + j); };
    return (1 - t) * ((1 - s) * corner(0, 0) + s * corner(1, 0)) + t * ((1 - s) * corner(0, 1) + s * corner(1, 1));
  }

  /// The least of the field and the move over a circle around x and the nodes within it, where the field is lower than
  /// `below`: no way goes in circles.
  Step next_step(const Vector2d& x, double below) const {
    constexpr int kDirections = 32, kHalvings = 8;
    Step best;
    double angle = 0;
    const auto look = [&](const Vector2d& to, double value) {
      if (!(value < below) || !(value < best.total)) return false;
      const double total = value + move(x, to);
      if (!(total < best.total)) return false;
      best = {total, value, to};
      return true;
    };
    const auto turn = [&](double a) {
      const Vector2d to = x + kReach * field_.step.cwiseProduct(Vector2d(std::cos(a), std::sin(a)));
      if (look(to, value_at(to))) angle = a;
    };
    constexpr double kWidth = 2 * std::numbers::pi / kDirections;
    for (int k = 0; k < kDirections; ++k) turn(k * kWidth);
    if (best.total < kLost)
      for (double width = kWidth / 2; width > kWidth / (1 << kHalvings); width /= 2) {
        const double middle = angle;
        turn(middle + width);
        turn(middle - width);
      }
    if (best.total < kLost) return best;
    const Vector2d at = in_steps(x);
    for (std::int32_t j = first(at, 1); j <= last(at, 1); ++j)
      for (std::int32_t i = first(at, 0); i <= last(at, 0); ++i) look(field_.node(i, j), field_.value(i, j));
    return best;
  }
  std::int32_t first(const Vector2d& at, std::size_t d) const {
    return static_cast<std::int32_t>(
        std::clamp(std::floor(at[static_cast<Eigen::Index>(d)] - kReach), 0.0, field_.count[d] - 1.0));
  }
  std::int32_t last(const Vector2d& at, std::size_t d) const {
    return static_cast<std::int32_t>(
        std::clamp(std::ceil(at[static_cast<Eigen::Index>(d)] + kReach), 0.0, field_.count[d] - 1.0));
  }

  const CostField& field_;
  const Problem& problem_;
  MoveCheck moves_;
};

std::string in_words(const Vector2d& x) {
  std::ostringstream out;
  out << '(' << x[0] << ", " << x[1] << ')';
  return out.str();
}

/// The same by a field of arrivals at the target, whose nodes know where their last move came from: where a current
/// leaves few directions, the values alone do not say it. Without points where that is lost too.
std::vector<Vector2d> way_by_arrivals(const CostField& field, const Problem& problem, const Vector2d& place) {
  const LatticeBox box{field.lower, field.node(field.count[0] - 1, field.count[1] - 1), {}, {}};
  ArrivalField::Way how;
  how.cells = {field.count[0] - 1, field.count[1] - 1};
  std::vector<Vector2d> best;
  double least = kLost;
  for (const Eigen::VectorXd& other : field.places) {
    Problem between = problem;
    between.source.u = field.to_places ? Eigen::VectorXd(place) : other;
    between.target.u = field.to_places ? other : Eigen::VectorXd(place);
    const MoveCheck moves(between);
    const ArrivalField arrivals(between, moves, box, 0, how, [] { return false; });
    if (!arrivals.arrival_cost() || !(*arrivals.arrival_cost() < least)) continue;
    try {
      best = arrivals.way();
      least = *arrivals.arrival_cost();
    } catch (const InitializationError&) {  // lost between the nodes
      continue;
    }
  }
  return best;
}

/// Lowers the cost of a way as it is walked by moving its points across it: many at once, then fewer.
class WayTightening {
 public:
  WayTightening(const Problem& problem, std::vector<Vector2d> way, double step, const Eigen::AlignedBox2d& room)
      : problem_(problem), moves_(problem), way_(std::move(way)), step_(step), room_(room) {
    for (const Vector2d& point : way_) room_.extend(point);
    for (std::size_t i = 0; i + 1 < way_.size(); ++i) costs_.push_back(move(way_[i], way_[i + 1]));
  }

  std::vector<Vector2d> tightened() {
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
    std::vector<Vector2d> finer = {way_[0]};
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
  Eigen::VectorXd ambient(const Vector2d& u) const { return positions(*problem_.manifold, {u, {}, true}).col(0); }

  double move(const Vector2d& from, const Vector2d& to) const {
    const Eigen::VectorXd a = ambient(from), b = ambient(to);
    double sum = 0;
    Eigen::VectorXd last = a;
    for (int k = 1; k <= kPieces; ++k) {
      const Eigen::VectorXd next = k == kPieces ? b : ambient(from + double(k) / kPieces * (to - from));
      sum += moves_.cost(last, next);
      last = next;
    }
    return sum < kLost && moves_.clear(a, b, kLost) ? sum : kLost;
  }

  /// The points up to `reach` before and after point i across the way by `by`, those farther off by less.
  void shift(std::size_t i, std::size_t reach, double by) {
    const std::size_t low = i > reach ? i - reach : 0, high = std::min(i + reach, way_.size() - 1);
    const Vector2d along = way_[high] - way_[low];
    if (!(along.norm() > 0) || !(by > 0)) return;
    const Vector2d across = Vector2d(-along[1], along[0]) / along.norm();
    const double here =
        std::accumulate(costs_.begin() + std::ptrdiff_t(low), costs_.begin() + std::ptrdiff_t(high), 0.0);
    if (!(here < kLost)) return;
    const auto tried = [&](double amount) {
      Trial trial{amount, 0, {}, {}};
      Vector2d last = way_[low];
      for (std::size_t k = low + 1; k <= high; ++k) {
        const double share = k <= i ? double(k - low) / double(i - low) : double(high - k) / double(high - i);
        const Vector2d next = way_[k] + amount * share * across;
        trial.costs.push_back(room_.contains(next) ? move(last, next) : kLost);
        trial.cost += trial.costs.back();
        if (!(trial.cost < kLost)) break;
        trial.points.push_back(next);
        last = next;
      }
      return trial;
    };
    // Where a parabola through three of them is lowest, or at the better side, or nearer where moves may not go.
    const Trial one = tried(by), other = tried(-by);
    Trial best = one.cost < other.cost ? one : other;
    const double bend = one.cost + other.cost - 2 * here;
    if (bend < kLost && bend > 0) {
      Trial lowest = tried(std::clamp(by * (other.cost - one.cost) / (2 * bend), -2 * by, 2 * by));
      if (lowest.cost < best.cost) best = std::move(lowest);
    } else if (!(bend < kLost)) {
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
    std::vector<Vector2d> points;
    std::vector<double> costs;
  };
  static constexpr double kRounding = 1e-12;

  const Problem& problem_;
  MoveCheck moves_;
  std::vector<Vector2d> way_;
  std::vector<double> costs_;  ///< of the moves
  double step_;                ///< of the lattice, halved with the moves
  Eigen::AlignedBox2d room_;   ///< that points may be in
};

}  // namespace

std::vector<Vector2d> way_down(const CostField& field, const Problem& problem, const Vector2d& place) {
  if (!place.allFinite()) throw InputError("field: a place needs two finite coordinates");
  const Vector2d last = field.node(field.count[0] - 1, field.count[1] - 1);
  if (((place - field.lower + field.step).array() < 0).any() || ((last + field.step - place).array() < 0).any())
    throw InputError("field: the place " + in_words(place) + " is outside the field, which reaches from " +
                     in_words(field.lower) + " to " + in_words(last));
  const FieldDescent descent(field, problem);
  if (!descent.is_reached(place))
    throw InputError("field: no path leads " + std::string(field.to_places ? "from" : "to") + " the place " +
                     in_words(place) + ": it has no data, or obstacles or places without data lie between");
  std::vector<Vector2d> way = descent.way(place);
  if (!field.to_places) std::reverse(way.begin(), way.end());
  if (way.empty()) way = way_by_arrivals(field, problem, place);
  if (way.empty())
    throw InputError("field: the way " + std::string(field.to_places ? "from" : "to") + " the place " +
                     in_words(place) + " is lost between the nodes: use a smaller resolution");
  std::vector<Vector2d> tight = WayTightening(problem, way, field.step.minCoeff(), {field.lower, last}).tightened();
  return cost_of_way(problem, tight) < cost_of_way(problem, way) ? tight : way;
}

double cost_of_way(const Problem& problem, const std::vector<Vector2d>& way) {
  constexpr Index kPieces = 4;  // of a move, which is two cells long
  if (way.size() < 2) return 0;
  const auto moves = static_cast<Index>(way.size()) - 1;
  CoordinatePath fine{Points(2, moves * kPieces + 1), {}, false};
  for (Index i = 0; i < moves; ++i) {
    const Vector2d &a = way[static_cast<std::size_t>(i)], &b = way[static_cast<std::size_t>(i) + 1];
    for (Index k = 0; k < kPieces; ++k) fine.u.col(i * kPieces + k) = a + double(k) / double(kPieces) * (b - a);
  }
  fine.u.rightCols<1>() = way.back();
  return PathEnergy(problem, 1).cost(fine);
}

}  // namespace leastcost
