// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The geodesics of measure.py in C++: geodesics MESH results/pairs.txt. Not part of a build:
//   c++ -std=c++20 -O2 -I build/release/include -isystem /usr/include/eigen3 python/benchmarks/geodesics.cpp \
//     build/release/problems/libleastcost_{mesh,core}.a build/release/framework/{,numbers/}libleastcost_*.a
#include <cstdio>
#include <ctime>
#include <fstream>
#include <utility>
#include <vector>

#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include <leastcost/problems/straighten/geodesic.hpp>

int main(int, char** arguments) {
  using namespace leastcost;
  const TriangleMesh mesh(read_mesh(arguments[1]));
  const ExactSearch exact(mesh);
  ExactSearch::Workspace workspace(exact);
  GeodesicSearch routes(mesh);
  std::vector<std::pair<int, int>> pairs;
  std::ifstream in(arguments[2]);
  for (int s = 0, t = 0; in >> s >> t;) pairs.emplace_back(s, t);
  const std::clock_t start = std::clock();
  double sum = 0;
  int proved = 0;
  for (const auto& [s, t] : pairs) {
    const SurfacePoint from = vertex_point(mesh, mesh.vertex_of_file(s));
    const SurfacePoint to = vertex_point(mesh, mesh.vertex_of_file(t));
    const Geodesic first = routes.shortest(from, to, {.routes = 1});
    const ExactResult found = exact.shortest(from, to, workspace, {.start = &first.result.path});
    sum += found.length;
    proved += found.is_proved() ? 1 : 0;
  }
  std::printf("%zu geodesics: %.2f CPU s, sum %.12f, proved %d\n", pairs.size(),
              static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, sum, proved);
}
