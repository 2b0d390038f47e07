// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Morse index by pivots, docs/numerics.md Sec. 6.4: the first negative pivot is the conjugate point.
#include <leastcost/framework/newton/path_index.hpp>

#include <numbers>

#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost::test {
namespace {

/// n + 1 equal chords of a great circle over an angle; a ring of n for the whole circle.
CoordinatePath arc(double angle, int segments, bool ring = false) {
  CoordinatePath path{Points(3, ring ? segments : segments + 1), {}, ring};
  for (Index i = 0; i < path.u.cols(); ++i) {
    const double t = angle * static_cast<double>(i) / segments;
    path.u.col(i) << std::cos(t), std::sin(t) * 0.8, std::sin(t) * 0.6;
  }
  return path;
}

PathIndex index_on(std::shared_ptr<const ConstraintManifold> manifold, const CoordinatePath& path,
                   const std::shared_ptr<const Kernel>& kernel = make_kernel<Expm1Square>()) {
  const int d = manifold->dimensions().ambient;
  const Problem problem{std::move(manifold), make_euclidean_cost(d), kernel, {}, {}, path.ring};
  PathEnergy energy(problem, PathEnergy(problem, 1).cost(path) / static_cast<double>(path.segment_count()));
  return path_index(energy, path, 1e-3);
}

}  // namespace

TEST_CASE("index of a great-circle arc of length L is floor(L / pi)", "[framework]") {
  const int segments = GENERATE(16, 64, 200);
  const bool square = GENERATE(true, false);
  const auto kernel = square ? make_kernel<Square>() : make_kernel<Expm1Square>();
  for (double length = 0.1 * kPi; length < 3 * kPi; length += 0.2 * kPi) {
    const PathIndex index = index_on(std::make_shared<Sphere>(), arc(length, segments), kernel);
    CAPTURE(segments, length / kPi, index.negatives, index.nullity);
    const int expected = static_cast<int>(length / kPi);
    CHECK(index.negatives == expected);
    CHECK(index.saddle_order == expected);
    CHECK(index.verdict == (expected > 0 ? IndexVerdict::saddle : IndexVerdict::minimum));
  }
}

TEST_CASE("index at the conjugate point itself: degenerate", "[framework]") {
  const PathIndex index = index_on(std::make_shared<Sphere>(), arc(kPi, 64));
  CHECK(index.verdict == IndexVerdict::degenerate);
  CHECK(index.nullity == 1);
}

TEST_CASE("index of a whole great circle: a saddle", "[framework]") {
  const PathIndex index = index_on(std::make_shared<Sphere>(), arc(2 * kPi, GENERATE(16, 64), true));
  CAPTURE(index.negatives, index.nullity);
  CHECK(index.verdict == IndexVerdict::saddle);
  CHECK(index.saddle_order >= 1);  // sinking to a small circle; tilting costs nothing to second order
}

TEST_CASE("index of a straight line is 0 in any dimension, H = s has none", "[framework]") {
  const int d = GENERATE(2, 3, 7);
  CoordinatePath line{Points(d, 21), {}, false};
  for (Index i = 0; i < 21; ++i) line.u.col(i).setConstant(0.1 * static_cast<double>(i));
  const PathIndex index = index_on(space(d), line);
  CHECK((index.verdict == IndexVerdict::minimum && index.negatives == 0 && index.nullity == 0));
  CHECK(index_on(space(d), line, make_kernel<Linear>()).verdict == IndexVerdict::not_applicable);
}

TEST_CASE("index of a straight line under an ill-conditioned tensor: a minimum, not rounding", "[framework]") {
  const double condition = GENERATE(1e6, 1e9, 1e11, 1e13), turn = GENERATE(0.3, 1.1, 2.5);
  const double c = std::cos(turn), s = std::sin(turn);
  Eigen::Matrix2d m;
  m << c * c + condition * s * s, (1 - condition) * c * s, (1 - condition) * c * s, s * s + condition * c * c;
  const Problem problem =
      between(space(2), make_metric_tensor_cost({.matrix = m}, 2), Eigen::Vector2d(0, 0), Eigen::Vector2d(0.9, 0.75));
  const Result result = find(problem, 60);
  CAPTURE(condition, turn, failures(result.certificate));
  CHECK(result.certificate.index.verdict == IndexVerdict::minimum);
}

TEST_CASE("index by elimination keeps its digits where a metric is ill-conditioned", "[framework]") {
  // The same tensor by formulas: nothing says that it is constant. Beyond 1e11 rounding decides, and that is said.
  const double condition = GENERATE(1e6, 1e9, 1e10, 1e15), turn = GENERATE(0.3, 1.1, 2.5);
  const double c = std::cos(turn), s = std::sin(turn);
  const auto text = [](double x) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "(%.17g)", x);
    return std::string(buffer);
  };
  MetricFieldOptions options;
  options.field = metric::Formula{
      {text(c * c + condition * s * s), text((1 - condition) * c * s), text(s * s + condition * c * c)}};
  const Problem problem =
      between(space(2), make_metric_field_cost(options, 2), Eigen::Vector2d(0, 0), Eigen::Vector2d(0.9, 0.75));
  const Result result = find(problem, 60);
  CAPTURE(condition, turn, failures(result.certificate));
  CHECK_FALSE(failed(result.certificate, "saddle"));
  if (condition < 1e12) CHECK(result.certificate.index.verdict == IndexVerdict::minimum);
}

TEST_CASE("index of a ring on a shallow neck: a minimum, on a cylinder: degenerate", "[framework][slow]") {
  const double opening = GENERATE(0.0, 1e-9, 1e-4, 1e-3);
  const ImplicitManifoldOptions options{
      .surface = implicit::Formula{.f = "x^2 + y^2 - k*z^2 - 1", .parameters = {{"k", opening}}}};
  Points loop(3, 24);
  for (Index i = 0; i < 24; ++i) {
    const double t = 2 * kPi * static_cast<double>(i) / 24;
    loop.col(i) = Eigen::Vector3d(std::cos(t), std::sin(t), 0.1 * std::sin(2 * t));
  }
  const int n = GENERATE(15, 40);
  const Result result =
      find(closed(make_implicit_manifold(options), make_euclidean_cost(3)), n, WaypointsInitializer(loop));
  CAPTURE(opening, n, failures(result.certificate));
  CHECK(result.certificate.index.verdict == (opening > 1e-6 ? IndexVerdict::minimum : IndexVerdict::degenerate));
  if (opening < 1e-6) return;
  // 15 segments of 24 degrees are too few to tell the neck from other sheets: then there is no bar.
  if (failed(result.certificate, "unresolved")) {
    CHECK(n == 15);
    CHECK(std::isnan(result.certificate.estimate.error));
  } else {
    CHECK(std::abs(result.certificate.estimate.value - 2 * kPi) <= result.certificate.estimate.error);
  }
}

}  // namespace leastcost::test
