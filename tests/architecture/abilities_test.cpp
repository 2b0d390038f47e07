// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// One mechanism for abilities (docs/design.md Sec. 2): objects are asked for their type in framework/ability.hpp alone,
// and what composes, places, draws and writes asks no domain by name.
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;

/// The lines below root/folder that match, "file:line: text" each, but for those of `except`.
std::string matches(const fs::path& root, const std::string& folder, const std::regex& pattern,
                    const std::string& except = "") {
  std::string found;
  if (!fs::exists(root / folder)) return found;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string extension = entry.path().extension().string();
    const std::string name = fs::relative(entry.path(), root).generic_string();
    if (!entry.is_regular_file() || (extension != ".hpp" && extension != ".cpp") || name == except) continue;
    std::ifstream in(entry.path());
    std::string text;
    for (int line = 1; std::getline(in, text); ++line)
      if (std::regex_search(text, pattern)) found += name + ":" + std::to_string(line) + ": " + text + "\n";
  }
  return found;
}

std::string casts(const fs::path& root) {
  static const std::regex cast("dynamic_(pointer_)?cast\\b");
  std::string found;
  for (const char* layer : {"framework", "problems", "solvers", "recipes", "catalogue", "app"})
    found += matches(root, layer, cast, "framework/base/ability.hpp");
  return found;
}

/// Includes of rooms about one sort of domain.
std::string domains_by_name(const fs::path& root) {
  static const std::regex room(
      "#include.*problems/(mesh/|cloud/|distance/(?!build_progress)|level_set/)|#include.*problems/manifolds/(data/)?"
      "(box|chart|constraint|euclidean|implicit|level_set|mesh|parametric|point_cloud|signed)");
  std::string found;
  for (const char* folder : {"catalogue/config", "catalogue/run", "catalogue/scene", "catalogue/output",
                             "catalogue/options", "app/run", "app/report", "app/study", "app/reference"})
    found += matches(root, folder, room);
  return found;
}

void write_planted(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

}  // namespace

TEST_CASE("abilities: one place asks objects for their type") {
  CHECK(casts(project_dir()) == "");
  CHECK(matches(project_dir(), "framework", std::regex("dynamic_cast")) != "");  // the check has something to check
}

TEST_CASE("abilities: what composes, places, draws and writes names no domain") {
  CHECK(domains_by_name(project_dir()) == "");
}

TEST_CASE("abilities: a second cast and a domain by name are caught") {
  const ScratchDir tree;
  write_planted(tree / "framework/base/ability.hpp", "dynamic_cast<const A*>(object)\n");
  write_planted(tree / "problems/mesh/has_mesh.hpp", "#include <leastcost/problems/cloud/point_cloud.hpp>\n");
  CHECK(casts(tree.path()) + domains_by_name(tree.path()) == "");
  write_planted(tree / "solvers/a.cpp", "\nif (dynamic_cast<const HasChart*>(&manifold)) return;\n");
  CHECK_THAT(casts(tree.path()), Catch::Contains("solvers/a.cpp:2: if (dynamic_cast"));
  write_planted(tree / "app/run/b.cpp", "std::dynamic_pointer_cast<const HasMesh>(manifold);\n");
  CHECK_THAT(casts(tree.path()), Catch::Contains("app/run/b.cpp:1"));
  write_planted(tree / "catalogue/scene/scene.cpp", "#include <leastcost/problems/mesh/has_mesh.hpp>\n");
  CHECK_THAT(domains_by_name(tree.path()), Catch::Contains("catalogue/scene/scene.cpp:1"));
}

}  // namespace leastcost::test
