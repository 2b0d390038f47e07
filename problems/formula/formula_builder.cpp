// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/formula/formula_builder.hpp"

#include <bit>
#include <cmath>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

constexpr int kUnused = -1;

bool commutes(FormulaOp op) { return op == FormulaOp::add || op == FormulaOp::multiply; }

bool has_two_operands(FormulaOp op) {
  switch (op) {
    case FormulaOp::add:
    case FormulaOp::subtract:
    case FormulaOp::multiply:
    case FormulaOp::divide:
    case FormulaOp::power:
    case FormulaOp::atan2:
    case FormulaOp::hypot:
    case FormulaOp::min:
    case FormulaOp::max: return true;
    default: return false;
  }
}

double evaluated(FormulaOp op, double a, double b) {
  double value = 0;
  detail::apply<double>(op, value, a, b, 0);
  return value;
}

}  // namespace

FormulaBuilder::FormulaBuilder(int inputs) : inputs_(inputs) {
  for (int i = 0; i < inputs; ++i) nodes_.push_back({FormulaOp::variable, i, i, 0});
}

FormulaBuilder::Node FormulaBuilder::add(const Expression& expression) {
  const std::tuple key(expression.op, expression.a, expression.b, std::bit_cast<std::uint64_t>(expression.c));
  const auto [entry, is_new] = known_.try_emplace(key, static_cast<Node>(nodes_.size()));
  if (is_new) nodes_.push_back(expression);
  return entry->second;
}

FormulaBuilder::Node FormulaBuilder::constant(double c) { return add({FormulaOp::constant, 0, 0, c}); }

FormulaBuilder::Node FormulaBuilder::unary(FormulaOp op, Node a) {
  if (is_constant(a)) return constant(evaluated(op, value(a), 0));
  return add({op, a, a, 0});
}

FormulaBuilder::Node FormulaBuilder::whole_power(Node base, int exponent) {
  if (exponent == 1) return base;
  const Node half = whole_power(base, exponent / 2);
  const Node square = binary(FormulaOp::multiply, half, half);
  return exponent % 2 == 0 ? square : binary(FormulaOp::multiply, square, base);
}

FormulaBuilder::Node FormulaBuilder::power(Node base, double exponent) {
  constexpr double kMostMultiplied = 64;
  if (exponent == 0) return constant(1);
  if (exponent < 0) return binary(FormulaOp::divide, constant(1), power(base, -exponent));
  if (exponent == 0.5) return unary(FormulaOp::sqrt, base);
  if (exponent == std::floor(exponent) && exponent <= kMostMultiplied)
    return whole_power(base, static_cast<int>(exponent));
  return add({FormulaOp::power_constant, base, base, exponent});
}

FormulaBuilder::Node FormulaBuilder::binary(FormulaOp op, Node a, Node b) {
  const bool left = is_constant(a), right = is_constant(b);
  if (left && right) return constant(evaluated(op, value(a), value(b)));
  if (left && commutes(op)) return binary(op, b, a);
  const double c = left ? value(a) : right ? value(b) : 0;
  if (right) {
    if (op == FormulaOp::add) return c == 0 ? a : add({FormulaOp::add_constant, a, a, c});
    if (op == FormulaOp::subtract) return c == 0 ? a : add({FormulaOp::add_constant, a, a, -c});
    if (op == FormulaOp::multiply) return c == 1 ? a : add({FormulaOp::times_constant, a, a, c});
    if (op == FormulaOp::divide) return c == 1 ? a : add({FormulaOp::over_constant, a, a, c});
    if (op == FormulaOp::power) return power(a, c);
  }
  if (left) {
    if (op == FormulaOp::subtract) return add({FormulaOp::constant_minus, b, b, c});
    if (op == FormulaOp::divide) return add({FormulaOp::constant_over, b, b, c});
    if (op == FormulaOp::power) return add({FormulaOp::constant_power, b, b, c});
  }
  if (commutes(op) && b < a) std::swap(a, b);
  return add({op, a, b, 0});
}

/// For each node the last one that reads it: nodes_.size() for an output, kUnused for what nothing needs.
std::vector<int> FormulaBuilder::last_uses(const std::vector<Node>& outputs) const {
  std::vector<int> last(nodes_.size(), kUnused);
  for (const Node n : outputs) last[static_cast<std::size_t>(n)] = static_cast<int>(nodes_.size());
  for (int n = static_cast<int>(nodes_.size()) - 1; n >= inputs_; --n) {
    const Expression& e = at(n);
    if (last[static_cast<std::size_t>(n)] == kUnused || e.op == FormulaOp::constant) continue;
    for (const Node operand : {e.a, e.b}) {
      int& use = last[static_cast<std::size_t>(operand)];
      if (use < n) use = n;
    }
  }
  return last;
}

FormulaProgram FormulaBuilder::compile(const std::vector<Node>& outputs) const {
  const std::vector<int> last = last_uses(outputs);
  std::vector<int> reg(nodes_.size(), 0), free;
  int used = inputs_;
  for (int i = 0; i < inputs_; ++i) reg[static_cast<std::size_t>(i)] = i;
  std::vector<FormulaStep> steps;
  const auto of = [&](Node n) { return static_cast<std::uint8_t>(reg[static_cast<std::size_t>(n)]); };
  const auto release = [&](Node operand, Node reader) {
    if (operand >= inputs_ && last[static_cast<std::size_t>(operand)] == reader) free.push_back(of(operand));
  };
  for (Node n = inputs_; n < static_cast<Node>(nodes_.size()); ++n) {
    if (last[static_cast<std::size_t>(n)] == kUnused) continue;
    const Expression& e = at(n);
    const bool reads = e.op != FormulaOp::constant;
    if (free.empty()) free.push_back(used++);
    reg[static_cast<std::size_t>(n)] = free.back();  // before the operands are released: it is none of them
    free.pop_back();
    if (reads) release(e.a, n);
    if (has_two_operands(e.op) && e.b != e.a) release(e.b, n);
    steps.push_back({e.op, of(n), reads ? of(e.a) : std::uint8_t{0}, reads ? of(e.b) : std::uint8_t{0}, e.c});
  }
  if (used > FormulaProgram::kMaxRegisters)
    throw InputError("a formula needs " + std::to_string(used) +
                     " variables and intermediate values at the same time; the limit is " +
                     std::to_string(FormulaProgram::kMaxRegisters));
  if (steps.size() > FormulaProgram::kMaxSteps)
    throw InputError("a formula needs " + std::to_string(steps.size()) + " operations; the limit is " +
                     std::to_string(FormulaProgram::kMaxSteps));
  std::vector<std::uint8_t> where;
  where.reserve(outputs.size());
  for (const Node n : outputs) where.push_back(of(n));
  return {inputs_, std::move(steps), std::move(where)};
}

}  // namespace leastcost
