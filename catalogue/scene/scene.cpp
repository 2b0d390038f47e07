// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <leastcost/framework/cost/segment_cost.hpp>
#include "catalogue/scene/relief.hpp"
#include "problems/drawing/surroundings.hpp"

namespace leastcost {
namespace {

Points side_by_side(const Points& a, const Points& b) {
  Points both(a.rows(), a.cols() + b.cols());
  both << a, b;
  return both;
}

/// A path as it runs on the domain: along the chart between its points, closed for a ring.
Points chart_line(const Problem& problem, const CoordinatePath& path) {
  constexpr Index kPoints = 400;
  const bool chart = find_ability<HasChart>(*problem.manifold) != nullptr;
  const Index moves = path.segment_count();
  const Index pieces = chart ? std::max<Index>(1, kPoints / std::max<Index>(1, moves)) : 1;
  CoordinatePath dense;
  dense.u.resize(path.u.rows(), moves * pieces + 1);
  for (Index i = 0; i < moves; ++i) {
    const Eigen::VectorXd a = path.column(i), b = path.column(i + 1);
    for (Index k = 0; k < pieces; ++k)
      dense.u.col(i * pieces + k) = a + (b - a) * static_cast<double>(k) / static_cast<double>(pieces);
  }
  dense.u.col(moves * pieces) = path.column(moves);
  return positions(*problem.manifold, dense);
}

/// The delivered curve. In a chart it is drawn through the points along the chart, because its chords lie below the
/// surface, unless it is more than its points (a zigzag).
Points path_line(const Problem& problem, const Result& result) {
  const bool only_points = result.curve.x.cols() == result.path.segment_count() + 1;
  if (find_ability<HasChart>(*problem.manifold) != nullptr && only_points) return chart_line(problem, result.path);
  return result.curve.x;
}

/// Cost per unit of length over a rectangle of the plane; nothing where it is the same everywhere.
std::optional<Raster> cost_raster(const SegmentCost& cost, const Surroundings& rectangle) {
  constexpr int kLongest = 96, kDirections = 24;
  constexpr double kUniform = 1e-6;
  const Eigen::Vector2d extent = rectangle.extent();
  const double cell = extent.maxCoeff() / kLongest;
  Raster raster{std::max(8, static_cast<int>(std::lround(extent[0] / cell))) + 1,
                std::max(8, static_cast<int>(std::lround(extent[1] / cell))) + 1,
                rectangle.lower,
                rectangle.upper,
                {}};
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  Eigen::VectorXd x(2), v(2);
  for (int j = 0; j < raster.rows; ++j) {
    for (int i = 0; i < raster.columns; ++i) {
      x << raster.lower[0] + extent[0] * i / (raster.columns - 1), raster.lower[1] + extent[1] * j / (raster.rows - 1);
      double sum = 0;
      int possible = 0;  // directions: a current may carry all but a few of them away
      for (int k = 0; k < kDirections; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.5) / kDirections;
        v << std::cos(angle), std::sin(angle);
        const double element = cost.line_element(x, v);
        if (!std::isfinite(element)) continue;
        sum += element;
        ++possible;
      }
      raster.values.push_back(possible > 0 ? sum / possible : std::numeric_limits<double>::infinity());
      least = std::min(least, raster.values.back());
      largest = std::max(largest, raster.values.back());
    }
  }
  if (!(largest > least * (1 + kUniform))) return std::nullopt;
  return raster;
}

std::optional<Raster> potential_raster(const Result& result) {
  if (!result.certificate.global || !result.certificate.global->grid) return std::nullopt;
  const PotentialSamples& samples = result.certificate.global->grid->potential;
  if (samples.columns < 2 || samples.rows < 2) return std::nullopt;
  return Raster{samples.columns, samples.rows, samples.box.min(), samples.box.max(), samples.values};
}

void draw_plane(const Problem& problem, const Points& paths, Scene& scene) {
  Surroundings shown = around(paths).enlarged(0.15);
  // A path along an axis still gets a picture with some height.
  const double least = shown.extent().maxCoeff() * 0.4;
  for (Index i = 0; i < 2; ++i) {
    const double missing = std::max(0.0, least - shown.extent()[i]) / 2;
    shown.lower[i] -= missing;
    shown.upper[i] += missing;
  }
  if (scene.lower.size() > 0) {
    shown.lower = shown.lower.cwiseMax(scene.lower);
    shown.upper = shown.upper.cwiseMin(scene.upper);
  }
  scene.cost = cost_raster(*problem.cost, shown);
}

}  // namespace

Scene make_scene(const Problem& problem, const Result& result, std::span<const FamilyMember> others) {
  Scene scene;
  scene.dimension = problem.manifold->dimensions().ambient;
  if (const auto* robot = find_ability<DrawsPoses>(*problem.manifold)) {
    const Points path = path_line(problem, result);
    if (path.cols() > 0 && path.allFinite()) scene.strip = robot->pose_strip(path);
  }
  if (scene.dimension != 2 && scene.dimension != 3) return scene;
  scene.lines.path = path_line(problem, result);
  scene.lines.first = chart_line(problem, result.first.path);
  for (const FamilyMember& member : others) scene.lines.others.push_back(path_line(member.problem, member.result));
  Points drawn = side_by_side(scene.lines.path, scene.lines.first);
  for (const Points& other : scene.lines.others) drawn = side_by_side(drawn, other);
  const Surroundings box = around(drawn);
  if (!box.lower.allFinite() || !(box.extent().maxCoeff() > 0)) return scene;
  if (const auto* domain = find_ability<DrawsItself>(*problem.manifold))
    domain->draw({drawn, side_by_side(result.path.u, result.first.path.u)}, scene);
  const bool plane = scene.dimension == 2 && problem.manifold->dimensions().tangent == 2 &&
                     find_ability<HasChart>(*problem.manifold) == nullptr;  // with obstacles or without
  if (plane) draw_plane(problem, drawn, scene);
  scene.relief = relief_around(*problem.manifold, drawn);
  scene.potential = potential_raster(result);
  return scene;
}

}  // namespace leastcost
