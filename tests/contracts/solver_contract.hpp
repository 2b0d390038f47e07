// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/energy/chain_model.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include "framework/energy/spacing.hpp"
#include "framework/newton/bundle.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost::test {

/// A solver with given limits.
using MakeSolver = std::function<std::unique_ptr<Solver>(int max_iterations, int max_evaluations)>;

/// What a solver promises beyond what all do.
struct Promise {
  bool own_rule = false;       ///< ends at a fixed point of its own, which need not be a minimum of the energy
  bool by_cost = false;        ///< improves the true cost, not the energy
  bool has_iterations = true;  ///< false: a back end that counts evaluations only
  bool converges = true;       ///< false: a method without gradients, which improves and may get stuck
};

struct StandardProblem {
  std::string name;
  Problem problem;
  CoordinatePath start;
  double tolerance = 1e-14;  ///< relative cost error that a solver claims when it says "converged"
};

struct HyperbolicPlane {
  static constexpr int dim = 2;
  CostTraits traits() const { return {.unit = "hyperbolic length"}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    const S y = (a[1] + b[1]) * 0.5;
    if (!(innermost(y) > 0)) return S(std::numeric_limits<double>::infinity());
    return (b - a).squaredNorm() / (y * y);
  }
};

inline StandardProblem standard(const char* name, const Problem& problem,
                                const Initializer& initializer = StraightInitializer()) {
  const bool kinked = problem.manifold->shape() == Shape::polyhedral;
  return {name, problem, sample_equally(problem, initializer.first_path(problem, {}).path, 20),
          kinked ? kKinkedTolerance : 1e-14};
}

/// One problem per ability a solver meets: singular cost, curved metric, anisotropy in R^7, curved domain, active
/// bounds, ring, kinks.
inline std::vector<StandardProblem> standard_problems() {
  const Eigen::Vector2d left(0, 1), right(2, 1);
  const auto hyperbolic = make_segment_cost(HyperbolicPlane{});
  MetricTensorOptions metric;
  metric.matrix = Eigen::VectorXd::LinSpaced(7, 1, 40).asDiagonal();
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(7), one = Eigen::VectorXd::Ones(7);
  const Eigen::Vector3d from = Eigen::Vector3d(1, 0, 0.2).normalized(), to = Eigen::Vector3d(-0.5, 1, 0.4).normalized();
  Points loop(3, 12);
  for (Index i = 0; i < 12; ++i) {
    const double t = 2 * std::numbers::pi * static_cast<double>(i) / 12;
    loop.col(i) = Torus::at(t, std::numbers::pi + 0.4 * std::sin(2 * t));
  }
  return {
      standard("bead from rest", bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(std::numbers::pi, -2))),
      standard("half-plane", between(space(2), hyperbolic, left, Eigen::Vector2d(2, 3))),
      standard("metric in R^7", between(space(7), make_metric_tensor_cost(metric, 7), zero, one),
               WaypointsInitializer(2 * Eigen::VectorXd::Unit(7, 3))),
      standard("sphere", between(std::make_shared<Sphere>(), make_euclidean_cost(3), from, to),
               WaypointsInitializer(Eigen::Vector3d(0.3, 0.5, 0.9))),
      standard("half-plane under a lid",  // the circle of radius sqrt 2 does not fit below y = 1.2
               between(box(Eigen::Vector2d(-5, 0.1), Eigen::Vector2d(5, 1.2)), hyperbolic, left, right)),
      // A floor it has to run along, and a lid at the height of the start: at rest there, with an infinite gradient.
      standard("bead between floor and lid", between(box(Eigen::Vector2d(-5, -0.8), Eigen::Vector2d(5, 0)),
                                                     make_travel_time_cost({.gravity = 1}, 2, Eigen::Vector2d(0, 0)),
                                                     Eigen::Vector2d(0, 0), Eigen::Vector2d(3, -0.5))),
      standard("ring on a torus", closed(std::make_shared<Torus>(), make_euclidean_cost(3)),
               WaypointsInitializer(loop)),
      standard("mesh",
               between(std::make_shared<MeshManifold>(TriangleMesh(sphere(3))), make_euclidean_cost(3), from, to),
               DijkstraInitializer()),
  };
}

inline void check_report(const SolveReport& report, PathEnergy& energy, const CoordinatePath& start,
                         const CoordinatePath& path, const Promise& promise) {
  PathEnergy fresh(energy.problem(), energy.reference_cost());
  const double before = fresh.value(start), after = fresh.value(path);
  // A deadline may pass before there is anything to measure.
  if (report.termination == Termination::time_limit && report.history.empty()) {
    CHECK(report.iterations == 0);
    CHECK((std::isnan(report.final_energy) || report.final_energy == Approx(before).epsilon(1e-14)));
    CHECK(path.u == start.u);
    return;
  }
  CHECK(report.initial_energy == Approx(before).epsilon(1e-14));
  CHECK(report.final_energy == Approx(after).epsilon(1e-14));
  if (promise.by_cost)
    CHECK(fresh.cost(path) <= fresh.cost(start) * (1 + 1e-14));
  else
    CHECK(after <= before * (1 + 1e-14));
  CHECK(report.seconds > 0);
  CHECK(report.message != SolveReport().message);
  CHECK(std::isfinite(report.cost_error));
  REQUIRE_FALSE(report.history.empty());
  CHECK(report.iterations == report.history.back().iteration);
  CHECK(report.counters.gradients > 0);
  CHECK(energy.counters().gradients >= report.counters.gradients);
  if (!start.ring) CHECK((path.u.col(0) == start.u.col(0) && path.u.rightCols(1) == start.u.rightCols(1)));
  CHECK(energy.problem().manifold->residual(path) < 1e-13);
}

inline PathEnergy energy_at_mean(const StandardProblem& p) {
  return PathEnergy(p.problem, PathEnergy(p.problem, 1).cost(p.start) / static_cast<double>(p.start.segment_count()));
}

/// What two energies may differ by when both are solved to the relative cost error they claim, with room for rounding:
/// an excess of the cost by e is one of the energy by e scale. (Costs alone may differ more, where the segments are not
/// exactly equal at the minimum.)
inline double energy_tolerance(const StandardProblem& p, PathEnergy& energy, const CoordinatePath& path) {
  return 10 * p.tolerance * energy.scale(path);
}

/// A problem that the solver cannot work on comes back untouched, with the reason, and unevaluated.
inline void check_refuses(const StandardProblem& p, const Solver& solver, const std::string& reason) {
  PathEnergy energy = energy_at_mean(p);
  CoordinatePath path = p.start;
  const SolveReport report = solver.solve(energy, path, {});
  CHECK(report.termination == Termination::refused);
  CHECK(report.message == reason);
  CHECK(path.u == p.start.u);
  CHECK(report.counters.gradients == 0);
}

/// Solves, reports, counts, and does not make a path worse, nor better than it can be a second time.
inline void check_solves(const StandardProblem& p, const Solver& solver, const Promise& promise) {
  PathEnergy energy = energy_at_mean(p);
  CoordinatePath path = p.start;
  const SolveReport report = solver.solve(energy, path, {});
  CAPTURE(word_of(report.termination), report.message, report.iterations, report.cost_error);
  check_report(report, energy, p.start, path, promise);
  CHECK(report.counters.projections > 0);
  if (promise.own_rule) {
    CHECK(report.termination == Termination::fixed_point);
    return;
  }
  if (!promise.converges) {
    CHECK(report.final_energy < report.initial_energy);
    CHECK((report.termination != Termination::converged || report.cost_error <= p.tolerance));
    return;
  }
  CHECK((report.termination == Termination::converged || report.termination == Termination::round_off));
  if (report.termination == Termination::converged) CHECK(report.cost_error <= p.tolerance);
  const double floor =
      100 * rounding_slack(report.final_energy, path.segment_count());  // nobody claims more at round_off
  const SolveReport again = solver.solve(energy, path, {});
  CHECK(std::abs(again.final_energy - report.final_energy) <=
        energy_tolerance(p, energy, path) + (report.termination == Termination::round_off ? floor : 0));
}

/// Limits, stop requests and deadlines end a solve with their own reason; the path is feasible and no worse.
inline void check_ends_when_told(const StandardProblem& p, const MakeSolver& make, const Promise& promise) {
  constexpr int kMany = 100000;
  const auto run = [&](const Solver& solver, const Monitor& monitor, Termination expected) {
    PathEnergy energy = energy_at_mean(p);
    CoordinatePath path = p.start;
    const SolveReport report = solver.solve(energy, path, monitor);
    CAPTURE(word_of(report.termination), word_of(expected), report.message);
    const bool limit = expected == Termination::iteration_limit || expected == Termination::evaluation_limit;
    const bool done_before = promise.own_rule && limit && report.termination == Termination::fixed_point;
    if (!done_before) CHECK(report.termination == expected);
    check_report(report, energy, p.start, path, promise);
    return report;
  };
  if (promise.has_iterations) CHECK(run(*make(2, kMany), {}, Termination::iteration_limit).iterations <= 2);
  const Counters few = run(*make(kMany, 4), {}, Termination::evaluation_limit).counters;
  CHECK(few.energies + few.gradients <=
        4 + 80);  // the search under way is finished: 40 trials, an energy and a gradient each
  int asked = 0;
  Monitor stop;
  stop.stop_requested = [&asked] { return ++asked >= 2; };
  run(*make(kMany, kMany), stop, Termination::cancelled);
  Monitor at_once;
  at_once.stop_requested = [] { return true; };
  run(*make(kMany, kMany), at_once, Termination::cancelled);
  Monitor late;
  late.deadline = Monitor::Clock::now() - std::chrono::seconds(1);
  run(*make(kMany, kMany), late, Termination::time_limit);
}

/// Length that goes wrong at a given call: a defect of the caller's cost, which no solver may make its own.
struct FaultyLength {
  static constexpr int dim = 2;
  enum class Fault { throws, nan, infinite };
  Fault fault = Fault::throws;
  std::shared_ptr<long> calls_left;
  CostTraits traits() const { return {.unit = "length"}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    if (--*calls_left < 0) {
      if (fault == Fault::throws) throw std::runtime_error("the cost is broken");
      return S(fault == Fault::nan ? std::numeric_limits<double>::quiet_NaN()
                                   : std::numeric_limits<double>::infinity());
    }
    return (b - a).squaredNorm();
  }
};

/// Whatever a cost does in the midst of a solve, there is a typed outcome and the path is the best so far.
inline void check_survives_faults(const Solver& solver) {
  using Fault = FaultyLength::Fault;
  for (const Fault fault : {Fault::throws, Fault::nan, Fault::infinite}) {
    for (const long calls : {0L, 30L, 100L, 300L, 500L}) {  // 21 calls for an energy
      const auto calls_left = std::make_shared<long>(std::numeric_limits<long>::max());
      StandardProblem p = standard("faulty",
                                   between(space(2), make_segment_cost(FaultyLength{fault, calls_left}),
                                           Eigen::Vector2d(0, 0), Eigen::Vector2d(3, 1)),
                                   WaypointsInitializer(Eigen::Vector2d(0, 2)));
      PathEnergy energy = energy_at_mean(p);
      CoordinatePath path = p.start;
      const double before = energy.cost(path);
      *calls_left = calls;
      const SolveReport report = solver.solve(energy, path, {});
      CAPTURE(solver.name(), static_cast<int>(fault), calls, word_of(report.termination), report.message);
      *calls_left = std::numeric_limits<long>::max();
      CHECK(path.u.allFinite());
      CHECK(energy_at_mean(p).cost(path) <= before * (1 + 1e-14));  // not what was kept of a faulty call
      if (fault != Fault::throws) {
        CHECK(report.termination != Termination::exception);
        if (calls == 0)
          CHECK((report.termination == Termination::non_finite || report.termination == Termination::refused));
      } else if (report.termination == Termination::exception) {
        CHECK(report.message == "the cost is broken");
      } else {
        CHECK(calls > 0);  // it was done before
      }
    }
  }
}

/// A path with infinite energy comes back untouched, with the reason.
inline void check_refuses_infinite(const Solver& solver) {
  const Problem problem = bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(2, -1));
  CoordinatePath path{(Points(2, 4) << 0, 0.5, 1, 2, 0, 0.5, -0.5, -1).finished(), {}, false};
  const Points before = path.u;
  PathEnergy energy(problem, 1);
  const bool refuses = solver.cannot_solve(energy, path).has_value();
  const SolveReport report = solver.solve(energy, path, {});
  CHECK(report.termination == (refuses ? Termination::refused : Termination::non_finite));
  CHECK_FALSE(report.message.empty());
  CHECK(path.u == before);
}

/// A ring of one point: its only segment joins it to itself. (Ceres aborts at such a block.)
inline void check_survives_one_point(const Solver& solver) {
  const Problem problem = closed(space(2), make_euclidean_cost(2));
  CoordinatePath path{Points::Constant(2, 1, 0.5), {}, true};
  PathEnergy energy(problem, 1);
  const SolveReport report = solver.solve(energy, path, {});
  CAPTURE(solver.name(), word_of(report.termination), report.message);
  CHECK(path.u == Points::Constant(2, 1, 0.5));
  if (report.termination != Termination::refused) CHECK(report.final_energy == report.initial_energy);
}

/// The contract of Solver (framework/energy/solver.hpp).
inline void check_solver_contract(const MakeSolver& make, const Promise& promise = {}) {
  const std::unique_ptr<Solver> solver = make(100000, 1000000);
  for (const StandardProblem& p : standard_problems()) {
    CAPTURE(solver->name(), p.name);
    const PathEnergy energy = energy_at_mean(p);
    if (const auto reason = solver->cannot_solve(energy, p.start)) {
      check_refuses(p, *solver, *reason);
      continue;
    }
    check_solves(p, *solver, promise);
    check_ends_when_told(p, make, promise);
  }
  check_refuses_infinite(*solver);
  check_survives_faults(*solver);
  check_survives_one_point(*solver);
}

/// Two solvers give the same energy to the digits they claim. (On a mesh each may come to rest in a kink of its own:
/// within a hundred times that.)
inline void check_agreement(const Solver& one, const Solver& other) {
  for (const StandardProblem& p : standard_problems()) {
    CAPTURE(one.name(), other.name(), p.name);
    PathEnergy energy = energy_at_mean(p);
    CoordinatePath path = p.start, same = p.start;
    const SolveReport mine = one.solve(energy, path, {}), theirs = other.solve(energy, same, {});
    const double rest = p.problem.manifold->shape() == Shape::polyhedral ? 10 : 1;
    CHECK(std::abs(mine.final_energy - theirs.final_energy) <= rest * energy_tolerance(p, energy, path));
  }
}

}  // namespace leastcost::test
