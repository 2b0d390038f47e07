// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/newton/bundle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "framework/base/dense_solves.hpp"

namespace leastcost {
namespace {

constexpr double kSufficient = 1e-3;  ///< part of the predicted decrease that counts as descent
constexpr double kUsefulSlope =
    0.5;                     ///< a collected gradient, less its penalty, has at most this part of the descent left
constexpr int kTrials = 12;  ///< step lengths 1, 1/4, 1/16, ...

class Bundle {
 public:
  Bundle(PathEnergy& energy, CoordinatePath& path) : energy_(energy), path_(path) {}

  BundleStep run(double tolerance, int most) {
    if (!model_.evaluate(energy_, path_)) return {false, std::numeric_limits<double>::infinity(), 0};
    model_.solve(energy_, path_, HessianKind::gauss_newton);
    const double scale = energy_.scale(path_);
    add(model_.tangent, 0);
    BundleStep result;
    for (int i = 0; i < most; ++i) {
      aggregate();
      result.cost_error = decrement_ / (2 * scale);
      if (result.cost_error <= tolerance) break;
      result.decrease = try_step();
      result.lowered = result.decrease > 0;
      if (result.lowered || exhausted_) break;
    }
    return result;
  }

 private:
  /// `penalty`: by how much the linear piece of the energy with this gradient lies off the energy at the path. Without
  /// it gradients from afar, which say nothing about the path, make a hull that contains 0.
  void add(const Eigen::VectorXd& gradient, double penalty) {
    gradients_.push_back(gradient);
    solved_.push_back(gradient);
    energy_.solve(model_.system, solved_.back());
    const Index m = static_cast<Index>(gradients_.size());
    penalties_.conservativeResize(m);
    penalties_[m - 1] = penalty;
    gram_.conservativeResize(m, m);
    for (Index j = 0; j < m; ++j)
      gram_(j, m - 1) = gram_(m - 1, j) = gradients_[static_cast<std::size_t>(j)].dot(solved_.back());
  }

  void aggregate() {
    const Eigen::VectorXd w = shortest_in_hull(gram_, penalties_);
    step_.setZero(model_.tangent.size());
    for (Index j = 0; j < w.size(); ++j) step_ -= w[j] * solved_[static_cast<std::size_t>(j)];
    decrement_ = w.dot(gram_ * w) + w.dot(penalties_);
  }

  /// Energy decrease of the first step length that gives enough; otherwise 0, with a gradient collected whose slope
  /// along the step shows the other side of the kink (it then shortens the aggregate).
  double try_step() {
    energy_.from_tangent(model_.frames, step_, moves_);
    const double slack = rounding_slack(model_.value, path_.segment_count());
    double t = 1;
    for (int i = 0; i < kTrials && t * decrement_ > slack; ++i, t /= 4) {
      trial_moves_ = t * moves_;
      energy_.retract(path_, trial_moves_, trial_);
      if (!trial_model_.evaluate(energy_, trial_)) continue;
      const double decrease = model_.value - trial_model_.value;
      if (decrease > kSufficient * t * decrement_ && decrease > slack) {
        std::swap(path_, trial_);
        return decrease;
      }
      if (-decrease > decrement_) continue;  // too far to say anything about the path: exp(s^2) grows by decades
      energy_.from_tangent(trial_model_.frames, trial_model_.tangent, transported_);
      energy_.to_tangent(model_.frames, transported_, here_);
      const double slope = here_.dot(step_), penalty = std::abs(decrease + t * slope);
      if (slope - penalty < -kUsefulSlope * decrement_) continue;
      add(here_, penalty);
      return 0;
    }
    exhausted_ = true;
    return 0;
  }

  PathEnergy& energy_;
  CoordinatePath& path_;
  ChainModel model_, trial_model_;
  CoordinatePath trial_;
  std::vector<Eigen::VectorXd> gradients_, solved_;
  Eigen::MatrixXd gram_;
  Eigen::VectorXd penalties_, step_, here_;
  Points moves_, trial_moves_, transported_;
  double decrement_ = 0;
  bool exhausted_ = false;  ///< no step length gave a decrease or a gradient
};

/// Moves w towards the minimum over the affine hull of its support, up to the first weight that vanishes, which leaves
/// the support. True when the minimum itself was reached.
bool toward_affine_minimum(const Eigen::MatrixXd& gram, const Eigen::VectorXd& penalties, double ridge,
                           std::vector<Index>& support, Eigen::VectorXd& w) {
  const Index k = static_cast<Index>(support.size());
  Eigen::MatrixXd g = gram(support, support);
  g.diagonal().array() += ridge;
  Eigen::MatrixXd sides(k, 2);
  sides << Eigen::VectorXd::Ones(k), penalties(support);
  const Eigen::MatrixXd solved = solve_symmetric(g, sides);
  const Eigen::VectorXd goal = (1 + solved.col(1).sum()) / solved.col(0).sum() * solved.col(0) - solved.col(1);
  double t = 1;
  Index leaves = -1;
  for (Index i = 0; i < k; ++i) {
    const double now = w[support[static_cast<std::size_t>(i)]];
    if (goal[i] > 0 || now <= goal[i]) continue;
    if (const double reach = now / (now - goal[i]); reach < t) t = reach, leaves = i;
  }
  for (Index i = 0; i < k; ++i) {
    double& weight = w[support[static_cast<std::size_t>(i)]];
    weight = std::max(0.0, weight + t * (goal[i] - weight));
  }
  if (leaves < 0) return true;
  w[support[static_cast<std::size_t>(leaves)]] = 0;
  support.erase(support.begin() + leaves);
  return support.size() <= 1;
}

}  // namespace

Eigen::VectorXd shortest_in_hull(const Eigen::MatrixXd& gram, const Eigen::VectorXd& penalties) {
  const Index m = gram.rows();
  const double ridge = 1e-300 + 1e-14 * gram.diagonal().maxCoeff();
  Eigen::VectorXd w = Eigen::VectorXd::Zero(m);
  std::vector<Index> support(1);
  (gram.diagonal() + 2 * penalties).minCoeff(&support[0]);
  w[support[0]] = 1;
  for (Index step = 0; step < 20 * m; ++step) {
    const Eigen::VectorXd slope = gram * w + penalties;
    Index enter = 0;
    const double value = w.dot(slope), gap = value - slope.minCoeff(&enter);
    if (gap <= 1e-12 * std::abs(value) + ridge || w[enter] > 0) break;
    support.push_back(enter);
    while (!toward_affine_minimum(gram, penalties, ridge, support, w)) {
    }
  }
  return w / w.sum();
}

BundleStep bundle_step(PathEnergy& energy, CoordinatePath& path, double tolerance, int most_gradients) {
  return Bundle(energy, path).run(tolerance, most_gradients);
}

SolveReport descend_by_bundles(PathEnergy& energy, CoordinatePath& path, SolveLoop& loop) {
  for (;;) {
    CoordinatePath before = path;
    const BundleStep step = bundle_step(energy, path, kKinkedTolerance);
    const double value = energy.value(path);
    loop.record(value, step.cost_error, (path.u - before.u).colwise().norm().maxCoeff());
    if (step.cost_error <= kKinkedTolerance)
      return loop.finish(Termination::converged,
                         "stationary at a kink: the shortest vector in the hull of the gradients around it is small",
                         value);
    if (!step.lowered) return loop.finish(Termination::line_search_failed, "no bundle step lowers the energy", value);
    if (const std::optional<Termination> end = loop.must_end(path)) return loop.finish(*end, "", value);
  }
}

}  // namespace leastcost
