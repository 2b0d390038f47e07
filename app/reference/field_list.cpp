// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/reference/field_list.hpp"

#include "app/study/grid/study_config.hpp"
#include "catalogue/config/run_config.hpp"
#include "catalogue/options/options_writer.hpp"
#include "catalogue/registry/registry.hpp"
#include "catalogue/yaml/scalars.hpp"
#include "catalogue/yaml/suggest.hpp"
#include "catalogue/yaml/yaml_writer.hpp"

namespace leastcost::app {
namespace {

class FieldCollector final : public RunVisitor {
 public:
  std::vector<FieldInfo> take() { return std::move(fields_); }

  void field(std::string_view key, bool& value, const FieldDoc& doc) override {
    plain(key, value, FieldType::boolean, doc);
  }
  void field(std::string_view key, int& value, const FieldDoc& doc) override {
    plain(key, value, FieldType::integer, doc);
  }
  void field(std::string_view key, double& value, const FieldDoc& doc) override {
    plain(key, value, FieldType::number, doc);
  }
  void field(std::string_view key, std::string& value, const FieldDoc& doc) override {
    plain(key, value, FieldType::text, doc);
  }
  void field(std::string_view key, Eigen::VectorXd& value, const FieldDoc& doc) override {
    plain(key, value, FieldType::numbers, doc);
  }
  void field(std::string_view key, Eigen::MatrixXd& value, const FieldDoc& doc) override {
    plain(key, value, FieldType::matrix, doc);
  }
  void field(std::string_view key, std::map<std::string, double>& value, const FieldDoc& doc) override {
    plain(key, value, FieldType::named_numbers, doc);
  }
  void field(std::string_view key, std::vector<std::string>& value, const FieldDoc& doc) override {
    plain(key, value, FieldType::texts, doc);
  }
  void switch_or_number(std::string_view key, bool& on, double& number, const FieldDoc& doc) override {
    FieldInfo& info = add(key, FieldType::switch_or_number, doc);
    info.default_value = !on ? "false" : number == 0 ? "true" : number_text(number);
  }
  void file(std::string_view key, std::string&, const FieldDoc& doc) override { add(key, FieldType::file, doc); }
  void group(std::string_view key, const FieldDoc& doc, const std::function<void(FieldVisitor&)>& body) override {
    block(key, doc, body);
  }

  void points(std::string_view key, std::optional<int>& value, const FieldDoc& doc) override {
    add(key, FieldType::points, doc).default_value = value ? std::to_string(*value) : "auto";
  }
  void end(std::string_view key, std::optional<EndOptions>& value, const FieldDoc& doc) override {
    FieldCollector inner;
    EndOptions end = value.value_or(EndOptions{});
    end.fields(inner);
    add(key, FieldType::end, doc).children = inner.take();
  }
  void plugin(std::string_view key, PluginChoice&, std::string_view kind, const FieldDoc& doc) override {
    add(key, FieldType::plugin, doc).kind = &leastcost::kind(kind);
  }
  void plugins(std::string_view key, std::optional<PluginList>&, std::string_view kind, const FieldDoc& doc) override {
    add(key, FieldType::plugins, doc).kind = &leastcost::kind(kind);
  }
  void block(std::string_view key, const FieldDoc& doc, const std::function<void(RunVisitor&)>& body) override {
    FieldCollector inner;
    body(inner);
    add(key, FieldType::block, doc).children = inner.take();
  }
  void blocks(std::string_view key, const BlockList& list, const FieldDoc& doc) override {
    FieldCollector inner;
    list.resize(1);
    list.fields(0, inner);
    list.resize(0);
    add(key, FieldType::blocks, doc).children = inner.take();
  }
  void tree(std::string_view key, ConfigNode&, TreeForm form, const PluginKind* kind, const FieldDoc& doc) override {
    FieldInfo& info = add(key, FieldType::tree, doc);
    info.form = form;
    info.kind = kind;
  }

 protected:
  void optional_field(std::string_view, bool& given, const std::function<void()>& field) override {
    field();
    if (!given) fields_.back().default_value.clear();
  }
  void choice_of(std::string_view key, std::size_t& chosen, const std::vector<std::string>& choices,
                 const FieldDoc& doc) override {
    FieldInfo& info = add(key, FieldType::choice, doc);
    info.choices = choices;
    info.default_value = choices[chosen];
  }
  void variant_of(std::string_view key, std::optional<std::size_t>& chosen, const std::vector<FieldVariant>& variants,
                  const FieldDoc& doc) override {
    FieldInfo& info = add(key, FieldType::variant, doc);
    if (chosen && !doc.required) info.default_value = variants[*chosen].type;
    for (const FieldVariant& v : variants) {
      FieldCollector inner;
      if (v.fields) v.fields(inner);
      FieldInfo& form = info.children.emplace_back();
      form.key = v.type;
      form.type = FieldType::block;
      form.help = v.help;
      form.children = inner.take();
      info.choices.push_back(v.type);
    }
  }

 private:
  FieldInfo& add(std::string_view key, FieldType type, const FieldDoc& doc) {
    FieldInfo& info = fields_.emplace_back();
    info.key = key;
    info.type = type;
    info.help = doc.help;
    info.unit = doc.unit;
    info.minimum = doc.minimum;
    info.maximum = doc.maximum;
    info.exclusive_minimum = doc.exclusive_minimum;
    info.required = doc.required;
    return info;
  }

  /// The default is what the writer makes of it: the same text, and nothing where there is none.
  template <class T>
  void plain(std::string_view key, T& value, FieldType type, const FieldDoc& doc) {
    OptionsWriter writer;
    writer.field(key, value, doc);
    const ConfigNode node = writer.take();
    FieldInfo& info = add(key, type, doc);
    if (node.entries.empty() || doc.required) return;
    info.default_value = to_yaml(node.entries.front().value);
    info.default_value.pop_back();  // the line break
  }

  std::vector<FieldInfo> fields_;
};

std::string in_words(FieldType type) {
  switch (type) {
    case FieldType::boolean: return "true or false";
    case FieldType::integer: return "whole number";
    case FieldType::number: return "number";
    case FieldType::text: return "text";
    case FieldType::numbers: return "list of numbers, or a single one";
    case FieldType::matrix: return "list of rows of numbers";
    case FieldType::named_numbers: return "block of names and numbers";
    case FieldType::texts: return "text or list of texts";
    case FieldType::choice: return "one of";
    case FieldType::file: return "file";
    case FieldType::block: return "block";
    case FieldType::variant: return "a type, or a block with a type, of";
    case FieldType::switch_or_number: return "true, false or a number";
    case FieldType::points: return "whole number or auto";
    case FieldType::end: return "end of the path";
    case FieldType::plugin: return "a type, or a block with a type";
    case FieldType::plugins: return "list of types, or of blocks with a type";
    case FieldType::blocks: return "list of blocks";
    case FieldType::tree: return "";  // its form says it
  }
  return "";
}

std::string in_words(TreeForm form) {
  switch (form) {
    case TreeForm::run: return "configuration file, or a configuration";
    case TreeForm::options: return "block of options of a run, like {path.points: 10}";
    case TreeForm::sweep: return "block of options of a run with lists of values, like {path.cascade: [true, false]}";
    case TreeForm::plugins: return "list of types, or of blocks with a type and perhaps a name";
    case TreeForm::counts: return "list of whole numbers or auto";
    case TreeForm::integers: return "list of whole numbers";
  }
  return "";
}

}  // namespace

std::string FieldInfo::type_in_words() const {
  std::string words = type == FieldType::tree ? in_words(form) : in_words(type);
  if (type == FieldType::choice || type == FieldType::variant) return words + " " + joined(choices);
  FieldDoc doc;
  doc.minimum = minimum;
  doc.maximum = maximum;
  doc.exclusive_minimum = exclusive_minimum;
  const std::string range = range_in_words(doc);
  return range.empty() ? words : words + ", " + range;
}

std::vector<FieldInfo> fields_of(AnyOptions& options) {
  FieldCollector collector;
  options.fields(collector);
  return collector.take();
}

std::vector<FieldInfo> fields_of_run() {
  FieldCollector collector;
  RunConfig config;
  config.fields(collector);
  return collector.take();
}

std::vector<FieldInfo> fields_of_study() {
  FieldCollector collector;
  StudyConfig config;
  config.fields(collector);
  return collector.take();
}

}  // namespace leastcost::app
