// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/numbers/dual.hpp>

#include <Eigen/Core>

#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using First = Dual<double, 1>;
using Second = Dual<First, 1>;

/// x with unit derivative in both directions, so that .d[0].d[0] of f(x) is f''(x).
Second variable(double x) {
  Second s(x);
  s.value.d[0] = 1;
  s.d[0] = First(1.0);
  return s;
}

/// f, f' and f'' at x against what analysis says.
template <class F>
void check(const char* name, F f, double x, double value, double first, double second) {
  CAPTURE(name, x);
  const Second y = f(variable(x));
  CHECK(innermost(y) == Approx(value).epsilon(1e-14).margin(1e-15));
  CHECK(y.value.d[0] == Approx(first).epsilon(1e-14).margin(1e-15));
  CHECK(y.d[0].value == Approx(first).epsilon(1e-14).margin(1e-15));
  CHECK(y.d[0].d[0] == Approx(second).epsilon(1e-13).margin(1e-15));
}

}  // namespace

TEST_CASE("dual numbers: elementary functions with two derivatives", "[framework]") {
  Random random;
  for (const double x : {1e-8, 0.3, 1.0, 2.5, random.uniform(0.1, 3)}) {
    const double e = std::exp(x), s = std::sin(x), c = std::cos(x), sh = std::sinh(x), ch = std::cosh(x),
                 t = std::tanh(x);
    const double r = std::sqrt(x), p = std::pow(x, 2.3), a = 1 / (1 + x * x);
    check(
        "sqrt", [](auto y) { return sqrt(y); }, x, r, 0.5 / r, -0.25 / (r * x));
    check(
        "exp", [](auto y) { return exp(y); }, x, e, e, e);
    check(
        "expm1", [](auto y) { return expm1(y); }, x, std::expm1(x), e, e);
    check(
        "log", [](auto y) { return log(y); }, x, std::log(x), 1 / x, -1 / (x * x));
    check(
        "sin", [](auto y) { return sin(y); }, x, s, c, -s);
    check(
        "cos", [](auto y) { return cos(y); }, x, c, -s, -c);
    check(
        "sinh", [](auto y) { return sinh(y); }, x, sh, ch, sh);
    check(
        "cosh", [](auto y) { return cosh(y); }, x, ch, sh, ch);
    check(
        "tanh", [](auto y) { return tanh(y); }, x, t, 1 - t * t, -2 * t * (1 - t * t));
    check(
        "atan", [](auto y) { return atan(y); }, x, std::atan(x), a, -2 * x * a * a);
    check(
        "pow", [](auto y) { return pow(y, 2.3); }, x, p, 2.3 * p / x, 2.3 * 1.3 * p / (x * x));
    check(
        "abs", [](auto y) { return abs(-y * y); }, x, x * x, 2 * x, 2);
  }
}

TEST_CASE("dual numbers: inverse functions and powers", "[framework]") {
  Random random;
  for (const double x : {-0.8, 1e-8, 0.4, random.uniform(-0.9, 0.9)}) {
    const double r = 1 / std::sqrt((1 - x) * (1 + x)), t = std::tan(x);
    check(
        "asin", [](auto y) { return asin(y); }, x, std::asin(x), r, x * r * r * r);
    check(
        "acos", [](auto y) { return acos(y); }, x, std::acos(x), -r, -x * r * r * r);
    check(
        "tan", [](auto y) { return tan(y); }, x, t, 1 + t * t, 2 * t * (1 + t * t));
    const double e = std::pow(2.5, x), l = std::log(2.5);
    check(
        "power of a constant", [](auto y) { return pow(2.5, y); }, x, e, e * l, e * l * l);
    check(
        "constant power of a negative number", [](auto y) { return pow(y - 2, decltype(y)(3.0)); }, x,
        std::pow(x - 2, 3), 3 * std::pow(x - 2, 2), 6 * (x - 2));
  }
  for (const double x : {0.4, 2.0, random.uniform(0.5, 3)}) {
    const double p = std::pow(x, x), l = std::log(x) + 1;
    check(
        "x^x", [](auto y) { return pow(y, y); }, x, p, p * l, p * (l * l + 1 / x));
  }
  const Second zero = pow(Second(0.0), variable(2));  // no 0 * infinity
  CHECK((innermost(zero) == 0 && zero.d[0].value == 0 && zero.d[0].d[0] == 0));
}

TEST_CASE("dual numbers: functions of two arguments, on a circle and on its radii", "[framework]") {
  // atan2(r sin t, r cos t) = t and hypot(..) = r, in every quadrant.
  for (const double t : {-3.0, -1.2, 0.3, 1.9}) {
    check(
        "angle", [](auto y) { return atan2(2 * sin(y), 2 * cos(y)); }, t, t, 1, 0);
    check(
        "radius", [](auto y) { return hypot(2 * sin(y), 2 * cos(y)); }, t, 2, 0, 0);
    check(
        "along the ray", [t](auto y) { return hypot(std::sin(t) * y, std::cos(t) * y); }, 1.7, 1.7, 1, 0);
    check(
        "across the ray", [t](auto y) { return atan2(std::sin(t) * y, std::cos(t) * y); }, 1.7, t, 0, 0);
  }
  CHECK(hypot(First(0.0), First(0.0)).d[0] == 0);
}

TEST_CASE("dual numbers: arithmetic", "[framework]") {
  const double x = 1.7;
  check(
      "sum", [](auto y) { return 2 + y - (-y) + y; }, x, 2 + 3 * x, 3, 0);
  check(
      "product", [](auto y) { return 3 * y * y * y; }, x, 3 * x * x * x, 9 * x * x, 18 * x);
  check(
      "quotient", [](auto y) { return 1 / y; }, x, 1 / x, -1 / (x * x), 2 / (x * x * x));
  check(
      "self", [](auto y) { return (y * y) / y; }, x, x, 1, 0);
  check(
      "composed", [](auto y) { return exp(sin(y) / y); }, x, std::exp(std::sin(x) / x),
      std::exp(std::sin(x) / x) * (std::cos(x) / x - std::sin(x) / (x * x)),
      std::exp(std::sin(x) / x) * (std::pow(std::cos(x) / x - std::sin(x) / (x * x), 2) - std::sin(x) / x -
                                   2 * std::cos(x) / (x * x) + 2 * std::sin(x) / (x * x * x)));
  Second y = variable(x);
  y += y;
  y *= y;
  y -= y / 2;
  CHECK(innermost(y) == Approx(2 * x * x));
  CHECK(y.d[0].d[0] == Approx(4));
  y = variable(x);
  y /= y;
  CHECK((innermost(y) == 1 && std::abs(y.d[0].value) < 1e-15));
}

TEST_CASE("dual numbers: mixed second derivatives of several variables", "[framework]") {
  using Inner = Dual<double, 2>;
  using Outer = Dual<Inner, 2>;
  const auto seed = [](double v, std::size_t k) {
    Outer s(v);
    s.value.d[k] = 1;
    s.d[k] = Inner(1.0);
    return s;
  };
  const double x = 0.7, y = -1.3;
  const Outer f = sin(seed(x, 0) * seed(y, 1)) * seed(y, 1);  // y sin(x y)
  CHECK(f.d[0].d[0] == Approx(-y * y * y * std::sin(x * y)));
  CHECK(f.d[0].d[1] == Approx(2 * y * std::cos(x * y) - x * y * y * std::sin(x * y)));
  CHECK(f.d[1].d[0] == f.d[0].d[1]);
  CHECK(f.d[1].d[1] == Approx(2 * x * std::cos(x * y) - x * x * y * std::sin(x * y)));
}

TEST_CASE("dual numbers: the root of a constant 0 is a constant, that of a variable 0 is not", "[framework]") {
  const Second constant = sqrt(Second(0.0)) + variable(2);
  CHECK((innermost(constant) == 2 && constant.d[0].value == 1 && constant.d[0].d[0] == 0));
  CHECK_FALSE(std::isfinite(sqrt(variable(0)).d[0].value));
  First only_first(0.0);
  only_first.d[0] = 1;
  CHECK_FALSE(is_constant(only_first));
  CHECK(is_constant(First(3.0)));
}

TEST_CASE("dual numbers: a function of a constant is a constant, also where its slope is infinite", "[framework]") {
  using Outer = Dual<Dual<double, 2>, 2>;
  const Outer zero(0.0), one(1.0);
  for (const Outer& y : {sqrt(zero), pow(zero, 0.5), pow(zero, 1.5), pow(zero, 1.0), pow(zero, 2.0), acos(one),
                         hypot(zero, zero), atan2(zero, one)}) {
    CHECK(is_constant(y));
    CHECK(innermost(y) == 0);
  }
  CHECK(is_constant(asin(one)));
  CHECK((is_constant(log(zero)) && std::isinf(innermost(log(zero)))));
  CHECK(pow(variable(0.0), 1.0).d[0].d[0] == 0);
  CHECK(pow(variable(0.0), 2.0).d[0].d[0] == 2);
  CHECK(std::isinf(sqrt(variable(0.0)).value.d[0]));
}

TEST_CASE("dual numbers: comparisons and Eigen", "[framework]") {
  CHECK((First(1.0) < First(2.0) && First(2.0) >= First(2.0) && First(2.0) == First(2.0) && First(1.0) != First(2.0)));
  First nan(std::nan(""));
  CHECK_FALSE((nan == nan));
  CHECK_FALSE(isfinite(nan));
  Eigen::Matrix<First, 2, 1> v(First(3.0), First(4.0));
  v[0].d[0] = 1;
  const First square = v.squaredNorm(), half = (0.5 * v * 2.0)[0];
  CHECK((square.value == 25 && square.d[0] == 6));
  CHECK((half.value == 3 && half.d[0] == 1));
}

}  // namespace leastcost::test
