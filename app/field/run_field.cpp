// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/field/run_field.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/base/said_of.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include <leastcost/problems/raster/has_voids.hpp>
#include <leastcost/problems/robots/robot.hpp>
#include "catalogue/run/run_origin.hpp"
#include "catalogue/run/voids.hpp"
#include "problems/fields/no_way.hpp"
#include "problems/formula/coordinate_names.hpp"

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

/// Of a field over a lattice at a place. Beyond the outermost nodes, as in the outer half of a cell of a raster, it is
/// that of the nearest place among them and the straight move between the two.
double value_beside(const CostField& field, const Problem& problem, const Eigen::Vector2d& place) {
  if (!field.seams.empty()) return value_at(field, place);
  const Eigen::Vector2d near = place.cwiseMax(field.lower).cwiseMin(field.node(field.count[0] - 1, field.count[1] - 1));
  if (near == place) return value_at(field, place);
  return value_at(field, near) + (field.to_places ? cost_of_way(problem, std::vector<Eigen::Vector2d>{place, near})
                                                  : cost_of_way(problem, std::vector<Eigen::Vector2d>{near, place}));
}

/// Whatever is thrown about a place begins with its words.
template <class Work>
auto saying(const FieldPlace& place, Work work) {
  try {
    return work();
  } catch (const OptionError& e) {
    throw InputError(said_of(place.words, e.reason()));
  }
}

/// Throws InputError for a configuration that cannot have a field, or not from or to what the ends say.
void check_ends(const RunConfig& config, const FieldEnds& ends) {
  if (config.ring) throw InputError("field: a ring (path.ring: true) has no source: remove it");
  if (ends.from.empty() && config.has_pairs())
    throw InputError("field: the configuration has many pairs of ends: say where the field is from (--from X,Y)");
  if (ends.from.empty() && !config.source)
    throw InputError(
        "field: nothing says where it is from: give a source (--from X,Y), or the configuration ends: {source: {point: "
        "[X, Y]}} (on a mesh {vertex: 12})");
  if (ends.from.size() > 1 && config.cost.plugin->follows_source)
    throw InputError("field: this cost depends on the start of the path: give one place at a time");
}

EndOptions with_last(const std::vector<FieldPlace>& places, const EndOptions& otherwise) {
  return places.empty() ? otherwise : places.back().end;
}

/// Without the walls around cells of a raster that have no data, where there are no others: the costs know them, and a
/// field keeps no distance from them.
std::shared_ptr<const ConstraintManifold> without_voids(const RunConfig& config, const Problem& problem) {
  const bool walls = find_ability<HasWalls>(*problem.manifold) != nullptr;
  if (!walls || !config.obstacles.empty() || config.robot || config.clearance > 0) return problem.manifold;
  const ConstraintManifold* inner = problem.manifold->decorated(typeid(HasVoids));
  if (inner == nullptr) return problem.manifold;
  const bool voids =
      find_ability<HasVoids>(*inner) != nullptr || (problem.cost && find_ability<HasVoids>(*problem.cost) != nullptr);
  if (!voids || find_ability<HasWalls>(*inner) != nullptr) return problem.manifold;
  return {problem.manifold, inner};
}

}  // namespace

void check_dimension_of_field(const Problem& problem) {
  const ConstraintManifold& domain = *problem.manifold;
  const int d = domain.dimensions().coordinate;
  if (d == 2 || find_ability<HasMesh>(domain) != nullptr || (d == 3 && field_nodes(problem) == FieldNodes::space))
    return;
  throw InputError(
      d == 3
          ? "field: these three coordinates have none: it needs two coordinates, space or a box of it, or a mesh; "
            "leastcost run gives the least cost between two places"
          : fmt::format("field: there are none in {}: only in two and in three coordinates, and on a mesh; leastcost "
                        "run gives the least cost between two places",
                        d == 1 ? "one coordinate" : fmt::format("{} coordinates", d)));
}

std::vector<std::string> RunField::names() const {
  const Robot* robot = origin_->parts.robot.get();
  const auto d = static_cast<std::size_t>(problem_.manifold->dimensions().coordinate);
  if (robot != nullptr && robot->joints.size() == d) return robot->joints;
  if (robot != nullptr && robot->kinematics->link_count() == 1 && d == 3) return {"x", "y", "angle"};
  return point_coordinates(*problem_.manifold);
}

FieldNodes field_nodes(const Problem& problem) {
  if (find_ability<HasMesh>(*problem.manifold) != nullptr) return FieldNodes::mesh;
  return problem.manifold->dimensions().coordinate == 3 && is_in_space(problem) ? FieldNodes::space : FieldNodes::plane;
}

RunField::RunField(const Run& run, const FieldEnds& ends, const CostFieldOptions& options, const Monitor& monitor)
    : origin_(run.origin), problem_(run.parts.problem), options_(options) {
  const RunConfig& config = origin_->config;
  check_ends(config, ends);
  const std::vector<FieldPlace>& from = ends.from;
  source_ = config.source ? *config.source : from.front().end;
  // Of several targets a run takes the cheapest to reach; that is one from its own source alone.
  const bool one_target = config.target && !config.target->is_several();
  has_target_ = one_target || ends.target || (config.target && from.empty() && !config.ends_come_later());
  const EndOptions target = one_target ? *config.target : ends.target ? ends.target->end : with_last(from, source_);
  const auto placed = [&](const EndOptions& place) {
    return origin_->pairs->compose(place, target, origin_->pairs->parts()).problem;
  };
  // By itself: beside another place its faults would be said of that one.
  const FieldPlace* leads_to = one_target     ? nullptr
                               : ends.target  ? &*ends.target
                               : from.empty() ? nullptr
                                              : &from.back();
  if (leads_to != nullptr) saying(*leads_to, [&] { return placed(leads_to->end); });
  for (const FieldPlace& place : from) {
    const Problem problem = saying(place, [&] { return placed(place.end); });
    if (places_.empty()) problem_ = problem;
    places_.push_back(problem.source);
  }
  if (places_.empty() && config.ends_come_later()) {
    try {
      problem_ = placed(source_);
    } catch (const OptionError& e) {
      throw e.under("ends");
    }
  }
  if (places_.empty()) places_ = {problem_.source};
  notes_ = origin_->parts.notes;
  if (const auto open = without_voids(config, problem_); open != problem_.manifold) {
    problem_.manifold = open;
    std::erase_if(notes_, [](const std::string& note) { return note.starts_with(kVoidsNote); });
  }
  nodes_ = field_nodes(problem_);
  if (nodes_ == FieldNodes::plane) lattice_ = costs_from(problem_, coordinates_of(places_), options_, monitor);
  if (nodes_ == FieldNodes::space) space_ = space_costs_from(problem_, coordinates_of(places_), options_, monitor);
  if (nodes_ != FieldNodes::mesh) return;
  if (options_.resolution)
    throw OptionError("resolution", "is for lattices; on a mesh the nodes are its vertices: leave it out");
  const auto stop = [&monitor] { return monitor.interrupted(); };
  fields_ = std::make_shared<const MeshFields>(problem_, stop);
  vertices_ = fields_->from(points_of(*fields_, places_), stop);
}

PathEnd RunField::place(const FieldPlace& at) const {
  return saying(at, [&] { return origin_->pairs->compose(source_, at.end, origin_->pairs->parts()).problem.target; });
}

const PathEnd& RunField::target() const {
  if (!has_target_)
    throw InputError(
        "corridor: nothing says where it leads: give a target (--to X,Y), or the configuration ends with a target");
  return problem_.target;
}

RunField RunField::corridor(const PathEnd& target, const Monitor& monitor) const {
  RunField sum = *this;
  sum.corridor_ = true;
  sum.has_target_ = true;
  sum.problem_.target = target;
  if (on_mesh()) {
    const auto stop = [&monitor] { return monitor.interrupted(); };
    const SurfacePoint there = fields_->point(target);
    double least = 0;
    try {
      least = path_length(fields_->way(vertices_.places, there, stop));
    } catch (const NoWay&) {
      throw NoWay("corridor: no path joins the two places");
    }
    sum.vertices_ = app::corridor(vertices_, fields_->from({there}, stop), least);
    return sum;
  }
  double known = std::numeric_limits<double>::infinity();
  try {
    known = way(target, monitor).cost;
  } catch (const InputError&) {  // without a way there is no corridor, and corridor() says so; one may also be lost
  }
  CostFieldOptions back = options_;
  back.to_places = true;
  if (in_space()) {
    sum.space_ = leastcost::corridor(space_, space_costs_from(problem_, {target.u}, back, monitor), known);
    return sum;
  }
  sum.lattice_ = leastcost::corridor(lattice_, costs_from(problem_, {target.u}, back, monitor), known);
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
  if (in_space()) {
    const std::vector<Eigen::Vector3d> points = way_down(space_, problem_, place.u);
    way.cost = cost_of_way(problem_, points);
    way.points.assign(points.begin(), points.end());
    return way;
  }
  const std::vector<Eigen::Vector2d> points = way_down(lattice_, problem_, place.u);
  way.cost = cost_of_way(problem_, points);
  way.points.assign(points.begin(), points.end());
  way.value = value_beside(lattice_, problem_, place.u);
  return way;
}

}  // namespace leastcost::app
