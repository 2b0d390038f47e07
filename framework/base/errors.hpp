// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace leastcost {

/// Root of everything the library throws on purpose. A numerical outcome is never an exception: it is a value in
/// a report. An exception means that the question could not be asked.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An option has a value that cannot work. `key` is the path of the option below the object that was being built
/// ("matrix", "box.lower"); the application adds file, line and column.
class OptionError : public Error {
 public:
  OptionError(std::string key, const std::string& message) : Error(message), key_(std::move(key)) {}
  const std::string& key() const { return key_; }  ///< the option at fault, with dots: "ends.source.point"

 private:
  std::string key_;
};

/// Input data (a file, a mesh, an end point) is unreadable or invalid. The message names the place (file:line or
/// element numbers), what was found and what would be right.
class InputError : public Error {
 public:
  using Error::Error;
};

/// No first path could be made: ends in different components, a cost that stays infinite. The message says what
/// was tried.
class InitializationError : public Error {
 public:
  using Error::Error;
};

/// A deadline has passed, or somebody asked to stop, before there was a result. Thrown by parts of a search (an
/// Initializer, a PostProcessor, a long pass over a path); find_path() turns it into Status::interrupted, a Solver into
/// Termination::time_limit.
class Interrupted : public Error {
 public:
  using Error::Error;
};

}  // namespace leastcost
