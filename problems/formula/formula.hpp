// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "problems/formula/formula_program.hpp"

namespace leastcost {

/// A formula cannot be read. what() names the place, what was found there and what would be right.
class FormulaError : public Error {
 public:
  FormulaError(std::size_t formula, std::size_t position, const std::string& message);
  std::size_t formula() const { return formula_; }    ///< which of several formulas, from 0
  std::size_t position() const { return position_; }  ///< of the character that cannot stand there, from 0

 private:
  std::size_t formula_, position_;
};

/// Several formulas of the same variables, a function R^n -> R^m with exact derivatives by dual numbers:
///
///     const Formulas torus({"(R + cos(v)) * cos(u)", "(R + cos(v)) * sin(u)", "sin(v)"}, {"u", "v"}, {{"R", 2}});
///     std::array<Dual<double, 2>, 2> uv = ...;
///     std::array<Dual<double, 2>, 3> x;
///     torus.evaluate<Dual<double, 2>>(uv, x);
///
/// What they can say: + - * / ^ (x^y^z is x^(y^z), -x^2 is -(x^2)), parentheses, decimal numbers, pi, e, the variables
/// and parameters, and sqrt exp log sin cos tan asin acos atan sinh cosh tanh abs atan2(y, x) pow(x, y), and min, max,
/// hypot of two or more numbers. Compiled once to a flat program, with constants folded and common parts (also of
/// different formulas) computed once. Outside the domain of a function (log(-1)) the value is NaN or infinite, as in
/// C++. Immutable.
class Formulas {
 public:
  /// Throws FormulaError, and OptionError with the key "parameters.NAME" for a parameter whose name or value cannot be
  /// used.
  Formulas(const std::vector<std::string>& texts, const std::vector<std::string>& variables,
           const std::map<std::string, double>& parameters = {});

  int inputs() const { return program_.inputs(); }    ///< n
  int outputs() const { return program_.outputs(); }  ///< m
  std::size_t steps() const { return program_.steps(); }

  /// S: double, Dual<double, N>, Dual<Dual<double, N>, N>, ... No heap.
  template <class S>
  void evaluate(std::span<const S> variables, std::span<S> values) const {
    program_.run<S>(variables, values);
  }

 private:
  FormulaProgram program_;
};

/// One formula: see Formulas.
class Formula {
 public:
  Formula(std::string_view text, const std::vector<std::string>& variables,
          const std::map<std::string, double>& parameters = {})
      : formulas_({std::string(text)}, variables, parameters) {}
  /// The only one of them.
  explicit Formula(Formulas formulas) : formulas_(std::move(formulas)) {}

  template <class S>
  S operator()(std::span<const S> variables) const {
    S value;
    formulas_.evaluate<S>(variables, std::span<S>(&value, 1));
    return value;
  }

 private:
  Formulas formulas_;
};

/// Formulas that an option holds: a FormulaError becomes an OptionError of `key`, or of "key.i" where there are
/// several.
Formulas formulas_of_option(const std::string& key, const std::vector<std::string>& texts,
                            const std::vector<std::string>& variables,
                            const std::map<std::string, double>& parameters = {});

}  // namespace leastcost
