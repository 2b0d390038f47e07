// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/formula/formula.hpp"

#include <algorithm>
#include <cmath>

#include "problems/formula/formula_parser.hpp"

namespace leastcost {
namespace {

void check_parameters(const FormulaNames& names) {
  for (const auto& [name, value] : names.parameters) {
    const std::string key = "parameters." + name;
    if (!is_formula_name(name))
      throw OptionError(
          key, "the name of a parameter must have letters, digits and _ only, and must not begin with a digit");
    if (is_formula_word(name)) throw OptionError(key, "'" + name + "' is already a function or constant of formulas");
    if (std::count(names.variables.begin(), names.variables.end(), name) > 0)
      throw OptionError(key, "'" + name + "' is already a variable of the formula");
    if (!std::isfinite(value)) throw OptionError(key, "a parameter must be finite");
  }
}

FormulaProgram compiled(const std::vector<std::string>& texts, const FormulaNames& names) {
  check_parameters(names);
  FormulaBuilder builder(static_cast<int>(names.variables.size()));
  std::vector<FormulaBuilder::Node> outputs;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    try {
      outputs.push_back(parse_formula(texts[i], names, builder));
    } catch (const FormulaFault& fault) {
      throw FormulaError(i, fault.position, fault.what());
    }
  }
  try {
    return builder.compile(outputs);
  } catch (const InputError& error) {
    throw FormulaError(0, 0, error.what());
  }
}

}  // namespace

FormulaError::FormulaError(std::size_t formula, std::size_t position, const std::string& message)
    : Error("character " + std::to_string(position + 1) + " of the formula: " + message),
      formula_(formula),
      position_(position) {}

Formulas::Formulas(const std::vector<std::string>& texts, const std::vector<std::string>& variables,
                   const std::map<std::string, double>& parameters)
    : program_(compiled(texts, {variables, parameters})) {}

Formulas formulas_of_option(const std::string& key, const std::vector<std::string>& texts,
                            const std::vector<std::string>& variables,
                            const std::map<std::string, double>& parameters) {
  try {
    return {texts, variables, parameters};
  } catch (const FormulaError& error) {
    throw OptionError(texts.size() == 1 ? key : key + "." + std::to_string(error.formula()), error.what());
  }
}

}  // namespace leastcost
