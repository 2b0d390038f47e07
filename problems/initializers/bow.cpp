// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/bow.hpp>

#include <cmath>
#include <numbers>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/dense_solves.hpp"
#include "framework/domain/in_parts.hpp"

namespace leastcost {
namespace {

constexpr Index kSegments = 64;

/// A unit vector across the line, turned by `angle` about it in the first two directions across.
Eigen::VectorXd across(const Eigen::VectorXd& line, double angle) {
  const Index d = line.size();
  if (d == 2) return Eigen::Vector2d(-line[1], line[0]).normalized() * std::cos(angle);
  const Eigen::MatrixXd q = orthogonal_factor(line);
  return std::cos(angle) * q.col(1) + std::sin(angle) * q.col(2);
}

}  // namespace

void BowOptions::fields(FieldVisitor& visit) {
  visit.field("height", height,
              {.help = "Height of the arc, relative to the distance between the ends; 0.5 is nearly a half circle.",
               .minimum = 0});
  visit.field("angle", angle, {.help = "Side of the arc, as an angle about the straight line.", .unit = "degrees"});
}

FirstPath BowInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  if (problem.ring) throw InitializationError("a ring has no ends to join: give waypoints");
  const Eigen::VectorXd &a = problem.source.u, &b = problem.target.u;
  if (a.size() < 2) throw InitializationError("a path on a line cannot bow");
  const Eigen::VectorXd sag = options_.height * (b - a).norm() * across(b - a, options_.angle * std::numbers::pi / 180);
  FirstPath first;
  first.path.u.resize(a.size(), kSegments + 1);
  for (Index i = 0; i <= kSegments; ++i) {
    const double t = static_cast<double>(i) / kSegments;
    first.path.u.col(i) = (1 - t) * a + t * b + std::sin(std::numbers::pi * t) * sag;
  }
  const Projection projection = project(*problem.manifold, first.path, monitor.limit());
  if (!projection.failed.empty())
    throw InitializationError("point " + std::to_string(projection.failed.front()) + " of the arc (of " +
                              std::to_string(kSegments + 1) + ") has no nearest point on the domain");
  first.path.u.col(0) = a;
  first.path.u.col(kSegments) = b;
  return first;
}

}  // namespace leastcost
