// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "catalogue/plugins/run_visitor.hpp"

namespace leastcost::test {

/// Fills the options of any plug-in with numbers and words, past every check that a configuration would make: mostly
/// sensible ones, now and then such as no author thought of.
class RandomFields final : public RunVisitor {
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
  void switch_or_number(std::string_view key, bool& on, double& number, const FieldDoc& doc) override;
  void file(std::string_view key, std::string& value, const FieldDoc& doc) override;
  void group(std::string_view key, const FieldDoc& doc, const std::function<void(FieldVisitor&)>& body) override;

  /// One of those that need no files; of costs within costs mostly the first.
  void plugin(std::string_view key, PluginChoice& value, std::string_view kind, const FieldDoc& doc) override;
  void blocks(std::string_view key, const BlockList& list, const FieldDoc& doc) override;
  void block(std::string_view key, const FieldDoc& doc, const std::function<void(RunVisitor&)>& body) override;
  // What only a whole run has keeps its default.
  void points(std::string_view, std::optional<int>&, const FieldDoc&) override {}
  void end(std::string_view, std::optional<EndOptions>&, const FieldDoc&) override {}
  void plugins(std::string_view, std::optional<PluginList>&, std::string_view, const FieldDoc&) override {}
  void tree(std::string_view, ConfigNode&, TreeForm, const PluginKind*, const FieldDoc&) override {}

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
