// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Data as it is: meshes, clouds, and a cost sampled over the plane.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <leastcost/framework/segment_cost.hpp>
#include "catalogue/scene/domain_shapes.hpp"
#include "catalogue/scene/thinned.hpp"

namespace leastcost {

TriangleSoup mesh_surface(const TriangleMesh& mesh, const Points& focus, std::size_t budget,
                          std::vector<std::string>& notes) {
  TriangleSoup all{mesh.positions(), {}};
  for (const auto& [a, b, c] : mesh.faces()) all.triangles.push_back({a, b, c});
  TriangleSoup out = thinned(std::move(all), focus, budget);
  if (out.triangles.size() < mesh.faces().size())
    notes.push_back(fmt::format("drawn with {} triangles instead of {}, with all near the path", out.triangles.size(),
                                mesh.face_count()));
  return out;
}

Surfels cloud_surfels(const PointCloud& cloud, std::size_t most, std::vector<std::string>& notes) {
  const std::vector<CloudSample>& samples = cloud.samples();
  const std::size_t step = (samples.size() + most - 1) / most;
  Surfels out;
  for (std::size_t i = 0; i < samples.size(); i += step) {
    out.positions.emplace_back(samples[i].position + cloud.centre());
    out.normals.push_back(samples[i].normal);
    out.spacing += cloud.spacing(static_cast<std::int32_t>(i));
  }
  out.spacing *= std::sqrt(static_cast<double>(step)) / static_cast<double>(out.positions.size());
  if (step > 1) notes.push_back(fmt::format("drawn with {} of {} points", out.positions.size(), samples.size()));
  return out;
}

std::optional<Raster> cost_raster(const SegmentCost& cost, const Surroundings& rectangle) {
  constexpr int kLongest = 96, kDirections = 6;
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
      for (int k = 0; k < kDirections; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.5) / kDirections;
        v << std::cos(angle), std::sin(angle);
        sum += cost.line_element(x, v) / kDirections;
      }
      raster.values.push_back(std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity());
      least = std::min(least, raster.values.back());
      largest = std::max(largest, raster.values.back());
    }
  }
  if (!(largest > least * (1 + kUniform))) return std::nullopt;
  return raster;
}

}  // namespace leastcost
