// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Metrics with a closed form, docs/oracles.md D3 and D4, each a cost of a few lines that is defined here and nowhere
// else.
#include <cmath>

#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {
namespace {

/// Length under a metric that is taken at the middle of the move; +infinity where `inside` is not positive there.
template <class S>
S outside_is_infinite(const S& inside, const S& q) {
  return innermost(inside) > 0 ? q : S(std::numeric_limits<double>::infinity());
}

/// A metric of the library.
std::shared_ptr<const SegmentCost> field(const char* type, std::vector<std::string> entries = {}, int dim = 2) {
  MetricFieldOptions options{.field = form<metric::Field>(type)};
  if (auto* formula = std::get_if<metric::Formula>(&options.field)) formula->entries = std::move(entries);
  return make_metric_field_cost(options, dim);
}

struct PowerLaw {  // index of refraction y^k
  static constexpr int dim = 2;
  double k;
  CostTraits traits() const { return {.unit = "optical length"}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    using std::pow;
    const S y = (a[1] + b[1]) * 0.5;
    if (!(innermost(y) > 0)) return S(std::numeric_limits<double>::infinity());
    return (b - a).squaredNorm() * pow(y, 2 * k);
  }
};

/// Slides through the unit ball, rest at the surface: v^2 = 1 - r^2. Mean of the end speeds, as for a chute.
struct GravityTunnel {
  static constexpr int dim = 2;
  CostTraits traits() const { return {.unit = "s"}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    using std::sqrt;
    const S va = S(1.0) - a.squaredNorm(), vb = S(1.0) - b.squaredNorm();
    if (innermost(va) < 0 || innermost(vb) < 0) return S(std::numeric_limits<double>::infinity());
    const S v = sqrt(va) + sqrt(vb);
    return outside_is_infinite(v, S(4 * (b - a).squaredNorm() / (v * v)));
  }
};

struct Wind {  // air speed 1, wind (0.4, 0.3): Zermelo, docs/oracles.md D5
  static constexpr int dim = 2;
  CostTraits traits() const { return {.unit = "s", .symmetric = false, .additive = true, .below_curves = true}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    using std::sqrt;
    const Point<S, 2> d = b - a;
    const S along = d[0] * 0.4 + d[1] * 0.3, square = d.squaredNorm();
    if (innermost(square) == 0 && is_constant(square)) return S(0.0);
    const S time = (sqrt(S(along * along + 0.75 * square)) - along) / 0.75;
    return time * time;
  }
};

Result find_in_plane(std::shared_ptr<const SegmentCost> cost, const Eigen::Vector2d& source,
                     const Eigen::Vector2d& target, int n) {
  return find(between(space(2), std::move(cost), source, target), n);
}

template <class Cost>
Result find_in_plane(const Cost& cost, const Eigen::Vector2d& source, const Eigen::Vector2d& target, int n) {
  return find_in_plane(make_segment_cost(cost), source, target, n);
}

/// Certified, and the truth lies within the error bar, which is not simply wide.
void check_covers(const Result& result, double truth, double widest = 0.02) {
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(result.costs.size(), truth, e.value, e.error, e.method, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - truth) <= e.error);
  CHECK(e.error <= widest * truth);
}

}  // namespace

TEST_CASE("D3: hyperbolic, information and pull-back metrics", "[oracle]") {
  const int n = GENERATE(12, 32, 64, 200);
  const auto half_plane = field("half_plane"), by_formula = field("formula", {"1 / y^2", "0", "1 / y^2"});
  SECTION("half-plane") { check_covers(find_in_plane(half_plane, {0, 1}, {2, 3}, n), 1.49099630899480838); }
  SECTION("half-plane by formulas") { check_covers(find_in_plane(by_formula, {0, 1}, {2, 3}, n), 1.49099630899480838); }
  SECTION("Fisher-Rao") { check_covers(find_in_plane(field("fisher_rao"), {0, 1}, {1, 2}, n), 1.18938093140641183); }
  SECTION("Poincare") {
    check_covers(find_in_plane(field("poincare_disc"), {0.1, -0.3}, {-0.5, 0.6}, n), 2.72574840436481329);
  }
  SECTION("pull-back") {  // M = J'J, phi = (x + 0.3 sin y, y + 0.2 x^2)
    const auto pull_back = field("formula", {"1 + (0.4 * x)^2", "0.3 * cos(y) + 0.4 * x", "(0.3 * cos(y))^2 + 1"});
    check_covers(find_in_plane(pull_back, {-1, -1}, {1, 2}, n), 3.92132492874104357);
  }
}

TEST_CASE("D3: the value of a smooth curve is good to 1e-8 at 200 points", "[oracle]") {
  const auto value = [](const Result& r) { return r.certificate.estimate.value; };
  CHECK(value(find_in_plane(field("half_plane"), {0, 1}, {2, 3}, 199)) == Approx(1.49099630899480838).epsilon(1e-8));
  CHECK(value(find_in_plane(field("fisher_rao"), {0, 1}, {1, 2}, 199)) == Approx(1.18938093140641183).epsilon(1e-8));
  CHECK(value(find_in_plane(field("poincare_disc"), {0.1, -0.3}, {-0.5, 0.6}, 199)) ==
        Approx(2.72574840436481329).epsilon(1e-8));
}

TEST_CASE("D3: symmetric positive definite matrices under the affine-invariant metric", "[oracle]") {
  // tr((P^-1 dP)^2) for P = [x y; y z].
  const auto cost = field("formula",
                          {"z^2 / (x*z - y^2)^2", "-2*y*z / (x*z - y^2)^2", "y^2 / (x*z - y^2)^2",
                           "2*(x*z + y^2) / (x*z - y^2)^2", "-2*x*y / (x*z - y^2)^2", "x^2 / (x*z - y^2)^2"},
                          3);
  const auto solve = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return find(between(space(3), cost, a, b), 199);
  };
  const Result diagonal = solve({1, 0, 2}, {3, 0, 0.5}), full = solve({2, 0.5, 1}, {1, -0.3, 3});
  check_covers(diagonal, 1.76883040919286202);
  check_covers(full, 1.5426995089660);
  CHECK(diagonal.certificate.estimate.value == Approx(1.76883040919286202).epsilon(1e-8));
  CHECK(full.certificate.estimate.value == Approx(1.5426995089660).epsilon(1e-8));
}

TEST_CASE("D3: both readings of T and both rules agree where they must", "[oracle]") {
  const int n = 64;
  MetricFieldOptions options;
  options.rule = GENERATE(TensorRule::midpoint, TensorRule::average);
  options.reading = TensorReading::root;  // 1 / y is a root of 1 / y^2
  options.field = metric::Formula{.entries = {"1 / y", "0", "1 / y"}};
  check_covers(find_in_plane(make_metric_field_cost(options, 2), {0, 1}, {2, 3}, n), 1.49099630899480838);
  options.reading = TensorReading::metric;
  options.field = metric::Formula{.entries = {"1 / y^2", "0", "1 / y^2"}};
  check_covers(find_in_plane(make_metric_field_cost(options, 2), {0, 1}, {2, 3}, n), 1.49099630899480838);
}

TEST_CASE("D4: the power-law family", "[oracle]") {
  const int n = GENERATE(12, 32, 64, 200);
  SECTION("k = -1 is the half-plane") {
    check_covers(find_in_plane(PowerLaw{-1}, {0, 1}, {2, 3}, n), 1.49099630899480838);
  }
  SECTION("k = 0 is a line") { check_covers(find_in_plane(PowerLaw{0}, {0, 1}, {3, 5}, n), 5); }
  SECTION("k = 1/2 is a parabola") {
    check_covers(find_in_plane(PowerLaw{0.5}, {0, 1}, {1, 2}, n), 1.71528231633382749);
  }
  SECTION("k = 1 is a catenary") {
    check_covers(find_in_plane(PowerLaw{1}, {-0.5, 1}, {0.5, 1}, n), 0.953624106702002751);
  }
}

TEST_CASE("D4: no catenary beyond a / y0 = 0.6627, and none is certified", "[oracle]") {
  const Result result = find_in_plane(PowerLaw{1}, {-0.7, 1}, {0.7, 1}, 31);
  CAPTURE(word_of(result.solve.termination), result.costs.sum());
  CHECK(result.status == Status::uncertified);
}

TEST_CASE("D4: gravity tunnel", "[oracle]") {
  const int n = GENERATE(32, 64, 200);
  const Result result = find_in_plane(GravityTunnel{}, {1, 0}, {std::cos(1.0), std::sin(1.0)}, n);
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(n, e.value, e.error, e.method, failures(result.certificate));
  CHECK(std::abs(e.value - 2.29851806762087178) <= e.error);
  CHECK(e.error < 0.02 * e.value);
  CHECK(result.certificate.index.verdict == IndexVerdict::minimum);
}

TEST_CASE("D5: constant wind, there and back: asymmetric, and the certificate measures by how much", "[oracle]") {
  const Result there = find_in_plane(Wind{}, {0, 0}, {3, 1}, 12), back = find_in_plane(Wind{}, {3, 1}, {0, 0}, 12);
  check_covers(there, 2.16333199893226547, 1e-11);
  check_covers(back, 6.16333199893226547, 1e-11);
  REQUIRE(there.certificate.asymmetry);
  CHECK(*there.certificate.asymmetry == Approx(6.16333199893226547 / 2.16333199893226547 - 1).epsilon(1e-9));
}

TEST_CASE("D3: a half-plane geodesic under a lid hugs it", "[oracle]") {
  // Circles of radius 1.2 about points of y = 0 touch the lid y = 1.2; between them the path runs along it.
  const int n = GENERATE(32, 64, 200);
  const auto lid = box(Eigen::Vector2d(-5, 0.1), Eigen::Vector2d(5, 1.2));
  const Result result = find(between(lid, field("half_plane"), Eigen::Vector2d(0, 1), Eigen::Vector2d(2, 1)), n);
  const double truth = 2 * std::acosh(1.2) + (2 - 2 * std::sqrt(1.2 * 1.2 - 1)) / 1.2;
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(n, e.value, e.error, e.method, truth, failures(result.certificate));
  CHECK(std::abs(e.value - truth) <= e.error);
  CHECK(e.error < 0.01 * truth);
  CHECK(result.certificate.index.verdict == IndexVerdict::minimum);
  CHECK_FALSE(failed(result.certificate, "stationarity"));
  CHECK(result.path.u.row(1).maxCoeff() == 1.2);
}

TEST_CASE("D3: constant metric", "[oracle]") {
  MetricTensorOptions options;
  options.matrix = (Eigen::Matrix2d() << 4, 1, 1, 2).finished();
  const auto cost = make_metric_tensor_cost(options, 2);
  const Result result =
      find(between(space(2), cost, Eigen::Vector2d(0, 0), Eigen::Vector2d(3, -1)), GENERATE(1, 7, 40));
  check_covers(result, std::sqrt(32.0), 1e-11);
  CHECK(result.certificate.estimate.value == Approx(std::sqrt(32.0)).epsilon(1e-12));
  CHECK(spread(result.costs) < 1e-6);
}

TEST_CASE("D4: straight lines and random constant metrics in R^2, R^3, R^7 from bent starts", "[oracle]") {
  const int d = GENERATE(2, 3, 7);
  Random random;
  const Eigen::VectorXd a = random.vector(d), b = random.vector(d);
  const WaypointsInitializer detour((a + b) / 2 + random.vector(d));
  SECTION("euclidean") {
    const Result result = find(between(space(d), make_euclidean_cost(d), a, b), 20, detour);
    check_covers(result, (b - a).norm(), 1e-11);
  }
  SECTION("metric tensor") {
    const Eigen::MatrixXd root = random.matrix(d, d) + 2 * Eigen::MatrixXd::Identity(d, d);
    MetricTensorOptions options;
    options.matrix = root.transpose() * root;
    const Result result = find(between(space(d), make_metric_tensor_cost(options, d), a, b), 20, detour);
    check_covers(result, (root * (b - a)).norm(), 1e-11);
  }
}

}  // namespace leastcost::test
