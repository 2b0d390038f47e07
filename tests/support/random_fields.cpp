// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "tests/support/random_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "catalogue/registry/registry.hpp"

namespace leastcost::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array kBadNumbers = {0.0,     -0.0,      -1.0,       1e-300,
                                    -1e-300, 1e-9,      1e100,      1e300,
                                    -1e300,  kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()};
// No large ones: a count of 1e9 asks for all memory, which is no question of contracts.
constexpr std::array kBadCounts = {0, -1, 1, 2, 3, -1000000};
constexpr std::array kFormulas = {"x",
                                  "y",
                                  "1",
                                  "0",
                                  "1/0",
                                  "sqrt(-1)",
                                  "x^2 + y^2 + z^2 - 1",
                                  "x^2 + y^2 - 1",
                                  "x*y - z",
                                  "x^2 - y^2 + z",
                                  "exp(1000*x)",
                                  "1/x",
                                  "abs(x) - 1",
                                  "min(x, y)",
                                  "log(x)",
                                  "x^0.5",
                                  "1 + x^2",
                                  "sin(u)*cos(v)",
                                  "u",
                                  "v",
                                  "u*v",
                                  "cos(u)",
                                  "",
                                  "x +",
                                  "q",
                                  "((((x))))",
                                  "1e400",
                                  "x1^2 + x2^2 - 1",
                                  "sqrt(vx^2 + vy^2)",
                                  "sqrt(vx^2 + vy^2) + 0.5*vx*sin(y)",
                                  "sqrt(vx^2 + vy^2 + vz^2) * (2 + sin(x))"};

}  // namespace

double RandomFields::number(const FieldDoc& doc) {
  if (chance(bad_)) return kBadNumbers[below(kBadNumbers.size())];
  const double low = std::max(doc.minimum, -3.0), high = std::min(doc.maximum, std::max(low, 0.0) + 3.0);
  return std::uniform_real_distribution<double>(std::min(low, high), std::max(low, high))(random_);
}

std::string RandomFields::formula() { return kFormulas[below(kFormulas.size())]; }

void RandomFields::field(std::string_view, bool& value, const FieldDoc& doc) {
  if (bold(doc)) value = chance(0.5);
}

void RandomFields::field(std::string_view, int& value, const FieldDoc& doc) {
  if (!bold(doc)) return;
  const int low = doc.minimum > -100 ? static_cast<int>(doc.minimum) : -3;
  const int high = doc.maximum < low + 20.0 ? static_cast<int>(doc.maximum) : low + 20;
  value = chance(bad_) ? kBadCounts[below(kBadCounts.size())] : std::uniform_int_distribution<int>(low, high)(random_);
}

void RandomFields::field(std::string_view, double& value, const FieldDoc& doc) {
  if (bold(doc)) value = number(doc);
}

void RandomFields::switch_or_number(std::string_view, bool& on, double& value, const FieldDoc& doc) {
  if (!bold(doc)) return;
  on = chance(0.5);
  value = on && chance(0.5) ? number(doc) : 0;
}

void RandomFields::field(std::string_view, std::string& value, const FieldDoc& doc) {
  if (bold(doc)) value = formula();
}

void RandomFields::field(std::string_view, Eigen::VectorXd& value, const FieldDoc& doc) {
  if (!bold(doc)) return;
  value.resize(rows());
  for (double& x : value) x = number(doc);
}

void RandomFields::field(std::string_view, Eigen::MatrixXd& value, const FieldDoc& doc) {
  if (!bold(doc)) return;
  const Eigen::Index count = rows();
  value.resize(count, chance(1 - bad_) ? count : rows());
  for (double& x : value.reshaped()) x = number(doc);
  if (count == value.cols() && chance(1 - bad_)) value = (value * value.transpose()).eval();  // a metric, perhaps
}

void RandomFields::field(std::string_view, std::map<std::string, double>& value, const FieldDoc& doc) {
  if (bold(doc)) value = {{chance(0.5) ? "a" : "x", number(doc)}};
}

void RandomFields::field(std::string_view, std::vector<std::string>& value, const FieldDoc& doc) {
  if (!bold(doc)) return;
  value.resize(1 + below(6));
  for (std::string& text : value) text = formula();
}

void RandomFields::file(std::string_view, std::string& value, const FieldDoc& doc) {
  if (bold(doc) && !files_.empty()) value = files_[below(files_.size())];
}

void RandomFields::group(std::string_view, const FieldDoc&, const std::function<void(FieldVisitor&)>& body) {
  body(*this);
}

void RandomFields::plugin(std::string_view key, PluginChoice& value, std::string_view kind_name, const FieldDoc&) {
  if (chance(bad_)) return;  // not given
  const PluginKind& kind = leastcost::kind(kind_name);
  const PluginEntry* entry = kind.entries[chance(0.6) ? 0 : below(kind.entries.size())];
  if (!entry->missing.empty()) entry = kind.entries[0];
  value = choose(*entry, std::string(key));
  value.options->fields(*this);
}

void RandomFields::blocks(std::string_view, const BlockList& list, const FieldDoc&) {
  list.resize(chance(1 - bad_) ? 1 + below(2) : below(3));
  for (std::size_t i = 0; i < list.size(); ++i) list.fields(i, *this);
}

void RandomFields::block(std::string_view, const FieldDoc&, const std::function<void(RunVisitor&)>& body) {
  body(*this);
}

void RandomFields::optional_field(std::string_view, bool& given, const std::function<void()>& field) {
  if (chance(boldness_)) given = chance(0.7);
  if (given) field();
}

void RandomFields::choice_of(std::string_view, std::size_t& chosen, const std::vector<std::string>& choices,
                             const FieldDoc& doc) {
  if (bold(doc)) chosen = below(choices.size());
}

void RandomFields::variant_of(std::string_view, std::optional<std::size_t>& chosen,
                              const std::vector<FieldVariant>& variants, const FieldDoc& doc) {
  if (bold(doc)) chosen = below(variants.size());
  if (chosen && variants[*chosen].fields) variants[*chosen].fields(*this);
}

}  // namespace leastcost::test
