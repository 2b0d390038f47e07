// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/formula/formula_parser.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>
#include "problems/formula/edit_distance.hpp"

namespace leastcost {
namespace {

using Node = FormulaBuilder::Node;

struct Function {
  std::string_view name;
  FormulaOp op;
  int least, most;  ///< arguments; most 0: any number, taken from the left
};

constexpr std::array<Function, 18> kFunctions = {{{"sqrt", FormulaOp::sqrt, 1, 1},
                                                  {"exp", FormulaOp::exp, 1, 1},
                                                  {"log", FormulaOp::log, 1, 1},
                                                  {"sin", FormulaOp::sin, 1, 1},
                                                  {"cos", FormulaOp::cos, 1, 1},
                                                  {"tan", FormulaOp::tan, 1, 1},
                                                  {"asin", FormulaOp::asin, 1, 1},
                                                  {"acos", FormulaOp::acos, 1, 1},
                                                  {"atan", FormulaOp::atan, 1, 1},
                                                  {"sinh", FormulaOp::sinh, 1, 1},
                                                  {"cosh", FormulaOp::cosh, 1, 1},
                                                  {"tanh", FormulaOp::tanh, 1, 1},
                                                  {"abs", FormulaOp::abs, 1, 1},
                                                  {"atan2", FormulaOp::atan2, 2, 2},
                                                  {"pow", FormulaOp::power, 2, 2},
                                                  {"hypot", FormulaOp::hypot, 2, 0},
                                                  {"min", FormulaOp::min, 2, 0},
                                                  {"max", FormulaOp::max, 2, 0}}};

const Function* find_function(std::string_view name) {
  const auto* const it =
      std::find_if(kFunctions.begin(), kFunctions.end(), [&](const Function& f) { return f.name == name; });
  return it == kFunctions.end() ? nullptr : &*it;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

std::string in_quotes(std::string_view word) { return std::string("'").append(word).append("'"); }

std::string listed(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all;
}

/// Recursive descent: sum > product > sign > power > primary.
class Parser {
 public:
  Parser(std::string_view text, const FormulaNames& names, FormulaBuilder& builder)
      : text_(text), names_(names), builder_(builder) {}

  Node whole() {
    skip_space();
    if (at_end()) fail(0, "the formula is empty");
    const Node node = sum();
    if (at_end()) return node;
    if (text_[at_] == ')') fail(at_, "this ')' has no matching '('");
    if (text_[at_] == '=') fail(at_, "found '=': write an equation a = b as a - (b)");
    fail(at_, "found " + found() + " where an operator (+ - * / ^) or the end was expected");
  }

 private:
  [[noreturn]] static void fail(std::size_t position, const std::string& message) {
    throw FormulaFault(position, message);
  }

  bool at_end() const { return at_ >= text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[at_]; }
  void skip_space() {
    while (!at_end() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r')) ++at_;
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    skip_space();
    return true;
  }

  /// The word, number or character (all bytes of it) at the current place, in quotes.
  std::string found() const {
    if (at_end()) return "the end";
    std::size_t end = at_ + 1;
    const auto part_of_word = [](char c) { return is_letter(c) || is_digit(c); };
    if (part_of_word(text_[at_]))
      while (end < text_.size() && part_of_word(text_[end])) ++end;
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xc0) == 0x80) ++end;
    return in_quotes(text_.substr(at_, end - at_));
  }

  /// A constant that is not finite is a mistake in the formula, not a property of a point.
  Node checked(Node node, std::size_t position) const {
    if (builder_.is_constant(node) && !std::isfinite(builder_.value(node)))
      fail(position, "the value of this constant expression is not finite");
    return node;
  }
  Node apply(FormulaOp op, Node a, Node b, std::size_t position) const {
    return checked(builder_.binary(op, a, b), position);
  }

  Node sum() {
    Node node = product();
    for (;;) {
      const std::size_t here = at_;
      if (take('+'))
        node = apply(FormulaOp::add, node, product(), here);
      else if (take('-'))
        node = apply(FormulaOp::subtract, node, product(), here);
      else
        return node;
    }
  }

  Node product() {
    Node node = sign();
    for (;;) {
      const std::size_t here = at_;
      if (peek() == '*' && text_.substr(at_, 2) == "**") fail(at_, "found '**': write a power as x^y");
      if (take('*'))
        node = apply(FormulaOp::multiply, node, sign(), here);
      else if (take('/'))
        node = apply(FormulaOp::divide, node, sign(), here);
      else
        return node;
    }
  }

  Node sign() {
    constexpr int kDeepest = 200;  // the descent is recursive
    const std::size_t here = at_;
    if (++depth_ > kDeepest)
      fail(at_, "parentheses, signs and powers are nested more than " + std::to_string(kDeepest) + " deep");
    Node node = 0;
    if (take('-'))
      node = checked(builder_.unary(FormulaOp::negate, sign()), here);
    else if (take('+'))
      node = sign();
    else
      node = power();
    --depth_;
    return node;
  }

  Node power() {
    const Node base = primary();
    const std::size_t here = at_;
    return take('^') ? apply(FormulaOp::power, base, sign(), here) : base;
  }

  Node primary() {
    const std::size_t here = at_;
    if (take('(')) {
      const Node node = sum();
      close(here);
      return node;
    }
    if (is_digit(peek()) || peek() == '.') return number();
    if (is_letter(peek())) return name();
    fail(at_, "found " + found() + " where a number, a name or '(' was expected");
  }

  void close(std::size_t opened) {
    if (take(')')) return;
    const std::string open = "the '(' at character " + std::to_string(opened + 1);
    if (at_end()) fail(at_, open + " is never closed");
    fail(at_, "found " + found() + " where an operator or the ')' for " + open + " was expected");
  }

  Node number() {
    double value = 0;
    const char* const begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error == std::errc::invalid_argument) fail(at_, "found " + found() + ", which is not a number");
    if (error != std::errc() || !std::isfinite(value)) fail(at_, "this number does not fit double precision");
    at_ += static_cast<std::size_t>(end - begin);
    const std::string digits(begin, end);
    if (peek() == '.') fail(at_, "a number can have only one decimal point");
    if (is_letter(peek()))
      fail(at_, "found " + found() + " right after a number: write a product as " + digits + "*" +
                    found().substr(1, found().size() - 2));
    skip_space();
    return builder_.constant(value);
  }

  Node name() {
    const std::size_t begin = at_;
    while (!at_end() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
    const std::string word(text_.substr(begin, at_ - begin));
    skip_space();
    if (const Function* function = find_function(word)) return call(*function, begin);
    const auto variable = std::find(names_.variables.begin(), names_.variables.end(), word);
    const auto parameter = names_.parameters.find(word);
    Node node = 0;
    if (variable != names_.variables.end())
      node = builder_.variable(static_cast<int>(variable - names_.variables.begin()));
    else if (parameter != names_.parameters.end())
      node = builder_.constant(parameter->second);
    else if (word == "pi")
      node = builder_.constant(std::numbers::pi);
    else if (word == "e")
      node = builder_.constant(std::numbers::e);
    else
      unknown(word, begin);
    if (peek() == '(') fail(begin, "'" + word + "' is not a function; write a product as " + word + "*(..)");
    return node;
  }

  Node call(const Function& function, std::size_t begin) {
    const std::string name(function.name);
    const std::size_t opened = at_;
    if (!take('(')) fail(begin, "'" + name + "' is a function: write " + name + "(..)");
    std::vector<Node> arguments;
    if (peek() != ')') arguments.push_back(sum());
    while (take(',')) arguments.push_back(sum());
    close(opened);
    const int count = static_cast<int>(arguments.size());
    if (count < function.least || (function.most > 0 && count > function.most))
      fail(begin, name + " takes " + (function.most == 0 ? "at least " : "") + std::to_string(function.least) +
                      (function.least == 1 ? " argument" : " arguments") + ", found " + std::to_string(count));
    if (function.least == 1) return checked(builder_.unary(function.op, arguments[0]), begin);
    Node node = arguments[0];
    for (std::size_t i = 1; i < arguments.size(); ++i) node = apply(function.op, node, arguments[i], begin);
    return node;
  }

  [[noreturn]] void unknown(const std::string& word, std::size_t position) const {
    std::vector<std::string> candidates = names_.variables, parameters;
    for (const auto& [parameter, value] : names_.parameters) parameters.push_back(parameter);
    candidates.insert(candidates.end(), parameters.begin(), parameters.end());
    for (const Function& function : kFunctions) candidates.emplace_back(function.name);
    constexpr std::size_t kLongest = 60;
    std::string hint;
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
      const std::size_t distance = word.size() > kLongest ? least : edit_distance(word, candidate);
      if (distance >= least || candidate.size() == 1) continue;
      least = distance;
      hint = " (did you mean '" + candidate + "'?)";
    }
    std::string known = "; known names are " + listed(names_.variables);
    if (!parameters.empty()) known += ", the parameters " + listed(parameters);
    fail(position, "unknown name '" + word + "'" + hint + known + ", pi, e and the functions");
  }

  std::string_view text_;
  const FormulaNames& names_;
  FormulaBuilder& builder_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

FormulaBuilder::Node parse_formula(std::string_view text, const FormulaNames& names, FormulaBuilder& builder) {
  return Parser(text, names, builder).whole();
}

bool is_formula_name(std::string_view name) {
  return !name.empty() && is_letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

bool is_formula_word(std::string_view name) { return name == "pi" || name == "e" || find_function(name) != nullptr; }

}  // namespace leastcost
