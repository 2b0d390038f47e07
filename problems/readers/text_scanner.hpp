// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <leastcost/framework/base/deadline.hpp>

namespace leastcost {

/// The token as it may appear in a message: in quotes, shortened, without control characters.
std::string printable(std::string_view token);
/// Without the blanks before it and after it.
std::string_view trimmed(std::string_view text);

/// Walks through text line by line, token by token, and knows where it is. Lines end with LF, CR LF or CR; blanks
/// separate tokens; a comment runs from its character to the end of the line; lines without a token are skipped.
class TextScanner {
 public:
  struct Syntax {
    char comment = '#';         ///< 0: none
    bool continuation = false;  ///< a backslash before the end of a line joins the next line to it
  };

  /// `text` must outlive the scanner. `file` is for messages. After the deadline next_line() throws Interrupted.
  TextScanner(std::string_view text, std::string file, Syntax syntax, const Deadline& deadline = {});

  /// Leaves the rest of the present line and goes to the next one that has a token; false at the end of the text.
  bool next_line();
  /// The next token of the present line; empty at its end.
  std::string_view token();
  /// True when the present line has no further token.
  bool at_line_end();

  /// The next token as a finite number. `what` says what it should be, for the message.
  double number(const char* what);
  std::int64_t integer(const char* what);
  /// Turns a token into a finite number or an integer, or fails.
  double parse_number(std::string_view token, const char* what) const;
  std::int64_t parse_integer(std::string_view token, const char* what) const;
  /// Fails unless the line is used up.
  void expect_line_end(const char* after);

  std::size_t line() const { return line_; }
  std::size_t bytes_left() const { return text_.size() - at_; }
  /// Start of the next line, as an offset into the text.
  std::size_t next_line_offset() const;

  /// Throws InputError("file:line: message").
  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail_at(std::size_t line, const std::string& message) const;

 private:
  void skip_blanks();
  bool at_break(std::size_t i) const { return i == text_.size() || text_[i] == '\n' || text_[i] == '\r'; }
  bool joins_lines(std::size_t i) const { return syntax_.continuation && text_[i] == '\\' && at_break(i + 1); }
  std::size_t after_break(std::size_t i) const;

  std::string_view text_;
  std::string file_;
  Syntax syntax_;
  Deadline deadline_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;  // 0: before the first line
};

}  // namespace leastcost
