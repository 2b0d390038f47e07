// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/cell/run_cell.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include <leastcost/catalogue/run/solve.hpp>
#include <leastcost/framework/path/kernel.hpp>
#include "catalogue/output/csv_text.hpp"
#include "catalogue/run/compose_run.hpp"
#include "catalogue/run/run_origin.hpp"

namespace leastcost::app {
namespace {

/// Sum of H'(s) s over the delivered chain: the natural unit of its energy.
double energy_slope(const Problem& problem, const Result& result) {
  double sum = 0;
  for (const double cost : result.costs) sum += kernel_slope_times_s(*problem.kernel, cost / result.reference_cost);
  return sum;
}

std::string failures_of(const Certificate& certificate) {
  std::string names;
  for (const CertificateFailure& f : certificate.failures) names += (names.empty() ? "" : ";") + f.name();
  return names;
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return text;
}

void fill_solve(const SolveReport& report, RunRow& row) {
  row.termination = word_of(report.termination);
  row.message = one_line(report.message);
  row.iterations = report.iterations;
  row.energies = report.counters.energies;
  row.gradients = report.counters.gradients;
  row.evaluations = report.counters.energies + report.counters.gradients;
  row.hessians = report.counters.hessians;
  row.projections = report.counters.projections;
  row.linear_solves = report.counters.linear_solves;
  row.initial_energy = report.initial_energy;
  row.final_energy = report.final_energy;
  row.solver_error = report.cost_error;
}

void fill_result(const RunOutcome& run, RunRow& row) {
  const Result& result = run.result;
  const Certificate& certificate = result.certificate;
  row.status = word_of(result.status);
  row.failures = failures_of(certificate);
  row.points = static_cast<long>(result.path.free_count());
  // The estimate comes from chains that the certifier has solved: of a path that is not certified it says nothing.
  const bool certified = result.status == Status::certified;
  row.cost = certified ? certificate.estimate.value : result.curve.cost;
  if (certified) row.cost_error_bar = certificate.estimate.error;
  if (certificate.measured) row.spacing = certificate.spacing;
  row.chain_cost = result.costs.sum();
  if (row.optimum) row.optimum_error = std::abs(*row.cost - *row.optimum) / std::abs(*row.optimum);
  row.energy_slope = energy_slope(run.parts.problem, result);
  row.s_read = run.seconds.read;
  row.s_initialize = result.seconds.initialize;
  row.s_solve = result.seconds.solve;
  row.s_post_process = result.seconds.post_process;
  row.s_certify = result.seconds.certify;
}

/// All iterations up to this one, then steps of 1 % of their number: a profile loses nothing it could show.
constexpr int kEveryIteration = 200;

std::vector<TraceRow> trace_of(const std::vector<Iteration>& history, const RunRow& row) {
  std::vector<TraceRow> trace;
  double next = 0;
  for (const Iteration& i : history) {
    const bool last = &i == &history.back();
    if (i.iteration > kEveryIteration && i.iteration < next && !last) continue;
    next = 1.01 * i.iteration;
    trace.push_back({row.cell, row.repetition, i.iteration, i.evaluations, i.seconds, i.energy, i.cost_error, i.step});
  }
  return trace;
}

CellResult solved(const StudyCell& cell, RunRow row) {
  const RunOutcome run = solve(compose_run(cell.config, cell.folder));
  fill_solve(run.result.solve, row);
  row.outcome = outcome::kCannotSolve;
  if (run.result.solve.termination == Termination::refused) {  // nothing was measured
    row.initial_energy.reset();
    row.final_energy.reset();
    row.solver_error.reset();
    return {row, {}};
  }
  const Termination end = run.result.solve.termination;
  if ((end == Termination::exception || end == Termination::non_finite) && !std::isfinite(run.result.curve.cost)) {
    row.outcome = outcome::kError;  // no path came back
  } else {
    row.outcome = outcome::kOk;
    fill_result(run, row);
  }
  return {row, trace_of(run.result.solve.history, row)};
}

CellResult failed(RunRow row, const char* outcome, const std::string& message) {
  row.outcome = outcome;
  row.message = one_line(message);
  return {std::move(row), {}};
}

}  // namespace

RunRow row_of(const StudyCell& cell, long repetition) {
  RunRow row;
  row.cell = cell.number;
  row.repetition = repetition;
  row.problem = cell.values[0];
  row.solver = cell.values[1];
  row.kernel = cell.values[2];
  row.points = csv_long(cell.values[3]);  // `auto` is not known yet
  row.seed = csv_long(cell.values[4]);
  row.swept.assign(cell.values.begin() + 5, cell.values.end());
  row.optimum = cell.optimum;
  return row;
}

CellResult run_cell(const StudyCell& cell, long repetition) {
  const RunRow row = row_of(cell, repetition);
  try {
    return solved(cell, row);
  } catch (const OptionError& e) {
    return failed(row, outcome::kConfigurationError, e.what());
  } catch (const InputError& e) {
    return failed(row, outcome::kInputError, e.what());
  } catch (const StoppedEarly& e) {
    return failed(row, outcome::kTimeout, std::string("max_seconds: ") + e.what());
  } catch (const InitializationError& e) {
    return failed(row, outcome::kNoPath, e.what());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    return failed(row, outcome::kError, e.what());
  }
}

}  // namespace leastcost::app
