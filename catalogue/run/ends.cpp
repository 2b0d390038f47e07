// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/ends.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/framework/domain/has_images.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/framework/result/other_images.hpp>
#include <leastcost/problems/chart/is_geographic.hpp>
#include <leastcost/problems/manifolds/file_places.hpp>
#include <leastcost/problems/manifolds/made_from_data.hpp>
#include <leastcost/problems/occupancy/names_cells.hpp>
#include "framework/base/counted.hpp"
#include "framework/base/point_text.hpp"
#include "framework/problem/moved_end.hpp"
#include "framework/problem/one_place.hpp"
#include "problems/formula/coordinate_names.hpp"

namespace leastcost {
namespace {

/// Calls `place`; an OptionError of the domain gets the path of the end in front of its key.
template <class Place>
PathEnd with_path(const std::string& path, Place place) {
  try {
    return place();
  } catch (const OptionError& e) {
    throw e.under(path);
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

constexpr double kRounding = 1e-9;  ///< of coordinates

std::string name_of(const ConstraintManifold& manifold, Eigen::Index coordinate) {
  return point_coordinates(manifold)[static_cast<std::size_t>(coordinate)];
}

/// A place that was not given as an end of a configuration has no options.
std::string or_tolerance(const std::string& path) {
  return path.rfind("ends.", 0) == 0 ? ", or set 'tolerance' of the end" : "";
}

/// Throws for the coordinate that is beyond the sides of a box by more than rounding. Each is looked at by itself: one
/// that is large would forgive the others.
void check_sides(const ConstraintManifold& manifold, const Eigen::VectorXd& point, const std::string& path) {
  const auto* box = find_ability<HasBox>(manifold);
  const bool other_names = find_ability<HasImages>(manifold) != nullptr;  // one of them may be inside
  if (box == nullptr || other_names || find_ability<MadeFromData>(manifold) != nullptr) return;
  for (Eigen::Index i = 0; i < std::min(point.size(), box->box_lower().size()); ++i) {
    const double lower = box->box_lower()[i], upper = box->box_upper()[i];
    if (std::max(lower - point[i], point[i] - upper) <= kRounding * (1 + std::abs(point[i]))) continue;
    throw OptionError(path + ".point", fmt::format("must have {} between {} and {} (found {}): move the point{}",
                                                   name_of(manifold, i), lower, upper, point[i], or_tolerance(path)));
  }
}

/// Data forgives coordinates that were copied with few digits; elsewhere there is nothing to snap to.
double default_tolerance(const ConstraintManifold& manifold, const Eigen::VectorXd& point) {
  const auto* data = find_ability<MadeFromData>(manifold);
  return data != nullptr ? data->end_tolerance() : kRounding * (1 + point.norm());
}

/// The latitude of a chart with two poles: which coordinate it is, and where the north pole is.
struct LatitudeOfChart {
  Eigen::Index coordinate = 0;
  double pole = 0;
};

std::optional<LatitudeOfChart> latitude_of(const ConstraintManifold& manifold) {
  const auto* chart = find_ability<HasChart>(manifold);
  if (chart == nullptr || chart->poles().size() != 2) return std::nullopt;
  const SeamMap& over = chart->poles().front();
  for (Eigen::Index c = 0; c < over.sign.size(); ++c)
    if (over.sign[c] < 0) return LatitudeOfChart{c, std::abs(over.shift[c]) / 2};
  return std::nullopt;
}

/// On the Earth a latitude beyond a pole is a mistake, mostly of order. On a chart in radians it may state a way over a
/// pole; beyond a whole turn it is given in degrees.
void check_latitude(const ConstraintManifold& manifold, const Eigen::VectorXd& point, const std::string& path) {
  const std::optional<LatitudeOfChart> latitude = latitude_of(manifold);
  if (!latitude) return;
  const double value = point[latitude->coordinate];
  if (find_ability<IsGeographic>(manifold) != nullptr) {
    if (std::abs(value) > latitude->pole)
      throw OptionError(
          path + ".point",
          fmt::format(
              "the latitude {:.9g} is beyond {:g} degrees; give the point as (latitude, longitude), latitude first",
              value, latitude->pole));
  } else if (std::abs(value) > 4 * latitude->pole) {
    throw OptionError(path + ".point", fmt::format("the latitude {:.9g} is in radians here (the pole is at pi/2) and "
                                                   "more than a full turn; for degrees, use manifold: {{type: earth}}",
                                                   value));
  }
}

/// Ends that a user may have given in degrees.
void note_latitudes(RunParts& out) {
  const ConstraintManifold& manifold = *out.problem.manifold;
  const std::optional<LatitudeOfChart> latitude = latitude_of(manifold);
  if (!latitude || find_ability<IsGeographic>(manifold) != nullptr) return;
  for (const auto& [end, name] : {std::pair{&out.source, "source"}, std::pair{&out.target, "target"}}) {
    const double value = end->given[latitude->coordinate];
    if (std::abs(value) <= latitude->pole) continue;
    out.notes.push_back(
        fmt::format("the latitude {:.9g} of the {} is beyond pi/2; it was read in radians, as a path over a pole. For "
                    "degrees, use manifold: {{type: earth}}",
                    value, name));
  }
}

PlacedEnd at_point(const ConstraintManifold& manifold, const EndOptions& options, const std::string& path) {
  const int wanted = manifold.dimensions().coordinate;
  const Eigen::VectorXd point = options.point.value_or(Eigen::VectorXd());
  if (point.size() != wanted)
    throw OptionError(path + ".point", fmt::format("must have {} ({}; found {})", counted(wanted, "coordinate"),
                                                   fmt::join(point_coordinates(manifold), ", "), point.size()));
  if (!point.allFinite()) throw OptionError(path + ".point", "coordinates must be finite");
  check_latitude(manifold, point, path);
  if (!options.tolerance) check_sides(manifold, point, path);
  PlacedEnd placed{point, {}, 0};
  try {
    placed.end = project_end(manifold, point, &placed.moved);
  } catch (const InputError& e) {
    throw OptionError(path + ".point", e.what());
  }
  const double tolerance = options.tolerance ? *options.tolerance : default_tolerance(manifold, point);
  if (placed.moved > tolerance) {
    const auto* cells = find_ability<NamesCells>(manifold);
    const std::string why = cells != nullptr ? cells->why_not_free(point) : "";
    if (!why.empty()) {
      const std::string which = path.substr(path.rfind('.') + 1);  // npos + 1 is 0
      throw OptionError(path + ".point",
                        fmt::format("the {} {} (the nearest free point is {:.6g} away)", which, why, placed.moved));
    }
    const TwoNumbers texts = told_apart(placed.moved, tolerance, 6);
    throw OptionError(path + ".point",
                      fmt::format("the nearest point of the manifold is {} away, but the tolerance is {}: move the "
                                  "point{}",
                                  texts.first, texts.second, or_tolerance(path)));
  }
  return placed;
}

/// Whether a full turn of a coordinate brings every link to where it was.
bool turns(const Kinematics& robot, Eigen::VectorXd x, Eigen::Index coordinate) {
  constexpr double kSame = 1e-9;
  std::vector<Frame> before, after;
  robot.place(x, before);
  x[coordinate] += 2 * std::numbers::pi;
  robot.place(x, after);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double size = 1 + before[i].origin.norm();
    if ((after[i].rotation - before[i].rotation).norm() > kSame) return false;
    if ((after[i].origin - before[i].origin).norm() > kSame * size) return false;
  }
  return true;
}

}  // namespace

void refuse_many_turns(const RunParts& parts, const PathEnd& target, const std::string& key) {
  constexpr double kMostTurns = 100, kManyTurns = 1e6;
  if (!parts.robot) return;
  const Kinematics& robot = *parts.robot->kinematics;
  const Eigen::VectorXd &source = parts.problem.source.u, &end = target.u;
  if (source.size() != robot.dimension() || end.size() != robot.dimension()) return;
  for (Eigen::Index i = 0; i < end.size(); ++i) {
    const double way = end[i] - source[i], count = std::abs(way) / (2 * std::numbers::pi);
    if (!(count > kMostTurns) || std::isfinite(robot.lower()[i]) || std::isfinite(robot.upper()[i])) continue;
    Eigen::VectorXd near = end;  // a large angle has few digits left for a turn
    near[i] = source[i] + std::remainder(way, 2 * std::numbers::pi);
    if (!turns(robot, near, i)) continue;
    const auto k = static_cast<std::size_t>(i);
    const std::string joint = k < parts.robot->joints.size() ? " ('" + parts.robot->joints[k] + "')" : "";
    throw OptionError(
        key, fmt::format("coordinate {}{} is {}, {} turns from the source; at most {:.0f} are allowed. "
                         "The same position within half a turn of the source is {:.9g}",
                         i, joint, end[i],
                         count < kManyTurns ? fmt::format("{:.0f}", count) : fmt::format("about {:.3g}", count),
                         kMostTurns, near[i]));
  }
}

EndOptions with_state(EndOptions options, const Robot* robot, const std::string& path) {
  if (!options.state) return options;
  const std::string key = path + ".state";
  if (robot == nullptr) throw OptionError(key, "needs a robot with named states: give {point: [..]}");
  const auto found = robot->states.find(*options.state);
  if (found == robot->states.end()) {
    std::vector<std::string> names;
    for (const auto& [name, state] : robot->states) names.push_back(name);
    throw OptionError(key, names.empty() ? "the robot has no named states: give {point: [..]}"
                                         : fmt::format("the robot has no state '{}'; it has: {}", *options.state,
                                                       fmt::join(names, ", ")));
  }
  options.point = found->second;
  options.state.reset();
  return options;
}

EndOptions in_coordinates(EndOptions options, const ConstraintManifold& manifold, const SegmentCost* cost,
                          const std::string& path) {
  if (!options.lonlat) return options;
  const auto* earth = find_ability<IsGeographic>(manifold);
  if (earth == nullptr && cost != nullptr) earth = find_ability<IsGeographic>(*cost);
  const std::string key = path + ".lonlat";
  if (earth == nullptr)
    throw OptionError(
        key,
        "cannot locate longitude and latitude: the raster has no CRS that this build can read (GeoTIFF and .prj need "
        "GDAL). For a raster in degrees, set degrees: true; otherwise give {point: [x, y]}");
  const Eigen::Vector2d lonlat = options.lonlat->head<2>();
  if (!lonlat.allFinite() || std::abs(lonlat[1]) > 90)
    throw OptionError(
        key, fmt::format("the latitude {:.9g} is beyond 90 degrees; give longitude first: [longitude, latitude]",
                         lonlat[1]));
  options.point = earth->coordinates_of(lonlat);
  options.lonlat.reset();
  if (!options.point->allFinite())
    throw OptionError(
        key,
        fmt::format("the CRS of the raster does not cover longitude {:.9g} and latitude {:.9g}; give longitude first",
                    lonlat[0], lonlat[1]));
  return options;
}

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

void note_far_end(const std::string& which, const PlacedEnd& placed, RunParts& out) {
  constexpr double kFar = 0.01;  // of the diameter
  const auto* data = find_ability<MadeFromData>(*out.problem.manifold);
  if (data != nullptr && placed.moved > kFar * data->diameter())
    out.notes.push_back(note_of_moved_end(which, placed.moved));
}

void place_target(const EndOptions& options, const std::string& path, RunParts& out) {
  out.target = place_end(*out.problem.manifold, options, path);
  note_far_end("the target", out.target, out);
  out.problem.target = out.target.end;
  refuse_many_turns(out, out.target.end, path + ".point");
  note_latitudes(out);
}

bool are_one_place_but_for_rounding(const Problem& problem) {
  return !are_one_place(problem) && equal_up_to_rounding(problem.source, problem.target);
}

bool are_one_place(const Problem& problem) {
  // Two vertices may have one position, as those of a slit without width: their faces tell them apart.
  if (problem.source.u == problem.target.u) return problem.source.site == problem.target.site;
  const auto* domain = find_ability<HasImages>(*problem.manifold);
  return domain != nullptr && ends_are_one_point(problem) && !domain->states_way(problem.target.u, problem.source.u);
}

void refuse_one_place(const Problem& problem, const std::string& key) {
  if (are_one_place_but_for_rounding(problem))
    throw OptionError(key,
                      "is the same point as the source up to rounding; move it, or, for a closed path, use a ring "
                      "(path.ring: true)");
  if (!are_one_place(problem)) return;
  if (problem.source.u == problem.target.u)
    throw OptionError(key, "is the same point as the source; for a closed path, use a ring (path.ring: true)");
  throw OptionError(key,
                    "is the same point as the source, in other coordinates; for a closed path, use a ring (path.ring: "
                    "true) with waypoints around the domain");
}

void refuse_end_in_clearance(const Problem& problem, const PathEnd& end, const std::string& key) {
  const std::string why = why_in_clearance(problem, end);
  if (!why.empty()) throw OptionError(key, "end_in_clearance: it " + why);
}

Eigen::VectorXd source_position(const Problem& problem) {
  return positions(*problem.manifold, {problem.source.u, {}, true});
}

}  // namespace leastcost
