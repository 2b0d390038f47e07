// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The libraries that problems/ and recipes/ are divided into, as problems/CMakeLists.txt says: an include goes only to
// what the library is linked with.
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/architecture/includes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

/// Abilities and interfaces, headers without a source: who asks for them need not link their library.
const std::set<std::string>& interfaces() {
  static const std::set<std::string> headers = {"problems/mesh/has_mesh.hpp", "problems/obstacles/has_walls.hpp",
                                                "problems/obstacles/walls.hpp"};
  return headers;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), std::istream_iterator<std::string>()};
}

/// What problems/CMakeLists.txt says: the parts of each library but core, and the libraries that each is linked with.
struct Libraries {
  std::map<std::string, std::string> of_part;          ///< "problems/mesh" -> "mesh"
  std::map<std::string, std::set<std::string>> below;  ///< "planning" -> core, mesh

  explicit Libraries(const fs::path& list) {
    std::ifstream in(list);
    std::string text, line;
    while (std::getline(in, line)) text += line.substr(0, line.find('#')) + '\n';
    static const std::regex library(R"(leastcost_library\((\w+) NEEDS ([\w ]+?) (ONLY|ALSO) )");
    for (std::sregex_iterator it(text.begin(), text.end(), library), end; it != end; ++it)
      for (const std::string& need : words_of((*it)[2].str())) {
        std::set<std::string>& mine = below[(*it)[1].str()];
        mine.insert(need);
        if (const auto known = below.find(need); known != below.end())
          mine.insert(known->second.begin(), known->second.end());
      }
    static const std::regex parts(R"(set\((\w+)\s([^)]*)\))");
    for (std::sregex_iterator it(text.begin(), text.end(), parts), end; it != end; ++it)
      for (const std::string& part : words_of((*it)[2].str()))
        of_part[fs::path("problems/" + part).lexically_normal().generic_string()] = (*it)[1].str();
  }

  /// Empty for a file that is part of no such library.
  std::string of(const std::string& file) const {
    if (!starts_with(file, "problems/") && !starts_with(file, "recipes/")) return "";
    fs::path part = fs::path(file).replace_extension();
    const std::string name = part.filename().string();
    if (part.parent_path() == "problems") return below.count(name) == 1 ? name : "";  // <leastcost/problems/mesh.hpp>
    for (; !part.empty(); part = part.parent_path())
      if (const auto found = of_part.find(part.generic_string()); found != of_part.end()) return found->second;
    return "core";
  }

  std::string fault(const Include& include) const {
    const std::string from = of(include.file), to = include.own ? of(include.target) : "";
    if (from.empty() || to.empty() || from == to || interfaces().count(include.target) == 1) return "";
    return below.at(from).count(to) == 1 ? "" : from + " is not linked with " + to;
  }
};

const Libraries& libraries() {
  static const Libraries read(project_dir() / "problems/CMakeLists.txt");
  return read;
}

}  // namespace

TEST_CASE("libraries: no include outside what a library is linked with") {
  std::ostringstream faults;
  std::set<std::string> seen;
  for (const Include& include : all_includes(project_dir())) {
    seen.insert(libraries().of(include.file));
    const std::string reason = libraries().fault(include);
    if (!reason.empty())
      faults << include.file << ':' << include.line << ": " << include.target << ": " << reason << '\n';
  }
  CHECK(faults.str() == "");
  CHECK(seen == std::set<std::string>{"", "core", "mesh", "planning", "bounds"});
}

TEST_CASE("libraries: an arrow up or aside is caught") {
  struct Wrong {
    const char* file;
    const char* target;
    const char* reason;
  };
  const Wrong wrong = GENERATE(
      Wrong{"problems/costs/euclidean.cpp", "problems/mesh/triangle_mesh.hpp", "core is not linked with mesh"},
      Wrong{"problems/manifolds/box.hpp", "problems/robots/arm_models.hpp", "core is not linked with planning"},
      Wrong{"problems/costs/new_cost.cpp", "problems/bracket/front_heap.hpp", "core is not linked with bounds"},
      Wrong{"recipes/facts.cpp", "problems/post_processors/taut.hpp", "core is not linked with planning"},
      Wrong{"problems/distance/grid_bounds.cpp", "problems/obstacles/ball.hpp", "mesh is not linked with planning"},
      Wrong{"recipes/offers/mesh.cpp", "problems/post_processors/taut.hpp", "mesh is not linked with planning"},
      Wrong{"problems/taut/taut_path.cpp", "problems/post_processors/bracket.hpp",
            "planning is not linked with bounds"},
      Wrong{"problems/bracket/cells/net.hpp", "problems/mesh/weld.hpp", "bounds is not linked with mesh"});
  CAPTURE(wrong.file);
  CHECK(libraries().fault({wrong.file, 1, wrong.target, true, false}) == wrong.reason);
}

TEST_CASE("libraries: arrows down and interfaces are allowed") {
  const auto fault = [](const char* file, const char* target) {
    return libraries().fault({file, 1, target, true, false});
  };
  CHECK(fault("problems/obstacles/mesh_obstacle.cpp", "problems/mesh/closest_point.hpp") == "");
  CHECK(fault("problems/obstacles/outlines.cpp", "problems/drawing/draws_itself.hpp") == "");
  CHECK(fault("problems/post_processors/bracket.cpp", "problems/obstacles/has_walls.hpp") == "");
  CHECK(fault("problems/problems.hpp", "problems/planning.hpp") == "");
  CHECK(fault("catalogue/run/compose.cpp", "problems/robots/arm_models.hpp") == "");
  for (const std::string& header : interfaces())
    CHECK_FALSE(fs::exists((project_dir() / header).replace_extension(".cpp")));
}

}  // namespace leastcost::test
