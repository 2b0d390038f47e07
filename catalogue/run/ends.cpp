// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/ends.hpp"

#include <fmt/format.h>

#include <leastcost/framework/errors.hpp>
#include <leastcost/problems/manifolds/file_places.hpp>
#include <leastcost/problems/manifolds/made_from_data.hpp>

namespace leastcost {
namespace {

/// Calls `place`; an OptionError of the domain gets the path of the end in front of its key.
template <class Place>
PathEnd with_path(const std::string& path, Place place) {
  try {
    return place();
  } catch (const OptionError& e) {
    throw OptionError(path + "." + e.key(), e.what());
  }
}

PlacedEnd at_vertex(const ConstraintManifold& manifold, const HasVertices& domain, int number,
                    const std::string& path) {
  const PathEnd vertex = with_path(path, [&] { return domain.vertex(number); });
  PlacedEnd placed{vertex.u, vertex, 0};
  if (vertex.site == kNoSite) placed.end = project_end(manifold, vertex.u, &placed.moved);
  return placed;
}

PlacedEnd on_face(const HasFaces& domain, int face, const std::optional<Eigen::VectorXd>& barycentric,
                  const std::string& path) {
  if (!barycentric || barycentric->size() != 3) throw OptionError(path + ".barycentric", "must have three numbers");
  const PathEnd end = with_path(path, [&] { return domain.on_face(face, *barycentric); });
  return {end.u, end, 0};
}

/// Data forgives coordinates that were copied with few digits; elsewhere there is nothing to snap to.
double default_tolerance(const ConstraintManifold& manifold, const Eigen::VectorXd& point) {
  constexpr double kRounding = 1e-9;
  const auto* data = find_ability<MadeFromData>(manifold);
  return data != nullptr ? data->end_tolerance() : kRounding * (1 + point.norm());
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
  if (options.vertex) {
    if (const auto* domain = find_ability<HasVertices>(manifold))
      return at_vertex(manifold, *domain, *options.vertex, path);
    throw OptionError(path + ".vertex", "the manifold has no vertices: give {point: [..]}");
  }
  if (options.face) {
    if (const auto* domain = find_ability<HasFaces>(manifold))
      return on_face(*domain, *options.face, options.barycentric, path);
    throw OptionError(path + ".face", "the manifold has no faces: give {point: [..]}");
  }
  return at_point(manifold, options, path);
}

}  // namespace leastcost
