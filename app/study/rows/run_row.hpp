// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace leastcost::app {

/// What became of one repetition of one cell of a study. `cannot_solve` is an answer; all others but `ok` are failures
/// of the study.
namespace outcome {
inline constexpr const char* kOk = "ok";  ///< a path came back, certified or not
inline constexpr const char* kConfigurationError = "configuration_error";
inline constexpr const char* kInputError = "input_error";
inline constexpr const char* kNoPath = "no_path";
inline constexpr const char* kCannotSolve = "cannot_solve";  ///< the solver says beforehand that it cannot
inline constexpr const char* kError =
    "error";  ///< an exception that nobody expected, or a solver that returned no path
inline constexpr const char* kCrash = "crash";
inline constexpr const char* kTimeout = "timeout";
inline constexpr const char* kMemory = "memory";
}  // namespace outcome

/// One row of runs.csv: one repetition of one cell. An empty optional is an empty field: does not apply. Costs in the
/// unit of the problem's cost, times in seconds.
struct RunRow {
  long cell = 0;        ///< in the full grid, from 0
  long repetition = 0;  ///< from 0
  std::string problem, solver, kernel;
  std::optional<long> points;      ///< free points that were used
  std::optional<long> seed;        ///< of everything random
  std::vector<std::string> swept;  ///< values of RunTable::swept_keys
  std::string outcome;             ///< see above
  std::string status;              ///< of the result; empty unless ok
  std::string termination, message;
  std::string failures;  ///< names of the certificate's failures, joined by ;
  std::optional<long> iterations, evaluations, energies, gradients, hessians, projections, linear_solves;
  std::optional<double> cost, cost_error_bar, chain_cost, solver_error, optimum, optimum_error, spacing;
  std::optional<double> initial_energy, final_energy;
  std::optional<double> energy_slope;  ///< sum H'(s) s: an energy excess divided by it is a relative cost excess
  std::optional<double> s_read, s_initialize, s_solve, s_post_process, s_certify;
};

/// One line of a solver's history: one row of traces.csv.
struct TraceRow {
  long cell = 0, repetition = 0, iteration = 0, evaluations = 0;
  double seconds = 0, energy = 0, cost_error = 0, step = 0;
};

/// What a repetition of a cell leaves behind.
struct CellResult {
  RunRow row;
  std::vector<TraceRow> trace;
};

/// The columns in their order, said once for writing and reading CSV and the journal: `visit(name, member)`. `Row` is
/// RunRow or const RunRow. The swept keys stand between the two halves.
template <class Row, class Visit>
void visit_axis_columns(Row& row, Visit&& visit) {
  visit("cell", row.cell);
  visit("repetition", row.repetition);
  visit("problem", row.problem);
  visit("solver", row.solver);
  visit("kernel", row.kernel);
  visit("points", row.points);
  visit("seed", row.seed);
}

template <class Row, class Visit>
void visit_time_columns(Row& row, Visit&& visit) {
  visit("s_read", row.s_read);
  visit("s_initialize", row.s_initialize);
  visit("s_solve", row.s_solve);
  visit("s_post_process", row.s_post_process);
  visit("s_certify", row.s_certify);
}

template <class Row, class Visit>
void visit_result_columns(Row& row, Visit&& visit) {
  visit("outcome", row.outcome);
  visit("status", row.status);
  visit("termination", row.termination);
  visit("message", row.message);
  visit("failures", row.failures);
  visit("iterations", row.iterations);
  visit("evaluations", row.evaluations);
  visit("energies", row.energies);
  visit("gradients", row.gradients);
  visit("hessians", row.hessians);
  visit("projections", row.projections);
  visit("linear_solves", row.linear_solves);
  visit("cost", row.cost);
  visit("cost_error_bar", row.cost_error_bar);
  visit("chain_cost", row.chain_cost);
  visit("solver_error", row.solver_error);
  visit("optimum", row.optimum);
  visit("optimum_error", row.optimum_error);
  visit("spacing", row.spacing);
  visit("initial_energy", row.initial_energy);
  visit("final_energy", row.final_energy);
  visit("energy_slope", row.energy_slope);
  visit_time_columns(row, visit);
}

}  // namespace leastcost::app
