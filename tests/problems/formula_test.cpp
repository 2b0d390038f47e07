// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/formula/formula.hpp"
#include "problems/formula/coordinate_names.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/support/catch.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

constexpr double kE = std::numbers::e;
const std::vector<std::string> kXY = {"x", "y"};

double value(const std::string& text, double x = 0, double y = 0) {
  const std::array<double, 2> at = {x, y};
  return Formula(text, kXY)(std::span<const double>(at));
}

std::array<Dual<double, 2>, 2> seeded(double x, double y) {
  std::array<Dual<double, 2>, 2> at = {Dual<double, 2>(x), Dual<double, 2>(y)};
  at[0].d[0] = at[1].d[1] = 1;
  return at;
}

/// Position from 1 and message of the error, "" when the formula is accepted.
std::string error(const std::string& text, const std::map<std::string, double>& parameters = {}) {
  try {
    Formula(text, kXY, parameters);
    return "";
  } catch (const FormulaError& e) {
    CHECK(e.position() <= text.size());
    const std::string message = e.what();
    const std::string start = "character " + std::to_string(e.position() + 1) + " of the formula: ";
    CHECK(message.substr(0, start.size()) == start);
    return std::to_string(e.position() + 1) + ": " + message.substr(start.size());
  }
}

}  // namespace

TEST_CASE("formulas: precedence and associativity") {
  CHECK(value("1 + 2 * 3") == 7);
  CHECK(value("(1 + 2) * 3") == 9);
  CHECK(value("7 - 4 - 2") == 1);
  CHECK(value("16 / 4 / 2") == 2);
  CHECK(value("2^3^2") == 512);
  CHECK(value("-2^2") == -4);
  CHECK(value("2^-1") == 0.5);
  CHECK(value("--2 - -3") == 5);
  CHECK(value("2 * -x", 3) == -6);
  CHECK(value(" x ^ 2\t+ y\n", 3, 1) == 10);
  CHECK(value("1e-3 + 2.5E2 + .5 + 3.") == 1e-3 + 253.5 - 0.5 + 0.5);
  CHECK(value("2*e") == 2 * kE);
  CHECK(value("pi") == kPi);
}

TEST_CASE("formulas: values are those of the standard functions, derivatives those of analysis") {
  using F = std::function<double(double, double)>;
  struct Row {
    const char* text;
    F f, fx, fy;
  };
  const std::vector<Row> rows = {
      {"x - y", [](double x, double y) { return x - y; }, [](double, double) { return 1; },
       [](double, double) { return -1; }},
      {"3 - x/4 + y/2", [](double x, double y) { return 3 - x / 4 + y / 2; }, [](double, double) { return -0.25; },
       [](double, double) { return 0.5; }},
      {"x/y", [](double x, double y) { return x / y; }, [](double, double y) { return 1 / y; },
       [](double x, double y) { return -x / (y * y); }},
      {"2/x", [](double x, double) { return 2 / x; }, [](double x, double) { return -2 / (x * x); },
       [](double, double) { return 0; }},
      {"x/3", [](double x, double) { return x / 3; }, [](double, double) { return 1.0 / 3; },
       [](double, double) { return 0; }},
      {"x^3*y", [](double x, double y) { return x * x * x * y; }, [](double x, double y) { return 3 * x * x * y; },
       [](double x, double) { return x * x * x; }},
      {"x^-2", [](double x, double) { return 1 / (x * x); }, [](double x, double) { return -2 / (x * x * x); },
       [](double, double) { return 0; }},
      {"x^1.7", [](double x, double) { return std::pow(x, 1.7); },
       [](double x, double) { return 1.7 * std::pow(x, 0.7); }, [](double, double) { return 0; }},
      {"x^y", [](double x, double y) { return std::pow(x, y); },
       [](double x, double y) { return y * std::pow(x, y - 1); },
       [](double x, double y) { return std::pow(x, y) * std::log(x); }},
      {"pow(2, x)", [](double x, double) { return std::pow(2, x); },
       [](double x, double) { return std::pow(2, x) * std::log(2); }, [](double, double) { return 0; }},
      {"sqrt(x)", [](double x, double) { return std::sqrt(x); }, [](double x, double) { return 0.5 / std::sqrt(x); },
       [](double, double) { return 0; }},
      {"exp(x*y)", [](double x, double y) { return std::exp(x * y); },
       [](double x, double y) { return y * std::exp(x * y); }, [](double x, double y) { return x * std::exp(x * y); }},
      {"log(x)", [](double x, double) { return std::log(x); }, [](double x, double) { return 1 / x; },
       [](double, double) { return 0; }},
      {"sin(x)*cos(y)", [](double x, double y) { return std::sin(x) * std::cos(y); },
       [](double x, double y) { return std::cos(x) * std::cos(y); },
       [](double x, double y) { return -std::sin(x) * std::sin(y); }},
      {"tan(x)", [](double x, double) { return std::tan(x); },
       [](double x, double) { return 1 / (std::cos(x) * std::cos(x)); }, [](double, double) { return 0; }},
      {"asin(x/9) + acos(y/9)", [](double x, double y) { return std::asin(x / 9) + std::acos(y / 9); },
       [](double x, double) { return 1 / std::sqrt(81 - x * x); },
       [](double, double y) { return -1 / std::sqrt(81 - y * y); }},
      {"atan(x)", [](double x, double) { return std::atan(x); }, [](double x, double) { return 1 / (1 + x * x); },
       [](double, double) { return 0; }},
      {"atan2(y, x)", [](double x, double y) { return std::atan2(y, x); },
       [](double x, double y) { return -y / (x * x + y * y); }, [](double x, double y) { return x / (x * x + y * y); }},
      {"sinh(x) - cosh(y)", [](double x, double y) { return std::sinh(x) - std::cosh(y); },
       [](double x, double) { return std::cosh(x); }, [](double, double y) { return -std::sinh(y); }},
      {"tanh(x)", [](double x, double) { return std::tanh(x); },
       [](double x, double) { return 1 - std::tanh(x) * std::tanh(x); }, [](double, double) { return 0; }},
      {"abs(x - 5*y)", [](double x, double y) { return std::abs(x - 5 * y); },
       [](double x, double y) { return x > 5 * y ? 1 : -1; }, [](double x, double y) { return x > 5 * y ? -5 : 5; }},
      {"min(x, y, 1.2) + max(x, y)",
       [](double x, double y) {
         return std::min({x, y, 1.2}) + std::max(x, y);
       },
       [](double x, double y) { return (x < y && x < 1.2 ? 1 : 0) + (x > y ? 1 : 0); },
       [](double x, double y) { return (y < x && y < 1.2 ? 1 : 0) + (y > x ? 1 : 0); }},
      {"hypot(x, y, 2)", [](double x, double y) { return std::sqrt(x * x + y * y + 4); },
       [](double x, double y) { return x / std::sqrt(x * x + y * y + 4); },
       [](double x, double y) { return y / std::sqrt(x * x + y * y + 4); }},
  };
  Random random;
  for (const Row& row : rows) {
    const Formula formula(row.text, kXY);
    for (int i = 0; i < 5; ++i) {
      const double x = random.uniform(0.3, 3), y = random.uniform(0.3, 3);
      CAPTURE(row.text, x, y);
      const auto at = seeded(x, y);
      const Dual<double, 2> f = formula(std::span<const Dual<double, 2>>(at));
      // A handful of operations, each rounded once, on numbers of size up to e^9.
      CHECK(value(row.text, x, y) == Approx(row.f(x, y)).epsilon(1e-14).margin(1e-14));
      CHECK(f.value == Approx(row.f(x, y)).epsilon(1e-14).margin(1e-14));
      CHECK(f.d[0] == Approx(row.fx(x, y)).epsilon(1e-13).margin(1e-13));
      CHECK(f.d[1] == Approx(row.fy(x, y)).epsilon(1e-13).margin(1e-13));
    }
  }
}

TEST_CASE("formulas: Hessians by nested duals") {
  using Inner = Dual<double, 2>;
  using Outer = Dual<Inner, 2>;
  const auto seed = [](double v, std::size_t k) {
    Outer s(v);
    s.value.d[k] = 1;
    s.d[k] = Inner(1.0);
    return s;
  };
  const double x = 0.7, y = -1.3;
  const std::array<Outer, 2> at = {seed(x, 0), seed(y, 1)};
  const Outer f = Formula("x^4 + y^2 + 3*x*y + 3*sin(x)*cos(y) - 1", kXY)(std::span<const Outer>(at));
  CHECK(f.d[0].d[0] == Approx(12 * x * x - 3 * std::sin(x) * std::cos(y)).epsilon(1e-14));
  CHECK(f.d[0].d[1] == Approx(3 - 3 * std::cos(x) * std::sin(y)).epsilon(1e-14));
  CHECK(f.d[1].d[1] == Approx(2 - 3 * std::sin(x) * std::cos(y)).epsilon(1e-14));
  // x^2 at 0, where x^2 = exp(2 log x) would not do.
  const std::array<Outer, 2> zero = {seed(0, 0), seed(0, 1)};
  const Outer square = Formula("x^2 + y^1", kXY)(std::span<const Outer>(zero));
  CHECK((square.d[0].d[0] == 2 && square.d[1].value == 1 && square.d[1].d[1] == 0));
}

TEST_CASE("formulas: parameters, several outputs, what is common is computed once") {
  const Formulas torus({"(R + cos(v)) * cos(u)", "(R + cos(v)) * sin(u)", "sin(v)"}, {"u", "v"}, {{"R", 2}});
  CHECK((torus.inputs() == 2 && torus.outputs() == 3));
  CHECK(torus.steps() == 7);  // four functions, one sum, two products
  const std::array<double, 2> uv = {0.4, 1.1};
  std::array<double, 3> x{};
  torus.evaluate<double>(uv, x);
  CHECK(x ==
        std::array<double, 3>{(2 + std::cos(1.1)) * std::cos(0.4), (2 + std::cos(1.1)) * std::sin(0.4), std::sin(1.1)});
  CHECK(Formulas({"x^8"}, kXY).steps() == 3);
  CHECK(Formulas({"x*y + y*x", "2^10 * sin(pi/2)"}, kXY).steps() == 3);
  const Formulas plain({"y", "x", "7"}, kXY);
  std::array<double, 3> out{};
  plain.evaluate<double>(uv, out);
  CHECK(out == std::array<double, 3>{1.1, 0.4, 7});
}

TEST_CASE("formulas: a random formula keeps its value however it is compiled") {
  // Sums of products of sines, with many values alive at once, against the same sum in C++.
  Random random;
  std::string text = "0";
  double expected = 0;
  const double x = 0.3, y = 0.8;
  for (int i = 0; i < 60; ++i) {
    const int a = random.integer(1, 9), b = random.integer(1, 9);
    text = "(" + text + ") + sin(" + std::to_string(a) + "*x + y) * (cos(y) - sin(" + std::to_string(b) + "*x + y))";
    expected += std::sin(a * x + y) * (std::cos(y) - std::sin(b * x + y));
  }
  CHECK(value(text, x, y) == Approx(expected).epsilon(1e-13).margin(1e-13));
}

TEST_CASE("formulas: errors name the place, what was found and what would be right") {
  struct Row {
    const char* text;
    const char* message;
  };
  for (const Row& row : std::vector<Row>{
           {"", "1: the formula is empty"},
           {"  ", "1: the formula is empty"},
           {"x +", "4: found the end where a number, a name or '(' was expected"},
           {"x + * y", "5: found '*' where a number, a name or '(' was expected"},
           {"2 x", "3: found 'x' where an operator (+ - * / ^) or the end was expected"},
           {"2x", "2: found 'x' right after a number: write a product as 2*x"},
           {"1.2.3", "4: a number can have only one decimal point"},
           {".", "1: found '.', which is not a number"},
           {"1e999", "1: this number does not fit double precision"},
           {"x**2", "2: found '**': write a power as x^y"},
           {"(x + y", "7: the '(' at character 1 is never closed"},
           {"sin(x, y)", "1: sin takes 1 argument, found 2"},
           {"atan2(x)", "1: atan2 takes 2 arguments, found 1"},
           {"max(x)", "1: max takes at least 2 arguments, found 1"},
           {"cos()", "1: cos takes 1 argument, found 0"},
           {"x)", "2: this ')' has no matching '('"},
           {"(x y)", "4: found 'y' where an operator or the ')' for the '(' at character 1 was expected"},
           {"sin x", "1: 'sin' is a function: write sin(..)"},
           {"x(2)", "1: 'x' is not a function; write a product as x*(..)"},
           {"x = 1", "3: found '=': write an equation a = b as a - (b)"},
           {"1 + sine(x)",
            "5: unknown name 'sine' (did you mean 'sin'?); known names are x, y, the parameters radius, pi, e and the "
            "functions"},
           {"radus*x",
            "1: unknown name 'radus' (did you mean 'radius'?); known names are x, y, the parameters radius, pi, e and "
            "the "
            "functions"},
           {"x + 1/0", "6: the value of this constant expression is not finite"},
           {"sqrt(-1)*x", "1: the value of this constant expression is not finite"},
           {"x\xc2\xb2", "2: found '\xc2\xb2' where an operator (+ - * / ^) or the end was expected"}}) {
    CAPTURE(row.text);
    CHECK(error(row.text, {{"radius", 1}}) == row.message);
  }
  CHECK(error(std::string(100000, '(')) != "");
  CHECK(error(std::string(100000, '-').append("x")) != "");
  CHECK_THAT(error([] {
               std::string sum = "x";
               for (int i = 1; i < 5000; ++i) sum += " + sin(" + std::to_string(i) + "*x)";
               return sum;
             }()),
             Catch::Contains("operations; the limit is 4096"));
}

TEST_CASE("formulas: errors of options are at their key") {
  const auto key = [](const std::vector<std::string>& texts, const std::map<std::string, double>& parameters) {
    try {
      formulas_of_option("equations", texts, kXY, parameters);
    } catch (const OptionError& e) {
      return e.key();
    }
    return std::string("accepted");
  };
  CHECK(key({"x"}, {}) == "accepted");
  CHECK(key({"z"}, {}) == "equations");
  CHECK(key({"x", "z"}, {}) == "equations.1");
  CHECK(key({"x"}, {{"sin", 1}}) == "parameters.sin");
  CHECK(key({"x"}, {{"x", 1}}) == "parameters.x");
  CHECK(key({"x"}, {{"2a", 1}}) == "parameters.2a");
  CHECK(key({"x"}, {{"a", std::nan("")}}) == "parameters.a");
  CHECK(coordinate_names(2) == kXY);
  CHECK(coordinate_names(4) == std::vector<std::string>{"x0", "x1", "x2", "x3"});
}

}  // namespace leastcost::test
