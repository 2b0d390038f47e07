// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "tests/support/data.hpp"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;

// Set by tests/CMakeLists.txt.
constexpr std::string_view kProjectDir = LEASTCOST_TEST_PROJECT_DIR;
constexpr std::string_view kProgram = LEASTCOST_TEST_PROGRAM;
constexpr std::string_view kSkipRecord = LEASTCOST_TEST_SKIP_RECORD;

std::string environment(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): tests do not change the environment
  return value == nullptr ? std::string() : std::string(value);
}

bool is_file(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored);
}

std::string current_test() { return Catch::getResultCapture().getCurrentTestName(); }

}  // namespace

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::filesystem::path project_dir() { return kProjectDir; }

std::filesystem::path program() { return kProgram; }

void record_skip(std::string_view what, std::string_view why) {
  std::ostringstream line;  // written at once, because test programs run at the same time
  line << current_test() << '\t' << what << '\t' << why << '\n';
  std::cout << "skipped: " << line.str() << std::flush;
  std::ofstream record{fs::path(kSkipRecord), std::ios::app};
  record << line.str() << std::flush;
}

std::optional<std::filesystem::path> data_file(std::string_view relative) {
  const std::string chosen = environment("LEASTCOST_DATA");
  const fs::path root = chosen.empty() ? (project_dir() / "../shared/data").lexically_normal() : fs::path(chosen);
  const fs::path file = root / relative;
  if (is_file(file)) return file;
  record_skip(relative, "not in the shared data (set LEASTCOST_DATA to its folder)");
  return std::nullopt;
}

std::optional<std::filesystem::path> installed_model(std::string_view relative) {
  const std::string chosen = environment("XDG_DATA_DIRS");
  std::istringstream folders(chosen.empty() ? "/usr/local/share:/usr/share" : chosen);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder) / relative;
    if (!folder.empty() && is_file(file)) return file;
  }
  record_skip(relative, "not installed (./leastcost test installs it through apt)");
  return std::nullopt;
}

ScratchDir::ScratchDir() {
  std::string name = (fs::temp_directory_path() / "leastcost-test-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder below the temporary folder");
  path_ = name;
}

ScratchDir::~ScratchDir() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace leastcost::test
