// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "ompl/tighten.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace leastcost {
namespace {

constexpr double kEnough = 1e-4;                            ///< relative gain of a round that is worth another
constexpr std::array<double, 3> kParts = {0.5, 0.2, 0.05};  ///< of the way to a straight stretch

/// The path with its vertices and points between them, no farther apart than an equal share of its length.
Points divided(const PlanSpace& space, const Points& x, int points) {
  double length = 0;
  for (Index i = 0; i + 1 < x.cols(); ++i) length += (x.col(i + 1) - x.col(i)).norm();
  const double share = length / (points + 1);
  std::vector<Eigen::VectorXd> all{x.col(0)};
  for (Index i = 0; i + 1 < x.cols(); ++i) {
    const double pieces = std::max(1.0, std::ceil((x.col(i + 1) - x.col(i)).norm() / share));
    for (double k = 1; k < pieces; ++k) all.push_back(space.between(x.col(i), x.col(i + 1), k / pieces));
    all.emplace_back(x.col(i + 1));
  }
  Points out(x.rows(), static_cast<Index>(all.size()));
  for (Index i = 0; i < out.cols(); ++i) out.col(i) = all[static_cast<std::size_t>(i)];
  return out;
}

class Tightening {
 public:
  Tightening(const PlanSpace& space, Points x) : space_(space), x_(std::move(x)) {}

  /// Whether the round was worth it.
  bool round(bool partial, const Monitor& monitor) {
    const double before = space_.cost(x_);
    for (Index stride = std::max<Index>(1, (x_.cols() - 1) / 2); stride >= 1; stride /= 2) {
      for (Index i = 0; i + 1 < x_.cols(); i += stride) {
        if (monitor.interrupted()) return false;
        straighten(i, std::min(i + 2 * stride, x_.cols() - 1), partial);
      }
    }
    return space_.cost(x_) < (1 - kEnough) * before;
  }

  const Points& path() const { return x_; }

 private:
  void straighten(Index begin, Index end, bool partial) {
    if (end - begin < 2) return;
    const Points now = x_.middleCols(begin, end - begin + 1);
    const double cost = space_.cost(now);
    const Points line = moved(now, 1);
    if (!(space_.cost(line) < cost)) return;
    if (space_.moves(x_.col(begin), x_.col(end))) {
      x_.middleCols(begin, now.cols()) = line;
      return;
    }
    if (!partial) return;
    for (const double part : kParts) {
      const Points next = moved(now, part);
      if (!(space_.cost(next) < cost) || !all_move(next)) continue;
      x_.middleCols(begin, now.cols()) = next;
      return;
    }
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

  bool all_move(const Points& x) const {
    for (Index i = 0; i + 1 < x.cols(); ++i)
      if (!space_.moves(x.col(i), x.col(i + 1))) return false;
    return true;
  }

  const PlanSpace& space_;
  Points x_;
};

}  // namespace

Points tighten(const PlanSpace& space, const Points& x, const TightenOptions& options, const Monitor& monitor) {
  Tightening tightening(space, divided(space, x, options.points));
  for (int k = 0; k < options.rounds && tightening.round(options.partial, monitor); ++k) {
  }
  return tightening.path();
}

}  // namespace leastcost
