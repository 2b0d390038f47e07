// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "solvers/ceres/point_manifold.hpp"

#include <chrono>
#include <utility>

#include "framework/base/dense_solves.hpp"
#include "solvers/free_move.hpp"

namespace leastcost {
namespace {

constexpr int kShorter = 12;  ///< halvings of a step that leads where the domain is not
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

PointManifold::PointManifold(const ConstraintManifold& manifold, Points free, bool& stopped, const Deadline& deadline)
    : manifold_(manifold),
      dims_(manifold.dimensions()),
      free_(std::move(free)),
      stopped_(stopped),
      deadline_(deadline) {}

/// A stop is heard between iterations: here Ceres would take it for a line search that fails.
bool PointManifold::is_late() const { return deadline_.is_over(std::chrono::steady_clock::now()); }

/// A ring of one column: a path all of whose points are free.
CoordinatePath PointManifold::at(const double* x) const {
  CoordinatePath one{Eigen::Map<const Eigen::VectorXd>(x, dims_.coordinate), {}, true};
  if (manifold_.shape() == Shape::polyhedral) manifold_.project(one);  // finds its site
  return one;
}

Points PointManifold::basis(const CoordinatePath& one) const {
  Points all;
  manifold_.tangent_bases(one, all);
  if (free_.cols() == 0) return all;
  const Points turned = all * (all.transpose() * free_);
  return orthogonal_factor(turned).leftCols(turned.cols());
}

bool PointManifold::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  if (is_late()) return false;
  const CoordinatePath from = at(x);
  Points step = basis(from) * Eigen::Map<const Eigen::VectorXd>(delta, TangentSize());
  if (!step.allFinite()) return false;
  CoordinatePath to;
  for (int i = 0; i < kShorter; ++i, step *= 0.5) {
    const bool freely = move_freely(manifold_, from, step, to, {});
    if (!to.u.allFinite()) continue;
    if (!freely) stopped_ = true;
    break;
  }
  if (!to.u.allFinite()) to.u = from.u;
  Eigen::Map<Eigen::VectorXd>(x_plus_delta, dims_.coordinate) = to.u.col(0);
  return true;
}

bool PointManifold::PlusJacobian(const double* x, double* jacobian) const {
  Eigen::Map<RowMajor> out(jacobian, dims_.coordinate, TangentSize());
  if (is_late())
    out.setZero();  // Ceres ends at the next look at the clock, before it would use them
  else
    out = basis(at(x));
  return true;
}

bool PointManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  const Eigen::Map<const Eigen::VectorXd> to(y, dims_.coordinate), from(x, dims_.coordinate);
  Eigen::Map<Eigen::VectorXd>(y_minus_x, TangentSize()) = basis(at(x)).transpose() * (to - from);
  return true;
}

bool PointManifold::MinusJacobian(const double* x, double* jacobian) const {
  Eigen::Map<RowMajor>(jacobian, TangentSize(), dims_.coordinate) = basis(at(x)).transpose();
  return true;
}

}  // namespace leastcost
