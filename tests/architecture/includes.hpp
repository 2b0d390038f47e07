// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace leastcost::test {

namespace fs = std::filesystem;

struct Include {
  std::string file;  ///< relative to the root, '/' between folders
  int line = 0;
  std::string target;  ///< without the leading "leastcost/" of our own
  bool own = false;    ///< a file of the tree: "folder/file.hpp" or <leastcost/folder/file.hpp>
  bool open = false;   ///< written <leastcost/...>: installed
};

inline constexpr std::array<std::string_view, 10> kLayers = {"framework", "problems", "solvers", "recipes",   "ompl",
                                                             "gdal",      "urdf",     "octomap", "catalogue", "app"};

inline constexpr std::string_view kPublic = "leastcost/";

inline bool starts_with(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

inline std::string first_folders(const std::string& path, int count) {
  std::size_t end = 0;
  for (int i = 0; i < count; ++i) {
    end = path.find('/', end == 0 ? 0 : end + 1);
    if (end == std::string::npos) return "";
  }
  return path.substr(0, end);
}

inline bool is_header(const std::string& file) { return fs::path(file).extension() == ".hpp"; }

inline std::vector<Include> includes_of(const fs::path& root, const fs::path& file) {
  static const std::regex pattern(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
  std::vector<Include> found;
  std::ifstream in(file);
  std::string text;
  std::smatch match;
  for (int line = 1; std::getline(in, text); ++line) {
    if (!std::regex_search(text, match, pattern)) continue;
    const std::string target = match[2].str();
    if (target == "leastcost/version.hpp" || target == "leastcost/eigen_alignment.hpp") continue;  // made by CMake
    const bool open = match[1].str() == "<" && starts_with(target, kPublic);
    found.push_back({fs::relative(file, root).generic_string(), line, open ? target.substr(kPublic.size()) : target,
                     open || match[1].str() == "\"", open});
  }
  return found;
}

inline std::vector<fs::path> sources_below(const fs::path& folder) {
  std::vector<fs::path> found;
  if (!fs::exists(folder)) return found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (entry.is_regular_file() && (extension == ".hpp" || extension == ".cpp")) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

inline std::vector<Include> all_includes(const fs::path& root) {
  std::vector<Include> all;
  for (const std::string_view layer : kLayers) {
    for (const fs::path& file : sources_below(root / layer)) {
      for (Include& include : includes_of(root, file)) all.push_back(std::move(include));
    }
  }
  return all;
}

}  // namespace leastcost::test
