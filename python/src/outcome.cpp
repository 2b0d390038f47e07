// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "python/src/outcome.hpp"

#include <leastcost/catalogue/output/write_run.hpp>
#include "python/src/arrays.hpp"

namespace leastcost::python {

namespace py = pybind11;

const RunOutcome& Outcome::run() const {
  if (!run_) throw OutputError("a result that was pickled has no files and no picture any more: make them before");
  return *run_;
}

py::object Outcome::points() const { return run_ ? rows_of(run_->result.path.u) : py::object(state_[0]); }

py::object Outcome::curve() const { return run_ ? rows_of(run_->result.curve.x) : py::object(state_[1]); }

py::object Outcome::json() const { return run_ ? py::str(result_json(*run_)) : py::object(state_[2]); }

std::filesystem::path Outcome::write(const std::filesystem::path& folder, bool replace) const {
  const RunOutcome& outcome = run();
  const py::gil_scoped_release released;
  return write_run(outcome, folder, {.replace = replace});
}

py::tuple Outcome::state() const { return py::make_tuple(points(), curve(), json()); }

}  // namespace leastcost::python
