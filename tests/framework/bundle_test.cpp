// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/newton/bundle.hpp"

#include <Eigen/Dense>

#include <leastcost/framework/cost/segment_cost_function.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

/// Squared norm of the shortest element of the hull of the columns, by trying every subset of them: the shortest
/// element of the affine hull of a subset counts where its weights are not negative.
double shortest_by_subsets(const Eigen::MatrixXd& g) {
  double best = std::numeric_limits<double>::infinity();
  for (int set = 1; set < (1 << g.cols()); ++set) {
    Eigen::MatrixXd chosen(g.rows(), 0);
    for (Index j = 0; j < g.cols(); ++j)
      if (set & (1 << j)) chosen.conservativeResize(Eigen::NoChange, chosen.cols() + 1), chosen.rightCols(1) = g.col(j);
    const Index m = chosen.cols();
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(m + 1, m + 1);
    system.topLeftCorner(m, m) = chosen.transpose() * chosen;
    system.row(m).head(m).setOnes();
    system.col(m).head(m).setOnes();
    const Eigen::VectorXd w = system.completeOrthogonalDecomposition().solve(Eigen::VectorXd::Unit(m + 1, m)).head(m);
    if (w.minCoeff() >= -1e-12 && std::abs(w.sum() - 1) < 1e-9) best = std::min(best, (chosen * w).squaredNorm());
  }
  return best;
}

/// A ridge of low cost along y = 0 with a kink in it: no gradient near it is small.
struct Kinked {
  static constexpr int dim = 2;
  CostTraits traits() const { return {}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    using std::abs;
    const S weight = S(1.0) + 2 * abs(S((a[1] + b[1]) * 0.5));
    return (b - a).squaredNorm() * weight * weight;
  }
};

/// A rough weight, of which the Gauss-Newton model knows the slope alone.
struct Rough {
  static constexpr int dim = 2;
  CostTraits traits() const { return {}; }
  template <class S>
  Point<S, 2> residual(const Point<S, 2>& a, const Point<S, 2>& b) const {
    using std::cos, std::sin;
    const S weight = S(2.0) + S(1.5) * sin(S(15.0 * (a[0] + b[0]))) * cos(S(17.0 * (a[1] + b[1])));
    return weight * (b - a);
  }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    return residual<S>(a, b).squaredNorm();
  }
};

}  // namespace

TEST_CASE("bundle: a step that is far too long is shortened, not learned from", "[framework]") {
  const Problem problem = between(space(2), make_segment_cost(Rough{}), Eigen::Vector2d(-1, 0), Eigen::Vector2d(1, 0));
  CoordinatePath path =
      sample_equally(problem, WaypointsInitializer(Eigen::Vector2d(0.2, 0.31)).first_path(problem, {}).path, 60);
  PathEnergy energy(problem, 0.01);  // exp(s^2) with s about 8
  BundleStep step{true, 0, 0};
  int steps = 0;
  for (; steps < 300 && step.lowered; ++steps) step = bundle_step(energy, path, 1e-8);
  CAPTURE(steps, energy.cost(path), step.cost_error);
  CHECK(step.cost_error <= 1e-6);
}

TEST_CASE("bundle: the shortest element of a hull, against brute force", "[framework]") {
  Random random;
  for (int repeat = 0; repeat < 200; ++repeat) {
    const int vectors = random.integer(1, 7), d = random.integer(1, 5);
    const bool far = random.integer(0, 1) == 1;  // the hull may or may not contain the origin
    const Eigen::MatrixXd g = random.matrix(d, vectors) + Eigen::MatrixXd::Constant(d, vectors, far ? 1.5 : 0);
    const Eigen::VectorXd w = shortest_in_hull(g.transpose() * g, Eigen::VectorXd::Zero(vectors));
    CAPTURE(repeat, vectors, d, far);
    CHECK(w.minCoeff() >= 0);
    CHECK(w.sum() == Approx(1).epsilon(1e-12));
    const double largest = g.colwise().squaredNorm().maxCoeff();
    CHECK((g * w).squaredNorm() == Approx(shortest_by_subsets(g)).margin(1e-8 * largest));
  }
}

TEST_CASE("bundle: one vector, equal vectors, opposite vectors", "[framework]") {
  CHECK(shortest_in_hull(Eigen::MatrixXd::Constant(1, 1, 4), Eigen::VectorXd::Zero(1))[0] == 1);
  CHECK(shortest_in_hull(Eigen::MatrixXd::Ones(3, 3), Eigen::VectorXd::Zero(3)).sum() == Approx(1));
  const Eigen::RowVector2d opposite(3, -1);
  const Eigen::VectorXd w = shortest_in_hull(opposite.transpose() * opposite, Eigen::Vector2d::Zero());
  CHECK(w[0] == Approx(0.25));
  const Eigen::VectorXd kept = shortest_in_hull(opposite.transpose() * opposite, Eigen::Vector2d(0, 100));
  CHECK(kept[0] == 1);  // a gradient with a large penalty does not count
}

TEST_CASE("bundle: a kinked problem is solved, and its minimiser found stationary", "[framework]") {
  const Problem problem = between(space(2), make_segment_cost(Kinked{}), Eigen::Vector2d(-1, 0), Eigen::Vector2d(1, 0));
  CoordinatePath path =
      sample_equally(problem, WaypointsInitializer(Eigen::Vector2d(0.2, 0.31)).first_path(problem, {}).path, 9);
  PathEnergy energy(problem, 0.2);
  double before = energy.value(path);
  BundleStep step{true, 0, 0};
  for (int i = 0; i < 300 && step.lowered; ++i) {
    step = bundle_step(energy, path, 1e-8);
    const double after = energy.value(path);
    CHECK(after <= before);
    CHECK(before - after == Approx(step.lowered ? step.decrease : 0).margin(1e-12));
    before = after;
  }
  CAPTURE(energy.cost(path), step.cost_error);
  CHECK(step.cost_error <= 1e-5);
  CHECK(energy.cost(path) / 2 - 1 <= 10 * step.cost_error);  // what it says of its own error is not a lie
}

}  // namespace leastcost::test
