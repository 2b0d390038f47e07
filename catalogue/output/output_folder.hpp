// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <leastcost/catalogue/output/write_run.hpp>

namespace leastcost {

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
  /// Puts the folder in its place, which is looked at again. Throws OutputRefused when something has appeared there
  /// that may not be replaced, and OutputError; what was written is then kept where the message says.
  void commit();

 private:
  [[noreturn]] void keep(const std::string& reason, bool refused);

  std::filesystem::path target_, temporary_;
  bool force_ = false;
  bool committed_ = false;
};

}  // namespace leastcost
