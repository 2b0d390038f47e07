// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include <leastcost/problems/mesh/edge_graph.hpp>
#include <leastcost/problems/straighten/straighten.hpp>

/// What the tables of paths on meshes share: pairs of vertices, CPU time, and the way that is their unit.
namespace leastcost::bench {

using Pair = std::pair<std::int32_t, std::int32_t>;

/// CPU time of this thread.
inline double thread_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

inline double timed(const std::function<void()>& work) {
  const double begin = thread_milliseconds();
  work();
  return thread_milliseconds() - begin;
}

/// The least time of a few repetitions, fewer where one takes long.
inline double least_time(const std::function<void()>& work) {
  constexpr int kRounds = 3;
  constexpr double kLong = 200;  // milliseconds
  double least = timed(work), all = least;
  for (int k = 1; k < kRounds && all < kLong; ++k) {
    const double next = timed(work);
    all += next;
    least = std::min(least, next);
  }
  return least;
}

inline double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

inline double mean(const std::vector<double>& v) {
  double sum = 0;
  for (const double x : v) sum += x;
  return sum / static_cast<double>(v.size());
}

/// The unit: one first path over edges, straightened, with flips; no proof.
inline SurfacePath short_way(const TriangleMesh& mesh, EdgeGraphSearch& graph, Pair pair) {
  const SurfacePoint from = vertex_point(mesh, pair.first), to = vertex_point(mesh, pair.second);
  const Eigen::Vector3d goal = mesh.position(pair.second);
  EdgePathOptions options;
  options.lower_bound = [&goal](const Eigen::Vector3d& p) { return (p - goal).norm(); };
  const auto length = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (b - a).norm(); };
  StraightenOptions straighten_options;
  straighten_options.flips = true;
  return straighten(mesh, graph.shortest(from, to, length, options).path, straighten_options).path;
}

/// Vertices of the largest component. Far: more than a quarter of the bounding box's diagonal apart; near: 1 to 8 %.
inline std::vector<Pair> random_pairs(const TriangleMesh& mesh, int count, std::uint64_t seed, bool far) {
  constexpr int kTries = 1000000;
  std::mt19937_64 engine(seed);
  std::uniform_int_distribution<std::int32_t> any(0, mesh.vertex_count() - 1);
  const auto& sizes = mesh.component_sizes();
  const auto largest = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();
  std::vector<Pair> pairs;
  for (int k = 0; k < kTries && static_cast<int>(pairs.size()) < count; ++k) {
    const std::int32_t a = any(engine), b = any(engine);
    if (mesh.component(a) != largest || mesh.component(b) != largest) continue;
    const double apart = (mesh.position(a) - mesh.position(b)).norm() / mesh.diameter();
    if (far ? apart > 0.25 : apart > 0.01 && apart < 0.08) pairs.emplace_back(a, b);
  }
  return pairs;
}

}  // namespace leastcost::bench
