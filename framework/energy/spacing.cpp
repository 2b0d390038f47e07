// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/energy/spacing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/fits_segments.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/domain/in_parts.hpp"

namespace leastcost {
namespace {

/// A cubic that leaves the middle of a segment by more than this part of its length does not belong to a smooth curve.
constexpr double kSmoothBend = 0.5;

/// A polyline by arc length in coordinates.
class ArcLength {
 public:
  explicit ArcLength(const CoordinatePath& polyline) : polyline_(polyline), knots_(polyline.segment_count() + 1) {
    knots_[0] = 0;
    for (Index i = 0; i + 1 < knots_.size(); ++i) knots_[i + 1] = knots_[i] + (column(i + 1) - column(i)).norm();
  }
  double length() const { return knots_[knots_.size() - 1]; }
  const Eigen::VectorXd& knots() const { return knots_; }

  /// Position and site hint at arc length t.
  void at(double t, Eigen::Ref<Eigen::VectorXd> position, Site& site) const {
    const double* begin = knots_.data();
    const double* end = begin + knots_.size();
    const Index i = std::clamp<Index>(std::upper_bound(begin, end, t) - begin - 1, 0, knots_.size() - 2);
    const double step = knots_[i + 1] - knots_[i];
    const double w = step > 0 ? std::clamp((t - knots_[i]) / step, 0.0, 1.0) : 0;
    position = (1 - w) * column(i) + w * column(i + 1);
    site = polyline_.site(i);
  }

 private:
  Eigen::VectorXd column(Index i) const { return polyline_.column(i); }

  const CoordinatePath& polyline_;
  Eigen::VectorXd knots_;
};

/// The polyline's points at arc lengths t (N + 1 of them; in a ring the last is the first again).
CoordinatePath points_at(const Problem& problem, const ArcLength& curve, const CoordinatePath& polyline,
                         const Eigen::VectorXd& t, const Deadline& deadline) {
  const Index columns = polyline.ring ? t.size() - 1 : t.size();
  CoordinatePath path{Points(polyline.u.rows(), columns), {}, polyline.ring, polyline.closing};
  path.sites.resize(polyline.sites.empty() ? 0 : static_cast<std::size_t>(columns));
  Site site = kNoSite;
  for (Index i = 0; i < columns; ++i) {
    curve.at(t[i], path.u.col(i), site);
    if (!path.sites.empty()) path.sites[static_cast<std::size_t>(i)] = site;
  }
  const Projection projection = project(*problem.manifold, path, deadline);
  if (!projection.failed.empty())
    throw InitializationError("point " + std::to_string(projection.failed.front()) +
                              " of the first path has no nearest point on the domain; give waypoints around it" +
                              reason_for_failure(*problem.manifold, path.u.col(projection.failed.front())));
  if (!polyline.ring) {  // the ends are given, not found again
    path.u.col(0) = polyline.u.col(0);
    path.u.rightCols(1) = polyline.u.rightCols(1);
    if (!path.sites.empty() && !polyline.sites.empty()) {
      path.sites.front() = polyline.sites.front();
      path.sites.back() = polyline.sites.back();
    }
  }
  return path;
}

/// New arc lengths at equal shares of the cost, from the costs of the segments between the old ones.
Eigen::VectorXd equal_shares(const Eigen::VectorXd& t, const Eigen::VectorXd& costs) {
  const Index n = costs.size();
  Eigen::VectorXd cumulative(n + 1);
  cumulative[0] = 0;
  for (Index i = 0; i < n; ++i) cumulative[i + 1] = cumulative[i] + costs[i];
  Eigen::VectorXd next = t;
  Index j = 0;
  for (Index i = 1; i < n; ++i) {
    const double share = cumulative[n] * static_cast<double>(i) / static_cast<double>(n);
    while (j + 1 < n && cumulative[j + 1] < share) ++j;
    const double w = costs[j] > 0 ? (share - cumulative[j]) / costs[j] : 0;
    next[i] = t[j] + std::clamp(w, 0.0, 1.0) * (t[j + 1] - t[j]);
  }
  return next;
}

}  // namespace

void refuse_infinite(const Problem& problem, const Points& x, const Eigen::VectorXd& costs) {
  Index bad = 0;
  while (bad < costs.size() && std::isfinite(costs[bad])) ++bad;
  if (bad == costs.size()) return;
  const std::string reason = reason_for_infinity(*problem.cost, x.col(bad), x.col((bad + 1) % x.cols()));
  throw InitializationError("the first path has infinite cost on segment " + std::to_string(bad) + " of " +
                            std::to_string(costs.size()) +
                            (reason.empty() ? ": the cost is not defined along all of it" : reason) +
                            "; give another initializer or waypoints");
}

double spread(const Eigen::VectorXd& costs) {
  const double least = costs.minCoeff();
  return least > 0 ? costs.maxCoeff() / least - 1 : std::numeric_limits<double>::infinity();
}

CoordinatePath MaybeChain::or_throw() && {
  if (!chain) throw InitializationError(why_not);
  return std::move(*chain);
}

MaybeChain try_sampling(const Problem& problem, const CoordinatePath& polyline, const Sampling& sampling,
                        const Deadline& deadline) {
  try {
    return {sample_equally(problem, polyline, sampling, deadline), ""};
  } catch (const InitializationError& error) {
    return {std::nullopt, error.what()};
  }
}

CoordinatePath sample_equally(const Problem& problem, const CoordinatePath& polyline, const Sampling& sampling,
                              const Deadline& deadline) {
  const ArcLength curve(polyline);
  if (!(curve.length() > 0)) throw InitializationError("the first path has no length");
  const Index segments = polyline.ring ? sampling.points : sampling.points + 1;
  PathEnergy energy(problem, 1, deadline);
  Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(segments + 1, 0, curve.length());
  CoordinatePath path = points_at(problem, curve, polyline, t, deadline);
  Eigen::VectorXd costs = energy.costs(path);
  refuse_infinite(problem, energy.ambient(path).x, costs);
  try {
    for (int pass = 0; pass < sampling.passes && !(spread(costs) < sampling.tolerance) && costs.sum() > 0; ++pass) {
      const Eigen::VectorXd next = equal_shares(t, costs);
      CoordinatePath trial = points_at(problem, curve, polyline, next, deadline);
      const Eigen::VectorXd trial_costs = energy.costs(trial);
      if (!trial_costs.allFinite()) break;  // the even samples at least have a cost
      t = next;
      costs = trial_costs;
      path = std::move(trial);
    }
  } catch (const Interrupted&) {  // unevenly spaced they are a path all the same
  }
  return path;
}

CoordinatePath sample_evenly(const Problem& problem, const CoordinatePath& polyline, int points,
                             const Deadline& deadline) {
  const ArcLength curve(polyline);
  const Index segments = polyline.ring ? points : points + 1;
  return points_at(problem, curve, polyline, Eigen::VectorXd::LinSpaced(segments + 1, 0, curve.length()), deadline);
}

CoordinatePath refine(const Problem& problem, const CoordinatePath& path, const Deadline& deadline) {
  const Index columns = path.u.cols(), segments = path.segment_count();
  CoordinatePath fine{Points(path.u.rows(), path.ring ? 2 * columns : 2 * columns - 1), {}, path.ring, path.closing};
  fine.sites.resize(path.sites.empty() ? 0 : static_cast<std::size_t>(fine.u.cols()));
  const auto x = [&path](Index i) { return path.column(i); };
  const auto fill = [&](bool cubic) {
    for (Index i = 0; i < columns; ++i) fine.u.col(2 * i) = path.u.col(i);
    for (Index i = 0; i < segments; ++i) {
      const bool left = path.ring || i > 0, right = path.ring || i + 2 < columns;
      const Eigen::VectorXd a = x(i), b = x(i + 1), linear = (a + b) / 2;
      Eigen::VectorXd middle = linear;
      if (cubic && left && right) middle = (9 * (a + b) - x(i - 1) - x(i + 2)) / 16;
      if (cubic && left && !right) middle = (3 * b + 6 * a - x(i - 1)) / 8;
      if (cubic && !left && right) middle = (3 * a + 6 * b - x(i + 2)) / 8;
      // Points that jump (around a pole, in a chart) are no samples of a smooth curve.
      if (!((middle - linear).norm() <= kSmoothBend * (b - a).norm())) middle = linear;
      fine.u.col(2 * i + 1) = middle;
    }
    for (std::size_t i = 0; i < fine.sites.size(); ++i) fine.sites[i] = path.sites[i / 2];
    // What the domain is fitted to are the moves of this path, not those of the finer one.
    const auto* fits = find_ability<FitsSegments>(*problem.manifold);
    const std::shared_ptr<const ConstraintManifold> domain = fits != nullptr ? fits->unfitted(fine) : problem.manifold;
    project(*domain, fine, deadline);
    for (Index i = 0; i < columns; ++i) fine.u.col(2 * i) = path.u.col(i);
  };
  fill(true);
  PathEnergy energy(problem, 1, deadline);
  if (!energy.costs(fine).allFinite()) fill(false);
  return fine;
}

}  // namespace leastcost
