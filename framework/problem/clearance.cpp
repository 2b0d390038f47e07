// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/problem/clearance.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/measures_chains.hpp>
#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

constexpr double kContact = 1e-11;  ///< of the size of the coordinates: so near is in contact

}  // namespace

std::optional<Clearance> measure_clearance(const ConstraintManifold& manifold, const Points& curve, bool ring,
                                           const Deadline& deadline) {
  constexpr Index kSegmentsAtOnce = 64;  // between two looks at the clock
  const auto* obstacles = find_ability<ChecksMoves>(manifold);
  if (obstacles == nullptr) return std::nullopt;
  Clearance least;
  look_at_clock(deadline);
  const auto* chains = find_ability<MeasuresChains>(manifold);
  if (chains != nullptr && !ring && curve.cols() > 1)
    if (std::optional<ChainClearance> whole = chains->chain_clearance(curve)) {
      MoveClearance& move = whole->least;
      return Clearance{
          move.lower, move.upper, obstacles->obstacle_name(move.obstacle), whole->segment, std::move(move.place),
          move.proved};
    }
  least.lower = least.upper = std::numeric_limits<double>::infinity();
  bool all_proved = true;
  const Index segments = ring ? curve.cols() : curve.cols() - 1;
  for (Index i = 0; i < segments; ++i) {
    if (i % kSegmentsAtOnce == 0) look_at_clock(deadline);
    MoveClearance move = obstacles->clearance(curve.col(i), curve.col((i + 1) % curve.cols()));
    all_proved = all_proved && move.proved;
    const bool unknown = std::isnan(move.lower);  // a checker that cannot say so has not said that the way is clear
    if (!unknown && move.lower >= least.lower) continue;
    least = {move.lower, move.upper, obstacles->obstacle_name(move.obstacle), i, std::move(move.place)};
    if (!unknown) continue;
    least.lower = -std::numeric_limits<double>::infinity();
    break;
  }
  least.proved = all_proved;
  return least;
}

bool goes_clear(const ChecksMoves& obstacles, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const double size = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  return obstacles.clearance(a, b).lower >= -kContact * size;
}

std::string why_in_clearance(const Problem& problem, const PathEnd& end) {
  const auto* obstacles = find_ability<ChecksMoves>(*problem.manifold);
  if (obstacles == nullptr) return "";
  const Eigen::VectorXd x = positions(*problem.manifold, {end.u, {}, true});
  double size = x.cwiseAbs().maxCoeff();
  for (const PathEnd* other : {&problem.source, &problem.target})  // an end at the origin has no size of its own
    if (other->u.size() == end.u.size()) size = std::max(size, other->u.cwiseAbs().maxCoeff());
  const MoveClearance here = obstacles->clearance(x, x);
  if (here.upper >= -kContact * size) return "";
  std::string deep = obstacles->depth_text(here.obstacle, -here.upper);
  if (!deep.empty()) return deep;
  return "is " + short_number(-here.upper) + " too close to " + obstacles->obstacle_name(here.obstacle);
}

double contact_tolerance(const Points& x, double allowed) {
  constexpr double kLastDigits = 64 * std::numeric_limits<double>::epsilon();  // what proofs of clearance allow, too
  const double extent = extent_of(x);
  return allowed * extent + kLastDigits * x.cwiseAbs().maxCoeff();
}

double depth_in_obstacles(const Problem& problem, const CoordinatePath& chain, double allowed,
                          const Deadline& deadline) {
  if (find_ability<ChecksMoves>(*problem.manifold) == nullptr) return 0;
  const Points x = positions(*problem.manifold, chain);
  const auto clearance = measure_clearance(*problem.manifold, x, chain.ring, deadline);
  return clearance && clearance->lower < -contact_tolerance(x, allowed) ? -clearance->lower : 0;
}

}  // namespace leastcost
