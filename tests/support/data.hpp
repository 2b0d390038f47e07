// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// Where tests find things. A test that needs a file which is not there leaves early:
///
///     const auto file = test::data_file("meshes/duck.obj");
///     if (!file) return;   // the reason is printed, and counted in the last ctest entry
namespace leastcost::test {

/// A file of the shared data set, `relative` to its root: the folder named by the environment variable
/// LEASTCOST_DATA, else ../shared/data beside the project. Without the file, records the skip and returns nothing.
std::optional<std::filesystem::path> data_file(std::string_view relative);

/// A model that a Debian package installs, `relative` to a data folder of the system (XDG_DATA_DIRS, else
/// /usr/local/share and /usr/share): "glmark2/models/bunny.obj". Without it, records the skip and returns nothing.
std::optional<std::filesystem::path> installed_model(std::string_view relative);

/// Prints that the running test case leaves something out, and why, and adds it to the record of this test run.
void record_skip(std::string_view what, std::string_view why);

/// Root of the source tree: `project_dir() / "configs"`.
std::filesystem::path project_dir();

/// The command line program of this build, or an empty path when it was not built.
std::filesystem::path program();

/// All of a file, byte by byte.
std::string content(const std::filesystem::path& file);

/// A new empty folder for the running test case, removed with the object.
class ScratchDir {
 public:
  ScratchDir();
  ~ScratchDir();
  ScratchDir(const ScratchDir&) = delete;
  ScratchDir& operator=(const ScratchDir&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(std::string_view relative) const { return path_ / relative; }

 private:
  std::filesystem::path path_;
};

}  // namespace leastcost::test
