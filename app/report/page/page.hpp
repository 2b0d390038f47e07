// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace leastcost::app {

/// One cell of a table. Its text is not HTML: it is escaped.
struct Cell {
  std::string text;
  std::string style = {};  ///< a class of the style sheet: good, bad, mild
  std::string hover = {};
};

struct Column {
  std::string title;
  bool number = false;  ///< aligned on the decimal point
  std::string hover = {};
};

/// A table of a page. Rows as long as there are columns.
struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
  std::string style = {};  ///< class
};
std::string html(const Table& table);

/// A part of a page that can be folded. `body` is HTML.
std::string section(const std::string& title, const std::string& body, bool open = true);
/// Paragraph of plain text.
std::string paragraph(const std::string& text, const std::string& style = "");
/// Drawings side by side, as many as fit.
std::string figures(const std::vector<std::string>& svgs, const std::string& caption = "");

/// One large figure of the headline.
struct KeyFigure {
  std::string name, value, detail;  ///< plain text
};
std::string key_figures(const std::vector<KeyFigure>& figures);

struct Headline {
  std::string kind;     ///< "run", "study"
  std::string title;    ///< its name
  std::string about;    ///< in a line
  std::string verdict;  ///< in a word or two
  std::string style;    ///< of the verdict: good, bad, mild
};

/// The whole document. `body` and `after` (scripts) are HTML.
std::string page(const Headline& headline, const std::string& body, const std::string& after);

/// The style sheet of all pages.
std::string page_style();

}  // namespace leastcost::app
