// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The arrows of docs/design.md Sec. 2, read off the #include lines. What counts is the text: a condition around an
// include does not hide it.
#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;

struct Include {
  std::string file;  ///< relative to the root, '/' between folders
  int line = 0;
  std::string target;   ///< as written
  bool quoted = false;  ///< "..." rather than <...>
};

constexpr std::array<std::string_view, 4> kLayers = {"framework", "problems", "solvers", "app"};

bool starts_with(std::string_view text, std::string_view prefix) { return text.substr(0, prefix.size()) == prefix; }

std::string first_folders(const std::string& path, int count) {
  std::size_t end = 0;
  for (int i = 0; i < count; ++i) {
    end = path.find('/', end == 0 ? 0 : end + 1);
    if (end == std::string::npos) return "";
  }
  return path.substr(0, end);
}

bool is_header(const std::string& file) { return fs::path(file).extension() == ".hpp"; }

std::vector<Include> includes_of(const fs::path& root, const fs::path& file) {
  static const std::regex pattern(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
  std::vector<Include> found;
  std::ifstream in(file);
  std::string text;
  std::smatch match;
  for (int line = 1; std::getline(in, text); ++line) {
    if (!std::regex_search(text, match, pattern)) continue;
    found.push_back({fs::relative(file, root).generic_string(), line, match[2].str(), match[1].str() == "\""});
  }
  return found;
}

std::vector<fs::path> sources_below(const fs::path& folder) {
  std::vector<fs::path> found;
  if (!fs::exists(folder)) return found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (entry.is_regular_file() && (extension == ".hpp" || extension == ".cpp")) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Include> all_includes(const fs::path& root) {
  std::vector<Include> all;
  for (const std::string_view layer : kLayers) {
    for (const fs::path& file : sources_below(root / layer)) {
      for (Include& include : includes_of(root, file)) all.push_back(std::move(include));
    }
  }
  return all;
}

/// A layer may include itself and the layers listed here.
const std::map<std::string, std::set<std::string>>& arrows() {
  static const std::map<std::string, std::set<std::string>> table = {{"framework", {}},
                                                                     {"problems", {"framework"}},
                                                                     {"solvers", {"framework"}},
                                                                     {"app", {"framework", "problems", "solvers"}}};
  return table;
}

/// Why a third-party header (a name with a folder or an extension; the standard library has neither) may not stand
/// there; empty when it may.
std::string third_party_fault(const Include& include) {
  const std::string& file = include.file;
  const std::string& target = include.target;
  if (starts_with(target, "Eigen/")) return "";
  if (starts_with(file, "framework/")) return "framework uses Eigen and the standard library only";
  if (starts_with(target, "ceres/") || starts_with(target, "glog/"))
    return starts_with(file, "solvers/ceres/") && file != "solvers/ceres/ceres_solver.hpp"
               ? ""
               : "only solvers/ceres uses Ceres, and not in its installed header";
  if (starts_with(target, "nlopt"))
    return starts_with(file, "solvers/nlopt/") && file != "solvers/nlopt/nlopt_solver.hpp"
               ? ""
               : "only solvers/nlopt uses NLopt, and not in its installed header";
  if (!starts_with(file, "app/") && is_header(file)) return "an installed header includes no third party but Eigen";
  if (starts_with(target, "boost/") || target == "nanoflann.hpp") {
    return starts_with(file, "problems/geometry/") ? ""
                                                   : "only .cpp files of problems/geometry use Boost and nanoflann";
  }
  if (starts_with(target, "yaml-cpp/")) return starts_with(file, "app/config/") ? "" : "only app/config uses yaml-cpp";
  return starts_with(file, "app/") ? "" : "framework, problems and solvers know no such third party";
}

std::string own_fault(const Include& include) {
  const std::string from = first_folders(include.file, 1);
  const std::string to = first_folders(include.target, 1);
  if (arrows().count(to) == 0) return "is no folder of the tree; includes are written from the root";
  if (from != to && arrows().at(from).count(to) == 0) return from + " must not include " + to;
  if (from != "problems" || to != "problems") return "";
  const std::string from_part = first_folders(include.file, 2);
  const std::string to_part = first_folders(include.target, 2);
  // geometry stands alone, the readers stand on it, plug-ins on both.
  const bool base = from_part == "problems/geometry" || from_part == "problems/readers";
  if (from_part == to_part || to_part == "problems/geometry" || (to_part == "problems/readers" && !base)) return "";
  return from_part + " must not include " + to_part + ": what they share lies in problems/geometry";
}

std::string fault(const Include& include) {
  if (include.quoted) return own_fault(include);
  const bool standard = include.target.find_first_of("/.") == std::string::npos;
  const bool posix = starts_with(include.target, "sys/") || include.target == "unistd.h" || include.target == "fcntl.h";
  return standard || (posix && starts_with(include.file, "app/")) ? "" : third_party_fault(include);
}

/// A cycle among the files of the tree as "a -> b -> a", or nothing.
class CycleSearch {
 public:
  explicit CycleSearch(const std::vector<Include>& includes) {
    for (const Include& include : includes) {
      if (include.quoted) graph_[include.file].push_back(include.target);
    }
  }

  std::string find() {
    for (const auto& [file, unused] : graph_) {
      if (visit(file)) return cycle_;
    }
    return "";
  }

 private:
  bool visit(const std::string& file) {
    const auto open = std::find(trail_.begin(), trail_.end(), file);
    if (open != trail_.end()) {
      for (auto it = open; it != trail_.end(); ++it) cycle_ += *it + " -> ";
      cycle_ += file;
      return true;
    }
    if (!done_.insert(file).second) return false;
    trail_.push_back(file);
    const auto edges = graph_.find(file);
    if (edges != graph_.end()) {
      for (const std::string& next : edges->second) {
        if (visit(next)) return true;
      }
    }
    trail_.pop_back();
    return false;
  }

  std::map<std::string, std::vector<std::string>> graph_;
  std::set<std::string> done_;
  std::vector<std::string> trail_;
  std::string cycle_;
};

/// Every fault of the tree below `root`, one per line, in compiler style; empty when the layers are clean.
std::string layer_faults(const fs::path& root) {
  std::ostringstream report;
  const std::vector<Include> includes = all_includes(root);
  for (const Include& include : includes) {
    const std::string reason = fault(include);
    if (!reason.empty())
      report << include.file << ':' << include.line << ": " << include.target << ": " << reason << '\n';
  }
  const std::string cycle = CycleSearch(includes).find();
  if (!cycle.empty()) report << "include cycle: " << cycle << '\n';
  return report.str();
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

}  // namespace

TEST_CASE("layers: no include outside the table of the design") {
  REQUIRE(all_includes(project_dir()).size() > 10);  // the check has something to check
  CHECK(layer_faults(project_dir()) == "");
}

TEST_CASE("layers: every wrong arrow is caught") {
  struct Wrong {
    const char* file;
    const char* line;
    const char* reason;
  };
  const Wrong wrong = GENERATE(
      Wrong{"framework/a.hpp", "#include \"problems/geometry/b.hpp\"", "framework must not include problems"},
      Wrong{"framework/a.hpp", "#include \"solvers/b.hpp\"", "framework must not include solvers"},
      Wrong{"framework/a.hpp", "#include <boost/graph/graph_traits.hpp>", "framework uses Eigen"},
      Wrong{"framework/a.cpp", "#include <fmt/format.h>", "framework uses Eigen"},
      Wrong{"solvers/a.cpp", "#include \"problems/costs/b.hpp\"", "solvers must not include problems"},
      Wrong{"problems/costs/a.cpp", "#include \"solvers/b.hpp\"", "problems must not include solvers"},
      Wrong{"problems/costs/a.cpp", "  #  include \"app/b.hpp\"", "problems must not include app"},
      Wrong{"problems/costs/a.cpp", "#include \"problems/manifolds/b.hpp\"", "must not include problems/manifolds"},
      Wrong{"problems/geometry/a.cpp", "#include \"problems/readers/b.hpp\"", "must not include problems/readers"},
      Wrong{"problems/costs/a.cpp", "#include \"b.hpp\"", "written from the root"},
      Wrong{"problems/costs/a.cpp", "#include <boost/graph/astar_search.hpp>", "problems/geometry"},
      Wrong{"problems/geometry/a.hpp", "#include <boost/graph/astar_search.hpp>", "installed header"},
      Wrong{"problems/readers/a.cpp", "#include <yaml-cpp/yaml.h>", "app/config"},
      Wrong{"app/run.cpp", "#include <yaml-cpp/yaml.h>", "app/config"},
      Wrong{"solvers/lbfgs.cpp", "#include <ceres/ceres.h>", "only solvers/ceres"},
      Wrong{"solvers/ceres/ceres_solver.hpp", "#include <ceres/ceres.h>", "installed header"},
      Wrong{"solvers/lbfgs.cpp", "#include <nlopt.hpp>", "only solvers/nlopt"},
      Wrong{"solvers/nlopt/nlopt_solver.hpp", "#include <nlopt.hpp>", "installed header"},
      Wrong{"problems/costs/a.cpp", "#include <fmt/format.h>", "no such third party"},
      Wrong{"framework/a.hpp", "#include \"framework/a.hpp\"", "include cycle: framework/a.hpp -> framework/a.hpp"});
  const ScratchDir tree;
  write(tree / wrong.file, std::string("#include <vector>\n") + wrong.line + "\n");
  CAPTURE(wrong.line);
  CHECK_THAT(layer_faults(tree.path()), Catch::Contains(wrong.reason));
}

TEST_CASE("layers: a cycle through several files is caught, allowed arrows are not") {
  const ScratchDir tree;
  write(tree / "framework/path.hpp", "#include <Eigen/Core>\n#include <vector>\n");
  write(tree / "problems/geometry/graph.cpp", "#include <boost/graph/graph_traits.hpp>\n");
  write(tree / "problems/costs/cost.hpp", "#include \"framework/path.hpp\"\n#include \"problems/geometry/mesh.hpp\"\n");
  write(tree / "problems/geometry/mesh.hpp", "#include \"framework/path.hpp\"\n");
  write(tree / "solvers/solver.cpp", "#include \"framework/path.hpp\"\n");
  write(tree / "app/config/read.cpp", "#include <yaml-cpp/yaml.h>\n#include \"problems/costs/cost.hpp\"\n");
  CHECK(layer_faults(tree.path()) == "");

  write(tree / "framework/path.hpp", "#include \"framework/problem.hpp\"\n");
  write(tree / "framework/problem.hpp", "#include \"framework/path.hpp\"\n");
  CHECK_THAT(layer_faults(tree.path()), Catch::Contains("include cycle: framework/path.hpp -> framework/problem.hpp"));
}

}  // namespace leastcost::test
