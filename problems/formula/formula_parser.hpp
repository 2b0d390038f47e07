// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "problems/formula/formula_builder.hpp"

namespace leastcost {

/// What names in a formula mean.
struct FormulaNames {
  std::vector<std::string> variables;
  std::map<std::string, double> parameters;
};

/// A formula stops making sense at a character. Formulas turns it into a FormulaError.
class FormulaFault : public std::runtime_error {
 public:
  FormulaFault(std::size_t where, const std::string& message) : std::runtime_error(message), position(where) {}
  std::size_t position;
};

/// Adds a formula to the graph; its node. Throws FormulaFault.
FormulaBuilder::Node parse_formula(std::string_view text, const FormulaNames& names, FormulaBuilder& builder);

/// Whether a formula can use it as a name: letters, digits and _, not a digit first.
bool is_formula_name(std::string_view name);
/// A function or constant of the language.
bool is_formula_word(std::string_view name);

}  // namespace leastcost
