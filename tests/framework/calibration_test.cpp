// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Proofs of minima: their bounds hold closed-form values, and what the points of a chain did not see makes them fail.
#include "framework/proof/calibrate.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <leastcost/framework/check/check_cost.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/newton/refinement.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/initializers/coordinate_circle.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

std::shared_ptr<const SegmentCost> tensor(const std::vector<std::string>& entries) {
  MetricFieldOptions options;
  options.field = metric::Formula{entries, {}};
  return make_metric_field_cost(options, entries.size() == 3 ? 2 : 3);
}
/// c = n |dx|.
std::shared_ptr<const SegmentCost> index(const std::string& n) {
  return tensor({"(" + n + ")^2", "0", "(" + n + ")^2"});
}

/// The proof for the finest chain of the certificate.
Calibration proof(const Problem& problem, int points) {
  const CoordinatePath chain = find(problem, points).path;
  return calibrate(problem, refine_levels(problem, chain, {}).paths.at(2), {chain.segment_count(), 1e-9, 200}, {});
}

/// Around the origin, a little outside of the unit circle and not even.
WaypointsInitializer circle(int dimension) {
  Points around = Points::Constant(dimension, 24, 0.05);
  for (Index i = 0; i < around.cols(); ++i) {
    const double t = 2 * kPi * static_cast<double>(i) / static_cast<double>(around.cols());
    around.col(i).head(2) = (1.05 + 0.03 * std::sin(2 * t)) * Eigen::Vector2d(std::cos(t), std::sin(t));
  }
  return WaypointsInitializer(around);
}

/// Time of a ray where the speed is 1 + y / 2, less in a narrow trench.
struct RayTime {
  static constexpr int dim = 2;
  static constexpr bool encloses = true;
  double depth;
  CostTraits traits() const { return {.unit = "s", .symmetric = true}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    using std::exp;
    const S off = (0.5 * (a[0] + b[0]) - 2.005) / 1e-3;
    const S speed = 1.0 + 0.25 * (a[1] + b[1]) + depth * exp(-(off * off));
    if (!(speed > S(0.0))) return S(std::numeric_limits<double>::infinity());
    return (b - a).squaredNorm() / (speed * speed);
  }
};

/// With intervals it is another.
struct OtherMetric {
  static constexpr int dim = 2;
  static constexpr bool encloses = true;
  CostTraits traits() const { return {.unit = "s", .symmetric = true}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    return (IntervalBased<S> ? 2.0 : 1.0) * (b - a).squaredNorm();
  }
};

/// Certified, with an error bar that does not hold the truth.
bool is_false(const Result& result, double truth) {
  return result.status == Status::certified &&
         std::abs(result.certificate.estimate.value - truth) > result.certificate.estimate.error + 1e-13 * truth;
}

}  // namespace

TEST_CASE("bounds of a proof hold the closed form", "[calibration]") {
  SECTION("half-plane") {
    const Problem problem =
        between(space(2), tensor({"1/y^2", "0", "1/y^2"}), Eigen::Vector2d(-1, 0.5), Eigen::Vector2d(1, 0.6));
    const double truth = std::acosh(1 + (4 + 0.01) / (2 * 0.5 * 0.6));
    for (const int points : {32, 64}) {
      const Calibration c = proof(problem, points);
      REQUIRE(c.proved);
      CHECK(c.lower <= truth);
      CHECK(truth <= c.upper.value());
      CHECK(c.upper.value() - c.lower < 1e-4);
    }
  }
  SECTION("a constant tensor in space") {
    const Problem problem = between(space(3), tensor({"2", "0.3", "0", "1", "0.1", "3"}), Eigen::Vector3d(0, 0, 0),
                                    Eigen::Vector3d(1, 2, -1));
    Eigen::Matrix3d m;
    m << 2, 0.3, 0, 0.3, 1, 0.1, 0, 0.1, 3;
    const Eigen::Vector3d d(1, 2, -1);
    const double truth = std::sqrt(d.dot(m * d));
    const Calibration c = proof(problem, 20);
    REQUIRE(c.proved);
    CHECK(c.lower <= truth);
    CHECK(truth <= c.upper.value());
    CHECK(c.upper.value() - c.lower < 1e-11);
  }
  SECTION("a constant metric in any number of coordinates") {
    for (const int n : {1, 4, 7, 12}) {
      Eigen::MatrixXd m = Eigen::MatrixXd::Identity(n, n);
      for (Index i = 0; i + 1 < n; ++i) m(i, i + 1) = m(i + 1, i) = 0.4 / static_cast<double>(i + 1);
      m.diagonal() += Eigen::VectorXd::LinSpaced(n, 0, 1);
      const Eigen::VectorXd a = Eigen::VectorXd::Zero(n), b = Eigen::VectorXd::LinSpaced(n, 1, -2);
      const Problem problem = between(space(n), make_metric_tensor_cost({.matrix = m}, n), a, b);
      const long double truth = std::sqrt(b.cast<long double>().dot(m.cast<long double>() * b.cast<long double>()));
      const Result r = find(problem, 20);
      CAPTURE(n);
      REQUIRE(r.status == Status::certified);
      REQUIRE(r.certificate.resolution);
      const Resolution& found = *r.certificate.resolution;
      CHECK(found.verdict == ResolutionVerdict::proved);
      CHECK(found.minimum_proved);
      REQUIRE((found.lower && found.upper));
      CHECK(*found.lower <= truth);
      CHECK(truth <= *found.upper);
      CHECK(*found.upper - *found.lower < 1e-13L * truth * n);
    }
  }
  SECTION("a sphere in stereographic coordinates, before and beyond the antipode") {
    const std::string g = "4/(1 + x^2 + y^2)^2";
    const auto on_sphere = [&](double length) {  // along the x axis, from the angle -1
      const auto x = [](double angle) { return std::tan(angle / 2); };
      return between(space(2), tensor({g, "0", g}), Eigen::Vector2d(x(-1), 0), Eigen::Vector2d(x(length - 1), 0));
    };
    const Calibration before = proof(on_sphere(2.5), 64);
    REQUIRE(before.proved);
    CHECK(before.lower <= 2.5);
    CHECK(2.5 <= before.upper);
    const Problem beyond = on_sphere(3.6);
    const CoordinatePath straight = sample_equally(beyond, StraightInitializer().first_path(beyond, {}).path, 127);
    CHECK_FALSE(calibrate(beyond, straight, {64, 1e-9}, {}).proved);
  }
}

TEST_CASE("bounds of a proof in a chart hold the closed form", "[calibration]") {
  const auto check = [](const parametric::Surface& surface, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                        double truth) {
    const Calibration c =
        proof(between(make_parametric_manifold({.surface = surface}), make_euclidean_cost(3), a, b), 64);
    REQUIRE(c.proved);
    CHECK(c.details != DetailVerdict::found);  // bounds of cos^2 + sin^2 on the cylinder decide nothing
    CHECK(c.lower <= truth);
    CHECK(truth <= c.upper.value());
    CHECK(c.upper.value() - c.lower < 1e-4);
  };
  const auto on_sphere = [](const Eigen::Vector2d& u) {
    return Eigen::Vector3d(std::cos(u[1]) * std::cos(u[0]), std::cos(u[1]) * std::sin(u[0]), std::sin(u[1]));
  };
  const Eigen::Vector2d a(0, 0.2), b(1.3, 0.7);
  check(parametric::Sphere{}, a, b, std::acos(on_sphere(a).dot(on_sphere(b))));
  check(parametric::Cylinder{.radius = 2}, {0, 0}, {1, 1}, std::hypot(2, 1));
  check(parametric::Formula{.x = "u", .y = "v", .z = "u^2 - v^2"}, {-1, 0}, {1, 0},
        std::sqrt(5) + std::asinh(2) / 2);  // the parabola z = x^2, a line of symmetry
}

TEST_CASE("bounds of a proof on a surface by equation hold the closed form", "[calibration][slow]") {
  const auto check = [](const implicit::Surface& surface, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                        double truth) {
    for (const int points : share<int>({64, 32}, 2)) {
      const Calibration c =
          proof(between(make_implicit_manifold({.surface = surface}), make_euclidean_cost(3), a, b), points);
      CAPTURE(points, static_cast<int>(c.details), c.gap, c.lower, c.upper.value_or(0), c.half_width);
      REQUIRE(c.proved);
      CHECK(c.details == DetailVerdict::none);
      CHECK(c.lower <= truth);
      CHECK(truth <= c.upper.value());
      CHECK(c.upper.value() - c.lower < 1e-4);
    }
  };
  const Eigen::Vector3d a(1, 2, -1), b(-1, 0.5, 1);
  check(implicit::Sphere{2}, 2 * a.normalized(), 2 * b.normalized(), 2 * std::acos(a.normalized().dot(b.normalized())));
  // A line of symmetry of a saddle, a parabola.
  check(implicit::Formula{.f = "z - x^2 + y^2"}, {-1, 0, 1}, {1, 0, 1}, std::sqrt(5) + std::asinh(2) / 2);
  check(implicit::Torus{2, 1}, {0, 1, 0}, {1, 0, 0}, kPi / 2);  // around the hole
  check(implicit::Torus{2, 0.5}, {2.5, 0, 0}, {2, 0, 0.5}, kPi / 4);
}

TEST_CASE("a tube is as long as its curve, however many points the chain has", "[calibration]") {
  const Problem torus = between(make_implicit_manifold({.surface = implicit::Torus{2, 0.5}}), make_euclidean_cost(3),
                                Eigen::Vector3d(2.5, 0, 0), Eigen::Vector3d(2, 0, 0.5));
  const Problem half_plane =
      between(space(2), tensor({"1/y^2", "0", "1/y^2"}), Eigen::Vector2d(-1, 0.5), Eigen::Vector2d(1, 0.6));
  for (const Problem& problem : {torus, half_plane}) {
    for (const int points : {64, 800}) {
      const Calibration c = proof(problem, points);
      CAPTURE(points, c.segments, c.gap);
      REQUIRE(c.proved);
      CHECK(c.segments <= 128);
      CHECK(c.gap < (points == 64 ? 1e-6 : 1e-8));
    }
  }
  // Where the metric has fine details, the tube has short segments, and there only.
  const Problem fine =
      between(space(2), index("1 + 1e-3*exp(-((x-0.5)^2+y^2)/2e-2^2)"), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0));
  const Calibration local = proof(fine, 800);
  REQUIRE(local.proved);
  CHECK(local.details == DetailVerdict::none);
  CHECK(local.segments < 300);
}

TEST_CASE("a surface by equation: details and second sheets beside the path", "[calibration]") {
  const auto between_on = [](const std::string& f, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const implicit::Formula surface{.f = f};
    return between(make_implicit_manifold({.surface = surface}), make_euclidean_cost(3), a, b);
  };
  const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0);
  const auto details = [&](const std::string& f) { return proof(between_on(f, a, b), 64).details; };
  CHECK(details("z - 2e-3*x*(1-x)*cos(y)") == DetailVerdict::none);
  CHECK(details("z - 2e-4*exp(-((x-0.5037)^2+(y-0.001)^2)/1e-3^2)") == DetailVerdict::found);
  // The other sheet is within the tube, or half way beyond it.
  for (const char* apart : {"0.001", "0.004"}) {
    const std::string f = std::string("z*(z - ") + apart + ")";
    CHECK(proof(between_on(f, a, b), 64).details == DetailVerdict::undecided);
    const Result result = find(between_on(f, a, b), 64);
    CHECK(result.status == Status::uncertified);
    REQUIRE_FALSE(result.certificate.failures.empty());
    CHECK(result.certificate.failures.front().name() == "unresolved");
  }
  // Through the apex of a cone, which has no normal.
  const Problem cone = between_on("z^2 - x^2 - y^2", {1, 0, 1}, {-1, 0, -1});
  CoordinatePath through;
  through.u.resize(3, 9);
  for (Index i = 0; i < 9; ++i) through.u.col(i) = (1 - 0.25 * static_cast<double>(i)) * Eigen::Vector3d(1, 0, 1);
  const Calibration apex = calibrate(cone, through, {8, 1e-9}, {});
  CHECK(apex.applies);
  CHECK_FALSE(apex.proved);
  CHECK(apex.details == DetailVerdict::undecided);
  const Result far = find(between_on("z*(z - 0.1)", a, b), 64);
  CHECK(far.status == Status::certified);
  CHECK(far.certificate.resolution->verdict == ResolutionVerdict::proved);
}

TEST_CASE("bounds of a proof hold the closed form of a ring", "[calibration]") {
  const auto check = [](const Result& r, double truth) {
    CAPTURE(r.costs.size(), failures(r.certificate));
    REQUIRE(r.status == Status::certified);
    const Resolution& found = r.certificate.resolution.value();
    CHECK(found.verdict == ResolutionVerdict::proved);
    REQUIRE(found.minimum_proved);
    CHECK(found.lower.value() <= truth);
    CHECK(truth <= found.upper.value());
    CHECK(*found.upper - *found.lower < 1e-4 * truth);
  };
  const int n = GENERATE(32, 64);
  for (const parametric::Surface& surface :
       std::vector<parametric::Surface>{parametric::Torus{}, parametric::Catenoid{}})
    check(find(closed(make_parametric_manifold({.surface = surface}), make_euclidean_cost(3)), n,
               CoordinateCircleInitializer(
                   {0, Eigen::Vector2d(0.3, std::holds_alternative<parametric::Torus>(surface) ? kPi - 0.3 : 0.3), 1})),
          2 * kPi);
  const ImplicitManifoldOptions hyperboloid{.surface = implicit::Formula{.f = "x^2 + y^2 - z^2 - 1"}};
  check(find(closed(make_implicit_manifold(hyperboloid), make_euclidean_cost(3)), n, circle(3)), 2 * kPi);
  // Around the origin at the distance r it costs 2 pi (1 + (r^2 - 1)^2).
  check(find(closed(space(2), index("(1 + (x^2 + y^2 - 1)^2)/sqrt(x^2 + y^2)")), n, circle(2)), 2 * kPi);
}

TEST_CASE("no proof of a ring that is no strict minimum, or of what its points did not see", "[calibration]") {
  const CalibrationOptions options{64, 1e-9, 200};
  const auto in_chart = [&](const parametric::Surface& surface, double v) {
    CoordinatePath ring;
    ring.ring = true;
    ring.u.resize(2, 128);
    for (Index i = 0; i < 128; ++i) ring.u.col(i) = Eigen::Vector2d(2 * kPi * static_cast<double>(i) / 128, v);
    ring.closing = {Eigen::Vector2d(1, 1), Eigen::Vector2d(2 * kPi, 0)};
    const Problem problem = closed(make_parametric_manifold({.surface = surface}), make_euclidean_cost(3));
    return calibrate(problem, ring, options, {});
  };
  CHECK(in_chart(parametric::Torus{}, kPi).proved);         // the inner equator
  CHECK_FALSE(in_chart(parametric::Torus{}, 0).proved);     // the outer one, a saddle
  CHECK_FALSE(in_chart(parametric::Cylinder{}, 0).proved);  // may drift
  const Calibration beside =
      in_chart(parametric::Torus{}, 3);  // no geodesic: the circles nearer to the inner one are less
  REQUIRE(beside.proved);
  CHECK(beside.lower <= 2 * kPi * (2 + std::cos(3 + beside.half_width)));

  // A trench along a radius, between two points of the finest chain and across the whole tube.
  const std::string ring = "(1 + (x^2 + y^2 - 1)^2)/sqrt(x^2 + y^2)";
  const Problem hidden = closed(space(2), index(ring + " - 0.5*exp(-((y - 0.0123*x)/1e-4)^2)"));
  const Result r = find(hidden, 64, circle(2));
  CHECK(failed(r.certificate, "unresolved"));
  CHECK(r.status == Status::uncertified);
}

TEST_CASE("a cost in C++ that compiles with intervals is proved", "[calibration]") {
  const auto costs = [](double depth) {
    return between(space(2), make_segment_cost(RayTime{depth}), Eigen::Vector2d(0, 0), Eigen::Vector2d(4, 0));
  };
  const double truth = std::acosh(1 + 0.25 * 16 / 2) / 0.5;
  const Calibration c = proof(costs(0), 64);
  REQUIRE(c.proved);
  CHECK(c.details == DetailVerdict::none);
  CHECK(c.lower <= truth);
  CHECK(truth <= c.upper.value());
  CHECK(c.upper.value() - c.lower < 1e-3);
  CHECK(proof(costs(1e-4), 64).details == DetailVerdict::found);  // a trench beside the path
  std::mt19937_64 engine(1);
  CHECK(
      text(check_cost(*make_segment_cost(RayTime{0}), sample_box(Eigen::Vector2d(0, 0), Eigen::Vector2d(4, 2)), engine))
          .empty());
  CHECK(text(check_cost(*make_segment_cost(OtherMetric{}), sample_box(Eigen::Vector2d(0, 0), Eigen::Vector2d(4, 2)),
                        engine))
            .find("enclosure") != std::string::npos);
}

TEST_CASE("details finer than the segments are found, and kinks told apart", "[calibration]") {
  const Eigen::Vector2d a(0, 0), b(1, 0);
  const auto details = [](const Problem& problem) {
    const Calibration c = proof(problem, 64);
    REQUIRE(c.applies);
    CHECK_FALSE((c.proved && c.details == DetailVerdict::found));
    return c.details;
  };
  const auto in_plane = [&](const std::string& n) { return details(between(space(2), index(n), a, b)); };
  CHECK(in_plane("1 + 0.3*exp(-6*((x-0.5)^2+(y-0.1)^2))") == DetailVerdict::none);
  CHECK(in_plane("1 + 1e-4*exp(-((x-0.5037)^2+(y-0.001)^2)/4e-4^2)") == DetailVerdict::found);
  CHECK(in_plane("1 - 5e-4*exp(-((y-0.003)/3e-4)^2)") == DetailVerdict::found);
  // On the path, where the derivatives of the metric are not known, and beside it.
  CHECK(in_plane("1 + abs(y)") == DetailVerdict::kink);
  CHECK(in_plane("2 + abs(x - 0.5)") == DetailVerdict::kink);
  CHECK(in_plane("1 + abs(y - 0.001)") == DetailVerdict::kink);
  SECTION("a bump of the surface beside the path") {
    const parametric::Formula bump{.x = "u", .y = "v", .z = "2e-4*exp(-((u-0.5037)^2+(v-0.001)^2)/1e-3^2)"};
    const auto surface = make_parametric_manifold({.surface = bump});
    CHECK(details(between(surface, make_euclidean_cost(3), a, b)) == DetailVerdict::found);
    CHECK(find(between(surface, make_euclidean_cost(3), a, b), 64).status == Status::uncertified);
  }
}

TEST_CASE("a proof is tried as it is asked for, and what is only sampled says what it sees", "[calibration]") {
  const Problem problem =
      between(space(2), index("1 + 0.3*exp(-6*((x-0.5)^2+(y-0.1)^2))"), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0));
  const auto resolution = [&](ProofRule rule) {
    FindOptions options{.points = 63};
    options.certificate.proof = rule;
    return find_path(problem, StraightInitializer(), Newton(), options).certificate;
  };
  const Certificate proved = resolution(ProofRule::always);
  CHECK(proved.resolution->minimum_proved);
  CHECK_FALSE(proved.resolution->narrowest);
  for (const ProofRule rule : {ProofRule::needed, ProofRule::never}) {
    const Certificate c = resolution(rule);
    CHECK(c.certified());
    CHECK(c.resolution->verdict == ResolutionVerdict::sampled);
    CHECK_FALSE(c.resolution->minimum_proved);
    // Two chains that share their ends only, with 128 segments and some 90: the widest gap is that of the finer one.
    CHECK(c.resolution->narrowest.value() <= c.estimate.value / 128);
    CHECK(c.resolution->narrowest.value() > 0.7 * c.estimate.value / 128);
  }
}

TEST_CASE("no proof of what a chain did not see", "[calibration]") {
  SECTION("a kink along the path, cheaper on one side of it") {
    for (const char* n : {"1 - max(0, 5*y)", "1 - max(5*y, 0)", "1 + min(0, 5*y)", "1 + min(5*y, 0)"}) {
      CAPTURE(n);
      const Problem problem = between(space(2), index(n), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0));
      const CoordinatePath straight = sample_equally(problem, StraightInitializer().first_path(problem, {}).path, 127);
      CHECK_FALSE(calibrate(problem, straight, {64, 1e-9, 200}, {}).proved);
    }
  }
  SECTION("constant on the path, and cheaper within the tube") {
    CHECK_FALSE(proof(between(space(2), index("max(0.5, min(1, 1.5 - 1000*(y-0.002)))"), Eigen::Vector2d(0, 0),
                              Eigen::Vector2d(1, 0)),
                      64)
                    .proved);
  }
  SECTION("a wall a fiftieth of a segment wide, met at an angle") {
    CHECK_FALSE(proof(between(space(2), index("1 + 10*exp(-((x-0.123)/2e-4)^2)"), Eigen::Vector2d(-1, 0),
                              Eigen::Vector2d(1, 1)),
                      63)
                    .proved);
  }
  SECTION("a shallow trench beside the path, a fiftieth of a segment wide") {
    CHECK_FALSE(proof(between(space(2), index("1 - 5e-4*exp(-((y-0.003)/3e-4)^2)"), Eigen::Vector2d(0, 0),
                              Eigen::Vector2d(1, 0)),
                      64)
                    .proved);
  }
}

TEST_CASE("the cost of a curve across kinks is enclosed", "[calibration]") {
  struct Kinked {
    std::string index;
    double cost;  // straight ahead from -1 to 1
  };
  const Kinked kinked = GENERATE(Kinked{"1+abs(x-0.1234)", 2 + (1.1234 * 1.1234 + 0.8766 * 0.8766) / 2},
                                 Kinked{"max(1,1.5+x)", 3.125}, Kinked{"min(1+x^2,1.25)", 2 + 1.0 / 3});
  const Problem problem = between(space(2), index(kinked.index), Eigen::Vector2d(-1, 0), Eigen::Vector2d(1, 0));
  CoordinatePath line{Points::Zero(2, 42), {}, false};
  line.u.row(0).setLinSpaced(-1, 1);
  const Calibration found = calibrate(problem, line, {41, 1e-9}, {});
  CAPTURE(kinked.index, kinked.cost);
  REQUIRE(found.applies);
  CHECK_FALSE(found.proved);
  REQUIRE(found.upper);
  CHECK(*found.upper >= kinked.cost * (1 - 1e-15));
  CHECK(*found.upper <= kinked.cost * (1 + 1e-9));
}

TEST_CASE("problems finer than the segments are not certified with an error beyond the bar", "[calibration]") {
  SECTION("ripples that fit all levels") {
    const Result r =
        find(between(space(2), index("1 - 0.5*cos(2*pi*256*x)"), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0)), 63);
    CHECK_FALSE(is_false(r, 1));
    CHECK(r.status == Status::uncertified);
    CHECK(std::isnan(r.certificate.estimate.error));
  }
  SECTION("a wall that no point meets") {
    const Result r = find(
        between(space(2), index("1 + 10*exp(-((x-0.123)/2e-4)^2)"), Eigen::Vector2d(-1, 0), Eigen::Vector2d(1, 1)), 63);
    CHECK(r.status == Status::uncertified);
  }
  SECTION("a condition of 7e7") {
    const Result r = find(between(space(2), tensor({"30161626.53531196", "-36296095.80716718", "43678236.090502486"}),
                                  Eigen::Vector2d(0, 0), Eigen::Vector2d(0.913668311176993, 0.7592475403307616)),
                          63);
    CHECK_FALSE(is_false(r, 1.18795900813));
  }
  SECTION("smooth and resolved: certified, with a proof") {
    const Result r = find(between(space(2), index("1 + 0.3*exp(-6*((x-0.5)^2+(y-0.1)^2))"), Eigen::Vector2d(0, 0),
                                  Eigen::Vector2d(1, 0.1)),
                          64);
    REQUIRE(r.status == Status::certified);
    REQUIRE(r.certificate.resolution);
    CHECK(r.certificate.resolution->verdict == ResolutionVerdict::proved);
    CHECK(r.certificate.resolution->minimum_proved);
    CHECK(r.certificate.estimate.value >= *r.certificate.resolution->lower - r.certificate.estimate.error);
    CHECK(*r.certificate.resolution->lower <= *r.certificate.resolution->upper);
  }
}

}  // namespace leastcost::test
