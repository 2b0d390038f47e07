// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/newton/bounded_step.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "framework/newton/chain_newton.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

/// The plane, where each column has a half-plane of its own: normal . (x - x before) >= -gap.
class HalfPlanes final : public ConstraintManifold, public SeesBounds {
 public:
  struct Bound {
    Vector2d normal;
    double gap;
  };
  /// `copies`: so many of each, one behind the other.
  explicit HalfPlanes(std::vector<Bound> bounds, int copies = 1) : bounds_(std::move(bounds)), copies_(copies) {}
  Dimensions dimensions() const override { return {2, 2, 2}; }
  Shape shape() const override { return Shape::flat; }
  Projection project(CoordinatePath&) const override { return {}; }
  void tangent_bases(const CoordinatePath& path, Points& bases) const override {
    bases = Points::Identity(2, 2).replicate(1, path.u.cols());
  }
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override {
    to = from;
    to.u.middleCols(from.free_begin(), from.free_count()) += step;
  }
  double residual(const CoordinatePath&) const override { return 0; }
  void bounds_within(const CoordinatePath&, Index column, double reach, std::vector<NearBound>& found) const override {
    found.clear();
    const Bound& bound = bounds_[static_cast<std::size_t>(column)];
    for (int k = 0; k < copies_ && bound.gap + kApart * k <= reach; ++k)
      found.push_back({static_cast<int>(column + k * kMostColumns), bound.normal, bound.gap + kApart * k});
  }
  void retract_onto(const CoordinatePath& from, const Points& step, const BoundsOfPoints& bounds,
                    CoordinatePath& to) const override {
    retract(from, step, to);
    onto = bounds;
  }

  mutable BoundsOfPoints onto;

 private:
  static constexpr double kApart = 1e-3;
  static constexpr Index kMostColumns = 1000;
  std::vector<Bound> bounds_;
  int copies_;
};

/// The plane, where the middle column stays where it is unless its step is short: between walls that leave it no room.
class Pinched final : public ConstraintManifold, public SeesBounds {
 public:
  Pinched(Index column, double longest) : column_(column), longest_(longest) {}
  Dimensions dimensions() const override { return {2, 2, 2}; }
  Shape shape() const override { return Shape::flat; }
  Projection project(CoordinatePath&) const override { return {}; }
  void tangent_bases(const CoordinatePath& path, Points& bases) const override {
    bases = Points::Identity(2, 2).replicate(1, path.u.cols());
  }
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override {
    to = from;
    to.u.middleCols(from.free_begin(), from.free_count()) += step;
    if (step.col(column_ - from.free_begin()).norm() > longest_) to.u.col(column_) = from.u.col(column_);
  }
  double residual(const CoordinatePath&) const override { return 0; }
  void bounds_within(const CoordinatePath&, Index, double, std::vector<NearBound>& found) const override {
    found.clear();
  }
  void retract_onto(const CoordinatePath& from, const Points& step, const BoundsOfPoints&,
                    CoordinatePath& to) const override {
    retract(from, step, to);
  }

 private:
  Index column_;
  double longest_;
};

constexpr Index kColumns = 9, kFree = kColumns - 2;

CoordinatePath crooked(Random& random) {
  CoordinatePath path{Points(2, kColumns), {}, false};
  for (Index i = 0; i < kColumns; ++i)
    path.u.col(i) << static_cast<double>(i), i == 0 || i + 1 == kColumns ? 0 : random.uniform(0.2, 1);
  return path;
}

Problem among(std::shared_ptr<const ConstraintManifold> manifold) {
  return {std::move(manifold), make_euclidean_cost(2), make_kernel<Square>(), {}, {}, false};
}

/// The least of the model within one half-plane for each point, by projected gradients: slow and simple.
Points by_projected_gradients(const ChainModel& model, const std::vector<HalfPlanes::Bound>& bounds) {
  double steepest = 0;
  for (Index i = 0; i < kFree; ++i) steepest = std::max(steepest, model.system.diagonal(i).norm());
  VectorXd z = VectorXd::Zero(2 * kFree), product;
  for (int k = 0; k < 20000; ++k) {
    model.system.multiply(z, product);
    z -= (product + model.gradient.reshaped()) / (2 * steepest);
    for (Index i = 0; i < kFree; ++i) {
      const HalfPlanes::Bound& bound = bounds[static_cast<std::size_t>(i + 1)];
      const double off = bound.normal.dot(z.segment(2 * i, 2)) + bound.gap;
      if (off < 0) z.segment(2 * i, 2) -= off * bound.normal;
    }
  }
  return z.reshaped(2, kFree);
}

}  // namespace

TEST_CASE("bounded steps: the least of the model within the bounds of all points, onto those that hold it") {
  Random random(5);
  int resting = 0;
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    std::vector<HalfPlanes::Bound> bounds;
    for (Index i = 0; i < kColumns; ++i)
      bounds.push_back({Vector2d(random.uniform(-1, 1), 1).normalized(), random.uniform(0, 0.3)});
    const auto domain = std::make_shared<HalfPlanes>(bounds, k % 2 == 0 ? 1 : 40);  // 39 of which hold nothing
    const Problem problem = among(domain);
    const CoordinatePath path = crooked(random);
    PathEnergy energy(problem, 1);
    ChainModel model;
    REQUIRE(model.evaluate(energy, path));
    model.solve(energy, path, HessianKind::exact);
    REQUIRE(model.frames.identity);
    BoundedStep step(energy);
    REQUIRE(step.solve(path, model));
    const Points expected = by_projected_gradients(model, bounds);
    CHECK((step.moves() - expected).norm() <= 1e-6 * expected.norm());
    CHECK(step.slope() == Approx(model.gradient.cwiseProduct(expected).sum()).epsilon(1e-6));
    CoordinatePath to;
    step.retract(path, to);
    CHECK((to.u.middleCols(1, kFree) - path.u.middleCols(1, kFree) - step.moves()).norm() <= 1e-12);
    CHECK(energy.value(to) < model.value);
    for (Index i = 0; i < kFree; ++i) {
      const HalfPlanes::Bound& bound = bounds[static_cast<std::size_t>(i + 1)];
      const double left = bound.gap + bound.normal.dot(step.moves().col(i));
      CHECK(left >= -1e-10);
      const std::vector<int>& onto = domain->onto[static_cast<std::size_t>(i)];
      CHECK(onto == (left < 1e-8 ? std::vector<int>{static_cast<int>(i + 1)} : std::vector<int>{}));
      resting += static_cast<int>(onto.size());
    }
  }
  CHECK(resting > 20);
}

TEST_CASE("bounded steps: a first step among many bounds goes few segments far") {
  constexpr Index kMany = 101;
  CoordinatePath path{Points(2, kMany), {}, false};  // half a circle, which the model's own step would straighten
  for (Index i = 0; i < kMany; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / (kMany - 1);
    path.u.col(i) << -std::cos(angle), std::sin(angle);
  }
  const auto longest_move = [&](int copies) {
    const Problem problem =
        among(std::make_shared<HalfPlanes>(std::vector<HalfPlanes::Bound>(kMany, {{0, 1}, 0.4}), copies));
    PathEnergy energy(problem, 1);
    ChainModel model;
    REQUIRE(model.evaluate(energy, path));
    model.solve(energy, path, HessianKind::exact);
    BoundedStep step(energy);
    REQUIRE(step.solve(path, model));
    return step.moves().colwise().norm().maxCoeff();
  };
  const double segment = (path.u.col(1) - path.u.col(0)).norm();
  CHECK(longest_move(1) > 10 * segment);
  CHECK(longest_move(40) <= 8 * segment * (1 + 1e-9));
  CHECK(longest_move(40) > 3 * segment);
}

TEST_CASE("bounded steps: none where the model's step passes no bound, for rings, and where no bounds are seen") {
  Random random(6);
  const CoordinatePath path = crooked(random);
  const auto solved = [&](const Problem& problem, bool ring) {
    CoordinatePath chain = path;
    chain.ring = ring;
    PathEnergy energy(problem, 1);
    ChainModel model;
    REQUIRE(model.evaluate(energy, chain));
    model.solve(energy, chain, HessianKind::exact);
    return BoundedStep(energy).solve(chain, model);
  };
  const auto all_at = [](double gap) {
    return std::make_shared<HalfPlanes>(std::vector<HalfPlanes::Bound>(kColumns, {Vector2d(0, 1), gap}));
  };
  CHECK(solved(among(all_at(0.01)), false));
  CHECK_FALSE(solved(among(all_at(2)), false));
  CHECK_FALSE(solved(among(all_at(0.01)), true));
  CHECK_FALSE(solved(among(std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2})), false));
}

TEST_CASE("bounded steps: no point moves farther than a radius that follows the steps taken") {
  Random random(7);
  const Problem problem = among(std::make_shared<HalfPlanes>(std::vector<HalfPlanes::Bound>(kColumns, {{0, 1}, 9})));
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    const CoordinatePath path = crooked(random);
    PathEnergy energy(problem, 1);
    ChainModel model;
    REQUIRE(model.evaluate(energy, path));
    model.solve(energy, path, HessianKind::exact);
    REQUIRE(model.frames.identity);
    const double whole = model.moves.colwise().norm().maxCoeff();
    ChainSystem hessian;
    energy.chain_hessian(path, model.gradient, model.frames, HessianKind::exact, hessian);
    const VectorXd gradient = model.gradient.reshaped();
    BoundedStep step(energy);
    CHECK(step.part_within(model.moves) == 1);
    CHECK_FALSE(step.solve(path, model));  // the model's own, which passes no bound
    for (const double part : {0.125, 0.25, 0.5}) {
      if (part == 0.125)
        step.took(part * whole, false);
      else
        step.took(0, true);
      CHECK(step.part_within(model.moves) == Approx(part));
      REQUIRE(step.solve(path, model));
      const double longest = step.moves().colwise().norm().maxCoeff();
      CHECK(longest <= part * whole);
      CHECK(longest > part * whole / 2);
      CHECK(step.slope() == Approx(model.gradient.cwiseProduct(step.moves()).sum()));
      CHECK(step.slope() < 0);
      // The least of the model among steps as long: its slope there is along the step, backwards.
      const VectorXd z = step.moves().reshaped();
      VectorXd left;
      hessian.multiply(z, left);
      left += gradient;
      const double added = -left.dot(z) / z.squaredNorm();
      CHECK(added > 0);
      CHECK((left + added * z).norm() <= 1e-9 * gradient.norm());
    }
    step.took(0, true);
    CHECK_FALSE(step.solve(path, model));
  }
}

/// The radius doubled with each of many small steps; then a Hessian that just factored asked for steps of many times
/// the path, and each look along them took seconds.
TEST_CASE("bounded steps: many small steps do not make the radius longer than a share of the path") {
  Random random(8);
  const Problem problem = among(std::make_shared<HalfPlanes>(std::vector<HalfPlanes::Bound>(kColumns, {{0, 1}, 9})));
  const CoordinatePath path = crooked(random);
  PathEnergy energy(problem, 1);
  ChainModel model;
  REQUIRE(model.evaluate(energy, path));
  model.solve(energy, path, HessianKind::exact);
  BoundedStep step(energy);
  step.took(1, false);
  for (int k = 0; k < 60; ++k) step.took(1e-3, true);
  step.solve(path, model);
  const double length = (path.u.rightCols(kColumns - 1) - path.u.leftCols(kColumns - 1)).colwise().norm().sum();
  CHECK(step.part_within(1e6 * Points::Ones(2, 1)) * 1e6 < 16.1 * length / (kColumns - 1));
}

TEST_CASE("bounded steps: a solve to a loose tolerance ends where a point without room has cut 30 steps short") {
  constexpr Index kMiddle = kColumns / 2;
  constexpr double kHeight = 0.5;
  CoordinatePath tent{Points(2, kColumns), {}, false};
  for (Index i = 0; i < kColumns; ++i)
    tent.u.col(i) << static_cast<double>(i),
        kHeight * (1 - std::abs(static_cast<double>(i - kMiddle)) / static_cast<double>(kMiddle));
  const auto solved = [&](double longest, double tolerance) {
    const Problem problem = among(std::make_shared<Pinched>(kMiddle, longest));
    PathEnergy energy(problem, 1);
    CoordinatePath path = tent;
    Limits limits = kChainNewtonLimits;
    limits.tolerance = tolerance;
    return solve_by_newton(energy, path, limits, {});
  };
  constexpr double kLoose = 1e-8;
  const SolveReport free = solved(1, kLoose), pinched = solved(kHeight / 128, kLoose);
  CHECK(free.termination == Termination::converged);
  CHECK(free.iterations < 5);
  CHECK(pinched.termination == Termination::line_search_failed);
  CHECK(pinched.iterations >= 30);
  CHECK(pinched.iterations < 40);
  CHECK(solved(kHeight / 128, kChainNewtonLimits.tolerance).termination == Termination::converged);
}

}  // namespace leastcost::test
