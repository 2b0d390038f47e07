// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/options/options_writer.hpp"

#include "catalogue/yaml/scalars.hpp"
#include "catalogue/yaml/yaml_writer.hpp"

namespace leastcost {
namespace {

ConfigNode number_node(double value) { return scalar_node(number_text(value)); }

template <class Row>
ConfigNode list_node(const Row& row) {
  ConfigNode list;
  list.kind = ConfigNode::Kind::list;
  for (Eigen::Index i = 0; i < row.size(); ++i) list.items.push_back(number_node(row[i]));
  return list;
}

}  // namespace

void OptionsWriter::add(std::string_view key, ConfigNode value) {
  block_.entries.push_back({std::string(key), {}, std::move(value)});
}

void OptionsWriter::field(std::string_view key, bool& value, const FieldDoc&) {
  add(key, scalar_node(value ? "true" : "false"));
}

void OptionsWriter::field(std::string_view key, int& value, const FieldDoc&) {
  add(key, scalar_node(std::to_string(value)));
}

void OptionsWriter::field(std::string_view key, double& value, const FieldDoc&) { add(key, number_node(value)); }

void OptionsWriter::field(std::string_view key, std::string& value, const FieldDoc&) {
  if (!value.empty()) add(key, text_node(value));
}

void OptionsWriter::field(std::string_view key, Eigen::VectorXd& value, const FieldDoc&) {
  if (value.size() > 0) add(key, list_node(value));
}

void OptionsWriter::field(std::string_view key, Eigen::MatrixXd& value, const FieldDoc&) {
  if (value.size() == 0) return;
  ConfigNode rows;
  rows.kind = ConfigNode::Kind::list;
  for (Eigen::Index i = 0; i < value.rows(); ++i) rows.items.push_back(list_node(value.row(i)));
  add(key, std::move(rows));
}

void OptionsWriter::field(std::string_view key, std::map<std::string, double>& value, const FieldDoc&) {
  if (value.empty()) return;
  ConfigNode named;
  named.kind = ConfigNode::Kind::block;
  for (const auto& [name, number] : value) named.entries.push_back({name, {}, number_node(number)});
  add(key, std::move(named));
}

void OptionsWriter::field(std::string_view key, std::vector<std::string>& value, const FieldDoc&) {
  if (value.empty()) return;
  ConfigNode list;
  list.kind = ConfigNode::Kind::list;
  for (const std::string& text : value) list.items.push_back(text_node(text));
  add(key, std::move(list));
}

void OptionsWriter::switch_or_number(std::string_view key, bool& on, double& number, const FieldDoc&) {
  add(key, on && number != 0 ? number_node(number) : scalar_node(on ? "true" : "false"));
}

void OptionsWriter::optional_field(std::string_view, bool& given, const std::function<void()>& field) {
  if (given) field();
}

void OptionsWriter::choice_of(std::string_view key, std::size_t& chosen, const std::vector<std::string>& choices,
                              const FieldDoc&) {
  add(key, text_node(choices[chosen]));
}

void OptionsWriter::file(std::string_view key, std::string& value, const FieldDoc&) {
  if (!value.empty()) add(key, text_node(rename_ ? rename_(value) : value));
}

void OptionsWriter::group(std::string_view key, const FieldDoc& doc, const std::function<void(FieldVisitor&)>& body) {
  block(key, doc, body);
}

void OptionsWriter::variant_of(std::string_view key, std::optional<std::size_t>& chosen,
                               const std::vector<FieldVariant>& variants, const FieldDoc&) {
  if (!chosen) return;
  const FieldVariant& form = variants[*chosen];
  OptionsWriter inner(rename_);
  inner.add("type", text_node(form.type));
  if (form.fields) form.fields(inner);
  add(key, inner.take());
}

void OptionsWriter::block(std::string_view key, const FieldDoc&, const std::function<void(RunVisitor&)>& body) {
  OptionsWriter inner(rename_);
  body(inner);
  ConfigNode node = inner.take();
  if (!node.entries.empty()) add(key, std::move(node));
}

void OptionsWriter::blocks(std::string_view key, const BlockList& list, const FieldDoc&) {
  ConfigNode node;
  node.kind = ConfigNode::Kind::list;
  for (std::size_t i = 0; i < list.size(); ++i) {
    OptionsWriter inner(rename_);
    list.fields(i, inner);
    node.items.push_back(inner.take());
  }
  if (!node.items.empty()) add(key, std::move(node));
}

void OptionsWriter::tree(std::string_view key, ConfigNode& value, TreeForm, const PluginKind*, const FieldDoc&) {
  if (value.kind != ConfigNode::Kind::nothing) add(key, value);
}

void OptionsWriter::points(std::string_view key, std::optional<int>& value, const FieldDoc&) {
  add(key, scalar_node(value ? std::to_string(*value) : "auto"));
}

void OptionsWriter::end(std::string_view key, std::optional<EndOptions>& value, const FieldDoc&) {
  if (!value) return;
  OptionsWriter inner(rename_);
  value->fields(inner);
  add(key, inner.take());
}

ConfigNode OptionsWriter::written(const PluginChoice& choice) const {
  OptionsWriter inner(rename_);
  inner.add("type", text_node(choice.plugin->type));
  choice.options->fields(inner);
  return inner.take();
}

void OptionsWriter::plugin(std::string_view key, PluginChoice& value, std::string_view, const FieldDoc&) {
  if (value) add(key, written(value));
}

void OptionsWriter::plugins(std::string_view key, std::optional<PluginList>& value, std::string_view, const FieldDoc&) {
  if (!value) return;
  ConfigNode list;
  list.kind = ConfigNode::Kind::list;
  for (const PluginChoice& choice : *value) {
    if (!choice) continue;  // a fault of the configuration that was reported
    ConfigNode node = written(choice);
    list.items.push_back(node.entries.size() == 1 ? node.entries.front().value : std::move(node));
  }
  add(key, std::move(list));
}

}  // namespace leastcost
