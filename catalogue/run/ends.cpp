// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/ends.hpp"

#include <fmt/format.h>

#include <cmath>

#include <leastcost/framework/errors.hpp>
#include <leastcost/problems/cloud/has_point_cloud.hpp>
#include <leastcost/problems/distance/has_distance_grid.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include <leastcost/problems/mesh/surface_path.hpp>

namespace leastcost {
namespace {

PlacedEnd on_mesh(const TriangleMesh& mesh, const SurfacePoint& p) {
  const Eigen::VectorXd position = mesh.point(p);
  return {position, {position, p.face}, 0};
}

PlacedEnd at_vertex(const TriangleMesh& mesh, int vertex, const std::string& path) {
  if (vertex < 0 || vertex >= mesh.file_vertex_count())
    throw OptionError(path + ".vertex",
                      fmt::format("the mesh has vertices 0 to {}, not {}", mesh.file_vertex_count() - 1, vertex));
  const std::int32_t here = mesh.vertex_of_file(vertex);
  if (here < 0) throw OptionError(path + ".vertex", fmt::format("no face of the mesh uses vertex {}", vertex));
  return on_mesh(mesh, vertex_point(mesh, here));
}

PlacedEnd on_face(const TriangleMesh& mesh, int face, const std::optional<Eigen::VectorXd>& barycentric,
                  const std::string& path) {
  if (face < 0 || face >= mesh.file_face_count())
    throw OptionError(path + ".face",
                      fmt::format("the mesh has faces 0 to {}, not {}", mesh.file_face_count() - 1, face));
  if (!barycentric || barycentric->size() != 3) throw OptionError(path + ".barycentric", "must have three numbers");
  const double sum = barycentric->sum();
  constexpr double kRounding = 1e-6;  // what locate() forgives
  if (!(std::abs(sum - 1) <= kRounding))
    throw OptionError(path + ".barycentric", fmt::format("the three weights must have the sum 1, not {}", sum));
  try {
    return on_mesh(mesh, mesh.locate(face, *barycentric));
  } catch (const InputError& e) {
    throw OptionError(path + ".face", e.what());
  }
}

PlacedEnd at_sample(const ConstraintManifold& manifold, const PointCloud& cloud, int number, const std::string& path) {
  const std::int32_t here = cloud.sample_of_file(number);
  if (here < 0)
    throw OptionError(path + ".vertex",
                      fmt::format("the cloud has no point {}, counted from 0, or it repeats an earlier "
                                  "one and was removed",
                                  number));
  const Eigen::VectorXd position = cloud.sample(here).position + cloud.centre();
  PlacedEnd placed{position, {}, 0};
  placed.end = project_end(manifold, position, &placed.moved);
  return placed;
}

/// A mesh, cloud or grid forgives coordinates that were copied with few digits; elsewhere there is nothing to snap to.
double default_tolerance(const ConstraintManifold& manifold, const Eigen::VectorXd& point) {
  constexpr double kOfDiameter = 0.01, kRounding = 1e-9;
  if (const auto* mesh = dynamic_cast<const HasMesh*>(&manifold)) return kOfDiameter * mesh->mesh().diameter();
  if (const auto* cloud = dynamic_cast<const HasPointCloud*>(&manifold)) return kOfDiameter * cloud->cloud().diameter();
  if (const auto* sampled = dynamic_cast<const HasDistanceGrid*>(&manifold))
    return kOfDiameter * (sampled->grid().shape().upper() - sampled->grid().shape().origin).norm();
  return kRounding * (1 + point.norm());
}

PlacedEnd at_point(const ConstraintManifold& manifold, const EndOptions& options, const std::string& path) {
  const int wanted = manifold.dimensions().coordinate;
  const Eigen::VectorXd point = options.point.value_or(Eigen::VectorXd());
  if (point.size() != wanted)
    throw OptionError(path + ".point",
                      fmt::format("{} coordinates, points of the manifold have {}", point.size(), wanted));
  if (!point.allFinite()) throw OptionError(path + ".point", "coordinates must be finite");
  PlacedEnd placed{point, {}, 0};
  try {
    placed.end = project_end(manifold, point, &placed.moved);
  } catch (const InputError& e) {
    throw OptionError(path + ".point", e.what());
  }
  const double tolerance = options.tolerance ? *options.tolerance : default_tolerance(manifold, point);
  if (placed.moved > tolerance) {
    throw OptionError(path + ".point",
                      fmt::format("the nearest point of the manifold is {:.6g} away, the tolerance is {:.6g} "
                                  "(option 'tolerance' of the end)",
                                  placed.moved, tolerance));
  }
  return placed;
}

}  // namespace

PlacedEnd place_end(const ConstraintManifold& manifold, const EndOptions& options, const std::string& path) {
  const auto* mesh = dynamic_cast<const HasMesh*>(&manifold);
  const bool needs_mesh = options.vertex || options.face;
  const auto* cloud = dynamic_cast<const HasPointCloud*>(&manifold);
  if (cloud != nullptr && options.vertex) return at_sample(manifold, cloud->cloud(), *options.vertex, path);
  if (needs_mesh && mesh == nullptr)
    throw OptionError(path, "vertices and faces are ends on a mesh only: give {point: [..]}");
  if (options.vertex) return at_vertex(mesh->mesh(), *options.vertex, path);
  if (options.face) return on_face(mesh->mesh(), *options.face, options.barycentric, path);
  return at_point(manifold, options, path);
}

}  // namespace leastcost
