// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/catalogue/yaml/diagnostics.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace leastcost {
namespace {

constexpr std::size_t kMostKept = 100;
constexpr std::size_t kWidestExcerpt = 160;  // bytes of a source line that are shown

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }
bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);  // a byte order mark is not part of its line
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    lines.emplace_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// Terminals must not be steered by what a file contains.
std::string printable(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (is_control(c) && c != '\t') c = '?';
  return out;
}

/// Blanks as wide as `text`; tabs stay, so that the caret stands right whatever the width of a tab.
std::string blanks_for(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (!continues_character(c)) out += c == '\t' ? '\t' : ' ';
  return out;
}

std::size_t characters_in(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !continues_character(c); }));
}

}  // namespace

Diagnostics::Diagnostics(std::string file, std::string_view text) : file_(std::move(file)), lines_(split_lines(text)) {}

void Diagnostics::error(const Place& place, std::string message) {
  const auto is_this = [&](const Diagnostic& d) {
    return d.message == message && d.place.line == place.line && d.place.column == place.column;
  };
  if (!errors_.empty() && is_this(errors_.back())) return;  // two parts have read one file
  if (count_++ < kMostKept) errors_.push_back({place, std::move(message)});
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  std::vector<Diagnostic> out = errors_;
  std::stable_sort(out.begin(), out.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tuple(!a.place.origin.empty(), a.place.line, a.place.column) <
           std::tuple(!b.place.origin.empty(), b.place.line, b.place.column);
  });
  return out;
}

std::string Diagnostics::where(const Place& place) const {
  if (!place.origin.empty()) return printable(place.origin);
  if (place.line == 0) return file_;
  return fmt::format("{}:{}:{}", file_, place.line, place.column);
}

std::string Diagnostics::excerpt(const Place& place) const {
  if (!place.origin.empty() || place.line < 1 || static_cast<std::size_t>(place.line) > lines_.size()) return "";
  const std::string& line = lines_[static_cast<std::size_t>(place.line - 1)];
  const std::size_t column = std::min(static_cast<std::size_t>(std::max(place.column - 1, 0)), line.size());
  std::size_t first = 0;
  if (line.size() > kWidestExcerpt && column > kWidestExcerpt / 2) first = column - kWidestExcerpt / 2;
  while (first > 0 && continues_character(line[first])) --first;
  const std::string shown = printable(std::string_view(line).substr(first, kWidestExcerpt));
  const std::size_t at = column - first;
  const std::string_view marked =
      std::string_view(shown).substr(at, static_cast<std::size_t>(std::max(place.length, 1)));
  const std::size_t width = std::max<std::size_t>(characters_in(marked), 1);
  return fmt::format("{:>5} | {}\n      | {}^{}\n", place.line, shown,
                     blanks_for(std::string_view(shown).substr(0, at)), std::string(width - 1, '~'));
}

std::string Diagnostics::render(bool color) const {
  std::string out;
  for (const Diagnostic& e : sorted()) {
    const std::string_view label = color ? "\033[1;31merror:\033[0m" : "error:";
    out += fmt::format("{}: {} {}\n{}", where(e.place), label, e.message, excerpt(e.place));
  }
  return out;
}

std::string Diagnostics::count() const {
  std::string text = fmt::format("{} error{} in {}", count_, count_ == 1 ? "" : "s", file_);
  if (count_ > errors_.size()) text += fmt::format(", of which the first {} are shown", errors_.size());
  return text;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string shown = printable(text.substr(0, kLongest));
  std::replace(shown.begin(), shown.end(), '\t', ' ');
  if (text.size() > kLongest) {
    while (!shown.empty() && continues_character(text[shown.size()])) shown.pop_back();
    shown += "...";
  }
  return "'" + shown + "'";
}

}  // namespace leastcost
