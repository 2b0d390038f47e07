// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "ompl/plans/tighten.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <leastcost/framework/cost/has_constant_metric.hpp>
#include "problems/taut/tight_chain.hpp"

namespace leastcost {
namespace {

constexpr double kEnough = 1e-4;  ///< relative gain of a round that is worth another
constexpr int kMostPulls = 8;
constexpr int kFewPoints = 20, kManyPoints = 40;               ///< of a path to be pulled by programs, and by stretches
constexpr std::array<double, 4> kParts = {1, 0.5, 0.2, 0.05};  ///< of the way to a straight stretch

/// Equal parts of a move, from its begin to its end. Chords of a turn do not take it evenly, so that shorter ones are
/// other motions: where one of those is not valid, the move as a whole.
Points parts_of(const PlanSpace& space, const Eigen::VectorXd& a, const Eigen::VectorXd& b, Index pieces) {
  Points out(a.size(), pieces + 1);
  for (Index k = 0; k <= pieces; ++k)
    out.col(k) = space.between(a, b, static_cast<double>(k) / static_cast<double>(pieces));
  out.col(0) = a;
  out.col(pieces) = b;
  const bool same = pieces == 1 || space.is_flat();
  return same || all_move(space, out) ? out : (Points(a.size(), 2) << a, b).finished();
}

/// The cheapest way through places in their order, by moves that are asked for as late as possible (LazySP: Dellin,
/// Srinivasa 2016).
class Shortcuts {
 public:
  Shortcuts(const PlanSpace& space, Points x) : space_(space), x_(std::move(x)), moves_(x_.cols(), x_.cols()) {
    for (Index j = 1; j < x_.cols(); ++j)
      for (Index i = 0; i < j; ++i) moves_(i, j) = space_.cost(x_.col(i), space_.seen_from(x_.col(i), x_.col(j)));
  }

  Points path(const Monitor& monitor) {
    std::vector<Index> way = cheapest();
    while (!monitor.interrupted() && !ask(way)) way = cheapest();
    if (monitor.interrupted() && !ask(way)) return x_;
    Points out(x_.rows(), static_cast<Index>(way.size()));
    for (Index k = 0; k < out.cols(); ++k) {
      out.col(k) = x_.col(way[static_cast<std::size_t>(k)]);
      if (k > 0) out.col(k) = space_.seen_from(out.col(k - 1), out.col(k));
    }
    return out;
  }

 private:
  std::vector<Index> cheapest() const {
    const Index last = x_.cols() - 1;
    Eigen::VectorXd least = Eigen::VectorXd::Constant(last + 1, std::numeric_limits<double>::infinity());
    std::vector<Index> before(static_cast<std::size_t>(last + 1), 0);
    least[0] = 0;
    for (Index j = 1; j <= last; ++j) {
      before[static_cast<std::size_t>(j)] = j - 1;
      for (Index i = 0; i < j; ++i) {
        if (!(least[i] + moves_(i, j) < least[j])) continue;
        least[j] = least[i] + moves_(i, j);
        before[static_cast<std::size_t>(j)] = i;
      }
    }
    std::vector<Index> way{last};
    while (way.back() > 0) way.push_back(before[static_cast<std::size_t>(way.back())]);
    std::reverse(way.begin(), way.end());
    return way;
  }

  /// Whether all of these moves are valid; those that are not are taken out.
  bool ask(const std::vector<Index>& way) {
    bool valid = true;
    for (std::size_t k = 0; k + 1 < way.size(); ++k) {
      const Index i = way[k], j = way[k + 1];
      if (j == i + 1 || known_.count({i, j}) > 0) continue;
      if (space_.moves(x_.col(i), space_.seen_from(x_.col(i), x_.col(j)))) {
        known_.insert({i, j});
      } else {
        moves_(i, j) = std::numeric_limits<double>::infinity();
        valid = false;
      }
    }
    return valid;
  }

  const PlanSpace& space_;
  Points x_;
  Points moves_;                                  ///< what they cost; infinity: not valid
  std::set<std::pair<Index, Index>> known_ = {};  ///< valid ones
};

class Tightening {
 public:
  Tightening(const PlanSpace& space, Points x) : space_(space), x_(std::move(x)) {}

  /// Whether the round was worth it.
  bool round(const Monitor& monitor) {
    const double before = space_.cost(x_);
    for (Index stride = std::max<Index>(1, (x_.cols() - 1) / 2); stride >= 1; stride /= 2) {
      for (Index i = 0; i + 1 < x_.cols(); i += stride) {
        if (monitor.interrupted()) return false;
        straighten(i, std::min(i + 2 * stride, x_.cols() - 1));
      }
    }
    return space_.cost(x_) < (1 - kEnough) * before;
  }

  const Points& path() const { return x_; }

 private:
  void straighten(Index begin, Index end) {
    if (end - begin < 2) return;
    const Points now = x_.middleCols(begin, end - begin + 1);
    const double cost = space_.cost(now);
    Index blocked = (end - begin) / 2;  // where one part of the way was, the next ones are mostly as well
    for (const double part : kParts) {
      const Points next = moved(now, part);
      if (!(space_.cost(next) < cost) || !is_clear(next, blocked) || !planner_moves(next)) continue;
      x_.middleCols(begin, now.cols()) = next;
      return;
    }
  }

  bool planner_moves(const Points& x) const {
    for (Index i = 0; i + 1 < x.cols(); ++i)
      if (!space_.planner_moves(x.col(i), x.col(i + 1))) return false;
    return true;
  }

  /// The move that is not clear of walls is asked first the next time.
  bool is_clear(const Points& x, Index& blocked) const {
    const Index moves = x.cols() - 1;
    for (Index k = 0; k < moves; ++k) {
      const Index i = (blocked + k) % moves;
      if (space_.clear_of_walls(x.col(i), x.col(i + 1))) continue;
      blocked = i;
      return false;
    }
    return true;
  }

  /// A part of the way to the straight stretch, at equal shares of it.
  Points moved(const Points& now, double part) const {
    Points out = now;
    const Index last = now.cols() - 1;
    for (Index k = 1; k < last; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(last);
      out.col(k) = space_.between(now.col(k), space_.between(now.col(0), now.col(last), t), part);
    }
    return out;
  }

  const PlanSpace& space_;
  Points x_;
};

}  // namespace

Points divided(const PlanSpace& space, const Points& x, int points) {
  double length = 0;
  for (Index i = 0; i + 1 < x.cols(); ++i) length += (x.col(i + 1) - x.col(i)).norm();
  const double share = length / (points + 1);
  std::vector<Eigen::VectorXd> all{x.col(0)};
  for (Index i = 0; i + 1 < x.cols(); ++i) {
    const double pieces = std::max(1.0, std::ceil((x.col(i + 1) - x.col(i)).norm() / share));
    const Points parts = parts_of(space, x.col(i), x.col(i + 1), static_cast<Index>(pieces));
    for (Index k = 1; k < parts.cols(); ++k) all.emplace_back(parts.col(k));
  }
  Points out(x.rows(), static_cast<Index>(all.size()));
  for (Index i = 0; i < out.cols(); ++i) out.col(i) = all[static_cast<std::size_t>(i)];
  return out;
}

/// What is quicker first.
bool all_move(const PlanSpace& space, const Points& x) {
  for (Index i = 0; i + 1 < x.cols(); ++i)
    if (!space.clear_of_walls(x.col(i), x.col(i + 1))) return false;
  for (Index i = 0; i + 1 < x.cols(); ++i)
    if (!space.planner_moves(x.col(i), x.col(i + 1))) return false;
  return true;
}

Points with_shortcuts(const PlanSpace& space, const Points& x, int points, const Monitor& monitor) {
  return Shortcuts(space, divided(space, x, points)).path(monitor);
}

Points pulled_tight(const PlanSpace& space, const Points& x, int points, const Monitor& monitor) {
  Tightening tightening(space, divided(space, x, points));
  for (int k = 0; k < kMostPulls && tightening.round(monitor); ++k) {
  }
  return tightening.path();
}

Points pulled_among_walls(const PlanSpace& space, const Points& x, const Monitor& monitor, double gain) {
  const auto* constant = find_ability<HasConstantMetric>(space.move_costs());
  if (constant == nullptr || !space.is_flat()) return pulled_tight(space, x, kManyPoints, monitor);
  const std::shared_ptr<const Walls> seen = remembering(*space.walls());  // most looks are beside earlier ones
  return tight_chain(
      space.domain(), seen ? *seen : *space.walls(), constant->metric(), divided(space, x, kFewPoints),
      [&](const Points& p) { return all_move(space, p); }, {.gain = gain}, monitor);
}

}  // namespace leastcost
