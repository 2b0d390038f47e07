// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {

/// A place in a configuration file or in an argument of the command line.
struct Place {
  int line = 0;        ///< from 1; 0: the input as a whole
  int column = 0;      ///< from 1, bytes
  int length = 1;      ///< bytes to underline
  std::string origin;  ///< the argument ("--set a.b=v"); empty: the file
};

/// An error of a configuration, and where it is.
struct Diagnostic {
  Place place;          ///< line and column, or the path of the key
  std::string message;  ///< what is wrong, and what would be right
};

/// The errors of one configuration, collected so that a user sees all of them at once, in compiler style:
///
///     torus.yaml:12:5: error: unknown key 'max_iter' in solver (did you mean 'max_iterations'?)
///        12 |     max_iter: 200
///           |     ^~~~~~~~
class Diagnostics {
 public:
  /// `file`: the name to print; `text`: its content, for the source lines.
  Diagnostics(std::string file, std::string_view text);

  /// The first hundred are kept, the others counted.
  void error(const Place& place, std::string message);
  bool empty() const { return count_ == 0; }  ///< whether nothing was wrong
  /// Errors, kept or not.
  std::size_t size() const { return count_; }
  const std::string& file() const { return file_; }  ///< the configuration that is spoken of
  /// Those that are kept, in the order of the file; what came from the command line last.
  std::vector<Diagnostic> sorted() const;
  /// The same with their source lines, without the count.
  std::string render(bool color = false) const;
  /// "2 errors in torus.yaml", "60000 errors in torus.yaml, of which the first 100 are shown".
  std::string count() const;
  /// "torus.yaml:12:5", or the argument of the command line.
  std::string where(const Place& place) const;

 private:
  std::string excerpt(const Place& place) const;

  std::string file_;
  std::vector<std::string> lines_;
  std::vector<Diagnostic> errors_;
  std::size_t count_ = 0;
};

/// The configuration is not valid. what() is the rendered list with its count.
class ConfigError : public Error {
 public:
  explicit ConfigError(Diagnostics diagnostics)
      : Error(diagnostics.render() + diagnostics.count()), diagnostics_(std::move(diagnostics)) {}
  const Diagnostics& diagnostics() const { return diagnostics_; }  ///< all errors, each with its place

 private:
  Diagnostics diagnostics_;
};

/// `text` in single quotes, shortened, control characters made visible: safe to print on a terminal.
std::string in_quotes(std::string_view text);

}  // namespace leastcost
