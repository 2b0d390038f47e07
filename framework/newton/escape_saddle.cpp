// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/newton/escape_saddle.hpp"

#include <optional>
#include <utility>

#include <leastcost/framework/newton/path_index.hpp>

namespace leastcost {
namespace {

constexpr int kMostSaddles = 8;
constexpr int kMostHalvings = 20;

/// A move of the free points that lowers E to second order; empty at a minimum.
Points way_down(PathEnergy& energy, const CoordinatePath& path, double shift) {
  Points moves;
  std::optional<ChainHessians> h = chain_hessians(energy, path);
  if (!h) return moves;
  h->exact.add(shift, h->gauss_newton);
  const Eigen::VectorXd direction = h->exact.negative_direction(energy.deadline());
  if (direction.size() > 0) energy.from_tangent(h->model.frames, direction, moves);
  return moves;
}

/// Mean distance of neighbouring points, in coordinates.
double mean_step(const CoordinatePath& path) {
  double sum = 0;
  for (Index i = 0; i < path.segment_count(); ++i) sum += (path.column(i + 1) - path.column(i)).norm();
  return sum / static_cast<double>(path.segment_count());
}

/// Solves from a lower path on one side of the saddle; false where no step along `moves` lowers E.
bool descend(PathEnergy& energy, const Solver& solver, const Points& moves, CoordinatePath& path, SolveReport& report,
             const Monitor& monitor) {
  const double value = energy.value(path);
  double step = mean_step(path) / moves.colwise().norm().maxCoeff();
  CoordinatePath trial;
  for (int i = 0; i < kMostHalvings; ++i, step /= 2) {
    energy.retract(path, step * moves, trial);
    if (!(energy.value(trial) < value)) continue;
    report = solver.solve(energy, trial, monitor);
    path = std::move(trial);
    return true;
  }
  return false;
}

}  // namespace

int escape_saddles(PathEnergy& energy, const Solver& solver, double shift, CoordinatePath& path, SolveReport& report,
                   const Monitor& monitor) {
  int left = 0;
  for (; left < kMostSaddles && !monitor.interrupted(); ++left) {
    const Points moves = way_down(energy, path, shift);
    if (moves.size() == 0) return left;
    CoordinatePath one = path, other = path;
    SolveReport first, second;
    const bool down = descend(energy, solver, moves, one, first, monitor);
    const bool other_down = descend(energy, solver, -moves, other, second, monitor);
    if (!down && !other_down) return left;
    const bool take_first = down && (!other_down || first.final_energy <= second.final_energy);
    path = take_first ? std::move(one) : std::move(other);
    report = joined(report, take_first ? std::move(first) : std::move(second));
  }
  return left;
}

}  // namespace leastcost
