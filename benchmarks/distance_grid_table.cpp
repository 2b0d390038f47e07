// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Building a signed-distance grid of about 128 nodes along the longest side from a mesh, by phase, and what queries on it take: the file given,
// else $LEASTCOST_DATA/meshes/bunny_70k.obj. One thread.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <vector>

#include "problems/geometry/distance_grid.hpp"
#include "problems/geometry/mesh_distance.hpp"
#include "problems/readers/mesh_reader.hpp"

namespace {

using namespace leastcost;

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void row(const char* what, double seconds) { std::printf("%-28s %8.3f s\n", what, seconds); }

}  // namespace

int main(int argc, char** argv) {
  const char* data = std::getenv("LEASTCOST_DATA");
  const std::filesystem::path file =
      argc > 1 ? std::filesystem::path(argv[1])
               : std::filesystem::path(data ? data : "../shared/data") / "meshes/bunny_70k.obj";
  Stopwatch watch;
  const TriangleMesh mesh(read_mesh(file), {});
  row("mesh read", watch.lap());
  const auto source = make_mesh_distance(mesh, true);
  row("trees built", watch.lap());
  constexpr int kNodes = 128, kMargin = 8;
  const GridShape shape =
      grid_around(source->box(), source->box().sizes().maxCoeff() / (kNodes - 2 * kMargin), kMargin, 1e10);
  std::printf("%s\n", text(shape).c_str());
  std::vector<double> values =
      source->sample(shape, 6 * shape.cell, [&, last = std::string()](double, std::string_view phase) mutable {
        if (!last.empty() && phase != last) row(last.c_str(), watch.lap());
        last = phase;
      });
  row("signs", watch.lap());
  const DistanceGrid grid(shape, std::move(values));
  row("spline coefficients", watch.lap());

  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Eigen::Vector3d> points(100000);
  for (Eigen::Vector3d& x : points) {
    x = mesh.position(static_cast<std::int32_t>(uniform(engine) * mesh.vertex_count()));
    for (int a = 0; a < 3; ++a) x[a] += shape.cell * (uniform(engine) - 0.5);
  }
  watch.lap();
  double sum = 0;
  Eigen::Vector3d gradient;
  constexpr int kRepeats = 10;
  for (int r = 0; r < kRepeats; ++r)
    for (const Eigen::Vector3d& x : points) sum += grid.evaluate(x, gradient) + gradient[0];
  const double seconds = watch.lap();
  std::printf("%.1f million values with gradient per second (%g)\n",
              1e-6 * kRepeats * static_cast<double>(points.size()) / seconds, sum);
  return 0;
}
