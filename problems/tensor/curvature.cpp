// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/tensor/curvature.hpp"

#include <leastcost/problems/cloud/neighbour_search.hpp>
#include "problems/cloud/local_fit.hpp"

namespace leastcost {
namespace {

constexpr double kOppositeSheet = -0.5;  ///< cosine of 120 degrees
constexpr double kWider = 1.5;
constexpr double kWidest = 4;

}  // namespace

std::vector<Eigen::Matrix3d> shape_operators(const SurfaceSamples& samples, double radius) {
  const NeighbourSearch search(samples.positions);
  std::vector<Eigen::Matrix3d> shapes;
  shapes.reserve(samples.positions.size());
  std::vector<Neighbour> found;
  std::vector<Eigen::Vector3d> offsets;
  for (std::size_t i = 0; i < samples.positions.size(); ++i) {
    const Eigen::Vector3d& normal = samples.normals[i];
    LocalFit fit;
    for (double wider = 1; !fit.valid && !normal.isZero(0) && wider <= kWidest; wider *= kWider) {
      const double reach = wider * radius * samples.spacing[i];
      search.within(samples.positions[i], reach, found);
      offsets.clear();
      for (const Neighbour& near : found) {
        const auto j = static_cast<std::size_t>(near.index);
        if (samples.oriented && normal.dot(samples.normals[j]) < kOppositeSheet) continue;
        offsets.emplace_back(samples.positions[j] - samples.positions[i]);
      }
      fit = fit_locally(offsets, reach, normal);
    }
    shapes.push_back(fit.shape);
  }
  return shapes;
}

std::vector<Eigen::Matrix3d> isophotic_metric(const std::vector<Eigen::Matrix3d>& shapes, double weight) {
  std::vector<Eigen::Matrix3d> metric;
  metric.reserve(shapes.size());
  for (const Eigen::Matrix3d& shape : shapes)
    metric.emplace_back(Eigen::Matrix3d::Identity() + weight * weight * shape * shape);
  return metric;
}

}  // namespace leastcost
