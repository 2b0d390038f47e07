// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/energy/solver.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/energy/chain_model.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/base/point_text.hpp"

namespace leastcost {

namespace {

/// By energy, or by the cost for methods that have no energy. What throws again is worse.
bool no_worse(PathEnergy& energy, const CoordinatePath& path, const CoordinatePath& start) {
  try {
    return energy.value(path) <= energy.value(start) || energy.cost(path) <= energy.cost(start);
  } catch (...) {
    return false;
  }
}

/// What a solver did to a path that it must not: another shape, other ends, numbers that are none.
std::string damage(const CoordinatePath& path, const CoordinatePath& start) {
  if (path.u.rows() != start.u.rows() || path.u.cols() != start.u.cols() || path.ring != start.ring ||
      (!path.sites.empty() && path.sites.size() != static_cast<std::size_t>(path.u.cols())))
    return "the solver returned a path with a different number of rows or columns";
  if (!path.u.allFinite()) return "the solver returned coordinates that are not finite";
  if (!path.ring && (path.u.col(0) != start.u.col(0) || path.u.rightCols(1) != start.u.rightCols(1)))
    return "the solver moved an end of the path";
  return "";
}

/// Stopped from outside, or without a path to measure.
bool is_outcome_of_cost(Termination t) {
  return t != Termination::cancelled && t != Termination::time_limit && t != Termination::exception &&
         t != Termination::refused && t != Termination::collapsed && t != Termination::non_finite;
}

/// Whether a solver was led to its end by a gradient of another function than the values are of (a cost whose
/// value<double> and value<Dual> disagree). By an energy of its own: the counters are the solver's.
void doubt(const PathEnergy& energy, const CoordinatePath& path, SolveReport& report) try {
  constexpr double kSame = 1e-6;  // relative; rounding is far below, two functions are far above
  if (!is_outcome_of_cost(report.termination)) return;
  PathEnergy own(energy.problem(), energy.reference_cost(), energy.deadline());
  Points gradient;
  const double value = own.value(path), other = own.value_and_gradient(path, gradient);
  if (!std::isfinite(value) || !std::isfinite(other)) return;
  if (std::abs(value - other) <= kSame * std::max(std::abs(value), std::abs(other))) return;
  const TwoNumbers texts = told_apart(value, other, 6);
  report.termination = Termination::inconsistent;
  report.message = "the cost is inconsistent: its values give the energy " + texts.first +
                   ", but its gradients belong to the energy " + texts.second +
                   "; to find the fault, call check_cost()";
} catch (...) {  // what throws now did not while solving: the report stands
}

/// The energy's deadline during one solve: that of the monitor, which hears a stop too.
class DeadlineOf {
 public:
  DeadlineOf(PathEnergy& energy, const Deadline& limit) : energy_(energy), before_(energy.deadline()) {
    if (limit) energy_.set_deadline(limit.or_time_of(before_));
  }
  ~DeadlineOf() { energy_.set_deadline(before_); }
  DeadlineOf(const DeadlineOf&) = delete;
  DeadlineOf& operator=(const DeadlineOf&) = delete;

 private:
  PathEnergy& energy_;
  Deadline before_;
};

/// The report of a solve whose last iteration was cut short by the clock: there is no time to measure anything.
SolveReport abandoned(SolveReport report, Termination why, bool unmoved, double initial) {
  report.termination = why;
  report.message = "";
  report.final_energy = initial;
  if (report.history.empty()) return report;
  const Iteration& last = report.history.back();
  report.iterations = last.iteration;
  report.cost_error = last.cost_error;
  if (!unmoved) report.final_energy = last.energy;
  return report;
}

/// Of a solve that a stop cut short, and not the clock: measured like any other, up to the number of points for which
/// that takes a few hundredths of a second. Throws Interrupted where the cost is too slow for it.
void measure_stopped(PathEnergy& energy, const CoordinatePath& path, SolveReport& report) {
  constexpr Index kMostPoints = 10000;
  constexpr std::chrono::milliseconds kMoment{200};
  if (path.u.cols() > kMostPoints) return;
  const Monitor::Clock::time_point moment = Monitor::Clock::now() + kMoment;
  const auto& end = energy.deadline().time();
  energy.set_deadline(end ? std::min(moment, *end) : moment);
  ChainModel model;
  if (!model.evaluate(energy, path)) return;
  model.solve(energy, path, HessianKind::exact);
  report.final_energy = model.value;
  report.cost_error = model.cost_error;
  if (report.history.empty()) report.history.push_back({.energy = model.value, .cost_error = model.cost_error});
}

}  // namespace

std::optional<std::string> Solver::cannot_solve(const PathEnergy&, const CoordinatePath&) const { return std::nullopt; }

SolveReport Solver::solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  const auto start = Monitor::Clock::now();
  const Counters before = energy.counters();
  double initial = std::numeric_limits<double>::quiet_NaN();
  SolveReport report = guarded(energy, path, initial, monitor);
  report.initial_energy = initial;
  report.counters = energy.counters() - before;
  report.seconds = std::chrono::duration<double>(Monitor::Clock::now() - start).count();
  return report;
}

/// After an exception the path is the last one that was accepted, and the history what the monitor was told.
SolveReport Solver::guarded(PathEnergy& energy, CoordinatePath& path, double& initial, const Monitor& monitor) const {
  const CoordinatePath start = path;
  SolveReport report;
  Monitor listening;
  listening.observe = [&](const Progress& progress) {
    if (progress.iteration != nullptr) report.history.push_back(*progress.iteration);
    monitor.report(progress);
  };
  listening.stop_requested = [&] { return monitor.cancelled(); };
  listening.deadline = monitor.deadline;
  const DeadlineOf deadline(energy, monitor.limit());
  try {
    if (const std::optional<std::string> reason = cannot_solve(energy, path)) {
      report.termination = Termination::refused;
      report.message = *reason;
      return report;
    }
    initial = energy.value(path);
    if (std::isfinite(initial)) {
      report = do_solve(energy, path, listening);
      if (const std::string why = damage(path, start); !why.empty()) {
        path = start;
        throw InputError(why);
      }
      doubt(energy, path, report);
      return report;
    }
    report.termination = Termination::non_finite;
    report.message = "the energy of the first path is not finite";
    return report;
  } catch (const Interrupted&) {
    const bool unmoved = path.u == start.u;
    const Termination why = monitor.cancelled() ? Termination::cancelled : Termination::time_limit;
    SolveReport ended = abandoned(std::move(report), why, unmoved, initial);
    if (why == Termination::time_limit) return ended;
    try {
      measure_stopped(energy, path, ended);
      if (std::isnan(initial)) initial = ended.final_energy;  // the first pass was the one that was cut short
    } catch (const Interrupted&) {                            // what is known stands
    }
    return ended;
  } catch (const std::exception& error) {
    report.message = error.what();
  } catch (...) {
    report.message = "an exception not derived from std::exception";
  }
  report.termination = Termination::exception;
  energy.set_deadline({});
  if (!no_worse(energy, path, start)) path = start;
  report.final_energy = path.u == start.u ? initial : energy.value(path);
  return report;
}

}  // namespace leastcost
