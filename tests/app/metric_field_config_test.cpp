// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Metrics given on the data of a domain, in a configuration: where what is wrong shows.
#include <fstream>

#include <leastcost/framework/base/errors.hpp>
#include "app/run/run.hpp"
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

using Catch::Contains;

namespace {

constexpr const char* kRow = "1 0 0 1 0 1\n";

/// A square pyramid without base: five vertices, four faces; and rows of tensors.
std::string with(const std::string& field, int rows, const std::string& more = "") {
  const ScratchDir folder;
  std::ofstream(folder / "pyramid.obj")
      << "v 0 0 1\nv 1 1 0\nv -1 1 0\nv -1 -1 0\nv 1 -1 0\nf 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 2\n";
  std::ofstream tensors(folder / "tensors.txt");
  for (int i = 0; i < rows; ++i) tensors << kRow;
  tensors.close();
  std::ofstream(folder / "a.yaml")
      << "manifold: {type: mesh, file: pyramid.obj}\ncost:\n  type: metric_field\n  field: " << field
      << "\nends: {source: {vertex: 1}, target: {vertex: 3}}\n"
      << "path: {points: 9}\n"
      << more;
  try {
    const Run prepared = load_run(folder / "a.yaml");
    const auto& parts = prepared.parts;
    find_path(parts.problem, *parts.initializer, *parts.solver, parts.options);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

std::string in_space(const std::string& field) {
  return errors_of("manifold: {type: euclidean, dimension: 3}\ncost:\n  type: metric_field\n  field: " + field +
                   "\nends:\n  source: {point: [0, 0, 0]}\n  target: {point: [1, 0, 0]}\n");
}

}  // namespace

TEST_CASE("tensors on data in a configuration: right ones") {
  CHECK(with("{type: file, file: tensors.txt}", 5) == "");
  CHECK(with("{type: file, file: tensors.txt, on: faces}", 4) == "");
  CHECK(with("{type: curvature, weight: 0.5}", 0) == "");
}

TEST_CASE("tensors on data in a configuration: what does not fit the domain") {
  CHECK_THAT(in_space("{type: curvature, weight: 1}"),
             Contains("a.yaml:4:17: error: 'type' in cost.field: curvature needs a mesh or a point cloud"));
  CHECK_THAT(in_space("{type: file, file: t.txt}"),
             Contains("a.yaml:4:17: error: 'type' in cost.field: tensors given on data need a mesh or a point cloud"));
  CHECK_THAT(with("{type: file, file: tensors.txt, on: points}", 5), Contains("a mesh has vertices and faces"));
  CHECK_THAT(with("{type: file, file: tensors.txt}", 4),
             Contains("4 tensors, but the file of the manifold has 5 vertices"));
  CHECK_THAT(with("{type: file, file: tensors.txt, on: faces}", 5),
             Contains("5 tensors, but the file of the manifold has 4 faces"));
  CHECK_THAT(with("{type: file, file: tensors.txt}", 0), Contains("has no tensors"));
  CHECK_THAT(with("{type: file, file: none.txt}", 5), Contains("none.txt: no such file"));
}

TEST_CASE("tensors on data in a configuration: no straightening under a metric that changes") {
  CHECK_THAT(with("{type: curvature, weight: 1}", 0, "post_process: [trace, straighten]\n"),
             Contains("'straighten' needs a cost with a constant metric, but 'metric_field' has none"));
}

TEST_CASE("a metric that is none: told with its place") {
  CHECK_THAT(with("{type: formula, entries: [x, \"0\", \"0\", \"1\", \"0\", \"1\"]}", 0),
             Contains("at (-1, 1, 0) the tensor is not positive definite: its eigenvalues are (-1, 1, 1)"));
}

}  // namespace leastcost::test
