// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The part of OptionsReader that reads plug-ins, variants and ends.
#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "catalogue/options/options_reader.hpp"
#include "catalogue/plugins/external_plugin.hpp"
#include "catalogue/registry/registry.hpp"
#include "catalogue/yaml/scalars.hpp"
#include "catalogue/yaml/suggest.hpp"

namespace leastcost {
namespace {

std::string with_article(std::string_view kind) {
  return fmt::format("{} {}", std::string_view("aeiou").find(kind.front()) != std::string_view::npos ? "an" : "a",
                     kind);
}

}  // namespace

const PluginEntry* OptionsReader::find_type(const ConfigNode& node, const Place& place, const std::string& path,
                                            const PluginKind& kind) {
  const std::vector<std::string> types = types_of(kind);
  const ConfigNode* type = &node;
  if (node.is_block()) {
    const ConfigEntry* e = node.find("type");
    if (e == nullptr) {
      errors_.error(blamed(node, place),
                    fmt::format("missing key 'type' in {}: one of {}", shown_path(path), joined(types)));
      return nullptr;
    }
    type = &e->value;
  }
  if (!type->is_scalar()) {
    errors_.error(type->place, fmt::format("'{}' must be a type or a block with a type, like {{type: {}}} ({})",
                                           shown_path(path), types.front(), found(*type)));
    return nullptr;
  }
  if (type->text == kExternal) return &external_plugin();
  const PluginEntry* plugin = find_plugin(kind, type->text);
  if (plugin == nullptr) {
    errors_.error(type->place, fmt::format("unknown {} {}{}; valid types: {}", kind.name, in_quotes(type->text),
                                           did_you_mean(type->text, types), joined(types)));
  } else if (!plugin->missing.empty()) {
    errors_.error(type->place,
                  fmt::format("{} {} is not in this build: {}", kind.name, in_quotes(type->text), plugin->missing));
    return nullptr;
  }
  return plugin;
}

PluginChoice OptionsReader::read_plugin(const ConfigNode& node, const Place& place, const std::string& path,
                                        const PluginKind& kind) {
  const PluginEntry* plugin = find_type(node, place, path, kind);
  if (plugin == nullptr) return {};
  PluginChoice choice = choose(*plugin, path);
  ConfigNode options = node;
  if (!node.is_block()) {  // the word alone: all options keep their defaults
    options = ConfigNode{};
    options.kind = ConfigNode::Kind::block;
  }
  OptionsReader reader(options, path, node.is_block() ? place : blamed(node, place), errors_, externals_);
  choice.options->fields(reader);
  reader.known_.emplace_back("type");
  reader.finish();
  return plugin->type == kExternal ? find_external(options, choice, kind) : choice;
}

PluginChoice OptionsReader::find_external(const ConfigNode& node, const PluginChoice& asked, const PluginKind& kind) {
  const ConfigEntry* named = node.find("name");
  if (named == nullptr || !named->value.is_scalar()) return {};  // an error of its own
  const std::string& name = named->value.text;
  const auto refuse = [&](const std::string& why) {
    errors_.error(named->value.place, why);
    return PluginChoice{};
  };
  if (externals_ == nullptr || externals_->empty())
    return refuse(
        fmt::format("there is no object {}: objects are handed over by the program that reads the "
                    "configuration (externals in C++, keywords of run() in Python)",
                    in_quotes(name)));
  const auto found = externals_->find(name);
  if (found == externals_->end()) {
    std::vector<std::string> names;
    for (const auto& [known, object] : *externals_) names.push_back(known);
    return refuse(
        fmt::format("there is no object {}{}; objects: {}", in_quotes(name), did_you_mean(name, names), joined(names)));
  }
  if (std::visit([](const auto& object) { return object == nullptr; }, found->second))
    return refuse(fmt::format("the object {} is null", in_quotes(name)));
  if (kind_of(found->second) != kind.name)
    return refuse(fmt::format("the object {} is {}; this key takes {}", in_quotes(name),
                              with_article(kind_of(found->second)), with_article(kind.name)));
  return choose_external(found->second, name, asked.path);
}

void OptionsReader::plugin(std::string_view key, PluginChoice& value, std::string_view kind, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e != nullptr) value = read_plugin(e->value, e->place, path(key), leastcost::kind(kind));
}

void OptionsReader::plugins(std::string_view key, std::optional<PluginList>& value, std::string_view kind_name,
                            const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  const PluginKind& kind = leastcost::kind(kind_name);
  if (!e->value.is_list())
    return fault(key, e->value.place,
                 fmt::format("must be a list, like [{}] ({})", types_of(kind).front(), found(e->value)));
  value.emplace();
  for (std::size_t i = 0; i < e->value.items.size(); ++i) {
    const ConfigNode& item = e->value.items[i];
    value->push_back(read_plugin(item, item.place, fmt::format("{}.{}", path(key), i), kind));
  }
}

std::optional<std::size_t> OptionsReader::find_variant(const ConfigEntry& e, const std::string& path,
                                                       const std::vector<FieldVariant>& variants) {
  std::vector<std::string> types;
  types.reserve(variants.size());
  for (const FieldVariant& v : variants) types.push_back(v.type);
  const ConfigNode* type = &e.value;
  if (e.value.is_block()) {
    const ConfigEntry* named = e.value.find("type");
    const auto has_options = [](const FieldVariant& v) { return v.fields != nullptr; };
    // Options without a type are those of the only form that has any.
    if (named == nullptr && std::count_if(variants.begin(), variants.end(), has_options) == 1)
      return std::find_if(variants.begin(), variants.end(), has_options) - variants.begin();
    if (named == nullptr) {
      errors_.error(blamed(e.value, e.place),
                    fmt::format("missing key 'type' in {}: one of {}", shown_path(path), joined(types)));
      return std::nullopt;
    }
    type = &named->value;
  }
  if (!type->is_scalar()) {
    errors_.error(type->place, fmt::format("'{}' must be a type or a block with a type, like {{type: {}}} ({})",
                                           shown_path(path), types.front(), found(*type)));
    return std::nullopt;
  }
  for (std::size_t i = 0; i < variants.size(); ++i)
    if (variants[i].type == type->text) return i;
  errors_.error(type->place, fmt::format("unknown type {} of {}{}; valid types: {}", in_quotes(type->text),
                                         shown_path(path), did_you_mean(type->text, types), joined(types)));
  return std::nullopt;
}

void OptionsReader::variant_of(std::string_view key, std::optional<std::size_t>& chosen,
                               const std::vector<FieldVariant>& variants, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  const std::optional<std::size_t> at = e == nullptr ? std::nullopt : find_variant(*e, path(key), variants);
  if (!at) return;
  chosen = at;
  ConfigNode options = e->value;
  if (!options.is_block()) {  // the word alone
    options = ConfigNode{};
    options.kind = ConfigNode::Kind::block;
  }
  OptionsReader reader(options, path(key), e->place, errors_, externals_);
  if (variants[*at].fields) variants[*at].fields(reader);
  reader.known_.emplace_back("type");
  reader.finish();
}

void OptionsReader::end(std::string_view key, std::optional<EndOptions>& value, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  const std::size_t before = errors_.size();
  OptionsReader reader(e->value, path(key), e->place, errors_, externals_);
  EndOptions& end = value.emplace();
  end.fields(reader);
  reader.finish();
  if (errors_.size() > before) return;
  if (e->value.find("tool") != nullptr && !end.tool.given())
    fault("tool", e->value.find("tool")->place, "must have a position, like {tool: {position: [0.4, 0, 0.5]}}");
  else if (end.ways() != 1)
    fault(key, e->place, key == "target" ? EndOptions::kWaysOfTarget : EndOptions::kWays);
  else if (end.is_several() && key != "target")
    fault(key, e->place, "must be one point: only a target can have several goals, or a pose of the tool");
  else if (end.face.has_value() != end.barycentric.has_value())
    fault(key, e->place, "must have both face and barycentric, like {face: 12, barycentric: [0.2, 0.3, 0.5]}");
  else if (end.barycentric && end.barycentric->size() != 3)
    fault("barycentric", e->value.find("barycentric")->value.place, "must have three numbers");
  else if (end.lonlat && end.lonlat->size() != 2)
    fault("lonlat", e->value.find("lonlat")->value.place, "must have two numbers, longitude and latitude");
  else if (end.tolerance && !end.point && !end.lonlat)
    fault("tolerance", e->value.find("tolerance")->place, "is only for an end given as a point: remove it");
}

}  // namespace leastcost
