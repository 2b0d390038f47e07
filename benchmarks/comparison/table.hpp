// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "benchmarks/comparison/method.hpp"

namespace leastcost::comparison {

/// One line of the table: a method, a mesh, a pair of vertices.
struct Row {
  std::string mesh, method, pair;  ///< pair: "far" or "near"
  Kind kind = Kind::exact;
  int vertices = 0, source = 0, target = 0;
  std::string outcome;  ///< "found", "time", "windows", "failed", "killed", "skipped"
  double prepare_ms = 0, query_ms = 0, memory_mb = 0;
  double length = 0, exact = 0;
  double distance = 0;  ///< what the method itself says
  int iterations = 0;
  int to_a_thousandth = -1;  ///< iterations until the path is within 1e-3 of the shortest; -1: never
  long windows = 0;
  std::string note;

  bool found() const { return outcome == "found"; }
  double error() const { return length / exact - 1; }
};

/// The history of one method on the pair of panel f.
struct History {
  std::string method;
  std::vector<double> iterations, errors;
};

/// table.csv, table.md and panels.svg in a folder, which is made.
void write_tables(const std::filesystem::path& folder, const std::vector<Row>& rows);
void write_panels(const std::filesystem::path& folder, const std::vector<Row>& rows,
                  const std::vector<History>& histories);

}  // namespace leastcost::comparison
