// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/yaml/yaml_reader.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <unordered_map>

namespace leastcost {
namespace {

/// Far more than any option is, and far less than what the stack of a recursion bears.
constexpr std::size_t kDeepest = 100;

/// Builds the tree from the parser's events. The events, not the library's own tree: that one follows aliases (a bomb
/// of a few lines), keeps only one of two equal keys findable, and forgets where keys stand.
class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(std::string_view text, Diagnostics& errors) : text_(text), errors_(errors) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    line_starts_.push_back(text.substr(0, 3) == kByteOrderMark ? 3 : 0);
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\n') line_starts_.push_back(i + 1);
  }

  ConfigNode take() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ > 0)
      throw YAML::ParserException(mark, "a configuration must be one document, but another one starts here");
    root_.place = place(mark, 1);
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    no_anchor(mark, anchor);
    ConfigNode node;
    node.place = place(mark, 1);
    add(std::move(node));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    errors_.error(place(mark, 1), "aliases (*name) are not supported: write the value out");
    add(ignored(mark));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    no_anchor(mark, anchor);
    no_tag(mark, tag);
    ConfigNode node = scalar_node(value, tag == "!");
    node.place = place(mark, scalar_length(mark, value, node.quoted));
    add(std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(ConfigNode::Kind::list, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(ConfigNode::Kind::block, mark, tag, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Frame {
    ConfigNode node;
    std::optional<ConfigNode> key;               ///< of a block: read, its value not yet
    std::unordered_map<std::string, int> known;  ///< keys of the block, and the lines they stand in
  };

  static Place place(const YAML::Mark& mark, int length) { return {mark.line + 1, mark.column + 1, length, ""}; }

  static ConfigNode ignored(const YAML::Mark& mark) {
    ConfigNode node;
    node.place = place(mark, 1);
    return node;
  }

  void no_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (anchor != 0) errors_.error(place(mark, 1), "anchors (&name) are not supported: write the value out");
  }

  void no_tag(const YAML::Mark& mark, const std::string& tag) {
    if (tag.empty() || tag == "?" || tag == "!") return;
    errors_.error(place(mark, 1), "tags (" + in_quotes(tag) + ") are not supported");
  }

  void open(ConfigNode::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    no_anchor(mark, anchor);
    no_tag(mark, tag);
    if (stack_.size() >= kDeepest)
      throw YAML::ParserException(mark, fmt::format("blocks and lists can be nested at most {} deep", kDeepest));
    Frame frame;
    frame.node.kind = kind;
    frame.node.place = place(mark, 1);
    stack_.push_back(std::move(frame));
  }

  void close() {
    ConfigNode node = std::move(stack_.back().node);
    stack_.pop_back();
    add(std::move(node));
  }

  void add(ConfigNode node) {
    if (stack_.empty()) {
      root_ = std::move(node);
      return;
    }
    Frame& frame = stack_.back();
    if (frame.node.is_list()) {
      frame.node.items.push_back(std::move(node));
    } else if (!frame.key) {
      frame.key = std::move(node);
    } else {
      add_entry(frame, *frame.key, std::move(node));
      frame.key.reset();
    }
  }

  void add_entry(Frame& frame, const ConfigNode& key, ConfigNode value) {
    if (!key.is_scalar())
      return errors_.error(key.place, "a key must be a word (" + std::string("found ") + kind_of(key) + ")");
    if (key.text == "<<" && !key.quoted)
      return errors_.error(key.place, "merge keys (<<) are not supported: write the keys out");
    const auto [first, is_new] = frame.known.try_emplace(key.text, key.place.line);
    if (!is_new) {
      errors_.error(key.place,
                    fmt::format("duplicate key {} (first given on line {})", in_quotes(key.text), first->second));
      return;
    }
    frame.node.entries.push_back({key.text, key.place, std::move(value)});
  }

  static const char* kind_of(const ConfigNode& node) {
    return node.is_list() ? "a list" : node.is_block() ? "a block of keys" : "nothing";
  }

  /// Bytes of a scalar in the source: its text where it stands there as it is, to the closing quote, else one.
  int scalar_length(const YAML::Mark& mark, const std::string& value, bool quoted) {
    const std::string_view rest = text_from(mark);
    if (!quoted) return !value.empty() && rest.substr(0, value.size()) == value ? static_cast<int>(value.size()) : 1;
    if (rest.empty() || (rest[0] != '"' && rest[0] != '\'')) return 1;  // a block scalar
    const std::size_t end = closing_quote(rest);
    // The parser takes a quote that the end of the file closes: a truncated file.
    if (end == std::string_view::npos) errors_.error(place(mark, 1), "the quote is never closed");
    return end < rest.find('\n') ? static_cast<int>(end + 1) : 1;
  }

  /// Position of the quote that closes the one at position 0, or npos.
  static std::size_t closing_quote(std::string_view text) {
    for (std::size_t i = 1; i < text.size(); ++i) {
      if (text[0] == '"' && text[i] == '\\') {
        ++i;
      } else if (text[i] == text[0]) {
        const bool doubled = text[0] == '\'' && i + 1 < text.size() && text[i + 1] == '\'';
        if (!doubled) return i;
        ++i;
      }
    }
    return std::string_view::npos;
  }

  /// The text from a mark on. Found by line and column: the parser's byte positions do not count a byte order mark.
  std::string_view text_from(const YAML::Mark& mark) const {
    if (mark.line < 0 || static_cast<std::size_t>(mark.line) >= line_starts_.size()) return "";
    const std::size_t start =
        line_starts_[static_cast<std::size_t>(mark.line)] + static_cast<std::size_t>(std::max(mark.column, 0));
    return text_.substr(std::min(start, text_.size()));
  }

  std::string_view text_;
  std::vector<std::size_t> line_starts_;
  Diagnostics& errors_;
  ConfigNode root_;
  std::vector<Frame> stack_;
  int documents_ = 0;
};

/// Position of the first byte that is not UTF-8 (overlong forms and surrogates included) or is a NUL.
std::size_t first_invalid_byte(std::string_view text) {
  std::size_t i = 0;
  while (i < text.size()) {
    const auto byte = [&](std::size_t k) { return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0u; };
    const unsigned lead = byte(0);
    if (lead == 0) return i;
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xc2 && lead < 0xe0 ? 2
                               : lead >= 0xe0 && lead < 0xf0 ? 3
                               : lead >= 0xf0 && lead < 0xf5 ? 4
                                                             : 0;
    if (length == 0) return i;
    for (std::size_t k = 1; k < length; ++k)
      if ((byte(k) & 0xc0) != 0x80) return i;
    const bool overlong = (lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xf0 && byte(1) < 0x90);
    const bool beyond = (lead == 0xed && byte(1) >= 0xa0) || (lead == 0xf4 && byte(1) >= 0x90);
    if (overlong || beyond) return i;
    i += length;
  }
  return text.size();
}

Place place_of_byte(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, position);
  const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return {1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
          1 + static_cast<int>(position - line_start), 1, ""};
}

/// What must hold before the parser sees the text; false when it must not.
bool acceptable(std::string_view text, Diagnostics& errors) {
  if (text.size() > kLargestConfiguration) {
    errors.error(
        {}, fmt::format("a configuration can have at most {} bytes, but this one has more", kLargestConfiguration));
    return false;
  }
  const std::size_t bad = first_invalid_byte(text);
  if (bad < text.size()) {
    errors.error(place_of_byte(text, bad), "not UTF-8 text");
    return false;
  }
  bool tabs = false;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t first = text.find_first_not_of(" \r", start);
    const std::size_t end = std::min(text.find('\n', start), text.size());
    if (first != std::string_view::npos && first < end && text[first] == '\t') {
      errors.error(place_of_byte(text, first), "a tab in the indentation: use spaces");
      tabs = true;
    }
    start = end + 1;
  }
  return !tabs;
}

void set_origin(ConfigNode& node, const std::string& origin) {
  node.place.origin = origin;
  for (ConfigNode& item : node.items) set_origin(item, origin);
  for (ConfigEntry& e : node.entries) {
    e.place.origin = origin;
    set_origin(e.value, origin);
  }
}

}  // namespace

ConfigNode read_yaml(std::string_view text, Diagnostics& errors) {
  if (!acceptable(text, errors)) return {};
  TreeBuilder builder(text, errors);
  try {
    std::istringstream in{std::string(text)};
    YAML::Parser parser(in);
    // Two calls and no more: the second finds out whether a further document begins. A loop would never end on some
    // inputs.
    if (parser.HandleNextDocument(builder)) parser.HandleNextDocument(builder);
  } catch (const YAML::Exception& e) {
    const Place place = e.mark.is_null() ? Place{} : Place{e.mark.line + 1, e.mark.column + 1, 1, ""};
    errors.error(place, "YAML: " + e.msg);
  }
  return builder.take();
}

ConfigNode read_yaml_value(std::string_view text, const std::string& origin, Diagnostics& errors) {
  Diagnostics own(origin, text);
  ConfigNode node = read_yaml(text, own);
  set_origin(node, origin);
  for (const Diagnostic& e : own.sorted()) errors.error({0, 0, 1, origin}, e.message);
  return node;
}

}  // namespace leastcost
