// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/straight.hpp>

#include <cmath>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "problems/section/projected_line.hpp"

namespace leastcost {
namespace {

constexpr int kBowSegments = 32;

/// A parabolic arc from a to b, its middle off the straight line by `sag` along coordinate `axis`.
CoordinatePath bow(const PathEnd& a, const PathEnd& b, Index axis, double sag) {
  CoordinatePath path{Points(a.u.size(), kBowSegments + 1), {}, false};
  for (Index i = 0; i <= kBowSegments; ++i) {
    const double t = static_cast<double>(i) / kBowSegments;
    path.u.col(i) = (1 - t) * a.u + t * b.u;
    path.u(axis, i) += 4 * t * (1 - t) * sag;
  }
  return path;
}

bool finite(const Problem& problem, const CoordinatePath& path) {
  return PathEnergy(problem, 1).costs(path).allFinite();
}

/// Why the line costs infinitely much, where the cost knows it.
std::string reason_on(const Problem& problem, const CoordinatePath& line) {
  const Points x = positions(*problem.manifold, line);
  std::string reason;
  for (Index i = 0; i + 1 < x.cols() && reason.empty(); ++i)
    reason = reason_for_infinity(*problem.cost, x.col(i), x.col(i + 1));
  return reason;
}

/// The line itself, or the first bow with a finite cost: last coordinate downwards first, which is where a bead can go.
CoordinatePath find_finite(const Problem& problem) {
  CoordinatePath line = bow(problem.source, problem.target, 0, 0);
  if (finite(problem, line)) return line;
  const double length = (problem.target.u - problem.source.u).norm();
  for (Index axis = problem.source.u.size() - 1; axis >= 0; --axis)
    for (const double sign : {-1.0, 1.0})
      for (const double part : {0.125, 0.25, 0.5, 1.0}) {
        CoordinatePath path = bow(problem.source, problem.target, axis, sign * part * length);
        problem.manifold->project(path);
        if (finite(problem, path)) return path;
      }
  const bool flat = problem.manifold->shape() == Shape::flat;
  if (flat && !std::isfinite(problem.cost->line_element(problem.target.u, problem.target.u - problem.source.u)))
    throw InitializationError("the cost is not defined at the target: every move to it has infinite cost" +
                              reason_for_infinity(*problem.cost, problem.source.u, problem.target.u));
  const std::string reason = reason_on(problem, line);
  throw InitializationError(
      "the cost is infinite on the straight line between the ends, and on bows around it in all coordinate directions, "
      "up to the distance between the ends" +
      (reason.empty() ? ": the cost may not be defined at an end; otherwise give waypoints"
                      : reason + "; give waypoints around such places"));
}

/// The line, projected. It may pass a place where the nearest point jumps; what is on both sides of it is no path.
CoordinatePath project_continuously(const Problem& problem) {
  constexpr int kPieces = 32;
  constexpr double kGap = 0.25;  // of the distance of the ends: several of them make up the path
  const Eigen::VectorXd &a = problem.source.u, &b = problem.target.u;
  LineProjector lines(*problem.manifold);
  std::vector<Eigen::VectorXd> points = {a};
  if (!lines.append(a, b, kPieces, kGap * (b - a).norm(), points))
    throw InitializationError("the straight line between the ends has no continuous projection onto the domain: " +
                              lines.why() + "; give waypoints around it, or use the initializer rrt");
  CoordinatePath path = as_open_path(points);
  pin_ends(problem, path);
  return path;
}

}  // namespace

FirstPath StraightInitializer::first_path(const Problem& problem, const Monitor&) const {
  if (problem.ring) throw InitializationError("a ring has no ends to join: give waypoints");
  FirstPath first;
  const bool chart = find_ability<HasChart>(*problem.manifold) != nullptr;
  if (chart || problem.manifold->shape() == Shape::flat) {
    first.path = find_finite(problem);
  } else if (problem.manifold->shape() == Shape::smooth) {
    first.path = project_continuously(problem);
  } else {  // sampled and projected by find_path()
    first.path.u.resize(problem.source.u.size(), 2);
    first.path.u << problem.source.u, problem.target.u;
  }
  if (problem.source.site != kNoSite) {
    first.path.sites.assign(static_cast<std::size_t>(first.path.u.cols()), problem.source.site);
    first.path.sites.back() = problem.target.site;
  }
  return first;
}

}  // namespace leastcost
