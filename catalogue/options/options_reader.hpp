// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/catalogue/plugins/externals.hpp>
#include "catalogue/plugins/run_visitor.hpp"
#include "catalogue/yaml/config_node.hpp"

namespace leastcost {

/// Reads the fields of one options object from a block of the configuration, with every check that the field list
/// allows:
///
///     OptionsReader reader(block, "solver", place, errors);
///     options.fields(reader);
///     reader.finish();         // unknown keys
///
/// A field that is absent or wrong keeps its default; what is wrong goes to `errors`.
class OptionsReader final : public RunVisitor {
 public:
  /// `block`: a block, or a node of another kind, which is one error. `name`: its key, empty for the whole
  /// configuration. `place`: where missing keys are reported. `externals`: what {type: external}
  /// can name; null: nothing.
  OptionsReader(const ConfigNode& block, std::string name, const Place& place, Diagnostics& errors,
                const Externals* externals = nullptr);

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

  /// Reports the keys that no field asked for.
  void finish();

 protected:
  void optional_field(std::string_view key, bool& given, const std::function<void()>& field) override;
  void choice_of(std::string_view key, std::size_t& chosen, const std::vector<std::string>& choices,
                 const FieldDoc& doc) override;
  void variant_of(std::string_view key, std::optional<std::size_t>& chosen, const std::vector<FieldVariant>& variants,
                  const FieldDoc& doc) override;

 private:
  const ConfigEntry* entry(std::string_view key, const FieldDoc& doc);
  void fault(std::string_view key, const Place& place, const std::string& message);
  bool check_form(std::string_view key, const ConfigNode& node, TreeForm form);
  void check_range(std::string_view key, const ConfigNode& node, double value, const FieldDoc& doc);
  bool read_numbers(std::string_view key, const ConfigNode& list, bool infinite, std::vector<double>& out);
  std::optional<std::size_t> find_variant(const ConfigEntry& e, const std::string& path,
                                          const std::vector<FieldVariant>& variants);
  PluginChoice read_plugin(const ConfigNode& node, const Place& place, const std::string& path, const PluginKind& kind);
  const PluginEntry* find_type(const ConfigNode& node, const Place& place, const std::string& path,
                               const PluginKind& kind);
  PluginChoice find_external(const ConfigNode& node, const PluginChoice& asked, const PluginKind& kind);
  std::string inside() const { return name_.empty() ? "" : " in " + shown_path(name_); }
  std::string path(std::string_view key) const {
    return name_.empty() ? std::string(key) : name_ + "." + std::string(key);
  }

  const ConfigNode& block_;
  std::string name_;
  Place place_;
  Diagnostics& errors_;
  const Externals* externals_;
  std::vector<std::string> known_;
};

}  // namespace leastcost
