// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/plugins/run_visitor.hpp"
#include "catalogue/yaml/config_node.hpp"

namespace leastcost {

/// What a file of the configuration is called in the written one.
using RenameFile = std::function<std::string(const std::string&)>;

/// Writes the fields of an options object as a block, defaults included, so that it reads back as the same object.
/// Fields without a value are left out.
class OptionsWriter final : public RunVisitor {
 public:
  explicit OptionsWriter(RenameFile rename = {}) : rename_(std::move(rename)) { block_.kind = ConfigNode::Kind::block; }
  ConfigNode take() { return std::move(block_); }

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

  void points(std::string_view key, std::optional<int>& value, const FieldDoc& doc) override;
  void end(std::string_view key, std::optional<EndOptions>& value, const FieldDoc& doc) override;
  void plugin(std::string_view key, PluginChoice& value, std::string_view kind, const FieldDoc& doc) override;
  void plugins(std::string_view key, std::optional<PluginList>& value, std::string_view kind,
               const FieldDoc& doc) override;
  void block(std::string_view key, const FieldDoc& doc, const std::function<void(RunVisitor&)>& body) override;
  void blocks(std::string_view key, const BlockList& list, const FieldDoc& doc) override;
  void tree(std::string_view key, ConfigNode& value, TreeForm form, const PluginKind* kind,
            const FieldDoc& doc) override;

 protected:
  void optional_field(std::string_view key, bool& given, const std::function<void()>& field) override;
  void choice_of(std::string_view key, std::size_t& chosen, const std::vector<std::string>& choices,
                 const FieldDoc& doc) override;
  void variant_of(std::string_view key, std::optional<std::size_t>& chosen, const std::vector<FieldVariant>& variants,
                  const FieldDoc& doc) override;

 private:
  void add(std::string_view key, ConfigNode value);
  ConfigNode written(const PluginChoice& choice) const;

  RenameFile rename_;
  ConfigNode block_;
};

}  // namespace leastcost
