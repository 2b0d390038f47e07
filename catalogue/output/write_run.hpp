// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <leastcost/catalogue/run/run.hpp>
#include <leastcost/framework/base/errors.hpp>

namespace leastcost {

/// The machine does not give what is needed: a place on the disk, a permission, a process.
class HostError : public Error {
 public:
  using Error::Error;
};

/// The output folder cannot be used or written.
class OutputError : public HostError {
 public:
  using HostError::HostError;
};

/// The folder exists and may not be replaced.
class OutputRefused : public OutputError {
 public:
  explicit OutputRefused(const std::string& message, bool replaceable = false)
      : OutputError(message), replaceable_(replaceable) {}
  /// It holds what an earlier run left and nothing else: WriteOptions::replace would replace it.
  bool replaceable() const { return replaceable_; }

 private:
  bool replaceable_;
};

struct WriteOptions {
  bool replace = false;  ///< a folder that an earlier run has written, as it is when write_run() begins
  std::vector<std::string> arguments = {};  ///< how the program was called, for manifest.json
};

/// Writes the files of a finished run into `folder` (relative to the current one), which appears complete or not at
/// all: result.json, path.*, curve.csv, history.csv, first_path.csv, scene.json, config.resolved.yaml, manifest.json,
/// and waypoints.csv where they were asked for.
/// Returns where they are, absolute. Throws OutputRefused when the folder is not empty and may not be replaced,
/// OutputError; what was written by then stays beside the folder, where the message says.
std::filesystem::path write_run(const RunOutcome& outcome, const std::filesystem::path& folder,
                                const WriteOptions& options = {});

/// The text of result.json.
std::string result_json(const RunOutcome& outcome);

}  // namespace leastcost
