// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/inputs/scene_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "catalogue/yaml/scalars.hpp"
#include "catalogue/yaml/suggest.hpp"

namespace leastcost {

SceneBlock::SceneBlock(const ConfigNode& node, std::string what, Diagnostics& errors)
    : node_(&node), what_(std::move(what)), errors_(errors) {
  if (!node.is_block()) errors_.error(node.place, fmt::format("{} must be a block of keys ({})", what_, found(node)));
}

const ConfigNode* SceneBlock::find(const char* key) {
  known_.emplace_back(key);
  const ConfigEntry* entry = node_->find(key);
  return entry == nullptr ? nullptr : &entry->value;
}

const ConfigNode* SceneBlock::required(const char* key) {
  const ConfigNode* node = find(key);
  if (node == nullptr && node_->is_block())
    errors_.error(node_->place, fmt::format("missing key '{}' in {}", key, what_));
  return node;
}

double SceneBlock::number(const char* key, std::optional<double> missing) {
  const ConfigNode* node = missing ? find(key) : required(key);
  if (node == nullptr) return missing.value_or(0);
  const Parsed<double> parsed = parse_double(*node);
  if (!parsed.value) fault(key, parsed.fault);
  return parsed.value.value_or(missing.value_or(0));
}

std::string SceneBlock::text(const char* key, const std::optional<std::string>& missing) {
  const ConfigNode* node = missing ? find(key) : required(key);
  if (node == nullptr) return missing.value_or("");
  const Parsed<std::string> parsed = parse_text(*node);
  if (!parsed.value) fault(key, parsed.fault);
  return parsed.value.value_or("");
}

bool SceneBlock::flag(const char* key, bool missing) {
  const ConfigNode* node = find(key);
  if (node == nullptr) return missing;
  const Parsed<bool> parsed = parse_bool(*node);
  if (!parsed.value) fault(key, parsed.fault);
  return parsed.value.value_or(missing);
}

Eigen::VectorXd SceneBlock::numbers(const char* key, std::size_t count) {
  const ConfigNode* node = find(key);
  if (node == nullptr) return {};
  std::string wrong;
  const std::optional<Eigen::VectorXd> read = numbers_of(*node, count, {}, wrong);
  if (!read) fault(key, wrong);
  return read.value_or(Eigen::VectorXd());
}

std::vector<ConfigNode> SceneBlock::list(const char* key) {
  const ConfigNode* node = find(key);
  if (node == nullptr || node->kind == ConfigNode::Kind::nothing) return {};
  if (!node->is_list()) fault(key, fmt::format("must be a list ({})", found(*node)));
  return node->items;
}

void SceneBlock::fault(std::string_view key, const std::string& message) {
  errors_.error(place_of(*node_, key), fmt::format("'{}' in {} {}", key, what_, message));
}

void SceneBlock::finish() {
  for (const ConfigEntry& entry : node_->entries) {
    if (is_note(entry.key) || std::count(known_.begin(), known_.end(), entry.key) > 0) continue;
    const std::string hint = did_you_mean(entry.key, known_);
    errors_.error(entry.place, fmt::format("unknown key {} in {}{}", in_quotes(entry.key), what_,
                                           hint.empty() ? "; valid keys: " + joined(known_) : hint));
  }
}

std::optional<Eigen::VectorXd> numbers_of(const ConfigNode& node, std::size_t count,
                                          const std::vector<std::string>& names, std::string& fault) {
  std::vector<const ConfigNode*> items;
  if (node.is_list())
    for (const ConfigNode& item : node.items) items.push_back(&item);
  if (node.is_block())
    for (const std::string& name : names)
      if (const ConfigEntry* entry = node.find(name)) items.push_back(&entry->value);
  if (items.empty() || (count > 0 && items.size() != count)) {
    fault = count > 0 ? fmt::format("must be a list of {} numbers ({})", count, found(node))
                      : fmt::format("must be a list of numbers ({})", found(node));
    return std::nullopt;
  }
  Eigen::VectorXd out(static_cast<Eigen::Index>(items.size()));
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Parsed<double> parsed = parse_double(*items[i]);
    if (!parsed.value) {
      fault = "has an entry that " + parsed.fault;
      return std::nullopt;
    }
    out[static_cast<Eigen::Index>(i)] = *parsed.value;
  }
  return out;
}

}  // namespace leastcost
