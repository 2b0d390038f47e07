// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Costs that are formulas in place and direction, sums, and costs times a field, against closed forms.
#include <cmath>
#include <numbers>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/cost/has_notes.hpp>
#include <leastcost/problems/costs/combined_cost.hpp>
#include <leastcost/problems/costs/formula_cost.hpp>
#include <leastcost/problems/costs/layers.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/costs/refractive_index.hpp>
#include <leastcost/problems/costs/walking.hpp>
#include <leastcost/solvers/georce.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

using Region = std::optional<CheckedRegion>;

CheckedRegion region(Eigen::VectorXd lower, Eigen::VectorXd upper) { return {std::move(lower), std::move(upper)}; }
const CheckedRegion kSquare = region(Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1));

std::shared_ptr<const SegmentCost> lagrangian(std::string text, const Region& where = kSquare, int dim = 2,
                                              bool convexify = false) {
  return make_formula_cost({.lagrangian = std::move(text), .convexify = convexify}, dim, where);
}

/// The message of the OptionError; empty where there is none.
std::string refusal(const std::string& text, const Region& where = kSquare, int dim = 2, bool convexify = false) {
  try {
    lagrangian(text, where, dim, convexify);
  } catch (const OptionError& error) {
    return error.key() + ": " + error.reason();
  }
  return "";
}

bool says(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

std::string note_of(const SegmentCost& cost) { return find_ability<HasNotes>(cost)->notes().front(); }

Result solved(std::shared_ptr<const SegmentCost> cost, const Eigen::VectorXd& a, const Eigen::VectorXd& b, int n) {
  return find(between(space(static_cast<int>(a.size())), std::move(cost), a, b), n);
}

void check_value(const Result& result, double truth, double widest) {
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(truth, e.value, e.error, e.method, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - truth) <= e.error);
  CHECK(e.error <= widest * truth);
}

const char* const kWind = "(sqrt((0.4*vx + 0.3*vy)^2 + 0.75*(vx^2 + vy^2)) - (0.4*vx + 0.3*vy)) / 0.75";

}  // namespace

TEST_CASE("a Riemannian Lagrangian is a metric: proved, and its certificate too", "[oracle]") {
  const char* const text = GENERATE("sqrt(vx^2 + vy^2) / y", "hypot(vx, vy) / y", "((vx*vx + vy*vy) / y^2)^0.5");
  const auto cost = lagrangian(text, region(Eigen::Vector2d(-1, 0.5), Eigen::Vector2d(3, 4)));
  CAPTURE(text, note_of(*cost));
  CHECK(cost->traits().symmetric);
  CHECK(cost->traits().quadratic_at_rest);
  CHECK(find_ability<EnclosesMetric>(*cost) != nullptr);
  CHECK(says(note_of(*cost), "proved by intervals"));
  const Result result = solved(cost, Eigen::Vector2d(0, 1), Eigen::Vector2d(2, 3), 64);
  check_value(result, 1.49099630899480838, 1e-5);
  REQUIRE(result.certificate.resolution);
  CHECK(result.certificate.resolution->minimum_proved);
  REQUIRE_FALSE(result.notes.empty());
  CHECK(result.notes.front() == note_of(*cost));
}

TEST_CASE("D5: constant wind as a formula: asymmetric, and says so", "[oracle]") {
  const auto cost = lagrangian(kWind);
  CHECK_FALSE(cost->traits().symmetric);
  CHECK_FALSE(cost->traits().quadratic_at_rest);
  CHECK(find_ability<EnclosesMetric>(*cost) == nullptr);
  CHECK(says(note_of(*cost), "proved by intervals"));
  const Eigen::Vector2d a(0, 0), b(3, 1);
  const Result there = solved(cost, a, b, 12), back = solved(cost, b, a, 12);
  check_value(there, 2.16333199893226547, 1e-10);
  check_value(back, 6.16333199893226547, 1e-10);
  REQUIRE(there.certificate.asymmetry);
  CHECK(*there.certificate.asymmetry == Approx(6.16333199893226547 / 2.16333199893226547 - 1).epsilon(1e-9));
}

TEST_CASE("D5: Zermelo's shear as a formula", "[oracle]") {
  // Current (-y, 0), speed 1: (sqrt((d.w)^2 + (1 - y^2) |d|^2) - d.w) / (1 - y^2).
  const auto cost = lagrangian("(sqrt((y*vx)^2 + (1 - y^2)*(vx^2 + vy^2)) + y*vx) / (1 - y^2)",
                               region(Eigen::Vector2d(0, -0.85), Eigen::Vector2d(2, 0.65)));
  check_value(solved(cost, Eigen::Vector2d(2, -0.8), Eigen::Vector2d(0, 0.6), 64), 2.40961645307160186, 1e-3);
  check_value(solved(cost, Eigen::Vector2d(0, 0.6), Eigen::Vector2d(2, -0.8), 64), 2.14281188063285385, 1e-3);
}

TEST_CASE("a Finsler norm that is no metric: straight lines, by symmetry of words and of numbers", "[oracle]") {
  const auto cost = lagrangian("(vx^4 + 4*vx^2*vy^2 + vy^4)^0.25");
  CHECK(cost->traits().symmetric);
  CHECK_FALSE(cost->traits().quadratic_at_rest);
  const Eigen::Vector2d a(0.2, -0.3), b(1.1, 0.4), d = b - a;
  const double truth = std::pow(std::pow(d[0], 4) + 4 * std::pow(d[0] * d[1], 2) + std::pow(d[1], 4), 0.25);
  check_value(solved(cost, a, b, 20), truth, 1e-10);
  CHECK(cost->line_element(a, d) == Approx(truth).epsilon(1e-15));
  // A method that works with metrics refuses it, in words.
  const Problem problem = between(space(2), cost, a, b);
  CoordinatePath path{Points(2, 3), {}, false};
  path.u << a, (a + b) / 2, b;
  PathEnergy energy(problem, 1);
  CHECK(Georce().cannot_solve(energy, path));
  // What it has for a metric in the direction of the path: v'Gv = F^2.
  Points metrics;
  energy.metrics(path, metrics);
  for (Index i = 0; i < 3; ++i) CHECK(d.dot(metrics.middleCols(2 * i, 2) * d) == Approx(truth * truth).epsilon(1e-9));
}

TEST_CASE("in space, and in five dimensions", "[oracle]") {
  const auto in_space =
      lagrangian("sqrt(vx^2 + vy^2 + vz^2) / z", region(Eigen::Vector3d(-1, -1, 0.8), Eigen::Vector3d(3, 3, 3.5)), 3);
  CHECK(says(note_of(*in_space), "proved by intervals"));
  check_value(solved(in_space, Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 2, 3), 64), 1.49099630899480838, 1e-5);
  const auto five = lagrangian("sqrt(v0^2 + v1^2 + v2^2 + v3^2 + 4*v4^2)",
                               region(Eigen::VectorXd::Zero(5), Eigen::VectorXd::Ones(5)), 5);
  CHECK(says(note_of(*five), "sampled"));
  check_value(solved(five, Eigen::VectorXd::Zero(5), Eigen::VectorXd::Ones(5), 10), std::sqrt(8.0), 1e-9);
}

TEST_CASE("what is no cost per length is refused, with what would be right", "[oracle]") {
  CHECK(says(refusal("vx^2 + vy^2"), "use its root"));
  CHECK(says(refusal("vx^2 + vy^2 + vx*vy*cos(x)"), "lagrangian: F(x, 2 v) = 4 F(x, v)"));
  CHECK(says(refusal("(vx^2 + vy^2)^0.75"), "degree 1.5"));
  CHECK(says(refusal("sqrt(vx^2 + vy^2) + 1"), "not a power of l"));
  CHECK(says(refusal("1 + x^2"), "degree 0"));
  CHECK(says(refusal("sqrt(vx^2 + vy^2) - 2*vx"), "must be positive for every v"));
  CHECK(says(refusal("sqrt(vx^2 + vy^2) * (1 + 2*(x > 3))"), "character"));
  CHECK(says(refusal("sqrt(vx^2 + vy^2) + 3.2*(vx*vy)^2 / (vx^2 + vy^2)^1.5"), "convexify: true"));
  CHECK(says(refusal("abs(vx) + abs(vy)"), "strictly convex across v"));
  CHECK(says(refusal("sqrt(vx^2 + vy^2 + vz^2) + 3*(vx*vy)^2/(vx^2 + vy^2 + vz^2)^1.5",
                     region(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)), 3),
             "strictly convex across v"));
  CHECK(says(refusal("sqrt(vx^2 + vy^2)", region(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()), 3, true),
             "convexify: works in the plane only"));
  CHECK(refusal("sqrt(vx^2 + vy^2) + 0.9*vx").empty());
  // Not everywhere in the region: a place where a formula has no value lies outside its domain.
  CHECK(says(note_of(*lagrangian("sqrt(vx^2 + vy^2) / sqrt(y)")), "it is not defined everywhere in that box"));
}

TEST_CASE("homogeneous in a way that its words do not show: measured, and said to be sampled", "[oracle]") {
  // exp(log(.)) is of degree 1, but no rule of degrees sees it.
  const auto cost = lagrangian("exp(0.5*log(vx^2 + vy^2))");
  CHECK(says(note_of(*cost), "sampled"));
  CHECK_FALSE(cost->traits().quadratic_at_rest);
  check_value(solved(cost, Eigen::Vector2d(0, 0), Eigen::Vector2d(3, 4), 20), 5, 1e-9);
}

TEST_CASE("the hull of a cost that is not convex: what zigzags make of it", "[oracle]") {
  // |v| (1 + 0.8 sin^2(2 t)), dear along the diagonals. The common tangent of the curve F = 1 over the first quadrant
  // is symmetric: g cos t - g' sin t = g sin t + g' cos t at its ends t and pi / 2 - t.
  const auto g = [](double t) { return 1 + 0.8 * std::pow(std::sin(2 * t), 2); };
  const auto slope = [](double t) { return 1.6 * std::sin(4 * t); };
  const auto defect = [&](double t) {
    return (g(t) * std::cos(t) - slope(t) * std::sin(t)) - (g(t) * std::sin(t) + slope(t) * std::cos(t));
  };
  double low = 0, high = 0.3;
  REQUIRE((defect(low) > 0 && defect(high) < 0));
  for (int i = 0; i < 60; ++i) (defect((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  const double per_component = g(low) * std::cos(low) - slope(low) * std::sin(low);
  const auto cost = lagrangian("sqrt(vx^2 + vy^2) * (1 + 0.8 * (2*vx*vy / (vx^2 + vy^2))^2)", kSquare, 2, true);
  CHECK(says(note_of(*cost), "convex hull is used"));
  const Eigen::Vector2d a(0, 0);
  const auto at = [&](double t) { return Eigen::Vector2d(std::cos(t), std::sin(t)); };
  for (const double t : {0.4, 0.7, std::numbers::pi / 4, 1.0})  // linear over the gap
    CHECK(move_cost(*cost, a, at(t)) == Approx(per_component * (std::cos(t) + std::sin(t))).epsilon(1e-12));
  for (const double t : {0.0, 0.05, std::numbers::pi / 2, 3.2})  // F itself beyond it
    CHECK(move_cost(*cost, a, at(t)) == Approx(g(t)).epsilon(1e-12));
  // The value of the straight path is right; that it is not unique is what the certificate says.
  const Result result = solved(cost, a, Eigen::Vector2d(1, 1), 20);
  CHECK(result.curve.cost == Approx(2 * per_component).epsilon(1e-9));
  CHECK(result.certificate.index.verdict == IndexVerdict::degenerate);
}

TEST_CASE("a hull is not asked for where F is convex", "[oracle]") {
  const auto plain = lagrangian("sqrt(vx^2 + vy^2) * (2 + x)"),
             hull = lagrangian("sqrt(vx^2 + vy^2) * (2 + x)", kSquare, 2, true);
  CHECK(move_cost(*plain, Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)) ==
        move_cost(*hull, Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)));
  CHECK(find_ability<EnclosesMetric>(*hull) != nullptr);
}

TEST_CASE("sums of lengths under one metric are such lengths, and are proved", "[oracle]") {
  // 1 / y = 0.25 / y + 0.75 / y.
  const auto part = make_refractive_index_cost({refraction::PowerLaw{.exponent = -1}}, 2);
  const auto scaled = make_scaled_cost({"1 / y"}, make_euclidean_cost(2));
  const auto sum = make_sum_cost({{0.25, part}, {0.75, scaled}});
  CHECK(sum->traits().quadratic_at_rest);
  REQUIRE(find_ability<EnclosesMetric>(*sum) != nullptr);
  const Result result = solved(sum, Eigen::Vector2d(0, 1), Eigen::Vector2d(2, 3), 64);
  check_value(result, 1.49099630899480838, 1e-5);
  REQUIRE(result.certificate.resolution);
  CHECK(result.certificate.resolution->minimum_proved);
}

TEST_CASE("a cost times a field keeps a metric that is no multiple of another", "[oracle]") {
  // Fisher-Rao, as sqrt(dx^2 + 2 dy^2) times 1 / y, and as half of itself times 2.
  MetricTensorOptions tensor;
  tensor.matrix = Eigen::Vector2d(1, 2).asDiagonal();
  const auto by_field = make_scaled_cost({"a / y", {{"a", 1}}}, make_metric_tensor_cost(tensor, 2));
  const auto twice = make_scaled_cost({"2 + 0 * x"}, make_metric_field_cost({.field = metric::FisherRao{}}, 2));
  const Result result = solved(by_field, Eigen::Vector2d(0, 1), Eigen::Vector2d(1, 2), 64);
  check_value(result, 1.18938093140641183, 1e-5);
  CHECK(result.certificate.resolution->minimum_proved);
  REQUIRE(find_ability<EnclosesMetric>(*twice) != nullptr);
  check_value(solved(twice, Eigen::Vector2d(0, 1), Eigen::Vector2d(1, 2), 64), 2 * 1.18938093140641183, 1e-5);
}

TEST_CASE("a sum of lengths under two constant metrics is a norm: straight, and no metric", "[oracle]") {
  MetricTensorOptions tensor;
  tensor.matrix = Eigen::Vector2d(9, 1).asDiagonal();
  const auto sum = make_sum_cost({{2, make_euclidean_cost(2)}, {0.5, make_metric_tensor_cost(tensor, 2)}});
  CHECK_FALSE(sum->traits().quadratic_at_rest);
  CHECK(sum->traits().additive);
  CHECK(find_ability<EnclosesMetric>(*sum) == nullptr);
  check_value(solved(sum, Eigen::Vector2d(0, 0), Eigen::Vector2d(4, 3), 20), 2 * 5 + 0.5 * std::hypot(12, 3), 1e-10);
}

TEST_CASE("a sum of one constant metric with itself is a constant metric", "[oracle]") {
  const auto sum = make_sum_cost({{2, make_euclidean_cost(2)}, {0.5, make_euclidean_cost(2)}});
  REQUIRE(find_ability<HasConstantMetric>(*sum) != nullptr);
  CHECK(move_cost(*sum, Eigen::Vector2d(0, 0), Eigen::Vector2d(4, 3)) == Approx(12.5).epsilon(1e-15));
}

TEST_CASE("time and length, traded: a bead that pays for its way", "[oracle]") {
  // At rest at the source, where a sum of derivatives would be infinite if the end were free.
  TravelTimeOptions options{.gravity = 1};
  const Eigen::Vector2d source(0, 0), target(std::numbers::pi, -2);
  const auto time = make_travel_time_cost(options, 2, Eigen::VectorXd(source));
  const auto sum = make_sum_cost({{1, time}, {1e-9, make_euclidean_cost(2)}});
  const Result result = solved(sum, source, target, 40);
  CHECK(result.curve.cost == Approx(find(bead(source, target), 40).curve.cost).epsilon(1e-7));
  // Where length counts for nearly everything the path is nearly straight.
  const auto length = make_sum_cost({{1e-6, time}, {1, make_euclidean_cost(2)}});
  CHECK(solved(length, source, target, 40).curve.cost == Approx((target - source).norm()).epsilon(1e-5));
}

TEST_CASE("parts of a sum that cannot be are refused by name", "[oracle]") {
  const auto key = [](std::vector<WeightedCost> terms) {
    try {
      make_sum_cost(std::move(terms));
    } catch (const OptionError& error) {
      return error.key();
    }
    return std::string();
  };
  const auto flat = make_euclidean_cost(2);
  CHECK(key({}) == "terms");
  CHECK(key({{1, flat}, {0, flat}}) == "terms.1.weight");
  CHECK(key({{1, flat}, {-2, flat}}) == "terms.1.weight");
  CHECK(key({{1, flat}, {1, make_euclidean_cost(3)}}) == "terms.1");
  // A sum that hid the kinks of walking was certified 0.2 % below the least time, with a bar of 1e-11.
  const auto walk = make_walking_cost({.length = MapLength::kilometres}, 3);
  CHECK(key({{1, make_euclidean_cost(3)}, {1, walk}}) == "terms.1.cost");
  CHECK_THROWS_WITH(make_scaled_cost({"2"}, walk), Catch::Contains("walking"));
  const Eigen::VectorXd interface = Eigen::VectorXd::Zero(1);
  const auto layers = make_layers_cost({.interfaces = interface, .speeds = Eigen::VectorXd(Eigen::Vector2d(1, 2))}, 2);
  CHECK(key({{1, layers}}) == "terms.0.cost");
  CHECK_THROWS_WITH(make_scaled_cost({"2"}, layers), Catch::Contains("interfaces"));
  CHECK_THROWS_AS(make_scaled_cost({"1 +"}, flat), OptionError);
  const auto scaled = make_scaled_cost({"y"}, flat);
  CHECK(std::isinf(move_cost(*scaled, Eigen::Vector2d(0, -1), Eigen::Vector2d(1, -1))));
  const auto* explains = find_ability<ExplainsInfinity>(*scaled);
  CHECK(says(explains->why_infinite(Eigen::Vector2d(0, -1), Eigen::Vector2d(1, -1)), "the field 'y' is not positive"));
}

}  // namespace leastcost::test
