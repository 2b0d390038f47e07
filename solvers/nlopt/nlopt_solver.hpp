// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <leastcost/framework/solver.hpp>
#include <leastcost/solvers/rounds.hpp>

namespace leastcost {

struct NloptOptions {
  std::string algorithm = "lbfgs";
  RoundOptions rounds = {};
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
