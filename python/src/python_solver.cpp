// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "python/src/python_solver.hpp"

#include <exception>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "python/src/chain.hpp"

namespace leastcost::python {

namespace py = pybind11;

PythonSolver::PythonSolver(const PythonOptions& options, const std::filesystem::path& folder)
    : name_(options.definition().type), errors_(options.errors()) {
  const py::gil_scoped_acquire gil;
  solve_ = options.definition().call;
  options_ = options.dict(folder);
}

PythonSolver::~PythonSolver() {
  const py::gil_scoped_acquire gil;
  solve_ = {};
  options_ = {};
}

std::optional<std::string> PythonSolver::cannot_solve(const PathEnergy&, const CoordinatePath& path) const {
  if (path.sites.empty()) return std::nullopt;
  return "the solver " + name_ +
         " is written in Python and moves points by their coordinates, which do not say in which face of this domain "
         "a point is";
}

SolveReport PythonSolver::do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  if (errors_->any()) throw Interrupted("a function has raised an exception");
  std::shared_ptr<Chain> chain;
  std::optional<Points> returned;
  {
    const py::gil_scoped_acquire gil;
    chain = std::make_shared<Chain>(energy, path, monitor);
    try {
      const Numbers rows = solve_(chain, options_);
      returned = columns_of(rows);
    } catch (...) {
      chain->close();
      if (!chain->ended()) {  // else it was stopped, whatever its own calls made of that
        errors_->keep(std::current_exception());
        throw;
      }
    }
  }
  return chain->finish(returned);
}

}  // namespace leastcost::python
