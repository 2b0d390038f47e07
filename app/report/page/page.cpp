// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/page/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/plot/chart.hpp"
#include "app/plot/text.hpp"

namespace leastcost::app {
namespace {

/// Characters before and after the decimal point; what is not a digit counts as well.
struct Parts {
  std::size_t before = 0, after = 0;
  bool point = false;
};

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Whether a cell of a number column holds a number; words stand on the left of it.
bool is_number(const std::string& text) {
  return text.empty() || (text[0] >= '0' && text[0] <= '9') || text.starts_with("-") || text.starts_with("−") ||
         text.starts_with("∞") || text.starts_with("≥");
}

Parts parts_of(const std::string& text) {
  if (!is_number(text)) return {};
  const std::size_t dot = text.find('.');
  if (dot == std::string::npos) return {characters(text), 0, false};
  return {dot, characters(std::string_view(text).substr(dot + 1)), true};
}

/// Puts figure spaces (as wide as a digit) behind shorter fractions: aligned to the right, the points stand below each
/// other.
std::string aligned(const std::string& text, std::size_t longest) {
  if (!is_number(text)) return text;
  const Parts parts = parts_of(text);
  std::string out = text;
  if (longest > 0 && !parts.point) out += "\u2008";  // as wide as a point
  for (std::size_t i = parts.after; i < longest; ++i) out += "\u2007";
  return out;
}

/// Of a column; zero with powers of ten in it, where points below each other would say nothing.
std::size_t longest_fraction(const Table& table, std::size_t column) {
  std::size_t longest = 0;
  for (const std::vector<Cell>& row : table.rows) {
    if (column >= row.size()) continue;
    if (row[column].text.find("×") != std::string::npos) return 0;
    longest = std::max(longest, parts_of(row[column].text).after);
  }
  return longest;
}

std::string attribute(const char* name, const std::string& value) {
  return value.empty() ? "" : fmt::format(" {}=\"{}\"", name, escaped(value));
}

}  // namespace

std::string html(const Table& table) {
  std::vector<std::size_t> fraction(table.columns.size(), 0);
  for (std::size_t c = 0; c < table.columns.size(); ++c) fraction[c] = longest_fraction(table, c);
  std::string out = fmt::format("<div class=\"scroll\"><table{}>\n", attribute("class", table.style));
  const bool titled =
      std::any_of(table.columns.begin(), table.columns.end(), [](const Column& c) { return !c.title.empty(); });
  out += titled ? "<thead><tr>" : "<tbody>\n";
  for (const Column& c : table.columns) {
    if (!titled) break;
    out += fmt::format("<th scope=\"col\"{}{}>{}</th>", c.number ? " class=\"n\"" : "", attribute("title", c.hover),
                       escaped(c.title));
  }
  if (titled) out += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) {
      const bool number = table.columns[c].number && is_number(row[c].text);
      const std::string kind = number ? "n" : table.columns[c].number ? "w" : "";
      const std::string style = kind.empty() || row[c].style.empty() ? kind + row[c].style : kind + " " + row[c].style;
      out += fmt::format("<td{}{}>{}</td>", attribute("class", style), attribute("title", row[c].hover),
                         escaped(number ? aligned(row[c].text, fraction[c]) : row[c].text));
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string section(const std::string& title, const std::string& body, bool open) {
  return fmt::format("<details{}><summary><h2>{}</h2></summary>\n{}</details>\n", open ? " open" : "", escaped(title),
                     body);
}

std::string paragraph(const std::string& text, const std::string& style) {
  return fmt::format("<p{}>{}</p>\n", attribute("class", style), escaped(text));
}

std::string figures(const std::vector<std::string>& svgs, const std::string& caption) {
  std::string out = "<figure><div class=\"row\">\n";
  for (const std::string& svg : svgs) out += svg;
  out += "</div>\n";
  if (!caption.empty()) out += fmt::format("<figcaption>{}</figcaption>\n", escaped(caption));
  return out + "</figure>\n";
}

std::string key_figures(const std::vector<KeyFigure>& figures) {
  std::string out = "<dl class=\"key\">\n";
  for (const KeyFigure& f : figures)
    out += fmt::format("<div><dt>{}</dt><dd>{}<small>{}</small></dd></div>\n", escaped(f.name), escaped(f.value),
                       escaped(f.detail));
  return out + "</dl>\n";
}

std::string page(const Headline& headline, const std::string& body, const std::string& after) {
  std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  out += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  // Nothing may be asked for; an empty icon keeps browsers from asking for theirs.
  out +=
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data: blob:; style-src "
      "'unsafe-inline'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; worker-src blob:\">\n<link rel=\"icon\" "
      "href=\"data:,\">\n";
  out += fmt::format("<title>{} – leastcost {}</title>\n<style>\n{}{}</style>\n</head>\n<body>\n<main>\n",
                     escaped(headline.title), escaped(headline.kind), page_style(), plot_style());
  out += fmt::format("<header>\n<p class=\"kind\">leastcost {}</p>\n<h1>{}</h1>\n<p class=\"about\">{}</p>\n",
                     escaped(headline.kind), escaped(headline.title), escaped(headline.about));
  if (!headline.verdict.empty())
    out += fmt::format("<p class=\"verdict {}\">{}</p>\n", escaped(headline.style), escaped(headline.verdict));
  return out + "</header>\n" + body + "</main>\n" + after + "</body>\n</html>\n";
}

}  // namespace leastcost::app
