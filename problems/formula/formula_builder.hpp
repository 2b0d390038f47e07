// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "problems/formula/formula_program.hpp"

namespace leastcost {

/// Grows the expression graph of formulas and compiles it. Equal nodes exist once; operations on constants are carried
/// out.
class FormulaBuilder {
 public:
  using Node = int;

  explicit FormulaBuilder(int inputs);
  Node variable(int index) const { return index; }
  Node constant(double c);
  Node unary(FormulaOp op, Node a);
  Node binary(FormulaOp op, Node a, Node b);

  bool is_constant(Node n) const { return at(n).op == FormulaOp::constant; }
  double value(Node n) const { return at(n).c; }

  /// Throws InputError when the formulas are too large: kMaxSteps, kMaxRegisters.
  FormulaProgram compile(const std::vector<Node>& outputs) const;

 private:
  struct Expression {
    FormulaOp op;
    Node a = 0, b = 0;
    double c = 0;
  };

  const Expression& at(Node n) const { return nodes_[static_cast<std::size_t>(n)]; }
  Node add(const Expression& expression);
  Node power(Node base, double exponent);
  Node whole_power(Node base, int exponent);
  std::vector<int> last_uses(const std::vector<Node>& outputs) const;

  int inputs_;
  std::vector<Expression> nodes_;  ///< operands before what uses them; the variables first
  std::map<std::tuple<FormulaOp, Node, Node, std::uint64_t>, Node> known_;
};

}  // namespace leastcost
