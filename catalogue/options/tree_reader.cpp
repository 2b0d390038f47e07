// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The part of OptionsReader that reads what only a study has.
#include <fmt/format.h>

#include <algorithm>

#include "catalogue/options/options_reader.hpp"
#include "catalogue/yaml/scalars.hpp"

namespace leastcost {
namespace {

/// What an entry of a list may not be, in words that follow the option: "has an entry that must be ..".
std::string entry_fault(const ConfigNode& item, TreeForm form) {
  if (form == TreeForm::plugins && !item.is_scalar() && item.find("type") == nullptr)
    return "must be a type or a block with a type (" + found(item) + ")";
  const bool automatic = form == TreeForm::counts && item.is_scalar() && item.text == "auto";
  if ((form == TreeForm::counts || form == TreeForm::integers) && !automatic) return parse_int(item).fault;
  return "";
}

std::string in_words(TreeForm form) {
  switch (form) {
    case TreeForm::run: return "must be the name of a configuration file or a configuration";
    case TreeForm::options: return "must be a block of options, like {path.points: 10}";
    case TreeForm::sweep: return "must be a block of options with lists of values, like {path.cascade: [true, false]}";
    case TreeForm::plugins: return "must be a list, like [newton, {name: plain, type: lbfgs, precondition: none}]";
    case TreeForm::counts: return "must be a list of numbers of points, like [20, 200]";
    case TreeForm::integers: return "must be a list of whole numbers, like [1, 2]";
  }
  return "";
}

bool has_form(const ConfigNode& node, TreeForm form) {
  const auto full_list = [](const ConfigNode& n) { return n.is_list() && !n.items.empty(); };
  switch (form) {
    case TreeForm::run: return node.is_block() || (node.is_scalar() && !node.text.empty());
    case TreeForm::options: return node.is_block();
    case TreeForm::sweep:
      return node.is_block() && std::all_of(node.entries.begin(), node.entries.end(),
                                            [&](const ConfigEntry& e) { return is_note(e.key) || full_list(e.value); });
    case TreeForm::plugins:
    case TreeForm::counts:
    case TreeForm::integers: return full_list(node);
  }
  return false;
}

}  // namespace

bool OptionsReader::check_form(std::string_view key, const ConfigNode& node, TreeForm form) {
  if (!has_form(node, form)) {
    const std::string what = node.is_list() && node.items.empty() ? "found an empty list" : found(node);
    fault(key, node.place, in_words(form) + " (" + what + ")");
    return false;
  }
  const std::size_t before = errors_.size();
  for (const ConfigNode& item : node.items) {
    const std::string what = entry_fault(item, form);
    if (!what.empty()) fault(key, item.place, "has an entry that " + what);
  }
  return errors_.size() == before;
}

void OptionsReader::tree(std::string_view key, ConfigNode& value, TreeForm form, const PluginKind*,
                         const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e != nullptr && check_form(key, e->value, form)) value = e->value;
}

void OptionsReader::blocks(std::string_view key, const BlockList& list, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  if (!e->value.is_list() || e->value.items.empty())
    return fault(key, e->value.place,
                 "must be a list of blocks (" + (e->value.is_list() ? "found an empty list" : found(e->value)) + ")");
  list.resize(e->value.items.size());
  for (std::size_t i = 0; i < e->value.items.size(); ++i) {
    const ConfigNode& item = e->value.items[i];
    OptionsReader inner(item, fmt::format("{}.{}", path(key), i), item.place, errors_, externals_);
    list.fields(i, inner);
    inner.finish();
  }
}

}  // namespace leastcost
