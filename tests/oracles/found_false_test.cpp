// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Kinds of problems whose certificates, or whose bars beside a refusal, were false once: kinked metrics with few
// points, smooth anisotropy, a surface whose ripples fit the levels, refraction at an edge, solvers that stop early.
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/solvers/georce.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;

std::shared_ptr<const SegmentCost> metric_of(const std::vector<std::string>& entries) {
  MetricFieldOptions options;
  options.field = metric::Formula{entries, {}};
  return make_metric_field_cost(options, 2);
}

/// A bar, whether the path is certified or not, holds the truth; or there is none.
void check_bar(const Result& result, double truth) {
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(result.costs.size(), truth, e.value, e.error, e.method, failures(result.certificate));
  if (!std::isnan(e.error)) CHECK(std::abs(e.value - truth) <= e.error + 1e-14 * truth);
  if (result.status == Status::certified) CHECK(std::isfinite(e.error));
}

/// n = 1 + |x - c|, from (-1, 0) to (1, rise): Snell's law in closed form, with p = n sin(angle).
double time_across_kink(double c, double rise) {
  const double left = 2 + c, right = 2 - c;  // n at the ends
  const auto rise_at = [&](double p) {
    return p * (std::acosh(left / p) + std::acosh(right / p) - 2 * std::acosh(1 / p));
  };
  const auto part = [](double n, double p) { return (n * std::sqrt(n * n - p * p) + p * p * std::acosh(n / p)) / 2; };
  if (rise == 0) return (left * left + right * right) / 2 - 1;
  double low = 1e-9, high = 1;
  for (int i = 0; i < 200; ++i) {
    const double p = (low + high) / 2;
    (rise_at(p) < rise ? low : high) = p;
  }
  return part(left, low) + part(right, low) - 2 * part(1, low);
}

/// Time of light from the air, y > 0, into glass of index 1.5: exact on each straight segment.
struct Refraction {
  static constexpr int dim = 2;
  CostTraits traits() const { return {.unit = "s", .symmetric = true, .additive = true}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    using std::sqrt;
    const double above = innermost(a[1]), below = innermost(b[1]);
    const auto in = [](double y) { return y > 0 ? 1.0 : 1.5; };
    const S square = (b - a).squaredNorm();
    if ((above > 0) == (below > 0)) return in(above)*in(above)*square;
    const S t = a[1] / (a[1] - b[1]);
    const S mean = in(above)*t + in(below) * (S(1.0) - t);
    return mean * mean * square;
  }
};

}  // namespace

TEST_CASE("found false: a kinked metric with few points", "[oracle]") {
  for (const double c : {0.0, 0.1, 1. / 3, -0.7})
    for (const double rise : {0.0, 0.4, 0.9})
      for (const int n : {7, 8, 9, 11, 13, 15, 32}) {
        CAPTURE(c, rise, n);
        const std::string index2 = "(1 + abs(x - (" + std::to_string(c) + ")))^2";
        const double kink = std::stod(std::to_string(c));
        const Result result =
            find(between(space(2), metric_of({index2, "0", index2}), Vector2d(-1, 0), Vector2d(1, rise)), n);
        check_bar(result, time_across_kink(kink, rise));
      }
}

TEST_CASE("found false: smooth anisotropy from 1e-1 to 1e-8", "[oracle]") {
  // (x, (y - 0.3 sin 2x) / sqrt e) straightens every geodesic: soft along the waves, stiff across.
  const int step = nightly() ? 1 : 2;
  int certified = 0;
  for (int decade = 1; decade <= 8; decade += step)
    for (const double off : {0.0, 2.0}) {
      const double e = std::pow(10, -decade), root = std::sqrt(e);
      const std::string slope = "0.6*cos(2*x)",
                        over = "/" + std::to_string(std::pow(10, decade) * e) + "e-" + std::to_string(decade);
      const Vector2d from(-1, 0.3 * std::sin(-2.0)), to(1, 0.3 * std::sin(2.0) + off * root);
      const Problem problem =
          between(space(2), metric_of({"1 + (" + slope + ")^2" + over, "-" + slope + over, "1" + over}), from, to);
      Points along(2, 39);  // near the answer: from a straight line nobody gets there in so narrow a valley
      for (Index i = 0; i < along.cols(); ++i) {
        const double x = -0.95 + 0.05 * static_cast<double>(i);
        along.col(i) = Vector2d(x, 0.3 * std::sin(2 * x) + off * root * (x + 1) / 2);
      }
      for (const int n : {32, 64}) {
        CAPTURE(decade, off, n);
        const Result result = find(problem, n, WaypointsInitializer(along));
        check_bar(result, std::hypot(2, off));
        certified += result.status == Status::certified;
      }
    }
  CHECK(certified >= 12 / step);  // of 32: not refused throughout
}

TEST_CASE("found false: a surface whose ripples fit the levels", "[oracle]") {
  const ImplicitManifoldOptions sheet{.surface = implicit::Formula{.f = "z - 0.0007*sin(2*3.141592653589793*202*x)"}};
  const Problem problem = between(make_implicit_manifold(sheet), make_euclidean_cost(3), Eigen::Vector3d(0, 0, 0),
                                  Eigen::Vector3d(1, 0, 0));
  for (const int n : {50, 100, 201}) {
    const Result result = find(problem, n);  // in truth some 1.18
    CAPTURE(n, result.certificate.estimate.value, failures(result.certificate));
    CHECK(result.status == Status::uncertified);
  }
}

TEST_CASE("found false: bars beside refusals at an edge of refraction", "[oracle]") {
  double low = 0, high = 1;  // where the ray enters: Snell's law by bisection
  for (int i = 0; i < 100; ++i) {
    const double x = (low + high) / 2;
    (x / std::hypot(x, 1) < 1.5 * (1 - x) / std::hypot(1 - x, 1) ? low : high) = x;
  }
  const double truth = std::hypot(low, 1) + 1.5 * std::hypot(1 - low, 1);
  for (const int n : {7, 12, 15, 31, 32, 64, 200})
    check_bar(find(between(space(2), make_segment_cost(Refraction{}), Vector2d(0, 1), Vector2d(1, -1)), n), truth);
}

TEST_CASE("found false: a solver that stops early quotes what its path costs, without a bar", "[oracle]") {
  GeorceOptions few;
  few.max_iterations = 1;
  const Result result = find(between(space(2), metric_of({"1/y^2", "0", "1/y^2"}), Vector2d(0, 1), Vector2d(2, 3)), 32,
                             StraightInitializer(), Georce(few));
  CAPTURE(failures(result.certificate));
  CHECK(result.status == Status::uncertified);
  CHECK(std::isnan(result.certificate.estimate.error));
  CHECK(result.certificate.estimate.value == Approx(result.costs.sum()).epsilon(1e-12));
}

/// Points keep margins from walls: the least chain is longer than the least curve, and bounds nothing from below.
TEST_CASE("found false: the lower bound of a cost among obstacles", "[oracle]") {
  const std::shared_ptr<const ConstraintManifold> plane = space(2);
  const auto around = std::make_shared<const FreeSpace>(plane, FreeSpace::Obstacles{make_ball({Vector2d(0, 0), 1})}, 0);
  const double truth = 2 * std::sqrt(3) + kPi / 3;
  for (const int points : {10, 20, 40}) {
    FindOptions options;
    options.points = points;
    const Result result = find_path(between(around, make_euclidean_cost(2), Vector2d(-2, 0), Vector2d(2, 0)),
                                    BowInitializer(BowOptions{0.5, 0}), Newton(), options);
    CAPTURE(points, result.certificate.estimate.value);
    check_bar(result, truth);
    if (result.certificate.estimate.lower) CHECK(*result.certificate.estimate.lower <= truth * (1 + 1e-12));
  }
}

}  // namespace leastcost::test
