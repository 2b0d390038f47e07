// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/ceres/ceres_solver.hpp>

#include <string>

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/errors.hpp>
#include "solvers/ceres/line_search.hpp"
#include "solvers/ceres/trust_region.hpp"

namespace leastcost {
namespace {

constexpr Index kMostForBfgs = 1000;  ///< variables: a dense matrix of them

}  // namespace

Ceres::Ceres(CeresOptions options) : options_(checked(options)) {}

std::optional<std::string> Ceres::cannot_solve(const PathEnergy& energy, const CoordinatePath& path) const {
  const Index variables = energy.problem().manifold->dimensions().tangent * path.free_count();
  if (options_.algorithm == CeresAlgorithm::bfgs && variables > kMostForBfgs)
    return "ceres bfgs keeps a dense matrix: at most " + std::to_string(kMostForBfgs) +
           " variables, but this path has " + std::to_string(variables) + "; lbfgs has no such limit";
  return std::nullopt;
}

SolveReport Ceres::do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  switch (options_.algorithm) {
    case CeresAlgorithm::levenberg_marquardt:
      return solve_by_trust_region(energy, path, ceres::LEVENBERG_MARQUARDT, options_.rounds, options_.max_iterations,
                                   monitor);
    case CeresAlgorithm::dogleg:
      return solve_by_trust_region(energy, path, ceres::DOGLEG, options_.rounds, options_.max_iterations, monitor);
    case CeresAlgorithm::lbfgs: return solve_by_line_search(energy, path, ceres::LBFGS, options_.rounds, monitor);
    case CeresAlgorithm::bfgs: return solve_by_line_search(energy, path, ceres::BFGS, options_.rounds, monitor);
    case CeresAlgorithm::ncg:
      return solve_by_line_search(energy, path, ceres::NONLINEAR_CONJUGATE_GRADIENT, options_.rounds, monitor);
  }
  throw OptionError("algorithm", "is not an algorithm of ceres");
}

}  // namespace leastcost
