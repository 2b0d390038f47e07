// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/energy/stopping.hpp>

#include <chrono>
#include <utility>

namespace leastcost {

SolveLoop::SolveLoop(PathEnergy& energy, const CoordinatePath& path, const Limits& limits, const Monitor& monitor)
    : energy_(energy), limits_(limits), monitor_(monitor), before_(energy.counters()), first_cost_(energy.cost(path)) {
  report_.history.reserve(64);
}

long SolveLoop::evaluations() const {
  const Counters& now = energy_.counters();
  return now.energies + now.gradients - before_.energies - before_.gradients;
}

void SolveLoop::record(double value, double cost_error, double step) {
  report_.cost_error = cost_error;
  const double seconds = std::chrono::duration<double>(Monitor::Clock::now() - start_).count();
  report_.iterations = static_cast<int>(report_.history.size());
  report_.history.push_back({report_.iterations, value, cost_error, step, evaluations(), seconds});
  monitor_.report({Stage::solve, &report_.history.back()});
}

std::optional<Termination> SolveLoop::must_end(const CoordinatePath& path) {
  if ((path.ring || energy_.problem().based) && energy_.cost(path) <= kCollapse * first_cost_)
    return Termination::collapsed;
  if (monitor_.cancelled()) return Termination::cancelled;
  if (monitor_.out_of_time()) return Termination::time_limit;
  if (report_.iterations >= limits_.max_iterations) return Termination::iteration_limit;
  if (evaluations() >= limits_.max_evaluations) return Termination::evaluation_limit;
  return std::nullopt;
}

SolveReport SolveLoop::finish(Termination termination, std::string message, double value) {
  report_.termination = termination;
  report_.message = std::move(message);
  report_.final_energy = value;
  return std::move(report_);
}

}  // namespace leastcost
