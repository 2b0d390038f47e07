// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include <leastcost/framework/certificate/certify.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/newton.hpp>
#include "framework/energy/spacing.hpp"

/// Composing problems in one line each.
namespace leastcost::test {

inline std::shared_ptr<const EuclideanManifold> space(int dimension) {
  return std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = dimension});
}
inline std::shared_ptr<const EuclideanManifold> box(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  return std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{static_cast<int>(lower.size()), {lower, upper}});
}

/// An open path from source to target.
inline Problem between(std::shared_ptr<const ConstraintManifold> manifold, std::shared_ptr<const SegmentCost> cost,
                       const Eigen::VectorXd& source, const Eigen::VectorXd& target,
                       std::shared_ptr<const Kernel> kernel = make_kernel<Expm1Square>()) {
  const PathEnd from = project_end(*manifold, source), to = project_end(*manifold, target);
  return {std::move(manifold), std::move(cost), std::move(kernel), from, to, false};
}
inline Problem closed(std::shared_ptr<const ConstraintManifold> manifold, std::shared_ptr<const SegmentCost> cost,
                      std::shared_ptr<const Kernel> kernel = make_kernel<Expm1Square>()) {
  return {std::move(manifold), std::move(cost), std::move(kernel), {}, {}, true};
}

/// A bead from `source`, at rest unless start_speed says otherwise.
inline Problem bead(const Eigen::VectorXd& source, const Eigen::VectorXd& target, double gravity = 1,
                    double start_speed = 0, TravelTimeRule rule = TravelTimeRule::chute,
                    std::shared_ptr<const Kernel> kernel = make_kernel<Expm1Square>()) {
  TravelTimeOptions options;
  options.rule = rule;
  options.gravity = gravity;
  options.start_speed = start_speed;
  const int d = static_cast<int>(source.size());
  return between(space(d), make_travel_time_cost(options, d, source), source, target, std::move(kernel));
}

/// find_path() from the straight line with Newton and a full certificate, of as many points as are asked for.
inline Result find(const Problem& problem, int points, const Initializer& initializer = StraightInitializer(),
                   const Solver& solver = Newton()) {
  FindOptions options;
  options.points = points;
  options.certificate.refine = 0;
  return find_path(problem, initializer, solver, options);
}

/// The same chain as the caller of find_path() gets, without a curve of its own.
inline PostProcessed as_delivered(const Problem& problem, const CoordinatePath& chain) {
  PathEnergy energy(problem, 1);
  return {{energy.ambient(chain).x, {}, energy.cost(chain), {}}, chain, energy.costs(chain), {}};
}

/// Certifies a chain as it stands, by default at s0 = its mean segment cost (1 for a chain that costs nothing).
inline Certificate certify_chain(const Problem& problem, const CoordinatePath& chain, double reference_cost = 0) {
  const PostProcessed delivered = as_delivered(problem, chain);
  if (reference_cost <= 0) reference_cost = delivered.curve.cost / static_cast<double>(chain.segment_count());
  return certify(problem, reference_cost > 0 ? reference_cost : 1, delivered,
                 [&](const CoordinatePath& path) { return as_delivered(problem, path); }, {}, {});
}

inline bool failed(const Certificate& certificate, std::string_view name) {
  for (const CertificateFailure& failure : certificate.failures)
    if (failure.name() == name) return true;
  return false;
}

/// All failures in one line, for messages.
inline std::string failures(const Certificate& certificate) {
  std::string text = certificate.measured ? "" : "not measured";
  for (const CertificateFailure& failure : certificate.failures) text += failure.name() + ": " + failure.message + "; ";
  return text.empty() ? "certified" : text;
}

}  // namespace leastcost::test
