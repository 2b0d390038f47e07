// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/field/run_field.hpp"

#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include "catalogue/run/run_origin.hpp"

namespace leastcost::app {
namespace {

std::vector<Eigen::VectorXd> coordinates_of(const std::vector<PathEnd>& places) {
  std::vector<Eigen::VectorXd> all;
  all.reserve(places.size());
  for (const PathEnd& place : places) all.push_back(place.u);
  return all;
}

std::vector<SurfacePoint> points_of(const MeshFields& fields, const std::vector<PathEnd>& places) {
  std::vector<SurfacePoint> all;
  all.reserve(places.size());
  for (const PathEnd& place : places) all.push_back(fields.point(place));
  return all;
}

/// Whatever is thrown about a place begins with its words.
template <class Work>
auto saying(const FieldPlace& place, Work work) {
  try {
    return work();
  } catch (const OptionError& e) {
    throw InputError(place.words + ": " + e.what());
  }
}

}  // namespace

RunField::RunField(const Run& run, const std::vector<FieldPlace>& from, const CostFieldOptions& options,
                   const Monitor& monitor)
    : origin_(run.origin), problem_(run.parts.problem), options_(options) {
  const RunConfig& config = origin_->config;
  if (config.has_pairs())
    throw InputError("field: the configuration has many pairs of ends: give it one source and one target");
  if (config.ring || !config.target || !origin_->pairs)
    throw InputError("field: needs a configuration with a source and a target");
  if (from.size() > 1 && config.cost.plugin->follows_source)
    throw InputError("field: this cost depends on where the path begins: give one place at a time");
  for (const FieldPlace& place : from) {
    const RunParts parts =
        saying(place, [&] { return origin_->pairs->compose(place.end, *config.target, origin_->pairs->parts()); });
    if (places_.empty()) problem_ = parts.problem;
    places_.push_back(parts.problem.source);
  }
  if (places_.empty()) places_ = {problem_.source};
  if (find_ability<HasMesh>(*problem_.manifold) == nullptr) {
    lattice_ = costs_from(problem_, coordinates_of(places_), options_, monitor);
    return;
  }
  if (options_.resolution)
    throw OptionError("resolution", "is of a lattice: the nodes of a mesh are its vertices; leave it out");
  const auto stop = [&monitor] { return monitor.interrupted(); };
  fields_ = std::make_shared<const MeshFields>(problem_, stop);
  vertices_ = fields_->from(points_of(*fields_, places_), stop);
}

PathEnd RunField::place(const FieldPlace& at) const {
  const EndOptions& source = *origin_->config.source;
  return saying(at, [&] { return origin_->pairs->compose(source, at.end, origin_->pairs->parts()).problem.target; });
}

RunField RunField::corridor(const PathEnd& target, const Monitor& monitor) const {
  RunField sum = *this;
  sum.corridor_ = true;
  sum.problem_.target = target;
  if (on_mesh()) {
    const MeshField to = fields_->from({fields_->point(target)}, [&monitor] { return monitor.interrupted(); });
    sum.vertices_ = app::corridor(vertices_, to);
    return sum;
  }
  CostFieldOptions back = options_;
  back.to_places = true;
  sum.lattice_ = leastcost::corridor(lattice_, costs_from(problem_, {target.u}, back, monitor));
  return sum;
}

FieldWay RunField::way(const PathEnd& place, const Monitor& monitor) const {
  FieldWay way;
  if (on_mesh()) {
    SurfacePath path =
        fields_->way(vertices_.places, fields_->point(place), [&monitor] { return monitor.interrupted(); });
    if (to_places()) path = reversed(path);
    way.cost = path_length(path);
    const Eigen::Index d = problem_.manifold->dimensions().coordinate;  // 2 on a map, whose mesh is at z = 0
    for (const Eigen::Vector3d& point : path.points) way.points.emplace_back(point.head(d));
    return way;
  }
  const std::vector<Eigen::Vector2d> points = way_down(lattice_, problem_, place.u);
  way.cost = cost_of_way(problem_, points);
  way.points.assign(points.begin(), points.end());
  return way;
}

}  // namespace leastcost::app
