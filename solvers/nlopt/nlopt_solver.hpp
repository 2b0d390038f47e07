// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/solvers/rounds.hpp>

namespace leastcost {

/// Local optimisers of NLopt, by its names; those from cobyla on need no gradients.
enum class NloptAlgorithm {
  lbfgs,
  tnewton,
  tnewton_restart,
  tnewton_precond,
  tnewton_precond_restart,
  var1,
  var2,
  mma,
  ccsaq,
  slsqp,
  cobyla,
  bobyqa,
  neldermead,
  sbplx,
  praxis
};
Words<NloptAlgorithm> words(NloptAlgorithm);

struct NloptOptions {
  NloptAlgorithm algorithm = NloptAlgorithm::lbfgs;
  RoundOptions rounds = {};  ///< solves again, with coordinates around the last chain
  void fields(FieldVisitor& visit);
};

/// The local optimisers of NLopt 2.7 in the variables of solvers/chain_variables, round by round. What NLopt says of
/// its own success is only quoted: the best path it has asked for is judged like that of every solver.
class Nlopt final : public Solver {
 public:
  explicit Nlopt(NloptOptions options = {});
  std::string_view name() const override { return "nlopt"; }
  /// Dense methods are refused above a size at which they would take minutes.
  std::optional<std::string> cannot_solve(const PathEnergy& energy, const CoordinatePath& path) const override;

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override;
  NloptOptions options_;
};

/// Version of the library in use, "2.7.1".
std::string nlopt_version();

}  // namespace leastcost
