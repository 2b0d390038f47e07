// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <leastcost/framework/errors.hpp>

namespace leastcost {

/// The output folder cannot be used or written.
class OutputError : public Error {
 public:
  using Error::Error;
};

/// The folder exists and may not be replaced.
class OutputRefused : public OutputError {
 public:
  using OutputError::OutputError;
};

/// Why results may not be put into `target`: it is not empty, and `force` is not set or it holds no manifest of ours.
/// Empty when they may.
std::string output_refusal(const std::filesystem::path& target, bool force);

/// Writes a file that appears complete or not at all, in the place of one that is there. Throws OutputError.
void write_whole_file(const std::filesystem::path& file, const std::string& content);

/// A folder of results that appears complete or not at all: written beside its place under a temporary name, then
/// renamed. What is there already is kept until that moment.
class OutputFolder {
 public:
  /// Makes the temporary folder, so that a place that cannot be written is found out before a long run. Throws
  /// OutputRefused when `target` is not empty, unless `force` is set and it holds a manifest of ours.
  OutputFolder(const std::filesystem::path& target, bool force);
  /// Without commit(): removes what was written.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where it will be, absolute.
  const std::filesystem::path& target() const { return target_; }
  /// Where it is until commit(), for whoever makes a file out of others.
  const std::filesystem::path& staging() const { return temporary_; }
  /// Adds a file. Throws OutputError when it could not be written to the end.
  void write(const std::string& name, const std::string& content);
  /// Puts the folder in its place. Throws OutputError.
  void commit();

 private:
  std::filesystem::path target_, temporary_;
  bool committed_ = false;
};

}  // namespace leastcost
