// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Whole queries on meshes as find_path answers them by default (n = 64, certificate in it): what they cost, as a ratio
// of CPU time to the short way of the same pairs in the same run, and how often the path is the shortest, against
// proved lengths. Far and near pairs as in exact_table.
//   mesh_path_table [--pairs 100] [--landmarks 16] [--subdivide 0] [--seed 7] [--index 1] mesh ...
// Of a mesh that is subdivided the truth comes from the mesh of the file, which is the same polyhedron.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/post_processors/shortest.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include "benchmarks/mesh_pairs.hpp"
#include "problems/readers/mesh_reader.hpp"

namespace {

using namespace leastcost;
using namespace leastcost::bench;

struct Settings {
  int pairs = 100, landmarks = 16, subdivide = 0, index = 1;
  std::uint64_t seed = 7;
  std::vector<std::string> files;
};

/// Peak memory of this process so far, MB.
double peak_memory() {
  double peak = 0;
  if (std::FILE* status = std::fopen("/proc/self/status", "r")) {
    constexpr int kLine = 256;
    char line[kLine];
    while (std::fgets(line, kLine, status) != nullptr)
      if (std::string(line).starts_with("VmHWM:")) peak = std::atof(line + 6) / 1024;
    std::fclose(status);
  }
  return peak;
}

/// One way to ask find_path.
struct Column {
  const char* name;
  DijkstraInitializer first;
  GlobalProof proof;
  std::vector<double> milliseconds = {}, excess = {};
  StageSeconds seconds = {};
  int proved = 0, certified = 0;
};

PathEnd end_at(const TriangleMesh& mesh, std::int32_t v) { return {mesh.position(v), vertex_point(mesh, v).face}; }

void ask(Column& column, const std::shared_ptr<const MeshManifold>& domain, const std::vector<Pair>& pairs,
         const std::vector<double>& truth) {
  constexpr int kPoints = 64;
  FindOptions options;
  options.points = kPoints;
  options.post_processors = {std::make_shared<const TracePostProcessor>(),
                             std::make_shared<const StraightenPostProcessor>(),
                             std::make_shared<const ShortestPostProcessor>(column.proof)};
  const NoSolver solver;
  Problem problem{domain, make_euclidean_cost(3), make_kernel<Expm1Square>(), {}, {}};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    problem.source = end_at(domain->mesh(), pairs[i].first);
    problem.target = end_at(domain->mesh(), pairs[i].second);
    Result result;
    const auto query = [&] { result = find_path(problem, column.first, solver, options); };
    if (i == 0) query();  // what is made once: tables, index
    column.milliseconds.push_back(least_time(query));
    column.seconds.initialize += result.seconds.initialize;
    column.seconds.post_process += result.seconds.post_process;
    column.seconds.certify += result.seconds.certify;
    column.proved += result.curve.global && result.curve.global->proved ? 1 : 0;
    column.certified += result.certificate.certified() ? 1 : 0;
    if (std::isfinite(truth[i])) column.excess.push_back(std::max(0.0, result.curve.cost / truth[i] - 1));
  }
}

void print(const Column& c, const std::vector<double>& unit) {
  constexpr double kExact = 2e-9, kClose = 1e-3;
  const double count = static_cast<double>(c.excess.size()), all = static_cast<double>(c.milliseconds.size());
  const auto share = [&](double most) {
    return 100 / count *
           static_cast<double>(std::count_if(c.excess.begin(), c.excess.end(), [most](double e) { return e <= most; }));
  };
  std::printf(
      "    %-24s ratio of means %6.2f of medians %6.2f  %8.3f ms (first %.3f, post %.3f, certificate %.3f)  "
      "proved %d, certified %d of %.0f\n",
      c.name, mean(c.milliseconds) / mean(unit), median(c.milliseconds) / median(unit), mean(c.milliseconds),
      1e3 * c.seconds.initialize / all, 1e3 * c.seconds.post_process / all, 1e3 * c.seconds.certify / all, c.proved,
      c.certified, all);
  if (!c.excess.empty())
    std::printf("    %-24s exact %.1f %%, within 0.1 %% %.1f %%, mean excess %.4f %%, worst %.2f %%, of %.0f\n", "",
                share(kExact), share(kClose), 100 * mean(c.excess),
                100 * *std::max_element(c.excess.begin(), c.excess.end()), count);
  std::fflush(stdout);
}

void measure(const std::string& file, const Settings& settings) {
  constexpr std::int64_t kMostWindows = 20000000;  // of a truth, two GB; beyond, none is known
  std::shared_ptr<const MeshManifold> domain;
  MeshOptions mesh_options;
  mesh_options.subdivide = settings.subdivide;
  const double before = peak_memory();
  const double loading =
      timed([&] { domain = std::make_shared<MeshManifold>(TriangleMesh(read_mesh(file), mesh_options)); });
  const TriangleMesh& mesh = domain->mesh();
  std::printf("%s: %d vertices; loaded in %.0f ms of CPU, peak memory %.0f MB before, %.0f MB after\n",
              file.substr(file.rfind('/') + 1).c_str(), mesh.vertex_count(), loading, before, peak_memory());
  std::fflush(stdout);
  const TriangleMesh base(read_mesh(file));  // the same polyhedron
  const ExactSearch search(base);
  ExactSearch::Workspace workspace(search);
  const auto in_base = [&](std::int32_t v) { return base.locate(mesh.in_file(vertex_point(mesh, v))); };
  EdgeGraphSearch graph(mesh);
  for (const bool far : {true, false}) {
    const std::vector<Pair> pairs = random_pairs(mesh, settings.pairs, settings.seed, far);
    if (pairs.empty()) continue;
    std::vector<double> unit, truth;
    double straight = 0;
    std::vector<double> excess;
    for (const Pair& pair : pairs) {
      SurfacePath path;
      unit.push_back(least_time([&] { path = short_way(mesh, graph, pair); }));
      straight = path_length(path);
      const ExactResult found =
          search.shortest(in_base(pair.first), in_base(pair.second), workspace, {.max_windows = kMostWindows});
      truth.push_back(found.is_proved() ? found.length : std::numeric_limits<double>::quiet_NaN());
      if (found.is_proved()) excess.push_back(std::max(0.0, straight / found.length - 1));
    }
    std::printf("  %s, %zu pairs: short way %.3f ms (median %.3f)\n", far ? "far" : "near", pairs.size(), mean(unit),
                median(unit));
    Column short_column{"the short way", DijkstraInitializer(), GlobalOff{}};
    short_column.milliseconds = unit;
    short_column.excess = std::move(excess);
    print(short_column, unit);
    GlobalBudget budget;
    budget.landmarks = settings.landmarks;
    const DijkstraInitializer edges, diagonals({.diagonals = true}), two({.routes = 2});
    const DijkstraInitializer aimed({.diagonals = true, .landmarks = settings.landmarks});
    std::vector<Column> columns{{"not proved, edges", edges, GlobalOff{}},
                                {"not proved", diagonals, GlobalOff{}},
                                {"not proved, 2 routes", two, GlobalOff{}}};
    if (settings.landmarks > 0) columns.push_back({"not proved, index", aimed, GlobalOff{}});
    columns.push_back({"default", diagonals, GlobalAuto{}});
    if (settings.landmarks > 0 && settings.index > 0) columns.push_back({"default, index", aimed, budget});
    for (Column& column : columns) {
      ask(column, domain, pairs, truth);
      print(column, unit);
    }
  }
}

Settings read_arguments(int count, char** words) {
  Settings s;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (!word.starts_with("--") || i + 1 >= count) {
      s.files.push_back(word);
      continue;
    }
    const long long number = std::atoll(words[++i]);
    if (word == "--pairs") s.pairs = static_cast<int>(number);
    if (word == "--landmarks") s.landmarks = static_cast<int>(number);
    if (word == "--subdivide") s.subdivide = static_cast<int>(number);
    if (word == "--index") s.index = static_cast<int>(number);
    if (word == "--seed") s.seed = static_cast<std::uint64_t>(number);
  }
  return s;
}

}  // namespace

int main(int count, char** words) {
  const Settings settings = read_arguments(count, words);
  if (settings.files.empty()) {
    std::printf("usage: mesh_path_table [--pairs 100] [--landmarks 16] [--subdivide 0] [--seed 7] mesh ...\n");
    return 2;
  }
  for (const std::string& file : settings.files) {
    try {
      measure(file, settings);
    } catch (const std::exception& error) {
      std::printf("%s: %s\n", file.c_str(), error.what());
    }
  }
}
