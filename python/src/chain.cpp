// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "python/src/chain.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "solvers/stopping_test.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;

constexpr double kInfiniteEnergy = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Solved is what a certificate takes for solved. The time of a run and the function itself are what limits it.
constexpr Limits kLimits{.tolerance = 1e-10,
                         .max_iterations = std::numeric_limits<int>::max(),
                         .max_evaluations = std::numeric_limits<int>::max()};

bool is_flat(const ConstraintManifold& manifold) {
  return manifold.shape() == Shape::flat && find_ability<HasBounds>(manifold) == nullptr;
}

}  // namespace

Chain::Chain(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor)
    : energy_(energy),
      path_(path),
      monitor_(monitor),
      loop_(energy, path, kLimits, monitor),
      first_(rows_of(path.u)),
      ring_(path.ring),
      flat_(is_flat(*energy.problem().manifold)) {
  const py::gil_scoped_release released;
  best_ = energy_.value(path_);
  loop_.record(best_, kNaN, 0);
}

template <class Work>
void Chain::search(const Work& work) {
  if (over_) throw InputError("the search of this chain is over");
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) throw InputError("another thread is asking this chain");
  if (ended_) stop();
  try {
    const py::gil_scoped_release released;
    ended_ = loop_.must_end(path_);
    if (!ended_) work();
  } catch (const Interrupted&) {  // in the midst of a pass
    ended_ = monitor_.cancelled() ? Termination::cancelled : Termination::time_limit;
  }
  if (ended_) stop();
}

void Chain::stop() {
  if (++stops_ == 2 &&
      PyErr_WarnEx(
          PyExc_RuntimeWarning,
          "a solver has caught leastcost.SearchEnded and goes on: the search is over, whatever it asks for; let "
          "SearchEnded pass, or return",
          1) != 0)
    throw py::error_already_set();
  const py::object type = py::module_::import("leastcost._register").attr("SearchEnded");
  PyErr_SetString(type.ptr(), "the search must end: return, or let this pass");
  throw py::error_already_set();
}

std::optional<CoordinatePath> Chain::path_of(const Points& columns) {
  CoordinatePath path = path_;
  if (!columns.allFinite()) return std::nullopt;
  path.u.middleCols(path.free_begin(), path.free_count()) = columns.middleCols(path.free_begin(), path.free_count());
  if (flat_) return path;
  const Points ends = path_.u;
  energy_.count({.projections = 1});
  if (!energy_.problem().manifold->project(path).failed.empty()) return std::nullopt;
  if (!path.ring) {  // to the last digit
    path.u.col(0) = ends.col(0);
    path.u.rightCols(1) = ends.rightCols(1);
  }
  return path;
}

void Chain::keep(const CoordinatePath& path, double value) {
  if (!(value < best_)) return;
  const double move = (path.u - path_.u).colwise().norm().maxCoeff();
  path_ = path;
  best_ = value;
  loop_.record(value, kNaN, move);
}

double Chain::value(const Numbers& rows) {
  const Points columns = columns_of(rows);
  double value = kInfiniteEnergy;
  search([&] {
    const std::optional<CoordinatePath> path = path_of(columns);
    if (!path) return;
    value = energy_.value(*path);
    keep(*path, value);
  });
  return value;
}

std::pair<double, py::array> Chain::value_and_gradient(const Numbers& rows) {
  const Points columns = columns_of(rows);
  double value = kInfiniteEnergy;
  Points all = Points::Constant(columns.rows(), columns.cols(), kNaN);
  search([&] {
    const std::optional<CoordinatePath> path = path_of(columns);
    if (!path) return;
    Points gradient, along;
    value = energy_.value_and_gradient(*path, gradient);
    if (!std::isfinite(value) || !gradient.allFinite()) return;
    keep(*path, value);
    Frames frames;
    Eigen::VectorXd tangent;
    energy_.frames(*path, gradient, frames);
    energy_.to_tangent(frames, gradient, tangent);
    energy_.from_tangent(frames, tangent, along);
    all.setZero();
    all.middleCols(path->free_begin(), path->free_count()) = along;
  });
  return {value, rows_of(all)};
}

py::array Chain::retract(const Numbers& rows, const Numbers& steps) {
  const Points columns = columns_of(rows), moves = columns_of(steps);
  Points moved = Points::Constant(columns.rows(), columns.cols(), kNaN);
  search([&] {
    const std::optional<CoordinatePath> path = path_of(columns);
    if (!path || !moves.allFinite()) return;
    CoordinatePath to;
    energy_.retract(*path, moves.middleCols(path->free_begin(), path->free_count()), to);
    moved = to.u;
  });
  return rows_of(moved);
}

SolveReport Chain::finish(const std::optional<Points>& returned) {
  close();
  if (returned && !ended_) {
    if (const std::optional<CoordinatePath> path = path_of(*returned)) keep(*path, energy_.value(*path));
  }
  if (ended_) return loop_.finish(*ended_, "", best_);
  const double cost_error = measured_cost_error(energy_, path_);
  loop_.set_cost_error(cost_error);
  if (cost_error <= kLimits.tolerance) return loop_.finish(Termination::converged, "", best_);
  return loop_.finish(Termination::iteration_limit,
                      fmt::format("the solver returned with a relative cost error of {:.2g}", cost_error), best_);
}

}  // namespace leastcost::python
