// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Enclosures contain what they enclose: values and derivatives at random points of random boxes.
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <leastcost/framework/numbers/dual.hpp>
#include <leastcost/framework/numbers/interval_jet.hpp>
#include "problems/formula/formula.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

Interval around(Random& random, double middle) {
  const double half = std::exp(random.uniform(-12, 1));
  return {middle - half * random.uniform(0, 1), middle + half * random.uniform(0, 1)};
}

struct Function {
  const char* name;
  std::function<Interval(const Interval&)> enclosed;
  std::function<double(double)> exact;
};

}  // namespace

TEST_CASE("intervals contain what functions make of their numbers", "[interval]") {
  const std::vector<Function> functions = {
      {"sqrt", [](const Interval& x) { return sqrt(x); }, [](double x) { return std::sqrt(x); }},
      {"exp", [](const Interval& x) { return exp(x); }, [](double x) { return std::exp(x); }},
      {"log", [](const Interval& x) { return log(x); }, [](double x) { return std::log(x); }},
      {"sin", [](const Interval& x) { return sin(x); }, [](double x) { return std::sin(x); }},
      {"cos", [](const Interval& x) { return cos(x); }, [](double x) { return std::cos(x); }},
      {"tan", [](const Interval& x) { return tan(x); }, [](double x) { return std::tan(x); }},
      {"asin", [](const Interval& x) { return asin(x); }, [](double x) { return std::asin(x); }},
      {"acos", [](const Interval& x) { return acos(x); }, [](double x) { return std::acos(x); }},
      {"atan", [](const Interval& x) { return atan(x); }, [](double x) { return std::atan(x); }},
      {"cosh", [](const Interval& x) { return cosh(x); }, [](double x) { return std::cosh(x); }},
      {"tanh", [](const Interval& x) { return tanh(x); }, [](double x) { return std::tanh(x); }},
      {"abs", [](const Interval& x) { return abs(x); }, [](double x) { return std::abs(x); }},
      {"square", [](const Interval& x) { return square(x); }, [](double x) { return x * x; }},
      {"1 / x", [](const Interval& x) { return Interval(1) / x; }, [](double x) { return 1 / x; }},
      {"x^3", [](const Interval& x) { return pow(x, 3); }, [](double x) { return std::pow(x, 3); }},
      {"x^-2", [](const Interval& x) { return pow(x, -2); }, [](double x) { return std::pow(x, -2); }},
      {"x^2.5", [](const Interval& x) { return pow(x, 2.5); }, [](double x) { return std::pow(x, 2.5); }},
      {"2^x", [](const Interval& x) { return pow(2.0, x); }, [](double x) { return std::pow(2.0, x); }}};
  Random random;
  for (const Function& f : functions) {
    CAPTURE(f.name);
    for (int i = 0; i < 300; ++i) {
      const Interval x = around(random, random.uniform(-4, 4)), range = f.enclosed(x);
      CAPTURE(x.lo, x.hi, range.lo, range.hi);
      for (const double part : {0.0, 1.0, random.uniform(0, 1)}) {
        const double at = std::min(x.hi, x.lo + part * (x.hi - x.lo)), y = f.exact(at);
        if (std::isnan(y))
          CHECK_FALSE(range.is_finite());
        else
          CHECK(range.contains(y));
      }
    }
  }
}

TEST_CASE("intervals are as narrow as rounding lets them be", "[interval]") {
  CHECK(sin(Interval(0, 3)).hi == 1);
  CHECK(sin(Interval(0, 3)).lo == Approx(0).margin(1e-15));
  CHECK(cos(Interval(3, 3.5)).lo == -1);
  CHECK(square(Interval(-2, 1)).lo == 0);
  CHECK((Interval(1) / Interval(3)).width() < 1e-15);
  CHECK((Interval(0) * Interval::all()).width() == 0);
  CHECK_FALSE((Interval(1) / Interval(-1, 1)).is_finite());
  CHECK_FALSE(sqrt(Interval(-1, 1)).is_finite());
  CHECK_FALSE(atan2(Interval(-1, 1), Interval(-2, -1)).is_finite());
}

TEST_CASE("jets of intervals contain all derivatives up to the third", "[interval]") {
  const std::vector<std::string> texts = {
      "exp(-x^2) * sin(3*y) + x*y^3",         "sqrt(1 + x^2 + y^2) / (2 + cos(x - y))",
      "log(3 + x*y) + atan(x + 2*y)",         "tanh(x) * cosh(y) + pow(2 + x, 1.5)",
      "atan2(y + 3, x) + hypot(x, 2 + y)",    "(2 + x)^(1 + y/4) - asin(x/4) * acos(y/4)",
      "sinh(x*y) + tan(x/3) + 1/(4 + x + y)", "x^2 + 2^(x*y)"};
  using First = Dual<double, 2>;
  using Second = Dual<First, 2>;
  using Third = Dual<Second, 2>;
  const auto variable = [](double value, std::size_t k) {
    Third x(value);
    x.value.value.d[k] = 1;
    x.value.d[k].value = 1;
    x.d[k].value.value = 1;
    return x;
  };
  Random random;
  for (const std::string& text : texts) {
    CAPTURE(text);
    const Formula formula(text, {"x", "y"});
    for (int i = 0; i < 40; ++i) {
      const Interval bx = around(random, random.uniform(-0.5, 0.5)), by = around(random, random.uniform(-0.5, 0.5));
      const std::array<IntervalJet<2>, 2> box = {IntervalJet<2>::variable(bx, 0), IntervalJet<2>::variable(by, 1)};
      const IntervalJet<2> jet = formula(std::span<const IntervalJet<2>>(box));
      const std::array<Third, 2> at = {variable(random.uniform(bx.lo, bx.hi), 0),
                                       variable(random.uniform(by.lo, by.hi), 1)};
      const Third exact = formula(std::span<const Third>(at));
      const auto contains = [](const Interval& range, double x) {
        const double room = 1e-11 * (1 + std::abs(x));  // what duals round
        return std::isnan(x) || (range.lo <= x + room && x - room <= range.hi);
      };
      CHECK(contains(jet.value(), exact.value.value.value));
      for (int k = 0; k < 2; ++k) {
        const auto a = static_cast<std::size_t>(k);
        CHECK(contains(jet.d(k), exact.d[a].value.value));
        for (int l = 0; l < 2; ++l) {
          const auto b = static_cast<std::size_t>(l);
          CHECK(contains(jet.d(k, l), exact.d[a].d[b].value));
          for (int m = 0; m < 2; ++m) CHECK(contains(jet.d(k, l, m), exact.d[a].d[b].d[static_cast<std::size_t>(m)]));
        }
      }
    }
  }
}

TEST_CASE("products beyond the largest number have bounds", "[interval]") {
  const Interval huge = Interval(1e200) * Interval(1e150, 1e200), less = Interval(-1e200) * Interval(1e200);
  CHECK((huge.lo <= 1.7e308 && huge.hi > 1.7e308));
  CHECK((less.lo < -1.7e308 && less.hi >= std::numeric_limits<double>::lowest()));
  CHECK_FALSE((std::isnan(huge.lo) || std::isnan(less.hi)));
}

TEST_CASE("at a kink a jet knows the slopes of both sides and nothing more", "[interval]") {
  const Formula formula("abs(x) + max(y, 2*y)", {"x", "y"});
  const std::array<IntervalJet<2>, 2> box = {IntervalJet<2>::variable({-1, 2}, 0), IntervalJet<2>::variable({1, 2}, 1)};
  const IntervalJet<2> jet = formula(std::span<const IntervalJet<2>>(box));
  CHECK(jet.d(0).lo == Approx(-1));
  CHECK(jet.d(0).hi == Approx(1));
  CHECK_FALSE(jet.d(0, 0).is_finite());
  CHECK(jet.d(1).contains(2));
}

}  // namespace leastcost::test
