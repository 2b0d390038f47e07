// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The contract of benchmarks/comparison: every method delivers a connected path on the mesh, never below the exact
// distance, and no worse than what is known of it.
#include <map>
#include <set>
#include <string>

#include <leastcost/problems/exact/exact_search.hpp>
#include "benchmarks/comparison/method.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using namespace leastcost::comparison;

/// What a path may be too long by, relative, on the meshes below: 0 for what must be exact.
const std::map<std::string, double>& excess_allowed() {
  static const std::map<std::string, double> table = {
      {"Dijkstra", 0.42}, {"FMM", 0.08}, {"Heat", 0.15}, {"CH", 0},    {"ICH", 0},     {"VTP", 0}, {"SR", 0.05},
      {"LS", 0.15},       {"DE", 0.45},  {"SLO", 0.1},   {"LLM", 0.1}, {"VFCS", 0.05}, {"ours", 0}};
  return table;
}

constexpr double kRoundingOfLengths = 1e-9;

/// A sphere with dents and bumps: saddles, unequal faces.
PolygonSoup bumpy_sphere(int levels) {
  PolygonSoup soup = sphere(levels);
  for (Eigen::Vector3d& p : soup.positions)
    p *= 1 + 0.25 * std::sin(5 * p.x() + 1) * std::sin(4 * p.y()) * std::cos(3 * p.z());
  return soup;
}

void check_pair(const TriangleMesh& mesh, const MethodEntry& entry, Method& method, std::int32_t source,
                std::int32_t target, double exact) {
  CAPTURE(entry.name, source, target, exact);
  const Answer answer = method.shortest(source, target, {});
  CAPTURE(answer.note);
  REQUIRE(answer.outcome == Outcome::found);
  REQUIRE(answer.path.faces.size() + 1 == answer.path.points.size());
  CHECK(lies_on(mesh, answer.path));
  CHECK((answer.path.points.front() - mesh.position(source)).norm() < 1e-12);
  CHECK((answer.path.points.back() - mesh.position(target)).norm() < 1e-12);
  const double length = path_length(answer.path);
  CHECK(length >= exact * (1 - kRoundingOfLengths));
  CHECK(length <= exact * (1 + kRoundingOfLengths + excess_allowed().at(std::string(entry.name))));
  if (entry.kind == Kind::exact) CHECK(answer.distance == Approx(exact).epsilon(kRoundingOfLengths));
}

void check_all(const TriangleMesh& mesh, const std::vector<std::pair<std::int32_t, std::int32_t>>& pairs) {
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  for (const MethodEntry& entry : all_methods()) {
    const std::unique_ptr<Method> method = entry.make();
    method->prepare(mesh, {});
    for (const auto& [source, target] : pairs) {
      const ExactResult exact = search.shortest(vertex_point(mesh, source), vertex_point(mesh, target), workspace);
      REQUIRE(exact.is_proved());
      check_pair(mesh, entry, *method, source, target, exact.length);
    }
  }
}

}  // namespace

TEST_CASE("comparison: the twelve methods of the paper and ours, each under its own name") {
  std::set<std::string> names;
  for (const MethodEntry& entry : all_methods()) names.emplace(entry.name);
  CHECK(names == std::set<std::string>{"Dijkstra", "FMM", "Heat", "CH", "ICH", "VTP", "SR", "LS", "DE", "SLO", "LLM",
                                       "VFCS", "ours"});
}

TEST_CASE("comparison: every method on a bumpy sphere") {
  const TriangleMesh mesh(bumpy_sphere(3));
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs = {{0, 1}, {2, 5}, {7, 7 + mesh.vertex_count() / 2}};
  for (int k = 0; k < 3; ++k) pairs.emplace_back(11 + 17 * k, mesh.vertex_count() - 1 - 41 * k);
  check_all(mesh, pairs);
}

TEST_CASE("comparison: every method across flat vertices, along edges and between neighbours") {
  const TriangleMesh mesh(cube(), {false, 3});  // most vertices are flat
  const std::int32_t neighbour = mesh.neighbours(0).front();
  // The length between opposite corners of the unit cube is sqrt 5.
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  CHECK(search.shortest(vertex_point(mesh, 0), vertex_point(mesh, 7), workspace).length ==
        Approx(std::sqrt(5.0)).epsilon(1e-12));
  check_all(mesh, {{0, 7}, {0, 1}, {0, neighbour}, {3, mesh.vertex_count() - 1}});
}

TEST_CASE("comparison: the window methods give the exact distances on rough ground") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> height(0, 0.15);
  const TriangleMesh mesh(sheet(12, 12, [&](double u, double v) { return Eigen::Vector3d(u, v, height(random)); }));
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const ExactDistances all = search.distances(vertex_point(mesh, 0), workspace);
  for (const MethodEntry& entry : all_methods()) {
    if (entry.kind != Kind::exact) continue;
    const std::unique_ptr<Method> method = entry.make();
    method->prepare(mesh, {});
    for (std::int32_t v = 5; v < mesh.vertex_count(); v += 13)
      check_pair(mesh, entry, *method, 0, v, all.at_most[static_cast<std::size_t>(v)]);
  }
}

TEST_CASE("comparison: a query that is stopped says so") {
  const TriangleMesh mesh(bumpy_sphere(4));
  for (const char* name : {"CH", "LS", "LLM", "DE", "SR"})
    for (const MethodEntry& entry : all_methods()) {
      if (entry.name != name) continue;
      CAPTURE(name);
      const std::unique_ptr<Method> method = entry.make();
      method->prepare(mesh, {});
      int looks = 0;
      CHECK(method->shortest(0, 1, [&looks] { return ++looks > 3; }).outcome != Outcome::found);
    }
}

}  // namespace leastcost::test
