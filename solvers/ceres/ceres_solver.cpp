// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/ceres/ceres_solver.hpp>

#include <ceres/version.h>

#include <utility>

#include "solvers/ceres/line_search.hpp"
#include "solvers/ceres/trust_region.hpp"

namespace leastcost {
namespace {

constexpr Index kMostForBfgs = 1000;  ///< variables: a dense matrix of them

bool is_trust_region(const std::string& algorithm) {
  return algorithm == "levenberg_marquardt" || algorithm == "dogleg";
}

}  // namespace

void CeresOptions::fields(FieldVisitor& visit) {
  visit.choice("algorithm", algorithm, {"levenberg_marquardt", "dogleg", "lbfgs", "bfgs", "ncg"},
               {.help = "Trust region (the first two) or line search; ncg: nonlinear conjugate gradients."});
  visit.field("max_iterations", max_iterations, {.help = "Limit on iterations of the trust region.", .minimum = 1});
  rounds.fields(visit);
}

Ceres::Ceres(CeresOptions options) : options_(std::move(options)) {}

std::optional<std::string> Ceres::cannot_solve(const PathEnergy& energy, const CoordinatePath& path) const {
  const Index variables = energy.problem().manifold->dimensions().tangent * path.free_count();
  if (options_.algorithm == "bfgs" && variables > kMostForBfgs)
    return "ceres bfgs keeps a dense matrix: at most " + std::to_string(kMostForBfgs) + " variables, this path has " +
           std::to_string(variables) + "; lbfgs has no such limit";
  return std::nullopt;
}

SolveReport Ceres::do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  if (is_trust_region(options_.algorithm)) return solve_by_trust_region(energy, path, options_, monitor);
  return solve_by_line_search(energy, path, options_, monitor);
}

std::string ceres_version() { return CERES_VERSION_STRING; }

}  // namespace leastcost
