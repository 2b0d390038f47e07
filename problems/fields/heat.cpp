// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/fields/heat.hpp>

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"
#include "problems/fields/intrinsic_mesh.hpp"

namespace leastcost {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Cholesky = Eigen::SimplicialLDLT<SparseMatrix>;

/// Heat falls off like exp(-d / sqrt(t)): with sqrt(t) below this part of the diameter it would leave the range of
/// doubles on the far side of the surface.
constexpr double kLeastReach = 1.0 / 400;
/// Of the mass, added to the singular Laplacian in units of 1 / diameter^2: far below its least positive eigenvalue.
constexpr double kShift = 1e-9;

void throw_if_stopped(const HeatOptions& options) {
  if (options.stop && options.stop()) throw Interrupted("heat distances: stopped while the systems were set up");
}

}  // namespace

struct HeatDistances::Systems {
  explicit Systems(const TriangleMesh& m) : mesh(&m), intrinsic(m) {}
  const TriangleMesh* mesh;
  IntrinsicMesh intrinsic;
  std::int64_t flips = 0;
  Cholesky flow, poisson;
};

HeatDistances::HeatDistances(const TriangleMesh& mesh, const HeatOptions& options) {
  if (!(options.time > 0)) throw OptionError("time", "is " + short_number(options.time) + ", but must be above 0");
  auto systems = std::make_unique<Systems>(mesh);
  IntrinsicMesh& intrinsic = systems->intrinsic;
  if (options.delaunay) systems->flips = intrinsic.make_delaunay(options.stop);
  throw_if_stopped(options);

  std::vector<Eigen::Triplet<double>> stiffness, masses;
  for (std::int32_t f = 0; f < intrinsic.face_count(); ++f) {
    const auto& v = intrinsic.vertices(f);
    const auto cotangents = intrinsic.cotangents(f);
    const double third = intrinsic.area(f) / 3;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = v[k], b = v[(k + 1) % 3];
      const double weight = 0.5 * cotangents[k];
      stiffness.emplace_back(a, a, weight);
      stiffness.emplace_back(b, b, weight);
      stiffness.emplace_back(a, b, -weight);
      stiffness.emplace_back(b, a, -weight);
      masses.emplace_back(a, a, third);
    }
  }
  const int n = mesh.vertex_count();
  SparseMatrix laplacian(n, n), mass(n, n);
  laplacian.setFromTriplets(stiffness.begin(), stiffness.end());
  mass.setFromTriplets(masses.begin(), masses.end());
  const double diameter = mesh.diameter();
  if (!(mass.diagonal().sum() > 0)) throw InputError(mesh.source() + ": no face has an area: heat cannot flow");
  // A vertex of faces without area alone has no mass: as much as rounding needs to solve.
  const double least = 1e-14 * mass.diagonal().maxCoeff();
  for (int v = 0; v < n; ++v) mass.coeffRef(v, v) = std::max(mass.coeff(v, v), least);
  const double reach = std::max(std::sqrt(options.time) * intrinsic.mean_length(), kLeastReach * diameter);
  systems->flow.compute(mass + reach * reach * laplacian);
  throw_if_stopped(options);
  systems->poisson.compute(laplacian + kShift / (diameter * diameter) * mass);
  if (systems->flow.info() != Eigen::Success || systems->poisson.info() != Eigen::Success)
    throw InputError(mesh.source() +
                     ": the systems of the heat method cannot be factored; are there faces without area?");
  systems_ = std::move(systems);
}

HeatDistances::~HeatDistances() = default;
HeatDistances::HeatDistances(HeatDistances&&) noexcept = default;
HeatDistances& HeatDistances::operator=(HeatDistances&&) noexcept = default;

std::int64_t HeatDistances::flips() const { return systems_->flips; }

std::vector<double> HeatDistances::from(const SurfacePoint& source) const {
  const TriangleMesh& mesh = *systems_->mesh;
  const IntrinsicMesh& intrinsic = systems_->intrinsic;
  Eigen::VectorXd heat = Eigen::VectorXd::Zero(mesh.vertex_count());
  const auto& corners = mesh.face(source.face);
  for (std::size_t k = 0; k < 3; ++k) heat[corners[k]] += source.barycentric[static_cast<Eigen::Index>(k)];
  heat = systems_->flow.solve(heat);

  // The divergence of the unit field, tested with the hat function of each vertex.
  Eigen::VectorXd divergence = Eigen::VectorXd::Zero(mesh.vertex_count());
  for (std::int32_t f = 0; f < intrinsic.face_count(); ++f) {
    const auto& v = intrinsic.vertices(f);
    const auto& l = intrinsic.lengths(f);
    const double area = intrinsic.area(f);
    if (!(area > 0) || !(l[0] > 0)) continue;
    // Corners at (0, 0), (l0, 0), (x, y); the gradient of hat k is its opposite side turned by 90 degrees / 2 area.
    const double x = (l[0] * l[0] + l[2] * l[2] - l[1] * l[1]) / (2 * l[0]), y = 2 * area / l[0];
    const std::array<Eigen::Vector2d, 3> hats = {Eigen::Vector2d(-y, x - l[0]) / (2 * area),
                                                 Eigen::Vector2d(y, -x) / (2 * area),
                                                 Eigen::Vector2d(0, l[0]) / (2 * area)};
    const double scale = std::max({std::abs(heat[v[0]]), std::abs(heat[v[1]]), std::abs(heat[v[2]])});
    if (!(scale > 0)) continue;
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < 3; ++k) gradient += heat[v[k]] / scale * hats[k];
    const double norm = gradient.norm();
    if (!(norm > 0)) continue;
    for (std::size_t k = 0; k < 3; ++k) divergence[v[k]] -= area * gradient.dot(hats[k]) / norm;
  }
  const Eigen::VectorXd potential = systems_->poisson.solve(divergence);

  double origin = 0;
  for (std::size_t k = 0; k < 3; ++k)
    origin += source.barycentric[static_cast<Eigen::Index>(k)] * potential[corners[k]];
  std::vector<double> distances(static_cast<std::size_t>(mesh.vertex_count()));
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v)
    distances[static_cast<std::size_t>(v)] = mesh.component(v) == mesh.component(corners[0])
                                                 ? std::max(0.0, potential[v] - origin)
                                                 : std::numeric_limits<double>::infinity();
  return distances;
}

std::vector<double> heat_distances(const TriangleMesh& mesh, const SurfacePoint& source, const HeatOptions& options) {
  return HeatDistances(mesh, options).from(source);
}

}  // namespace leastcost
