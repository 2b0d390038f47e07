// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <leastcost/framework/energy/solver.hpp>
#include "python/src/definition.hpp"

namespace leastcost::python {

/// A solver written in Python: a function of a chain (see Chain) that returns points. Of the paths that it has asked
/// for and the one that it returns, the one with the least energy is taken.
class PythonSolver final : public Solver {
 public:
  /// With or without the GIL.
  PythonSolver(const PythonOptions& options, const std::filesystem::path& folder);
  ~PythonSolver() override;
  PythonSolver(const PythonSolver&) = delete;
  PythonSolver& operator=(const PythonSolver&) = delete;

  std::string_view name() const override { return name_; }
  /// Points on the faces of a mesh are more than their coordinates.
  std::optional<std::string> cannot_solve(const PathEnergy& energy, const CoordinatePath& path) const override;

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override;

  std::string name_;
  pybind11::function solve_;  ///< solve(chain, options)
  pybind11::object options_;  ///< a dict
  std::shared_ptr<CallErrors> errors_;
};

}  // namespace leastcost::python
