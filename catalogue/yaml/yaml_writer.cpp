// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/yaml/yaml_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "catalogue/yaml/scalars.hpp"

namespace leastcost {
namespace {

bool is_plain_word(std::string_view text) {
  static const std::vector<std::string> kTaken = {"true", "false", "yes", "no", "on", "off", "null", "y", "n"};
  const auto harmless = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '/' || c == '-';
  };
  if (text.empty() || !std::all_of(text.begin(), text.end(), harmless)) return false;
  const bool path = text.substr(0, 2) == "./" || text.substr(0, 3) == "../";
  if (!path && !std::isalpha(static_cast<unsigned char>(text[0])) && text[0] != '/' && text[0] != '_') return false;
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::find(kTaken.begin(), kTaken.end(), lower) == kTaken.end();
}

std::string in_double_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    else
      out += c;
  }
  return out + "\"";
}

/// Plain are words, numbers, true and false; anything else might mean something to YAML.
bool needs_quotes(const ConfigNode& node) {
  return node.quoted || !(is_plain_word(node.text) || parse_bool(node).value || parse_double(node, true).value);
}

std::string on_one_line(const ConfigNode& node) {
  std::vector<std::string> parts;
  switch (node.kind) {
    case ConfigNode::Kind::nothing: return "~";
    case ConfigNode::Kind::scalar: return needs_quotes(node) ? in_double_quotes(node.text) : node.text;
    case ConfigNode::Kind::list:
      for (const ConfigNode& item : node.items) parts.push_back(on_one_line(item));
      return fmt::format("[{}]", fmt::join(parts, ", "));
    case ConfigNode::Kind::block: break;
  }
  for (const ConfigEntry& e : node.entries)
    parts.push_back(on_one_line(text_node(e.key)) + ": " + on_one_line(e.value));
  return fmt::format("{{{}}}", fmt::join(parts, ", "));
}

bool holds_blocks(const ConfigNode& list) {
  return std::any_of(list.items.begin(), list.items.end(), [](const ConfigNode& n) { return n.is_block(); });
}

void append_block(const ConfigNode& block, int indent, std::string& out) {
  for (const ConfigEntry& e : block.entries) {
    out += fmt::format("{:{}}{}:", "", indent, on_one_line(text_node(e.key)));
    if (e.value.is_block() && !e.value.entries.empty()) {
      out += '\n';
      append_block(e.value, indent + 2, out);
    } else if (e.value.is_list() && holds_blocks(e.value)) {
      out += '\n';
      for (const ConfigNode& item : e.value.items) out += fmt::format("{:{}}- {}\n", "", indent + 2, on_one_line(item));
    } else {
      out += fmt::format(" {}\n", on_one_line(e.value));
    }
  }
}

}  // namespace

ConfigNode text_node(std::string_view text) { return scalar_node(std::string(text), !is_plain_word(text)); }

std::string to_yaml(const ConfigNode& node) {
  std::string out;
  if (node.is_block() && !node.entries.empty())
    append_block(node, 0, out);
  else
    out = on_one_line(node) + "\n";
  return out;
}

}  // namespace leastcost
