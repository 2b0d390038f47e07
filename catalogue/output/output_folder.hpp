// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <leastcost/catalogue/output/write_run.hpp>

namespace leastcost {

/// Why results may not be put somewhere.
struct OutputRefusal {
  std::string reason;        ///< empty: they may
  bool replaceable = false;  ///< all that is there an earlier run left
  bool empty() const { return reason.empty(); }
};

/// Results may be put where nothing is, or an empty folder. With `force` also where an earlier run has written, unless
/// there is a file that no run of ours wrote.
OutputRefusal output_refusal(const std::filesystem::path& target, bool force);

/// Whether runs or studies write files of this name.
bool is_result_file(const std::filesystem::path& file);

/// Writes a file that appears complete or not at all, in the place of one that is there. Throws OutputError.
void write_whole_file(const std::filesystem::path& file, const std::string& content);

/// A folder of results that appears complete or not at all: written beside its place under a temporary name, then
/// renamed. What is there already is kept until that moment, and is replaced only if it is what was there at first.
class OutputFolder {
 public:
  /// Makes the temporary folder, so that a place that cannot be written is found out before a long run. Throws
  /// OutputRefused when `target` is not empty, unless `force` is set and it holds a manifest of ours.
  OutputFolder(const std::filesystem::path& target, bool force);
  /// Without commit() or leave(): removes what was written.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where it will be, absolute.
  const std::filesystem::path& target() const { return target_; }
  /// Where it is until commit(), for whoever makes a file out of others.
  const std::filesystem::path& staging() const { return temporary_; }
  /// Adds a file, or replaces one. Throws OutputError when it could not be written to the end; an earlier one of this
  /// name is then still there.
  void write(const std::string& name, const std::string& content);
  /// Puts the folder in its place, which is looked at again. Throws OutputRefused when something has appeared there,
  /// and OutputError; what was written is then kept where the message says.
  void commit();
  /// Gives up the place, but not the files: "; what could be written lies in ...", or nothing where there are none.
  std::string leave();

 private:
  [[noreturn]] void keep(const std::string& reason, bool refused);
  void replace();
  void put_back(const std::filesystem::path& old);

  std::filesystem::path target_, temporary_;
  bool force_ = false;
  bool done_ = false;     ///< the temporary folder is not ours to remove any more
  std::string replaced_;  ///< which folder --force may replace, see identity(); empty: none
};

}  // namespace leastcost
