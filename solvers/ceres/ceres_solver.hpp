// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/solvers/rounds.hpp>

namespace leastcost {

/// Trust regions (the first two) and line searches; ncg: nonlinear conjugate gradients.
enum class CeresAlgorithm { levenberg_marquardt, dogleg, lbfgs, bfgs, ncg };
Words<CeresAlgorithm> words(CeresAlgorithm);

struct CeresOptions {
  CeresAlgorithm algorithm = CeresAlgorithm::levenberg_marquardt;
  int max_iterations = 500;
  RoundOptions rounds = {};  ///< solves again, with coordinates around the last chain
  void fields(FieldVisitor& visit);
};

/// The minimisers of Ceres 2.1. Trust region (levenberg_marquardt, dogleg): the residual form with the kernel as loss,
/// one parameter block per point, its tangent plane and retraction as a ceres::Manifold, sparse Cholesky. Line search
/// (lbfgs, bfgs, nonlinear conjugate gradients): in the variables of solvers/chain_variables, round by round. What
/// Ceres says of its own success is only quoted: the best path it has visited is judged like that of every solver.
/// Ceres prints its warnings through glog, whose level is one for the whole process: while a solve lasts, in any
/// thread, it is raised so that nothing below a fatal error is printed (FLAGS_minloglevel), and then put back. Nothing
/// else of the host is touched: glog is not initialised, no handler is installed.
class Ceres final : public Solver {
 public:
  explicit Ceres(CeresOptions options = {});
  std::string_view name() const override { return "ceres"; }
  std::optional<std::string> cannot_solve(const PathEnergy& energy, const CoordinatePath& path) const override;

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override;
  CeresOptions options_;
};

/// Version of the library that this was built with, "2.1.0".
std::string ceres_version();

}  // namespace leastcost
