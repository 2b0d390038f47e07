// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The comparison of VFCS Sec. 5, repeated: comparison [FOLDER] [CPU SECONDS PER QUERY] writes table.csv, table.md and
// panels.svg. Meshes are those of LEASTCOST_DATA, else of the folder `shared/data` beside the project.
#include <fmt/format.h>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <set>
#include <sstream>

#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include "benchmarks/comparison/apart.hpp"
#include "benchmarks/comparison/method.hpp"
#include "benchmarks/comparison/table.hpp"

namespace {

using namespace leastcost;
using namespace leastcost::comparison;

struct Pair {
  const char* name;
  int source, target;  // vertices of the file
};
struct Model {
  const char *name, *file;
  int subdivide;
  std::vector<Pair> pairs;
};

constexpr double kPrepareSeconds = 60, kKillAfter = 30;  // CPU; beyond its limits a method is ended
/// Quick work is repeated for so long, and its mean counts: the CPU clock of some systems ticks in 4 ms.
constexpr double kMeasuredSeconds = 0.1;
constexpr int kMostPrepared = 100;
constexpr double kThousandth = 1e-3;

/// The fixed pairs: near ones first. Far: most of the way across; near: within a fifth of the diameter.
const std::vector<Pair> kDuckPairs = {
    {"near", 1655, 1697}, {"near", 1693, 1986}, {"far", 1044, 482}, {"far", 2029, 1841}, {"far", 2030, 954}};
const std::vector<Model> kModels = {
    {"duck", "duck.obj", 0, kDuckPairs},
    {"duck x4", "duck.obj", 1, kDuckPairs},
    {"duck x16", "duck.obj", 2, kDuckPairs},
    {"duck x64", "duck.obj", 3, kDuckPairs},
    {"fandisk",
     "fandisk.off",
     0,
     {{"near", 3221, 3035}, {"near", 1395, 1381}, {"far", 5623, 1774}, {"far", 5544, 1792}, {"far", 3394, 5445}}},
    {"phobos",
     "phobos.obj",
     0,
     {{"near", 9976, 11950}, {"near", 9023, 9575}, {"far", 4655, 9626}, {"far", 8417, 5633}, {"far", 5788, 7522}}},
    {"armadillo",
     "armadillo_52k.off",
     0,
     {{"near", 19300, 1131}, {"near", 5669, 12029}, {"far", 10401, 1002}, {"far", 22494, 7097}, {"far", 21046, 3276}}}};
/// Panel f: the far pair that comes first, on the finest duck.
constexpr const char* kHistoryMesh = "duck x64";

std::filesystem::path data_folder() {
  const char* root = std::getenv("LEASTCOST_DATA");
  return (root ? std::filesystem::path(root) : std::filesystem::path(LEASTCOST_PROJECT_DIR) / "../shared/data") /
         "meshes";
}

/// True once this process has used so many seconds more.
Stop stop_after(double seconds) {
  const double end = cpu_seconds() + seconds;
  return [end] { return cpu_seconds() >= end; };
}

const char* word_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::found: return "found";
    case Outcome::out_of_time: return "time";
    case Outcome::out_of_windows: return "windows";
    case Outcome::failed: return "failed";
  }
  return "";
}

int iterations_to(const Answer& answer, double length) {
  for (std::size_t i = 0; i < answer.lengths.size(); ++i)
    if (answer.lengths[i] <= length) return answer.looks.empty() ? static_cast<int>(i) : answer.looks[i];
  return -1;
}

/// One method on one mesh, in a process of its own: a line of tab-separated values per pair, and the history.
void work(const MethodEntry& entry, const Model& model, const TriangleMesh& mesh, const std::vector<double>& exact,
          double limit, const std::function<void(const std::string&)>& write) {
  reset_peak_memory();
  std::unique_ptr<Method> method;
  const double begin = cpu_seconds();
  int times = 0;
  do {
    method = entry.make();
    method->prepare(mesh, stop_after(kPrepareSeconds));
    ++times;
  } while (cpu_seconds() - begin < kMeasuredSeconds && times < kMostPrepared);
  const double prepared = 1e3 * (cpu_seconds() - begin) / times;
  bool history_due = std::string_view(model.name) == kHistoryMesh && entry.kind == Kind::local;
  for (std::size_t i = 0; i < model.pairs.size(); ++i) {
    const Pair& pair = model.pairs[i];
    const int source = mesh.vertex_of_file(pair.source), target = mesh.vertex_of_file(pair.target);
    Answer answer;
    const double first = cpu_seconds();
    int repeats = 0;
    do {
      answer = method->shortest(source, target, stop_after(limit));
      ++repeats;
    } while (answer.outcome == Outcome::found && cpu_seconds() - first < kMeasuredSeconds);
    const double mean = (cpu_seconds() - first) / repeats;
    if (answer.outcome == Outcome::found && !lies_on(mesh, answer.path)) {
      answer.outcome = Outcome::failed;
      answer.note = "the path leaves the mesh";
    }
    const double memory = peak_memory();
    const bool far = std::string_view(pair.name) == "far";
    if (answer.outcome == Outcome::found && answer.lengths.empty() && entry.kind == Kind::local && far)
      method->measure_lengths(source, target, stop_after(2 * limit), answer);
    const double length = answer.path.points.empty() ? 0 : path_length(answer.path);
    write(fmt::format("row\t{}\t{}\t{:.17g}\t{:.17g}\t{:.17g}\t{:.17g}\t{:.17g}\t{}\t{}\t{}\t{}\n", i,
                      word_of(answer.outcome), prepared, 1e3 * mean, memory, length, answer.distance, answer.iterations,
                      iterations_to(answer, (1 + kThousandth) * exact[i]), answer.windows, answer.note));
    if (history_due && far) {
      history_due = false;
      std::string line = "history";
      const std::size_t count = answer.lengths.size();
      for (std::size_t k = 0; k < count; ++k) {
        // Long histories are thinned: about equally on a logarithmic axis.
        if (k > 100 && k % (k / 50) != 0 && k + 1 < count) continue;
        const auto iteration = answer.looks.empty() ? static_cast<int>(k) : answer.looks[k];
        line += fmt::format("\t{}\t{:.17g}", iteration, answer.lengths[k] / exact[i] - 1);
      }
      write(line + "\n");
    }
    if (answer.outcome == Outcome::out_of_time || answer.outcome == Outcome::out_of_windows) return;
  }
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> parts;
  std::istringstream in(line);
  for (std::string part; std::getline(in, part, '\t');) parts.push_back(part);
  return parts;
}

/// What a process wrote, as rows; what it did not come to is said.
void read_rows(const Apart& apart, const MethodEntry& entry, const Model& model, int vertices,
               const std::vector<double>& exact, std::vector<Row>& rows, std::vector<History>& histories) {
  std::vector<Row> own(model.pairs.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    own[i].mesh = model.name;
    own[i].method = entry.name;
    own[i].kind = entry.kind;
    own[i].pair = model.pairs[i].name;
    own[i].vertices = vertices;
    own[i].source = model.pairs[i].source;
    own[i].target = model.pairs[i].target;
    own[i].exact = exact[i];
    own[i].outcome = "skipped";
  }
  std::size_t next = 0;
  std::istringstream in(apart.text);
  for (std::string line; std::getline(in, line);) {
    const std::vector<std::string> part = split(line);
    if (part.at(0) == "history") {
      History h{std::string(entry.name), {}, {}};
      for (std::size_t k = 1; k + 1 < part.size(); k += 2) {
        h.iterations.push_back(std::stod(part[k]));
        h.errors.push_back(std::stod(part[k + 1]));
      }
      histories.push_back(std::move(h));
      continue;
    }
    next = std::stoul(part.at(1)) + 1;
    Row& r = own.at(next - 1);
    r.outcome = part.at(2);
    r.prepare_ms = std::stod(part.at(3));
    r.query_ms = std::stod(part.at(4));
    r.memory_mb = std::stod(part.at(5));
    r.length = std::stod(part.at(6));
    r.distance = std::stod(part.at(7));
    r.iterations = std::stoi(part.at(8));
    r.to_a_thousandth = std::stoi(part.at(9));
    r.windows = std::stol(part.at(10));
    if (part.size() > 11) r.note = part[11];
  }
  if (!apart.ended && next < own.size()) own[next].outcome = apart.killed ? "killed" : "crashed";
  rows.insert(rows.end(), own.begin(), own.end());
}

int run(const std::filesystem::path& folder, double limit) {
  std::vector<Row> rows;
  std::vector<History> histories;
  std::set<std::string> gave_up;  // on a coarser mesh of the same surface
  for (const Model& model : kModels) {
    const std::filesystem::path file = data_folder() / model.file;
    if (!std::filesystem::exists(file)) {
      std::printf("skipped: %s is not there (set LEASTCOST_DATA)\n", file.c_str());
      continue;
    }
    const TriangleMesh mesh(read_mesh(file), {false, model.subdivide});
    std::vector<double> exact;
    {
      const ExactSearch search(mesh);
      ExactSearch::Workspace workspace(search);
      for (const Pair& p : model.pairs) {
        const ExactResult result = search.shortest(vertex_point(mesh, mesh.vertex_of_file(p.source)),
                                                   vertex_point(mesh, mesh.vertex_of_file(p.target)), workspace);
        if (!result.is_proved())
          throw std::runtime_error(fmt::format("{}: {} to {} is not proved", model.name, p.source, p.target));
        exact.push_back(result.length);
        std::printf("%s, %d vertices, %s: %d to %d, %.12g = %.2f diameters\n", model.name, mesh.vertex_count(), p.name,
                    p.source, p.target, result.length, result.length / mesh.diameter());
      }
    }
    if (model.subdivide == 0) gave_up.clear();
    for (const MethodEntry& entry : all_methods()) {
      Apart apart;
      apart.ended = true;
      if (!gave_up.count(std::string(entry.name)))
        apart = run_apart(kPrepareSeconds + kKillAfter + 30 * limit,
                          [&](const auto& write) { work(entry, model, mesh, exact, limit, write); });
      const std::size_t before = rows.size();
      read_rows(apart, entry, model, mesh.vertex_count(), exact, rows, histories);
      if (rows[before].outcome != "found" && rows[before].outcome != "failed") gave_up.emplace(entry.name);
      for (std::size_t i = before; i < rows.size(); ++i)
        std::printf("  %-9s %-4s %-8s %10.3f ms %10.3f ms %8.1f MB  error %.3e\n", rows[i].method.c_str(),
                    rows[i].pair.c_str(), rows[i].outcome.c_str(), rows[i].prepare_ms, rows[i].query_ms,
                    rows[i].memory_mb, rows[i].error());
      std::fflush(stdout);
    }
    write_tables(folder, rows);  // also what there is so far
    write_panels(folder, rows, histories);
  }
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    return run(count > 1 ? words[1] : "comparison", count > 2 ? std::stod(words[2]) : 3.0);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "comparison: %s\n", error.what());
    return 1;
  }
}
