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

#include "tests/architecture/includes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Arrows = std::map<std::string, std::set<std::string>>;

/// A layer may include itself and the layers listed here.
const Arrows& layers() {
  static const Arrows table = {{"framework", {}},
                               {"problems", {"framework"}},
                               {"solvers", {"framework"}},
                               {"recipes", {"framework", "problems", "solvers"}},
                               {"ompl", {"framework", "problems", "solvers"}},
                               {"gdal", {"framework", "problems"}},
                               {"urdf", {"framework", "problems"}},
                               {"octomap", {"framework", "problems"}},
                               {"catalogue", {"framework", "problems", "solvers", "recipes"}},
                               {"app", {"framework", "problems", "solvers", "recipes", "catalogue"}}};
  return table;
}

/// A room inside a layer may include itself, what is below it, and the rooms listed here. docs/design.md says what each
/// is for. Rooms that are not listed here may not exist.
const Arrows& rooms() {
  static const std::set<std::string> subjects = {
      "problems/bracket",        "problems/chart",     "problems/cloud",     "problems/distance",
      "problems/drawing",        "problems/exact",     "problems/fields",    "problems/formula",
      "problems/graph",          "problems/layers",    "problems/cells",     "problems/level_set",
      "problems/mesh",           "problems/obstacles", "problems/occupancy", "problems/raster",
      "problems/readers",        "problems/robots",    "problems/section",   "problems/spline",
      "problems/straighten",     "problems/taut",      "problems/tensor",    "problems/bracket/cells",
      "problems/bracket/search", "problems/methods"};
  static const auto subjects_and = [](std::initializer_list<const char*> rooms) {
    std::set<std::string> all = subjects;
    all.insert(rooms.begin(), rooms.end());
    return all;
  };
  static const Arrows table = {
      {"framework/base", {}},
      {"framework/numbers", {}},
      {"framework/path", {}},
      {"framework/cost", {"framework/base", "framework/numbers", "framework/path"}},
      {"framework/domain", {"framework/base", "framework/numbers", "framework/path"}},
      {"framework/problem", {"framework/base", "framework/cost", "framework/domain", "framework/path"}},
      {"framework/energy", {"framework/base", "framework/domain", "framework/path", "framework/problem"}},
      {"framework/newton",
       {"framework/base", "framework/cost", "framework/domain", "framework/energy", "framework/path",
        "framework/problem"}},
      {"framework/proof",
       {"framework/base", "framework/cost", "framework/domain", "framework/newton", "framework/numbers",
        "framework/path", "framework/problem"}},
      {"framework/certificate",
       {"framework/base", "framework/cost", "framework/domain", "framework/energy", "framework/newton",
        "framework/path", "framework/problem", "framework/proof"}},
      {"framework/result",
       {"framework/base", "framework/certificate", "framework/domain", "framework/energy", "framework/newton",
        "framework/path", "framework/problem"}},
      {"framework/search",
       {"framework/base", "framework/certificate", "framework/cost", "framework/domain", "framework/energy",
        "framework/newton", "framework/path", "framework/problem", "framework/proof", "framework/result"}},
      {"framework/family",
       {"framework/base", "framework/domain", "framework/energy", "framework/path", "framework/problem",
        "framework/proof", "framework/result", "framework/search"}},
      {"framework/replan",
       {"framework/base", "framework/cost", "framework/domain", "framework/energy", "framework/path",
        "framework/problem", "framework/result", "framework/search"}},
      {"framework/trajectory",
       {"framework/base", "framework/domain", "framework/path", "framework/problem", "framework/result"}},
      {"framework/check", {"framework/base", "framework/cost", "framework/domain", "framework/path"}},
      {"problems/chart", {}},
      {"problems/cloud", {"problems/graph"}},
      {"problems/formula", {}},
      {"problems/graph", {}},
      {"problems/layers", {}},
      {"problems/mesh", {}},
      {"problems/methods", {}},
      {"problems/level_set", {"problems/formula"}},
      {"problems/drawing", {"problems/chart", "problems/level_set"}},
      {"problems/spline", {}},
      {"problems/raster", {"problems/spline"}},
      {"problems/cells", {"problems/graph", "problems/raster"}},
      {"problems/distance", {"problems/cloud", "problems/level_set", "problems/mesh", "problems/spline"}},
      {"problems/section", {"problems/chart", "problems/cloud", "problems/mesh"}},
      {"problems/straighten", {"problems/mesh"}},
      {"problems/exact", {"problems/mesh", "problems/straighten"}},
      {"problems/fields",
       {"problems/bracket", "problems/cells", "problems/chart", "problems/graph", "problems/mesh", "problems/raster"}},
      {"problems/tensor", {"problems/cloud", "problems/mesh"}},
      {"problems/occupancy", {"problems/mesh"}},
      {"problems/readers",
       {"problems/cloud", "problems/distance", "problems/mesh", "problems/occupancy", "problems/raster"}},
      {"problems/obstacles",
       {"problems/distance", "problems/drawing", "problems/mesh", "problems/methods", "problems/occupancy",
        "problems/raster", "problems/readers"}},
      {"problems/bracket", {}},
      {"problems/bracket/cells", {"problems/bracket"}},
      {"problems/bracket/search", {"problems/bracket", "problems/bracket/cells"}},
      {"problems/taut", {"problems/obstacles"}},
      {"problems/shapes",
       {"problems/drawing", "problems/mesh", "problems/obstacles", "problems/raster", "problems/readers"}},
      {"problems/clicks", {"problems/mesh", "problems/obstacles"}},
      {"problems/robots", {"problems/drawing", "problems/obstacles"}},
      {"problems/kernels", {}},
      {"problems/costs/lagrangian", {"problems/formula"}},
      {"problems/costs", subjects_and({"problems/costs/lagrangian"})},
      {"problems/initializers", subjects},
      // Domains offer the proofs over all paths that speak of them.
      {"problems/manifolds", subjects_and({"problems/post_processors"})},
      {"problems/manifolds/data", subjects_and({"problems/manifolds", "problems/post_processors"})},
      {"problems/post_processors", subjects},
      {"ompl/plans", {"ompl"}},
      {"catalogue/yaml", {}},
      {"catalogue/inputs", {"catalogue/yaml", "catalogue/back_ends"}},
      {"catalogue/plugins", {"catalogue/yaml"}},
      {"catalogue/back_ends", {"catalogue/plugins"}},
      {"catalogue/registry", {"catalogue/plugins", "catalogue/back_ends", "catalogue/inputs"}},
      {"catalogue/options", {"catalogue/yaml", "catalogue/plugins", "catalogue/registry"}},
      {"catalogue/config", {"catalogue/yaml", "catalogue/plugins", "catalogue/registry", "catalogue/options"}},
      {"catalogue/run",
       {"catalogue/config", "catalogue/yaml", "catalogue/inputs", "catalogue/plugins", "catalogue/registry"}},
      {"catalogue/scene", {}},
      {"catalogue/pairs",
       {"catalogue/config", "catalogue/output", "catalogue/plugins", "catalogue/run", "catalogue/yaml"}},
      {"catalogue/output",
       {"catalogue/config", "catalogue/run", "catalogue/back_ends", "catalogue/inputs", "catalogue/options",
        "catalogue/registry", "catalogue/scene"}},
      {"app/plot", {}},
      {"app/report/page", {"app/plot"}},
      {"app/report/space", {"app/plot"}},
      {"app/report/run", {"app/report/page", "app/report/space", "app/plot"}},
      {"app/report/study", {"app/report/page", "app/plot", "app/study", "app/study/rows"}},
      {"app/figure", {"app/plot", "app/report/page", "app/report/run", "app/report/space"}},
      {"app/report", {"app/report/page", "app/report/run", "app/report/study"}},
      {"app/distances", {}},
      {"app/field", {"app/distances", "app/figure", "app/plot", "app/report/run", "app/report/space"}},
      {"app/wasm", {}},
      {"app/run", {"app/report"}},
      {"app/pairs", {"app/run", "app/study/rows"}},
      {"app/study/grid", {}},
      {"app/study/rows", {}},
      {"app/study/cell", {"app/study/grid", "app/study/rows"}},
      {"app/study", {"app/study/cell", "app/study/grid", "app/study/rows"}},
      {"app/reference", {"app/study/grid"}},
      {"app/init", {}},
      {"app/cli/shell", {"app/init", "app/reference"}},
      {"app/cli",
       {"app/cli/shell", "app/distances", "app/field", "app/figure", "app/init", "app/pairs", "app/reference",
        "app/report", "app/run", "app/study", "app/study/rows"}}};
  return table;
}

/// solvers/<name>/<name>_solver.hpp: what is installed of a back end.
bool is_back_end_header(const std::string& file) {
  static const std::regex pattern("solvers/([a-z0-9_]+)/\\1_solver\\.hpp");
  return std::regex_match(file, pattern);
}

/// Why a third-party header (a name with a folder or an extension; the standard library has neither) may not stand
/// there; empty when it may.
std::string third_party_fault(const Include& include) {
  const std::string& file = include.file;
  const std::string& target = include.target;
  if (starts_with(target, "Eigen/")) return "";
  if (starts_with(file, "framework/")) return "framework uses Eigen and the standard library only";
  if (starts_with(file, "solvers/") && file.find('/', std::string_view("solvers/").size()) != std::string::npos)
    return is_back_end_header(file) ? "the installed header of a back end includes no third party but Eigen" : "";
  if (starts_with(target, "ompl/"))
    return starts_with(file, "ompl/") && !is_header(file) ? "" : "only .cpp files of ompl use OMPL";
  if (starts_with(target, "gdal") || starts_with(target, "cpl_") || starts_with(target, "ogr_"))
    return file == "gdal/gdal_library.hpp" || (starts_with(file, "gdal/") && !is_header(file))
               ? ""
               : "only .cpp files of gdal use GDAL";
  if (target == "dlfcn.h")
    return file == "gdal/gdal_library.cpp" || file == "catalogue/back_ends/load_back_end.cpp"
               ? ""
               : "only gdal/gdal_library.cpp and catalogue/back_ends/load_back_end.cpp load libraries at run time";
  if (target == "sys/mman.h")
    return file == "problems/exact/large_pages.cpp" ? ""
                                                    : "only problems/exact/large_pages.cpp asks the system for pages";
  if (target == "malloc.h")
    return file == "app/cli/heap.cpp" ? "" : "only app/cli/heap.cpp sets up the heap of a process";
  if (target == "tinyxml2.h")
    return starts_with(file, "urdf/") && !is_header(file) ? "" : "only .cpp files of urdf use TinyXML-2";
  if (starts_with(target, "octomap/"))
    return starts_with(file, "octomap/") && !is_header(file) ? "" : "only .cpp files of octomap use OctoMap";
  const bool program = starts_with(file, "catalogue/") || starts_with(file, "app/");
  if (file == "problems/graph/compressed_rows.hpp" && starts_with(target, "boost/")) return "";
  if (!program && is_header(file)) return "a header of the library includes no third party but Eigen";
  if (starts_with(target, "boost/"))
    return starts_with(file, "problems/graph/") || file == "problems/obstacles/broad_phase.cpp"
               ? ""
               : "only problems/graph uses Boost";
  if (target == "nanoflann.hpp")
    return starts_with(file, "problems/cloud/") ? "" : "only problems/cloud uses nanoflann";
  if (starts_with(target, "yaml-cpp/"))
    return starts_with(file, "catalogue/yaml/") && !is_header(file) ? ""
                                                                    : "only .cpp files of catalogue/yaml use yaml-cpp";
  if (starts_with(target, "CLI/")) return starts_with(file, "app/cli/") ? "" : "only app/cli uses CLI11";
  if (target == "png.h")
    return file == "catalogue/inputs/png_image.cpp" ? "" : "only catalogue/inputs/png_image.cpp uses libpng";
  constexpr std::array<std::string_view, 3> kOfProgram = {"fmt/", "nlohmann/", "openssl/"};
  const bool known = std::any_of(kOfProgram.begin(), kOfProgram.end(), [&](auto p) { return starts_with(target, p); });
  if (!program) return "framework, problems and solvers know no such third party";
  return known ? "" : "a library that only its back end in solvers uses, or one that is not in the table";
}

std::string folder_of(const std::string& file) { return file.substr(0, file.rfind('/')); }

std::string own_fault(const Include& include) {
  const std::string from = first_folders(include.file, 1), to = first_folders(include.target, 1);
  if (layers().count(to) == 0) return "is no folder of the tree; includes are written from the root";
  if (from != to && layers().at(from).count(to) == 0) return from + " must not include " + to;
  const std::string room = folder_of(include.file), other = folder_of(include.target);
  // The header of a layer stands above its rooms; main.cpp above all.
  if (from != to || room == other || room == from) return "";
  if (from == "solvers" && other == "solvers") return "";  // a back end; it includes no other one
  if (rooms().count(room) == 0) return room + " is not in the table of rooms";
  return rooms().at(room).count(other) == 1 ? "" : room + " must not include " + other;
}

std::string fault(const Include& include) {
  if (include.own) return own_fault(include);
  const bool standard = include.target.find_first_of("/.") == std::string::npos;
  const bool posix = starts_with(include.target, "sys/") || include.target == "unistd.h" || include.target == "fcntl.h";
  return standard || (posix && (starts_with(include.file, "app/") || starts_with(include.file, "catalogue/")))
             ? ""
             : third_party_fault(include);
}

/// A header and its source are one unit: two that need each other are a circle, though no file includes itself.
std::string unit_of(const std::string& file) { return fs::path(file).replace_extension().generic_string(); }

/// A cycle among the units of the tree as "a -> b -> a", or nothing.
class CycleSearch {
 public:
  explicit CycleSearch(const std::vector<Include>& includes) {
    for (const Include& include : includes) {
      const std::string from = unit_of(include.file), to = unit_of(include.target);
      if (include.own && (from != to || include.file == include.target)) graph_[from].push_back(to);
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

/// The headers that are installed: those that the public headers of the components reach through <leastcost/...>.
std::set<std::string> public_headers(const std::vector<Include>& includes) {
  std::multimap<std::string, std::string> reaches;
  for (const Include& include : includes)
    if (include.open) reaches.emplace(include.file, include.target);
  std::vector<std::string> open = {"framework/numbers/numbers.hpp",
                                   "framework/check/check.hpp",
                                   "framework/framework.hpp",
                                   "problems/problems.hpp",
                                   "solvers/solvers.hpp",
                                   "recipes/recipes.hpp",
                                   "ompl/ompl.hpp",
                                   "gdal/gdal.hpp",
                                   "urdf/urdf.hpp",
                                   "octomap/octomap.hpp",
                                   "catalogue/catalogue.hpp",
                                   "app/study.hpp",
                                   "app/report.hpp",
                                   "app/app.hpp"};
  for (const Include& include : includes)
    for (const std::string& file : {include.file, include.target})
      if (is_back_end_header(file)) open.push_back(file);
  std::set<std::string> found;
  while (!open.empty()) {
    const std::string header = open.back();
    open.pop_back();
    if (!found.insert(header).second) continue;
    const auto [begin, end] = reaches.equal_range(header);
    for (auto it = begin; it != end; ++it) open.push_back(it->second);
  }
  return found;
}

/// One spelling for every header: <leastcost/...> for what is installed, "..." for what is internal. An installed
/// header sees installed ones only.
std::string spelling_fault(const Include& include, const std::set<std::string>& installed) {
  if (!include.own) {
    const bool plain = include.target.find_first_of("/.") == std::string::npos || starts_with(include.target, "Eigen/");
    return plain || installed.count(include.file) == 0 ? "" : "an installed header includes no third party but Eigen";
  }
  const bool is_public = installed.count(include.target) == 1;
  if (installed.count(include.file) == 1 && !include.open)
    return "an installed header must not include an internal one";
  if (include.open && !is_public) return "is not reached from a public header: write it in quotes";
  return !include.open && is_public ? "is installed: write <leastcost/...>" : "";
}

/// A folder should be divided that has more than a fifth of the lines of its layer in files of its own, unless it is
/// small, or more than 25 units: nobody sees so many names at a glance.
std::string size_faults(const fs::path& root, std::string_view layer, long small = 2000) {
  constexpr std::size_t kMostUnits = 25;
  std::map<std::string, long> lines;
  std::map<std::string, std::set<std::string>> units;
  long all = 0;
  for (const fs::path& file : sources_below(root / layer)) {
    std::ifstream in(file);
    const long count = std::count(std::istreambuf_iterator<char>(in), {}, '\n');
    const std::string folder = fs::relative(file.parent_path(), root).generic_string();
    lines[folder] += count;
    units[folder].insert(file.stem().string());
    all += count;
  }
  std::ostringstream report;
  for (const auto& [folder, count] : lines) {
    if (count > small && 5 * count > all)
      report << folder << ": " << count << " of the " << all << " lines of " << layer << '\n';
    if (units[folder].size() > kMostUnits) report << folder << ": " << units[folder].size() << " units\n";
  }
  return report.str();
}

/// Every fault of the tree below `root`, one per line, in compiler style; empty when the layers are clean.
std::string layer_faults(const fs::path& root) {
  std::ostringstream report;
  const std::vector<Include> includes = all_includes(root);
  const std::set<std::string> installed = public_headers(includes);
  for (const Include& include : includes) {
    for (const std::string& reason : {fault(include), spelling_fault(include, installed)}) {
      if (!reason.empty())
        report << include.file << ':' << include.line << ": " << include.target << ": " << reason << '\n';
    }
  }
  const std::string cycle = CycleSearch(includes).find();
  if (!cycle.empty()) report << "include cycle: " << cycle << '\n';
  return report.str();
}

/// A circle among the rooms of the table itself, as CycleSearch finds it.
std::string circle_of_rooms(const Arrows& table) {
  std::vector<Include> arrows;
  for (const auto& [from, targets] : table)
    for (const std::string& to : targets) arrows.push_back({from, 0, to, true, false});
  return CycleSearch(arrows).find();
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

TEST_CASE("layers: the tables have no circle") {
  CHECK(circle_of_rooms(rooms()) == "");
  CHECK(circle_of_rooms(layers()) == "");
  CHECK(circle_of_rooms({{"a", {"b"}}, {"b", {"c"}}, {"c", {"a"}}}) == "a -> b -> c -> a");
}

TEST_CASE("layers: no folder holds more than a fifth of its layer, or 25 units") {
  for (const std::string_view layer : kLayers) CHECK(size_faults(project_dir(), layer) == "");
  const ScratchDir tree;
  write(tree / "app/big/a.cpp", "\n\n\n\n");
  write(tree / "app/small/a.cpp", "\n");
  CHECK_THAT(size_faults(tree.path(), "app", 3), Catch::Contains("app/big: 4 of the 5 lines"));
  CHECK(size_faults(tree.path(), "app", 4) == "");
  for (char unit = 'a'; unit <= 'z'; ++unit) write(tree / "gdal" / (unit + std::string(".hpp")), "\n");
  CHECK_THAT(size_faults(tree.path(), "gdal"), Catch::Contains("gdal: 26 units"));
}

TEST_CASE("layers: every wrong arrow is caught") {
  struct Wrong {
    const char* file;
    const char* line;
    const char* reason;
  };
  const Wrong wrong = GENERATE(
      Wrong{"framework/a.hpp", "#include \"problems/mesh/b.hpp\"", "framework must not include problems"},
      Wrong{"framework/a.hpp", "#include <leastcost/problems/mesh/b.hpp>", "framework must not include problems"},
      Wrong{"framework/a.hpp", "#include \"solvers/b.hpp\"", "framework must not include solvers"},
      Wrong{"framework/a.hpp", "#include <boost/graph/graph_traits.hpp>", "framework uses Eigen"},
      Wrong{"framework/a.cpp", "#include <fmt/format.h>", "framework uses Eigen"},
      Wrong{"solvers/a.cpp", "#include \"problems/costs/b.hpp\"", "solvers must not include problems"},
      Wrong{"problems/costs/a.cpp", "#include \"solvers/b.hpp\"", "problems must not include solvers"},
      Wrong{"problems/costs/a.cpp", "  #  include \"app/b.hpp\"", "problems must not include app"},
      Wrong{"problems/costs/a.cpp", "#include \"catalogue/b.hpp\"", "problems must not include catalogue"},
      Wrong{"catalogue/run/a.cpp", "#include \"app/b.hpp\"", "catalogue must not include app"},
      Wrong{"catalogue/options/a.cpp", "#include \"catalogue/run/b.hpp\"", "must not include catalogue/run"},
      Wrong{"app/report/run/a.cpp", "#include \"app/cli/b.hpp\"", "must not include app/cli"},
      Wrong{"problems/costs/a.cpp", "#include \"problems/manifolds/b.hpp\"", "must not include problems/manifolds"},
      Wrong{"problems/mesh/a.cpp", "#include \"problems/readers/b.hpp\"", "must not include problems/readers"},
      Wrong{"problems/mesh/a.cpp", "#include \"problems/straighten/b.hpp\"", "must not include problems/straighten"},
      Wrong{"problems/attic/a.cpp", "#include \"problems/mesh/b.hpp\"", "not in the table of rooms"},
      Wrong{"problems/costs/a.cpp", "#include \"b.hpp\"", "written from the root"},
      Wrong{"solvers/a.cpp", "#include <boost/graph/astar_search.hpp>", "only problems/graph"},
      Wrong{"problems/mesh/a.hpp", "#include <boost/graph/astar_search.hpp>", "a header of the library"},
      Wrong{"problems/readers/a.cpp", "#include <yaml-cpp/yaml.h>", "catalogue/yaml"},
      Wrong{"app/run/run.cpp", "#include <yaml-cpp/yaml.h>", "catalogue/yaml"},
      Wrong{"catalogue/run/a.cpp", "#include <CLI/CLI.hpp>", "only app/cli"},
      Wrong{"solvers/lbfgs.cpp", "#include <ceres/ceres.h>", "know no such third party"},
      Wrong{"solvers/ceres/ceres_solver.hpp", "#include <ceres/ceres.h>", "installed header"},
      Wrong{"solvers/lbfgs.cpp", "#include <nlopt.hpp>", "know no such third party"},
      Wrong{"solvers/nlopt/nlopt_solver.hpp", "#include <nlopt.hpp>", "installed header"},
      Wrong{"problems/costs/a.cpp", "#include <fmt/format.h>", "no such third party"},
      Wrong{"catalogue/run/a.cpp", "#include <nlopt.hpp>", "only its back end"},
      Wrong{"catalogue/catalogue.hpp", "#include <fmt/format.h>", "an installed header includes no third party"},
      Wrong{"ompl/polish.hpp", "#include <ompl/base/State.h>", "only .cpp files of ompl use OMPL"},
      Wrong{"problems/initializers/a.cpp", "#include <ompl/base/State.h>", "only .cpp files of ompl use OMPL"},
      Wrong{"gdal/gdal_raster.hpp", "#include <gdal.h>", "only .cpp files of gdal use GDAL"},
      Wrong{"catalogue/inputs/a.cpp", "#include <cpl_conv.h>", "only .cpp files of gdal use GDAL"},
      Wrong{"urdf/xml_file.hpp", "#include <tinyxml2.h>", "only .cpp files of urdf use TinyXML-2"},
      Wrong{"catalogue/inputs/a.cpp", "#include <octomap/OcTree.h>", "only .cpp files of octomap use OctoMap"},
      Wrong{"gdal/a.cpp", "#include \"solvers/b.hpp\"", "gdal must not include solvers"},
      Wrong{"catalogue/run/a.cpp", "#include \"ompl/b.hpp\"", "catalogue must not include ompl"},
      Wrong{"ompl/a.cpp", "#include \"catalogue/b.hpp\"", "ompl must not include catalogue"},
      Wrong{"solvers/ceres/a.cpp", "#include \"solvers/nlopt/b.hpp\"", "not in the table of rooms"},
      Wrong{"framework/framework.hpp", "#include \"framework/b.hpp\"", "must not include an internal one"},
      Wrong{"framework/a.cpp", "#include <leastcost/framework/b.hpp>", "not reached from a public header"},
      Wrong{"framework/a.cpp", "#include \"framework/framework.hpp\"", "write <leastcost/...>"},
      Wrong{"framework/a.hpp", "#include \"framework/a.hpp\"", "include cycle: framework/a -> framework/a"});
  const ScratchDir tree;
  write(tree / wrong.file, std::string("#include <vector>\n") + wrong.line + "\n");
  CAPTURE(wrong.line);
  CHECK_THAT(layer_faults(tree.path()), Catch::Contains(wrong.reason));
}

TEST_CASE("layers: a cycle through several files is caught, allowed arrows are not") {
  const ScratchDir tree;
  write(tree / "framework/framework.hpp", "#include <leastcost/framework/path/path.hpp>\n");
  write(tree / "framework/path/path.hpp", "#include <Eigen/Core>\n#include <vector>\n");
  write(tree / "problems/graph/graph.cpp", "#include <boost/graph/graph_traits.hpp>\n");
  write(tree / "problems/costs/cost.hpp",
        "#include <leastcost/framework/path/path.hpp>\n#include \"problems/mesh/mesh.hpp\"\n");
  write(tree / "problems/mesh/mesh.hpp", "#include <leastcost/framework/path/path.hpp>\n");
  write(tree / "solvers/solver.cpp", "#include <leastcost/framework/path/path.hpp>\n");
  write(tree / "catalogue/yaml/read.cpp", "#include <yaml-cpp/yaml.h>\n#include \"problems/costs/cost.hpp\"\n");
  CHECK(layer_faults(tree.path()) == "");

  write(tree / "framework/path/path.hpp", "#include <leastcost/framework/path/problem.hpp>\n");
  write(tree / "framework/path/problem.hpp", "#include <leastcost/framework/path/path.hpp>\n");
  CHECK_THAT(layer_faults(tree.path()),
             Catch::Contains("include cycle: framework/path/path -> framework/path/problem"));
}

}  // namespace leastcost::test
