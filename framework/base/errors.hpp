// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <leastcost/framework/base/said_of.hpp>

namespace leastcost {

/// Root of everything the library throws on purpose. A numerical outcome is never an exception: it is a value in
/// a report. An exception means that the question could not be asked.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An option has a value that cannot work. what() is a sentence about it, "memory must be at least 1, not 0"; key() and
/// reason() are its two halves, for an application that adds file, line and column.
class OptionError : public Error {
 public:
  /// `key`: the path of the option below the object that was being built ("matrix", "box.lower"); empty: the object
  /// itself. `reason` begins with its verb where it can ("must be ...", see said_of()).
  OptionError(std::string key, std::string reason)
      : Error(key.empty() ? reason : said_of(key, reason)), key_(std::move(key)), reason_(std::move(reason)) {}
  const std::string& key() const { return key_; }        ///< the option at fault, with dots: "ends.source.point"
  const std::string& reason() const { return reason_; }  ///< what() without the key

  /// The same error for who built the object from the options under `block`: "matrix" becomes "metric.matrix".
  OptionError under(const std::string& block) const { return {key_.empty() ? block : block + "." + key_, reason_}; }

 private:
  std::string key_;
  std::string reason_;
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
