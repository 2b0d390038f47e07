// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What a page asks: shortest paths on one mesh, or among obstacles in the plane, by the library's own searches. A C
// interface, as WebAssembly knows only numbers; one mesh and one plan per module. What is thrown becomes a text.
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include <leastcost/problems/straighten/geodesic.hpp>
#include "problems/taut/tangent_path.hpp"
#include "problems/taut/tangent_search.hpp"
#include "problems/taut/taut_path.hpp"

namespace leastcost {
namespace {

constexpr double kTolerance = 1e-9;  // gap that counts as proved, as in a run
constexpr double kMemory = 1.2e9;    // bytes of windows; the module may have 2 GB
constexpr double kExcess = 1e-6;     // of the polyline of a plan over the path along the circles, as in a run
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct OneMesh {
  explicit OneMesh(const PolygonSoup& soup) : mesh(soup), exact(mesh), space(exact), routes(mesh) {}
  TriangleMesh mesh;
  ExactSearch exact;
  ExactSearch::Workspace space;
  GeodesicSearch routes;
};

/// What the last question found, as numbers: proved (1, 0), length, lower bound, number of points, then their
/// coordinates.
struct Answer {
  std::vector<double> numbers;
  void set(bool proved, double length, double bound, const std::vector<double>& coordinates, int dimension) {
    numbers = {proved ? 1.0 : 0.0, length, bound, static_cast<double>(coordinates.size()) / dimension};
    numbers.insert(numbers.end(), coordinates.begin(), coordinates.end());
  }
};

std::unique_ptr<OneMesh> the_mesh;
std::unique_ptr<ObstacleWalls> the_walls;
Eigen::AlignedBox2d the_box;
Answer the_answer;
std::string the_fault;  // of the last call; empty: none

/// Whether `work` came to its end.
template <class Work>
std::int32_t done(const Work& work) {
  the_fault.clear();
  try {
    work();
  } catch (const std::exception& error) {
    the_fault = error.what();
    if (the_fault.empty()) the_fault = "no reason";
  }
  return the_fault.empty() ? 1 : 0;
}

std::function<bool()> after(double seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  return [end] { return std::chrono::steady_clock::now() > end; };
}

}  // namespace
}  // namespace leastcost

using namespace leastcost;  // NOLINT: of functions that C sees

extern "C" {

void* give(std::int32_t bytes) { return std::malloc(static_cast<std::size_t>(bytes)); }
void take_back(void* memory) { std::free(memory); }
const double* answer() { return the_answer.numbers.data(); }
const char* fault() { return the_fault.c_str(); }

/// Triangles of vertices, three numbers each; numbers as in the arrays.
std::int32_t load_mesh(const double* coordinates, std::int32_t vertices, const std::int32_t* corners,
                       std::int32_t faces) {
  return done([&] {
    PolygonSoup soup;
    soup.source = "the page";
    for (std::int32_t v = 0; v < vertices; ++v)
      soup.positions.emplace_back(coordinates[3 * v], coordinates[3 * v + 1], coordinates[3 * v + 2]);
    soup.corners.assign(corners, corners + std::ptrdiff_t{3} * faces);
    for (std::int32_t f = 0; f <= faces; ++f) soup.polygon_begin.push_back(3 * f);
    the_mesh.reset();
    the_mesh = std::make_unique<OneMesh>(soup);
  });
}

/// Between two points on faces, by their barycentric coordinates. The faces are those of load_mesh().
std::int32_t on_mesh(std::int32_t source_face, double s0, double s1, double s2, std::int32_t target_face, double t0,
                     double t1, double t2, double seconds) {
  return done([&] {
    OneMesh& m = *the_mesh;
    const SurfacePoint source = m.mesh.locate(source_face, {s0, s1, s2});
    const SurfacePoint target = m.mesh.locate(target_face, {t0, t1, t2});
    Geodesic first = m.routes.shortest(source, target, {.routes = 1});
    ExactOptions options;
    options.tolerance = kTolerance;
    options.max_memory = kMemory;
    options.stop = after(seconds);
    if (first.found()) options.start = &first.result.path;
    const ExactResult found = m.exact.shortest(source, target, m.space, options);
    std::vector<double> points;
    for (const Eigen::Vector3d& p : found.path.points) points.insert(points.end(), {p[0], p[1], p[2]});
    the_answer.set(found.is_proved(), found.length, found.lower_bound, points, 3);
  });
}

/// Obstacles by the corners of their cores, `counts` corners each (one: a ball), and what is required around them; a
/// box for paths, infinite where there is none: lower x, y, upper x, y.
std::int32_t load_plan(const double* corners, const std::int32_t* counts, const double* required,
                       std::int32_t obstacles, const double* box) {
  return done([&] {
    double clearance = kInfinity;  // that of the polygons: they have no radius of their own
    for (std::int32_t i = 0; i < obstacles; ++i)
      if (counts[i] > 1) clearance = std::min(clearance, required[i]);
    if (!std::isfinite(clearance)) clearance = 0;
    ObstacleWalls::Obstacles made;
    for (std::int32_t i = 0; i < obstacles; corners += std::ptrdiff_t{2} * counts[i], ++i) {
      const Eigen::Map<const Eigen::MatrixXd> columns(corners, 2, counts[i]);
      made.push_back(counts[i] == 1 ? make_ball({.center = columns, .radius = required[i] - clearance})
                                    : make_polygon({.corners = columns.transpose()}));
    }
    the_walls = std::make_unique<ObstacleWalls>(2, std::move(made), clearance);
    the_box = Eigen::AlignedBox2d(Eigen::Vector2d(box[0], box[1]), Eigen::Vector2d(box[2], box[3]));
  });
}

/// How far a place is from all that is required; negative: it is taken.
double room_at(double x, double y) {
  const Eigen::Vector2d place(x, y);
  return the_walls->clearance(place, place).upper;
}

std::int32_t in_plane(double x, double y, double u, double v, double seconds) {
  return done([&] {
    const Eigen::Vector2d source(x, y), target(u, v);
    TangentSearchOptions options;
    options.tolerance = kTolerance;
    options.stop = after(seconds);
    options.box = the_box;
    const TangentSearchResult found = shorter_tangent_path(*the_walls, source, target, kInfinity, options);
    the_answer.set(false, kInfinity, found.lower_bound, {}, 2);
    if (!found.shorter) return;
    const auto path = TangentPath::make(*the_walls, source, target, found.bends, {});
    if (!path) return;
    const auto taut = taut_path(*the_walls, path->polyline(kExcess), kExcess, {});
    if (!taut) return;
    const bool proved =
        found.finished && taut->least - found.lower_bound <= kTolerance * taut->least + 2 * found.rounding;
    const double* first = taut->polyline.data();
    the_answer.set(proved, taut->least, found.lower_bound, {first, first + taut->polyline.size()}, 2);
  });
}

}  // extern "C"
