// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/table.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <fstream>
#include <limits>
#include <map>

namespace leastcost::comparison {
namespace {

double median_of(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

std::string percent(double part) { return fmt::format("{:.3g} %", 100 * part); }

/// Of a mesh, the far and the near pairs apart: one line per method.
void write_block(std::ostream& out, const std::vector<Row>& rows, const std::string& mesh, const std::string& pair) {
  std::vector<std::string> methods;
  int vertices = 0;
  for (const Row& r : rows)
    if (r.mesh == mesh && r.pair == pair) {
      vertices = r.vertices;
      if (std::find(methods.begin(), methods.end(), r.method) == methods.end()) methods.push_back(r.method);
    }
  out << fmt::format("\n### {}, {} vertices, {} pairs\n\n", mesh, vertices, pair)
      << "| method | prepare, ms | query, ms (median) | memory, MB | found | error, mean | error, worst | own "
         "distance, "
         "mean | iterations (to 1e-3) |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  for (const std::string& method : methods) {
    std::vector<double> times, memory;
    double prepare = 0, mean = 0, worst = 0, own = 0, iterations = 0;
    int found = 0, all = 0, reached = 0;
    double to_thousandth = 0;
    for (const Row& r : rows) {
      if (r.mesh != mesh || r.pair != pair || r.method != method) continue;
      ++all;
      prepare = r.prepare_ms;
      if (!r.found()) continue;
      ++found;
      times.push_back(r.query_ms);
      memory.push_back(r.memory_mb);
      mean += r.error();
      own += r.distance / r.exact - 1;
      worst = std::max(worst, r.error());
      iterations += r.iterations;
      if (r.to_a_thousandth >= 0) ++reached, to_thousandth += r.to_a_thousandth;
    }
    if (found == 0) {
      std::string why;
      for (const Row& r : rows)
        if (r.mesh == mesh && r.pair == pair && r.method == method && !r.found() && why.empty()) why = r.outcome;
      out << fmt::format("| {} | {:.3g} | {} | | 0 of {} | | | | |\n", method, prepare, why, all);
      continue;
    }
    const std::string steps = iterations > 0
                                  ? fmt::format("{:.0f} ({})", iterations / found,
                                                reached == found ? fmt::format("{:.0f}", to_thousandth / reached) : "-")
                                  : "";
    out << fmt::format("| {} | {:.3g} | {:.3g} | {:.3g} | {} of {} | {} | {} | {} | {} |\n", method, prepare,
                       median_of(times), median_of(memory), found, all, percent(mean / found), percent(worst),
                       percent(own / found), steps);
  }
}

}  // namespace

void write_tables(const std::filesystem::path& folder, const std::vector<Row>& rows) {
  std::filesystem::create_directories(folder);
  std::ofstream csv(folder / "table.csv");
  csv << "mesh,vertices,method,pair,source,target,outcome,prepare_ms,query_ms,memory_mb,length,exact,error,distance,"
         "iterations,to_a_thousandth,windows,note\n";
  std::vector<std::pair<std::string, std::string>> blocks;
  for (const Row& r : rows) {
    std::string note = r.note;
    std::replace(note.begin(), note.end(), ',', ';');
    std::replace(note.begin(), note.end(), '\n', ' ');
    csv << fmt::format("{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.15g},{:.15g},{:.6g},{:.15g},{},{},{},{}\n", r.mesh,
                       r.vertices, r.method, r.pair, r.source, r.target, r.outcome, r.prepare_ms, r.query_ms,
                       r.memory_mb, r.length, r.exact, r.error(), r.distance, r.iterations, r.to_a_thousandth,
                       r.windows, note);
    const std::pair block{r.mesh, r.pair};
    if (std::find(blocks.begin(), blocks.end(), block) == blocks.end()) blocks.push_back(block);
  }
  std::ofstream markdown(folder / "table.md");
  for (const auto& [mesh, pair] : blocks) write_block(markdown, rows, mesh, pair);
}

}  // namespace leastcost::comparison
