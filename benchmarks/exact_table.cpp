// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// What a proved shortest path on a mesh costs, as a ratio of CPU time to the short way (A* over edges, straightened,
// with flips; no proof) of the same pairs in the same run. Far pairs: more than a quarter of the bounding box's
// diagonal apart; near ones: 1 to 8 % of it. And the share of pairs whose proof takes at most 5, 20 and 100 times the
// short way of the same pair.
//   exact_table [--pairs 100] [--landmarks 16] [--subdivide 0] [--seed 7] [--most windows] mesh ...
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>
#include <leastcost/problems/straighten/straighten.hpp>
#include "benchmarks/mesh_pairs.hpp"
#include "problems/readers/mesh_reader.hpp"

namespace {

using namespace leastcost;
using namespace leastcost::bench;

struct Settings {
  int pairs = 100, landmarks = 16, subdivide = 0;
  std::uint64_t seed = 7;
  std::int64_t most = std::numeric_limits<std::int64_t>::max();
  std::vector<std::string> files;
};

constexpr std::array<double, 3> kBudgets{5, 20, 100};

/// One way to a proof, over all pairs.
struct Column {
  const char* name;
  bool landmarks, given_start;
  std::vector<double> milliseconds = {};
  double windows = 0;
  int proved = 0;
  std::array<int, kBudgets.size()> within = {};  // proofs in at most so many times the short way
};

void compare(const TriangleMesh& mesh, const ExactSearch& search, const Settings& settings, bool far) {
  const std::vector<Pair> pairs = random_pairs(mesh, settings.pairs, settings.seed, far);
  if (pairs.empty()) return;
  EdgeGraphSearch graph(mesh);
  ExactSearch::Workspace workspace(search);
  std::vector<double> shortest_way;
  std::vector<Column> columns{{"proved alone", false, false}, {"after the short way", false, true}};
  if (settings.landmarks > 0) {
    columns.push_back({"with index", true, false});
    columns.push_back({"index, short way", true, true});
  }
  int improved = 0, differ = 0;
  for (const Pair& pair : pairs) {
    const SurfacePoint from = vertex_point(mesh, pair.first), to = vertex_point(mesh, pair.second);
    SurfacePath start;
    const double before = least_time([&] { start = short_way(mesh, graph, pair); });
    shortest_way.push_back(before);
    double exact = 0;
    for (Column& column : columns) {
      ExactOptions options;
      options.landmarks = column.landmarks;
      options.max_windows = settings.most;
      if (column.given_start) options.start = &start;
      ExactResult found;
      const double least = least_time([&] { found = search.shortest(from, to, workspace, options); });
      column.milliseconds.push_back(least + (column.given_start ? before : 0));
      column.windows += static_cast<double>(found.windows) / static_cast<double>(pairs.size());
      column.proved += found.is_proved() ? 1 : 0;
      for (std::size_t b = 0; b < kBudgets.size(); ++b)
        column.within[b] += found.is_proved() && column.milliseconds.back() <= kBudgets[b] * before ? 1 : 0;
      if (exact > 0 && found.is_proved() && std::abs(found.length / exact - 1) > 2e-9) ++differ;
      if (found.is_proved()) exact = found.length;
    }
    if (exact > 0 && path_length(start) > exact * (1 + 1e-9)) ++improved;
  }
  std::printf("  %s, %zu pairs: short way %.3f ms (median %.3f), not the shortest %d times; proofs that differ %d\n",
              far ? "far" : "near", pairs.size(), mean(shortest_way), median(shortest_way), improved, differ);
  for (const Column& c : columns)
    std::printf(
        "    %-20s ratio of means %6.2f of medians %6.2f  %9.0f windows  %8.3f ms  proved %d, in 5, 20, 100 times the "
        "short way %d, %d, %d\n",
        c.name, mean(c.milliseconds) / mean(shortest_way), median(c.milliseconds) / median(shortest_way), c.windows,
        mean(c.milliseconds), c.proved, c.within[0], c.within[1], c.within[2]);
  std::fflush(stdout);
}

void measure(const std::string& file, const Settings& settings) {
  MeshOptions options;
  options.subdivide = settings.subdivide;
  const TriangleMesh mesh(read_mesh(file), options);
  double made = 0, marked = 0;
  std::unique_ptr<ExactSearch> search;
  made = timed([&] { search = std::make_unique<ExactSearch>(mesh); });
  if (settings.landmarks > 0) {
    marked = timed([&] {
      ExactSearch::Workspace workspace(*search);
      search->use(search->make_landmarks(settings.landmarks, workspace));
    });
  }
  std::printf("%s: %d vertices; tables %.1f ms, %d landmarks %.0f ms\n", file.substr(file.rfind('/') + 1).c_str(),
              mesh.vertex_count(), made, settings.landmarks, marked);
  compare(mesh, *search, settings, true);
  compare(mesh, *search, settings, false);
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
    if (word == "--seed") s.seed = static_cast<std::uint64_t>(number);
    if (word == "--most") s.most = number;
  }
  return s;
}

}  // namespace

int main(int count, char** words) {
  const Settings settings = read_arguments(count, words);
  if (settings.files.empty()) {
    std::printf("usage: exact_table [--pairs 100] [--landmarks 16] [--subdivide 0] [--seed 7] [--most n] mesh ...\n");
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
