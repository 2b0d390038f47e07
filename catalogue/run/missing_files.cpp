// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/missing_files.hpp"

#include <filesystem>
#include <system_error>

#include "catalogue/config/run_config.hpp"

namespace leastcost {
namespace {

/// The place of a text in a configuration; null where it has none of its own.
const ConfigNode* find_text(const ConfigNode& node, const std::string& text) {
  if (node.is_scalar() && node.text == text) return &node;
  const ConfigNode* found = nullptr;
  for (auto item = node.items.begin(); found == nullptr && item != node.items.end(); ++item)
    found = find_text(*item, text);
  for (auto entry = node.entries.begin(); found == nullptr && entry != node.entries.end(); ++entry)
    found = find_text(entry->value, text);
  return found;
}

}  // namespace

std::vector<MissingFile> missing_files(const LoadedConfig& loaded) {
  std::vector<MissingFile> missing;
  for (const std::string& name : files_of(loaded.config)) {
    const std::filesystem::path file = loaded.folder / name;
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (status.type() != std::filesystem::file_type::not_found) continue;
    const ConfigNode* named = find_text(loaded.tree, name);
    missing.push_back({named == nullptr ? Place{} : named->place, file.string()});
  }
  return missing;
}

}  // namespace leastcost
