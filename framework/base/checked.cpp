// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/base/checked.hpp>

#include <cmath>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

/// Visits options that exist already, and changes none of them.
class RangeCheck final : public FieldVisitor {
 public:
  explicit RangeCheck(std::string prefix) : prefix_(std::move(prefix)) {}

  void field(std::string_view, bool&, const FieldDoc&) override {}
  void field(std::string_view key, int& value, const FieldDoc& doc) override { check(key, value, doc); }
  void field(std::string_view key, double& value, const FieldDoc& doc) override { check(key, value, doc); }
  void field(std::string_view, std::string&, const FieldDoc&) override {}
  void field(std::string_view key, Eigen::VectorXd& value, const FieldDoc& doc) override { check_all(key, value, doc); }
  void field(std::string_view key, Eigen::MatrixXd& value, const FieldDoc& doc) override {
    check_all(key, value.reshaped(), doc);
  }
  void field(std::string_view, std::map<std::string, double>&, const FieldDoc&) override {}
  void field(std::string_view, std::vector<std::string>&, const FieldDoc&) override {}
  void switch_or_number(std::string_view key, bool& on, double& number, const FieldDoc& doc) override {
    if (on && number != 0) check(key, number, doc);
  }
  void file(std::string_view, std::string&, const FieldDoc&) override {}
  void group(std::string_view key, const FieldDoc&, const std::function<void(FieldVisitor&)>& body) override {
    RangeCheck inside(path_of(key) + ".");
    body(inside);
  }

 private:
  void optional_field(std::string_view, bool& given, const std::function<void()>& field) override {
    if (given) field();
  }
  void choice_of(std::string_view, std::size_t&, const std::vector<std::string>&, const FieldDoc&) override {}
  void variant_of(std::string_view key, std::optional<std::size_t>& chosen, const std::vector<FieldVariant>& variants,
                  const FieldDoc& doc) override {
    if (chosen && variants[*chosen].fields) group(key, doc, variants[*chosen].fields);
  }

  std::string path_of(std::string_view key) const { return prefix_ + std::string(key); }

  template <class Numbers>
  void check_all(std::string_view key, const Numbers& numbers, const FieldDoc& doc) const {
    for (const double number : numbers) check(key, number, doc);
  }

  /// NaN is in no range.
  void check(std::string_view key, double value, const FieldDoc& doc) const {
    const bool low = doc.exclusive_minimum ? !(value > doc.minimum) : !(value >= doc.minimum);
    if (!low && value <= doc.maximum) return;
    const bool bounded = std::isfinite(doc.minimum);
    if (!bounded && !std::isfinite(doc.maximum) && !std::isnan(value)) return;
    std::string range =
        bounded ? (doc.exclusive_minimum ? "greater than " : "at least ") + short_number(doc.minimum, 6) : "";
    if (std::isfinite(doc.maximum)) range += (bounded ? " and at most " : "at most ") + short_number(doc.maximum, 6);
    throw OptionError(path_of(key),
                      "must be " + (range.empty() ? "a number" : range) + ", not " + short_number(value, 6));
  }

  std::string prefix_;
};

}  // namespace

void check_ranges(const std::function<void(FieldVisitor&)>& fields, const std::string& key) {
  RangeCheck check(key.empty() ? "" : key + ".");
  fields(check);
}

}  // namespace leastcost
