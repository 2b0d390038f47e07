// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Costs with one defect each: check_cost() names it, and nothing that is not a consequence of it.
#include <leastcost/framework/check/check_cost.hpp>

#include <cmath>
#include <set>
#include <type_traits>

#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/solvers/georce.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

enum class Defect {
  none,
  negative,
  nan,
  rest,
  drifts,
  asymmetric,
  additive,
  below_curves,
  rough,
  dual,
  gradient,
  hessian,
  lopsided,
  residual,
  residual_jacobian,
  line_element
};

/// Length in a medium, c = w(m) |b - a| with the middle m; and one defect.
template <Defect D>
struct Medium {
  static constexpr int dim = 2;
  using P = Point<double, 2>;
  CostTraits traits() const { return {.additive = D == Defect::additive, .below_curves = D == Defect::below_curves}; }

  template <class S>
  S slowness(const Point<S, 2>& a, const Point<S, 2>& b) const {
    using std::sin;
    const double strength = D == Defect::below_curves ? 1.45 : 0.3;
    return 1.5 + strength * sin(a[0] + b[0]) + 0.0 * a[1];
  }

  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    using std::pow, std::sqrt;
    static int calls = 0;
    const S w = slowness<S>(a, b), length2 = (b - a).squaredNorm();
    const S q = length2 * w * w;
    if constexpr (D == Defect::negative) return -q;
    if constexpr (D == Defect::nan) return sqrt(-1.0 - q);
    if constexpr (D == Defect::rest) return q + 0.01;
    if constexpr (D == Defect::drifts) return q * (1 + 0.001 * (++calls % 7));
    if constexpr (D == Defect::asymmetric) return q * (1 + 0.1 * pow(b[0] - a[0], 3));
    if constexpr (D == Defect::rough) return sqrt(length2) * w * w;
    if constexpr (D == Defect::dual && !std::is_same_v<S, double>) return 1.01 * q;
    return q;
  }

  template <class S>
  Point<S, 2> residual(const Point<S, 2>& a, const Point<S, 2>& b) const
      requires(D == Defect::residual || D == Defect::residual_jacobian) {
    const S w = slowness<S>(a, b);
    Point<S, 2> r = (b - a) * w;
    if constexpr (D == Defect::residual) r *= S(1.1);
    if constexpr (D == Defect::residual_jacobian) r *= 1.0 + 0.1 * (b[0] - innermost(b[0]));
    return r;
  }

  /// q from value(), slopes that miss what the slowness contributes.
  double gradient(const P& a, const P& b, P& ga, P& gb) const requires(D == Defect::gradient) {
    const double w = slowness<double>(a, b);
    gb = 2 * w * w * (b - a);
    ga = -gb;
    return value<double>(a, b);
  }

  void hessian(const P& a, const P& b, Eigen::Ref<Points> h) const
      requires(D == Defect::hessian || D == Defect::lopsided) {
    SegmentGradient<2> g;
    detail::hessian_nested(*this, {a, b}, g, h);
    if (D == Defect::hessian) h *= 1.05;
    if (D == Defect::lopsided) h(0, 1) += 0.1 * h(0, 0), h(1, 0) -= 0.1 * h(0, 0);
  }

  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const requires(D == Defect::line_element) {
    return 2 * slowness<double>(x, x) * v.norm();
  }
};

/// Time of a ship in a current: |d| and a part linear in d, no metric.
struct Current {
  static constexpr int dim = 2;
  bool says_so = true;
  CostTraits traits() const { return {.symmetric = false, .additive = true, .quadratic_at_rest = !says_so}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    const Point<S, 2> d = b - a;
    const S c = d.norm() + 0.3 * d[0];
    return c * c;
  }
};

struct UpperHalf {
  static constexpr int dim = 2;
  CostTraits traits() const { return {}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    const S y = (a[1] + b[1]) * 0.5;
    if (!(innermost(y) > 0)) return S(std::numeric_limits<double>::infinity());
    return (b - a).squaredNorm() / (y * y);
  }
};

const PointSampler unit_square = sample_box(Eigen::Vector2d(0, 0.5), Eigen::Vector2d(1, 1.5));

std::string named(const SegmentCost& cost, const CheckCostOptions& options = {}) {
  std::mt19937_64 engine(7);
  std::string names;
  const std::vector<Fault> faults = check_cost(cost, unit_square, engine, options);
  INFO(text(faults));
  for (const Fault& fault : faults) {
    names += (names.empty() ? "" : " ") + fault.name;
    CHECK_FALSE(fault.message.empty());
    CHECK(fault.measured != fault.allowed);
  }
  return names;
}

template <Defect D>
std::string named() {
  return named(*make_segment_cost(Medium<D>{}));
}

bool names(const std::string& faults, const std::string& one) {
  return (" " + faults + " ").find(" " + one + " ") != std::string::npos;
}

}  // namespace

TEST_CASE("check_cost: a right cost has no faults, and a seed gives the same numbers again", "[framework]") {
  CHECK(named<Defect::none>() == "");
  CHECK(named(*make_segment_cost(UpperHalf{}), {.outside = {Eigen::Vector2d(0, -3)}}) == "");
  const auto cost = make_segment_cost(Medium<Defect::dual>{});
  std::mt19937_64 one(3), two(3);
  CHECK(text(check_cost(*cost, unit_square, one)) == text(check_cost(*cost, unit_square, two)));
}

TEST_CASE("check_cost: one defect, one name", "[framework]") {
  CHECK(named<Defect::asymmetric>() == "symmetric");
  CHECK(named<Defect::additive>() == "additive");
  CHECK(named<Defect::below_curves>() == "below_curves");
  CHECK(named<Defect::hessian>() == "quadratic_at_rest hessian");
  CHECK(named<Defect::residual>() == "residual residual_jacobian");
  CHECK(named<Defect::residual_jacobian>() == "residual_jacobian");
  CHECK(named<Defect::line_element>() == "line_element quadratic_at_rest");
}

TEST_CASE("check_cost: a defect that spoils more than one promise is named among them", "[framework]") {
  CHECK(names(named<Defect::negative>(), "value"));
  CHECK(names(named<Defect::nan>(), "value"));
  CHECK(names(named<Defect::rest>(), "rest"));
  CHECK(names(named<Defect::drifts>(), "repeatable"));
  CHECK(names(named<Defect::rough>(), "defect_order"));
  CHECK(names(named<Defect::rough>(), "line_element"));
  CHECK(names(named<Defect::dual>(), "value_and_gradient"));
  CHECK(names(named<Defect::gradient>(), "gradient"));
  CHECK_FALSE(names(named<Defect::gradient>(), "value_and_gradient"));
  CHECK(names(named<Defect::lopsided>(), "hessian_symmetry"));
  const CheckCostOptions beyond{.outside = {Eigen::Vector2d(5, 5)}};
  CHECK(named(*make_segment_cost(Medium<Defect::none>{}), beyond) == "outside");
}

TEST_CASE("a Finsler cost: it has a line element, and says that it has no metric", "[framework]") {
  CHECK(named(*make_segment_cost(Current{})) == "");
  CHECK(named(*make_segment_cost(Current{.says_so = false})) == "quadratic_at_rest");
  const auto cost = make_segment_cost(Current{});
  const Eigen::Vector2d x(0.3, 0.2);
  for (const Eigen::Vector2d& v : {Eigen::Vector2d(1, 0), Eigen::Vector2d(-1, 0), Eigen::Vector2d(-0.6, 0.8)})
    CHECK(cost->line_element(x, v) == Approx(v.norm() + 0.3 * v[0]).epsilon(1e-9));
}

TEST_CASE("a Finsler cost: Newton solves, georce refuses in words", "[framework]") {
  const Problem problem = between(space(2), make_segment_cost(Current{}), Eigen::Vector2d(0, 0), Eigen::Vector2d(3, 4));
  const Result result = find(problem, 12);
  CHECK(result.costs.sum() == Approx(5 + 0.9).epsilon(1e-12));
  PathEnergy energy(problem, 1);
  const auto refusal = Georce().cannot_solve(energy, result.path);
  REQUIRE(refusal.has_value());
  CHECK_THAT(*refusal, Catch::Contains("Finsler"));
}

TEST_CASE("the line element outside the domain of a cost is infinite", "[framework]") {
  const auto cost = make_segment_cost(UpperHalf{});
  CHECK(cost->line_element(Eigen::Vector2d(0, 2), Eigen::Vector2d(3, 0)) == Approx(1.5).epsilon(1e-14));
  CHECK(std::isinf(cost->line_element(Eigen::Vector2d(0, -1), Eigen::Vector2d(1, 0))));
}

}  // namespace leastcost::test
