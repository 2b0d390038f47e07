// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <leastcost/framework/options.hpp>

namespace leastcost::test {

/// Fills the options of any plug-in with numbers and words, past every check that a configuration would make: mostly
/// sensible ones, now and then such as no author thought of.
class RandomFields final : public FieldVisitor {
 public:
  /// `files`: what file options may name. `dimension`: rows that vectors and matrices mostly have. `boldness`: part of
  /// the fields that do not keep their default; `bad`: part of the numbers that no author thought of.
  RandomFields(std::mt19937_64& random, const std::vector<std::string>& files, int dimension, double boldness,
               double bad)
      : random_(random), files_(files), dimension_(dimension), boldness_(boldness), bad_(bad) {}

  using FieldVisitor::field;
  void field(std::string_view key, bool& value, const FieldDoc& doc) override;
  void field(std::string_view key, int& value, const FieldDoc& doc) override;
  void field(std::string_view key, double& value, const FieldDoc& doc) override;
  void field(std::string_view key, std::string& value, const FieldDoc& doc) override;
  void field(std::string_view key, Eigen::VectorXd& value, const FieldDoc& doc) override;
  void field(std::string_view key, Eigen::MatrixXd& value, const FieldDoc& doc) override;
  void field(std::string_view key, std::map<std::string, double>& value, const FieldDoc& doc) override;
  void field(std::string_view key, std::vector<std::string>& value, const FieldDoc& doc) override;
  void file(std::string_view key, std::string& value, const FieldDoc& doc) override;
  void group(std::string_view key, const FieldDoc& doc, const std::function<void(FieldVisitor&)>& body) override;

 protected:
  void optional_field(std::string_view key, bool& given, const std::function<void()>& field) override;
  void choice_of(std::string_view key, std::size_t& chosen, const std::vector<std::string>& choices,
                 const FieldDoc& doc) override;
  void variant_of(std::string_view key, std::optional<std::size_t>& chosen, const std::vector<FieldVariant>& variants,
                  const FieldDoc& doc) override;

 private:
  bool bold(const FieldDoc& doc) { return chance(doc.required ? 0.95 : boldness_); }
  bool chance(double p) { return std::uniform_real_distribution<double>(0, 1)(random_) < p; }
  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
  double number(const FieldDoc& doc);
  Eigen::Index rows() { return chance(1 - bad_) ? dimension_ : static_cast<Eigen::Index>(below(5)); }
  std::string formula();

  std::mt19937_64& random_;
  const std::vector<std::string>& files_;
  int dimension_;
  double boldness_, bad_;
};

}  // namespace leastcost::test
