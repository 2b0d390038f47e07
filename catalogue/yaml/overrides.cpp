// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/yaml/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "catalogue/yaml/scalars.hpp"
#include "catalogue/yaml/yaml_reader.hpp"

namespace leastcost {
namespace {

/// The words of "block.key". "obstacles[1].radius" is what "obstacles.1.radius" is; other brackets stay, and are no
/// path.
std::vector<std::string> split_path(const std::string& path) {
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::size_t close = path[i] == '[' ? path.find(']', i) : std::string::npos;
    const bool ends_word = close != std::string::npos && !parts.back().empty() &&
                           (close + 1 == path.size() || path[close + 1] == '.' || path[close + 1] == '[');
    if (ends_word && list_index(path.substr(i + 1, close - i - 1))) {
      parts.push_back(path.substr(i + 1, close - i - 1));
      i = close;
    } else if (path[i] == '.') {
      parts.emplace_back();
    } else {
      parts.back() += path[i];
    }
  }
  return parts;
}

bool is_path(const std::vector<std::string>& parts) {
  const auto harmless = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return std::all_of(parts.begin(), parts.end(), [&](const std::string& part) {
    return !part.empty() && std::all_of(part.begin(), part.end(), harmless);
  });
}

/// The deepest option is named by a few words; every further one would be a block around it.
constexpr std::size_t kMostWords = 16;

/// What an override is called in messages: one that nobody would read to its end is cut, because every place has it.
std::string shown(const std::string& origin) {
  constexpr std::size_t kLongest = 200;
  return origin.size() <= kLongest ? origin : origin.substr(0, kLongest) + "...";
}

/// Why `key`, the position of an entry, is none of what `path` names, and what would be one.
std::string why_no_list(const ConfigNode& node, const std::string& path, const std::string& key) {
  const std::string name = in_quotes(shown_path(path));
  if (node.kind == ConfigNode::Kind::nothing)
    return fmt::format("{} has no entry {}: the configuration does not give this list; give all of it at once, {}=[..]",
                       name, key, shown_path(path));
  return fmt::format(
      "{} has no entry {}: it is {}, not a list; {}", name, key, node.is_block() ? "a block of keys" : "one value",
      node.is_block() ? fmt::format("name one of its keys, {}.KEY", shown_path(path)) : "leave out the number");
}

/// The node that `key` names in `node`, which is at `path`, made when missing; null (with an error) where a list has no
/// such position, or there is no list.
ConfigNode* step_into(ConfigNode& node, const std::string& path, const std::string& key, const Place& place,
                      Diagnostics& errors) {
  if (node.is_list()) {
    const std::optional<std::size_t> index = list_index(key);
    if (index && *index < node.items.size()) return &node.items[*index];
    errors.error(place, "the list has " + std::to_string(node.items.size()) +
                            (node.items.size() == 1 ? " entry" : " entries") + ", numbered from 0; " + in_quotes(key) +
                            " is not one of them");
    return nullptr;
  }
  if (list_index(key) && !path.empty() && !(node.is_block() && node.find(key) != nullptr)) {
    errors.error(place, why_no_list(node, path, key));
    return nullptr;
  }
  if (!node.is_block()) {
    ConfigNode block;
    block.kind = ConfigNode::Kind::block;
    block.place = node.place;
    if (node.is_scalar()) block.entries.push_back({"type", node.place, node});
    node = std::move(block);
  }
  if (ConfigEntry* entry = node.find(key)) return &entry->value;
  node.entries.push_back({key, place, {}});
  node.entries.back().value.place = place;
  return &node.entries.back().value;
}

void apply(const Override& override, ConfigNode& root, Diagnostics& errors) {
  const std::string origin = shown(override.origin.empty() ? override.assignment : override.origin);
  const Place place{0, 0, 1, origin};
  const std::size_t equals = override.assignment.find('=');
  const std::string path = override.assignment.substr(0, equals);
  if (equals == std::string::npos || !is_path(split_path(path)))
    return errors.error(
        place,
        "must have the form key=value or block.key=value, like solver.max_iterations=50 or, the second of a "
        "list, obstacles[1].radius=2");
  const std::size_t before = errors.size();
  ConfigNode value = read_yaml_value(override.assignment.substr(equals + 1), origin, errors);
  if (errors.size() > before) return;
  value.place = place;
  put_option(path, std::move(value), place, root, errors);
}

}  // namespace

Override set_option(const std::string& assignment) { return {assignment, shown("--set " + assignment)}; }
Override seed_option(const std::string& number) { return {"seed=" + number, "--seed " + number}; }

void apply_overrides(const std::vector<Override>& overrides, ConfigNode& root, Diagnostics& errors) {
  for (const Override& override : overrides) apply(override, root, errors);
}

void put_option(const std::string& path, ConfigNode value, const Place& place, ConfigNode& root, Diagnostics& errors) {
  const std::vector<std::string> keys = split_path(path);
  if (!is_path(keys))
    return errors.error(place, in_quotes(path) + " is not an option: it must have the form key or block.key");
  if (keys.size() > kMostWords)
    return errors.error(
        place, fmt::format("{} is not an option: no option has more than {} words", in_quotes(path), kMostWords));
  ConfigNode *node = &root, *around = nullptr;
  bool made = false;
  std::string before;
  for (const std::string& key : keys) {
    const std::size_t had = node->entries.size();
    ConfigNode* const next = step_into(*node, before, key, place, errors);
    if (next == nullptr) {
      if (made) around->entries.pop_back();  // else it were a key without a value, another error
      return;
    }
    before += (before.empty() ? "" : ".") + key;
    made = node->entries.size() > had;
    around = node;
    node = next;
  }
  *node = std::move(value);
}

}  // namespace leastcost
