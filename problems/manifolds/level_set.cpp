// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/level_set.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/dense_solves.hpp"
#include "framework/base/point_text.hpp"
#include "problems/drawing/domain_shapes.hpp"

namespace leastcost {
namespace {

enum class Outcome { found, not_finite, singular, stalled };

template <int N>
using Vector = Eigen::Matrix<double, N, 1>;

/// Where F is now, with its gradients.
template <int N, int K>
struct State {
  Vector<N> x;
  Vector<K> f;
  Eigen::Matrix<double, N, K> gradients;

  State(Index n, Index k) : x(n), f(k), gradients(n, k) {}
  bool evaluate(const ConstraintFunction& function) {
    function.evaluate(x, f, gradients);
    return f.allFinite() && gradients.allFinite();
  }
  /// The step -J^+ f of least length; false where J has not full rank.
  bool step(Vector<N>& s) const {
    if constexpr (K == 1) {
      s.noalias() = gradients * (-f[0] / gradients.squaredNorm());
    } else {
      constexpr double kRank = 1e-12;  // relative to the largest gradient
      const std::optional<Eigen::VectorXd> least = least_norm_solution(gradients, -f, kRank);
      if (!least) return false;
      s = *least;
    }
    return s.allFinite();
  }
};

/// Whether F still changes along the step at the trial point as it did before it, by a tenth at least: a step that goes
/// over a hill of |F| would end on another sheet.
template <int N, int K>
bool keeps_falling(const State<N, K>& state, const State<N, K>& trial, const Vector<N>& step) {
  constexpr double kLeast = 0.1;
  double slope = 0;
  for (Index j = 0; j < state.f.size(); ++j) slope += state.f[j] * trial.gradients.col(j).dot(step);
  return slope <= -kLeast * state.f.squaredNorm();
}

/// Newton's method from state.x, which ends where it stopped.
template <int N, int K>
Outcome newton(const ConstraintFunction& function, State<N, K>& state) {
  constexpr int kMostSteps = 60, kMostHalvings = 20;
  constexpr double kLast = 1e-9;  // relative size of a step after which quadratic convergence leaves rounding only
  constexpr double kFast = 0.1, kRounding = 4 * std::numeric_limits<double>::epsilon();
  if (!state.evaluate(function)) return Outcome::not_finite;
  const double start = state.x.norm();
  Vector<N> step(state.x.size());
  State<N, K> trial = state;
  double previous = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostSteps; ++i) {
    if (!state.step(step)) return Outcome::singular;
    const double size = step.norm(), scale = std::max(start, state.x.norm());
    if (size <= kRounding * scale || (size <= kLast * scale && size <= kFast * previous)) {
      state.x += step;
      return Outcome::found;
    }
    const double before = state.f.norm();
    double part = 1;
    for (int halvings = 0;; ++halvings, part /= 2) {
      trial.x = state.x + part * step;
      if (trial.evaluate(function) && trial.f.norm() <= (1 - part / 4) * before && keeps_falling(state, trial, step))
        break;
      if (size <= kLast * scale) return Outcome::found;  // |F| is all rounding
      if (halvings == kMostHalvings) return Outcome::stalled;
    }
    std::swap(state, trial);
    previous = part == 1 ? size : std::numeric_limits<double>::infinity();
  }
  return Outcome::stalled;
}

template <int N, int K>
Outcome solve_from(const ConstraintFunction& function, Eigen::Ref<Eigen::VectorXd> x, Eigen::VectorXd* last = nullptr) {
  State<N, K> state(x.size(), function.outputs());
  state.x = x;
  const Outcome outcome = newton(function, state);
  if (outcome == Outcome::found) x = state.x;
  if (last != nullptr) *last = state.x;
  return outcome;
}

template <int N, int K>
void null_space(const ConstraintFunction& function, const Eigen::VectorXd& x, Eigen::Ref<Points> basis) {
  State<N, K> state(x.size(), function.outputs());
  state.x = x;
  state.evaluate(function);
  if constexpr (N == 2 && K == 1) {
    const Eigen::Vector2d normal = state.gradients.normalized();
    basis << -normal[1], normal[0];
  } else if constexpr (N == 3 && K == 1) {
    const Eigen::Vector3d normal = state.gradients.normalized();
    basis.col(0) = normal.unitOrthogonal();
    basis.col(1) = normal.cross(Eigen::Vector3d(basis.col(0)));
  } else {
    basis = orthogonal_factor(state.gradients).rightCols(basis.cols());
  }
}

/// -lambda for the multipliers lambda of least |g - sum_j lambda_j grad F_j|; false where F has no gradients there.
template <int N, int K>
bool negative_multipliers(const ConstraintFunction& function, const Eigen::Ref<const Eigen::VectorXd>& x,
                          const Eigen::VectorXd& g, Vector<K>& out) {
  State<N, K> state(x.size(), function.outputs());
  state.x = x;
  if (!state.evaluate(function)) return false;
  if constexpr (K == 1)
    out[0] = -state.gradients.col(0).dot(g) / state.gradients.squaredNorm();
  else
    out = -least_squares(state.gradients, g);
  return out.allFinite();
}

/// Calls `work` with the sizes as types: known at compile time for curves, surfaces and quaternions.
template <class Work>
auto with_sizes(const ConstraintFunction& function, Work work) {
  constexpr int kAny = Eigen::Dynamic;
  if (function.outputs() == 1) {
    switch (function.inputs()) {
      case 2: return work(std::integral_constant<int, 2>(), std::integral_constant<int, 1>());
      case 3: return work(std::integral_constant<int, 3>(), std::integral_constant<int, 1>());
      case 4: return work(std::integral_constant<int, 4>(), std::integral_constant<int, 1>());
      default: return work(std::integral_constant<int, kAny>(), std::integral_constant<int, 1>());
    }
  }
  return work(std::integral_constant<int, kAny>(), std::integral_constant<int, kAny>());
}

Dimensions dimensions_of(const ConstraintFunction& function) {
  const int n = function.inputs(), k = function.outputs();
  if (n > kMaxDimension)
    throw InputError("a level set in R^" + std::to_string(n) + ": the limit is R^" + std::to_string(kMaxDimension));
  if (k < 1 || k >= n)
    throw InputError(
        std::to_string(k) + " equations in R^" + std::to_string(n) +
        " leave only isolated points: a level set needs at least one equation, and fewer than coordinates");
  return {n, n, n - k};
}

}  // namespace

LevelSet::LevelSet(std::shared_ptr<const ConstraintFunction> function)
    : EmbeddedManifold(dimensions_of(*function)), function_(std::move(function)) {}

bool LevelSet::solve(const ConstraintFunction& function, Eigen::Ref<Eigen::VectorXd> x) {
  return with_sizes(function,
                    [&](auto n, auto k) { return solve_from<n.value, k.value>(function, x) == Outcome::found; });
}

bool LevelSet::project_point(Eigen::Ref<Eigen::VectorXd> x) const { return solve(*function_, x); }

void LevelSet::tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const {
  with_sizes(*function_, [&](auto n, auto k) { null_space<n.value, k.value>(*function_, x, basis); });
}

bool LevelSet::bend(const CoordinatePath& path, Index column, const Eigen::VectorXd& gradient, Points& bend) const {
  return with_sizes(*function_, [&](auto n, auto k) {
    Vector<k.value> weights(function_->outputs());
    const auto x = path.u.col(column);
    if (!negative_multipliers<n.value, k.value>(*function_, x, gradient, weights)) return false;
    bend.resize(x.size(), x.size());
    function_->curvature(x, weights, bend);
    return true;
  });
}

std::string LevelSet::why_not_projected(const Eigen::VectorXd& x) const {
  Eigen::VectorXd copy = x, last = x;
  const Outcome outcome =
      with_sizes(*function_, [&](auto n, auto k) { return solve_from<n.value, k.value>(*function_, copy, &last); });
  const std::string where = last == x ? "there" : "at " + point_text(last) + ", where the search from there ended";
  switch (outcome) {
    case Outcome::found: return "the equations have a solution near it";
    case Outcome::not_finite: return "the equations are not finite there";
    case Outcome::singular:
      return "the gradients of the equations are zero or linearly dependent " + where +
             ": a singular point, a centre, or an extremum (the set may be empty)";
    case Outcome::stalled: break;
  }
  Eigen::VectorXd value(function_->outputs());
  Points gradients(function_->inputs(), function_->outputs());
  function_->evaluate(last, value, gradients);
  std::ostringstream out;
  out.precision(3);
  out << "no solution of the equations was found: |F| = " << value.norm() << ' ' << where << " (the set may be empty)";
  return out.str();
}

void LevelSet::draw(const DrawnPaths& paths, Drawing& out) const {
  if (function_->outputs() != 1) return;
  if (dimensions().ambient == 3)
    out.surface = level_surface(*this, *function_, around(paths.x), nullptr, out.notes);
  else
    out.curves = level_curves(*this, *function_, around(paths.x));
}

}  // namespace leastcost
