// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/yaml/config_node.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace leastcost {
namespace {

/// The part of `path` before the first dot; `path` keeps the rest.
std::string_view pop_front(std::string_view& path) {
  const std::size_t dot = path.find('.');
  const std::string_view head = path.substr(0, dot);
  path.remove_prefix(dot == std::string_view::npos ? path.size() : dot + 1);
  return head;
}

}  // namespace

const ConfigEntry* ConfigNode::find(std::string_view key) const {
  const auto it = std::find_if(entries.begin(), entries.end(), [&](const ConfigEntry& e) { return e.key == key; });
  return it == entries.end() ? nullptr : &*it;
}

ConfigEntry* ConfigNode::find(std::string_view key) {
  return const_cast<ConfigEntry*>(static_cast<const ConfigNode*>(this)->find(key));
}

bool is_note(std::string_view key) { return key.substr(0, 2) == "x-"; }

ConfigNode scalar_node(std::string text, bool quoted) {
  ConfigNode node;
  node.kind = ConfigNode::Kind::scalar;
  node.text = std::move(text);
  node.quoted = quoted;
  return node;
}

std::optional<std::size_t> list_index(std::string_view text) {
  constexpr std::size_t kMostDigits = 6;
  const bool digits = std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (text.empty() || text.size() > kMostDigits || !digits) return std::nullopt;
  std::size_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string shown_path(std::string_view path) {
  std::string shown;
  while (!path.empty()) {
    const std::string_view head = pop_front(path);
    const bool is_index = !shown.empty() && list_index(head);
    if (!shown.empty() && !is_index) shown += '.';
    shown += is_index ? "[" + std::string(head) + "]" : std::string(head);
  }
  return shown;
}

const Place& blamed(const ConfigNode& node, const Place& place) {
  if (!place.origin.empty()) return place;
  if (!node.place.origin.empty()) return node.place;
  for (const ConfigNode& item : node.items)
    if (const Place& inside = blamed(item, place); !inside.origin.empty()) return inside;
  for (const ConfigEntry& entry : node.entries) {
    if (!entry.place.origin.empty()) return entry.place;
    if (const Place& inside = blamed(entry.value, place); !inside.origin.empty()) return inside;
  }
  return place;
}

Place place_of(const ConfigNode& root, std::string_view path) {
  const ConfigNode* node = &root;
  Place place = root.place;
  while (!path.empty()) {
    const std::string_view head = pop_front(path);
    if (node->is_list()) {
      const std::optional<std::size_t> index = list_index(head);
      if (!index || *index >= node->items.size()) return place;
      node = &node->items[*index];
      place = node->place;
      continue;
    }
    const ConfigEntry* entry = node->find(head);
    if (entry == nullptr) return place;
    node = &entry->value;
    // The value is what is wrong; a block is better named by its key.
    place = node->is_scalar() || node->is_list() ? node->place : entry->place;
  }
  return node == &root ? place : blamed(*node, place);
}

const ConfigNode* node_at(const ConfigNode& root, std::string_view path) {
  const ConfigNode* node = &root;
  while (!path.empty() && node != nullptr) {
    const std::string_view head = pop_front(path);
    const std::optional<std::size_t> index = node->is_list() ? list_index(head) : std::nullopt;
    const ConfigEntry* entry = node->find(head);
    if (index && *index < node->items.size())
      node = &node->items[*index];
    else
      node = entry == nullptr ? nullptr : &entry->value;
  }
  return node;
}

}  // namespace leastcost
