// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/catalogue/yaml/diagnostics.hpp>

namespace leastcost {

struct ConfigEntry;

/// A configuration as a tree in which everything knows its place. Scalars keep their text: what it means is decided by
/// the option that asks for it. Keys of a block are unique and in the order of the file.
struct ConfigNode {
  enum class Kind { nothing, scalar, list, block };

  Kind kind = Kind::nothing;
  Place place;
  std::string text;                  ///< of a scalar
  bool quoted = false;               ///< a scalar in quotes is text, never a number
  std::vector<ConfigNode> items;     ///< of a list
  std::vector<ConfigEntry> entries;  ///< of a block

  bool is_block() const { return kind == Kind::block; }
  bool is_list() const { return kind == Kind::list; }
  bool is_scalar() const { return kind == Kind::scalar; }
  const ConfigEntry* find(std::string_view key) const;
  ConfigEntry* find(std::string_view key);
};

struct ConfigEntry {
  std::string key;
  Place place;
  ConfigNode value;
};

/// Keys that start with x- are notes: they are kept, and mean nothing to any block.
bool is_note(std::string_view key);

ConfigNode scalar_node(std::string text, bool quoted = false);

/// A list position as it stands in a path: "0", "12".
std::optional<std::size_t> list_index(std::string_view text);

/// The node at "solver.tolerance" or "post_process.1.type"; null when it is not given.
const ConfigNode* node_at(const ConfigNode& root, std::string_view path);

/// A path as messages have it: "obstacles[1].radius" for "obstacles.1.radius".
std::string shown_path(std::string_view path);

/// The place to name for a fault of a node as a whole: `place`, but what the command line put into the node where it
/// did.
const Place& blamed(const ConfigNode& node, const Place& place);

/// The place of "solver.tolerance" or "post_process.1.type": of the key itself where it is given, else of the nearest
/// block around it that is.
Place place_of(const ConfigNode& root, std::string_view path);

}  // namespace leastcost
