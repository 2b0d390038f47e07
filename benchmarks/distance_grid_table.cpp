// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Making a signed-distance grid with 128 cells along the longest side, by phase, and what queries on it take, on one
// thread: from a mesh (the file that is named, else $LEASTCOST_DATA/meshes/bunny_70k.obj), from a torus given by a
// formula, from 20,000 samples of it.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <leastcost/problems/distance/build_distance_grid.hpp>
#include <leastcost/problems/manifolds/data/signed_distance.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include "problems/distance/cloud_distance.hpp"
#include "problems/distance/implicit_distance.hpp"
#include "problems/distance/mesh_distance.hpp"
#include "problems/level_set/formula_constraint.hpp"

namespace {

using Eigen::Vector3d;
using namespace leastcost;

constexpr int kCells = 128, kMargin = 8;
constexpr unsigned kSeed = 1;
constexpr std::size_t kQueries = 100000;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Prints how long each phase of a build took.
class Phases {
 public:
  void next(std::string_view phase) {
    if (phase == phase_) return;
    end();
    phase_ = phase;
    start_ = std::chrono::steady_clock::now();
  }
  void end() {
    if (!phase_.empty()) std::printf("  %-32s %7.2f s\n", phase_.c_str(), seconds_since(start_));
    phase_.clear();
  }

 private:
  std::string phase_;
  std::chrono::steady_clock::time_point start_;
};

/// Random points within half a cell of nodes near the surface.
std::vector<Vector3d> points_near(const DistanceGrid& grid) {
  std::mt19937_64 engine(kSeed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const GridShape& shape = grid.shape();
  std::vector<Vector3d> points;
  while (points.size() < kQueries) {
    const Vector3d at(uniform(engine), uniform(engine), uniform(engine));
    const Vector3d x = shape.origin + at.cwiseProduct(shape.upper() - shape.origin);
    Vector3d gradient;
    if (std::abs(grid.evaluate(x, gradient)) < shape.cell / 2) points.push_back(x);
  }
  return points;
}

void queries(const DistanceGrid& grid) {
  const std::vector<Vector3d> points = points_near(grid);
  auto start = std::chrono::steady_clock::now();
  double sum = 0;
  Vector3d gradient;
  for (const Vector3d& x : points) sum += grid.evaluate(x, gradient) + gradient[0];
  const double count = static_cast<double>(points.size());
  std::printf("  %-32s %7.2f million per second (sum %.3g)\n", "value and gradient",
              1e-6 * count / seconds_since(start), sum);
  const SignedDistanceManifold manifold(grid);
  CoordinatePath path{Points(3, static_cast<Index>(points.size())), {}, true};
  for (std::size_t i = 0; i < points.size(); ++i) path.u.col(static_cast<Index>(i)) = points[i];
  start = std::chrono::steady_clock::now();
  const std::size_t failed = manifold.project(path).failed.size();
  std::printf("  %-32s %7.2f million per second (%zu failed)\n", "projections from within a cell",
              1e-6 * count / seconds_since(start), failed);
}

void row(const char* title, const DistanceSource& source, double cells = kCells) {
  std::printf("%s\n", title);
  const DistanceGridSettings settings{.cell = source.box().sizes().maxCoeff() / (cells - 2 * kMargin),
                                      .margin = kMargin};
  Phases phases;
  const auto start = std::chrono::steady_clock::now();
  const SampledDistance built =
      build_distance_grid(source, settings, [&](double, std::string_view phase) { phases.next(phase); });
  const double seconds = seconds_since(start);
  phases.end();
  std::printf("  %-32s %7.2f s; %s\n", "together", seconds, text(built.grid.shape()).c_str());
  std::printf("  %-32s %.3g of a cell, mean %.3g\n", "surface of the grid off by", built.worst / *settings.cell,
              built.mean / *settings.cell);
  queries(built.grid);
}

/// Quasi-random samples of the torus with radii 2 and 1.
PointSamples torus_samples(int count) {
  PointSamples samples;
  const double g = 1.32471795724474602596;  // the plastic number: g^3 = g + 1
  for (int i = 1; i <= count; ++i) {
    const double u = 2 * std::numbers::pi * std::fmod(0.5 + i / g, 1.0);
    const double v = 2 * std::numbers::pi * std::fmod(0.5 + i / (g * g), 1.0);
    samples.positions.emplace_back((2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v));
  }
  return samples;
}

}  // namespace

int main(int argc, char** argv) {
  const char* data = std::getenv("LEASTCOST_DATA");
  const std::filesystem::path file =
      argc > 1 ? argv[1] : std::filesystem::path(data != nullptr ? data : "../shared/data") / "meshes/bunny_70k.obj";
  if (std::filesystem::exists(file)) {
    const auto start = std::chrono::steady_clock::now();
    const TriangleMesh mesh(read_mesh(file), {});
    const auto source = make_mesh_distance(mesh, true);
    std::printf("%s: read and searched in %.2f s\n", file.filename().c_str(), seconds_since(start));
    row("mesh", *source);
  }
  const Eigen::AlignedBox3d box(Vector3d(-3, -3, -1), Vector3d(3, 3, 1));
  const Formulas torus = formulas_of_option("f", {"(sqrt(x^2 + y^2) - 2)^2 + z^2 - 1"}, {"x", "y", "z"}, {});
  row("formula of a torus", *make_implicit_distance(make_formula_constraint(torus), box));
  constexpr int kSamples = 20000, kFewerCells = 64;
  row("cloud of a torus, 64 cells", *make_cloud_distance(PointCloud(torus_samples(kSamples), {}), true), kFewerCells);
  return 0;
}
