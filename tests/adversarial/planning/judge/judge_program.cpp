// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// judge SCENE PATH [TOLERANCE]: whether a polyline keeps the clearance of a scene but for the tolerance (default 1e-9
// diameters), decided in rational numbers; and the length of the shortest one, among discs in the plane. Exit 0: it
// does, 1: it touches, 2: a fault of the files.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>

#include "tests/adversarial/planning/judge/exact.hpp"
#include "tests/adversarial/planning/judge/tangent_graph.hpp"

namespace {

double length(const std::vector<judge::Place>& path) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    double square = 0;
    for (std::size_t k = 0; k < path[i].size(); ++k)
      square += (path[i + 1][k] - path[i][k]) * (path[i + 1][k] - path[i][k]);
    sum += std::sqrt(square);
  }
  return sum;
}

int run(const char* scene_file, const char* path_file, const char* tolerance_text) {
  std::ifstream scene_in(scene_file), path_in(path_file);
  const judge::Scene scene = judge::read_scene(scene_in);
  const std::vector<judge::Place> path = judge::read_path(path_in, scene.dimension);
  if (path.size() < 2 || path.front() != scene.source || path.back() != scene.target) {
    std::printf("the path does not lead from the source to the target\n");
    return 1;
  }
  const double tolerance = tolerance_text != nullptr ? std::atof(tolerance_text) : 1e-9 * scene.diameter();
  std::printf("length %.17g\n", length(path));
  bool discs = scene.dimension == 2;
  for (const judge::Thing& thing : scene.things) discs = discs && thing.kind == judge::Thing::Kind::ball;
  if (discs)
    if (const auto least = judge::shortest_among_discs(scene)) std::printf("shortest %.17g\n", *least);
  const auto touch = judge::first_touch(scene, path, tolerance);
  if (touch)
    std::printf("segment %zu touches thing %zu\n", touch->segment, touch->thing);
  else
    std::printf("clear\n");
  return touch ? 1 : 0;
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) {
    std::fprintf(stderr, "judge SCENE PATH [TOLERANCE]\n");
    return 2;
  }
  try {
    return run(words[1], words[2], count > 3 ? words[3] : nullptr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "judge: %s\n", error.what());
    return 2;
  }
}
