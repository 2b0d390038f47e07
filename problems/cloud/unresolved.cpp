// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cloud/unresolved.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr double kWidest = 16;           ///< spacings: the widest radius that is tried
constexpr double kBesideSamples = 0.45;  ///< supports to the mean of the samples: 0.42 on a straight border
constexpr double kRadiusOverGap = 1.4;   ///< of a gap: narrower supports lay a surface over parts of it
constexpr std::size_t kFewAround = 8;
constexpr std::size_t kMostAround = 20000;

/// The samples of a cloud around a place, for a fit of their own.
struct Around {
  PointSamples samples;
  Vector3d mean = Vector3d::Zero();  ///< relative to the place
};

Around samples_around(const PointCloud& cloud, const Vector3d& y, double radius) {
  Around out;
  std::vector<Neighbour> found;
  cloud.search().within(y, radius, found);
  for (const Neighbour& near : found) {
    const CloudSample& sample = cloud.sample(near.index);
    out.samples.positions.emplace_back(sample.position + cloud.centre());
    out.samples.normals.push_back(sample.normal);
    out.mean += (sample.position - y) / static_cast<double>(found.size());
  }
  return out;
}

/// What is the matter with the samples around y, which is relative to the cloud's centre.
std::string what_lies_around(const PointCloud& cloud, const CloudSurface& surface, const Vector3d& y) {
  const Neighbour nearest = cloud.search().nearest(y);
  const double distance = std::sqrt(nearest.squared_distance), support = cloud.radius(nearest.index);
  if (distance > support)
    return "the nearest sample is " + short_number(distance) + " away, " +
           short_number(distance / cloud.spacing(nearest.index)) +
           " local spacings: this is a hole, or outside the border";
  if (const auto sheet = surface.other_sheet(y + cloud.centre()))
    return "the samples there are on two sheets, " + short_number(sheet->apart) + " spacings apart";
  const CloudSample& sample = cloud.sample(nearest.index);
  const Around around = samples_around(cloud, y, support);
  const Vector3d along = around.mean - sample.normal.dot(around.mean) * sample.normal;
  if (around.samples.positions.size() < kFewAround) return "there are too few samples nearby";
  if (along.norm() > kBesideSamples * support)
    return "all samples nearby are on one side: the point is outside the border, or in a hole";
  return "the samples there do not fit a single surface: there is noise, a sharp edge, or sheets that cross";
}

/// The first radius, from `first` on, whose surface has a point near each of these places; 0: none up to kWidest has.
/// Tried on the samples around.
double radius_that_helps(const PointCloud& cloud, const std::vector<Vector3d>& places, double first) {
  const Vector3d y = places[places.size() / 2] - cloud.centre();
  const Neighbour nearest = cloud.search().nearest(y);
  const double spacing = cloud.spacing(nearest.index);
  const double distance = std::sqrt(nearest.squared_distance) + (places.back() - places.front()).norm() / 2;
  PointCloudSettings settings = cloud.settings();
  settings.normals = NormalSource::given;
  for (double radius = std::ceil(first); radius <= kWidest; radius = std::ceil(radius * 1.25)) {
    Around around = samples_around(cloud, y, distance + 3 * radius * spacing);
    if (around.samples.positions.size() > kMostAround) return 0;
    if (std::numbers::pi * radius * radius > PointCloud::kMostOfCloud * cloud.size()) return 0;
    settings.radius = radius;
    try {
      const PointCloud wider(std::move(around.samples), settings);
      const CloudSurface surface(wider);
      if (std::all_of(places.begin(), places.end(), [&](Vector3d x) { return surface.project(x); })) return radius;
    } catch (const InputError&) {
      continue;  // too few of them
    }
  }
  return 0;
}

}  // namespace

std::string why_unresolved_at(const CloudSurface& surface, const Eigen::Vector3d& x) {
  const auto sheet = surface.other_sheet(x);
  if (!sheet) return "";
  return "at " + point_text(x) + " the samples within one radius are on two sheets, " + short_number(sheet->apart) +
         " spacings apart, and the surface runs between them or is pulled from one to the other; to separate them, use "
         "more samples, a smaller radius, or normals that point to opposite sides";
}

std::string why_no_surface_at(const PointCloud& cloud, const CloudSurface& surface, const Eigen::Vector3d& x) {
  const double distance = std::sqrt(cloud.search().nearest(x - cloud.centre()).squared_distance);
  if (distance > cloud.diameter())
    return "it is " + short_number(distance) + " away from the nearest sample of a cloud that is " +
           short_number(cloud.diameter()) + " across: give a point on the cloud";
  const std::string why = what_lies_around(cloud, surface, x - cloud.centre());
  const std::string now = short_number(*cloud.settings().radius);
  const double radius = radius_that_helps(cloud, {x}, 1.25 * *cloud.settings().radius);
  if (radius > 0)
    return why + "; with radius: " + short_number(radius) + " (now " + now + ") the surface has a point nearby";
  return why + "; no radius from " + now + " to " + short_number(kWidest) +
         " helps: lead the path around it with waypoints or a smaller max_edge (now " +
         short_number(cloud.settings().max_edge) + ")";
}

std::string how_to_join(const PointCloud& cloud, const CloudGraph& graph, std::int32_t part, std::int32_t other) {
  const auto gap = graph.gap(cloud, part, other);
  if (!gap)
    return "no links up to " + short_number(CloudGraph::kWidestGap) +
           " local spacings join them: choose both ends in one part";
  const Vector3d a = cloud.sample(gap->from).position + cloud.centre();
  const Vector3d b = cloud.sample(gap->to).position + cloud.centre();
  const std::string what = "the gap between them is " + short_number((b - a).norm()) + ", " +
                           short_number(gap->spacings) + " local spacings, near " + point_text(a);
  std::vector<Vector3d> places;
  const int parts = 2 * static_cast<int>(std::ceil(gap->spacings));
  for (int k = 1; k < parts; ++k) places.emplace_back(a + k * (b - a) / parts);
  const double first = std::max(*cloud.settings().radius, kRadiusOverGap * gap->spacings);
  const double radius = radius_that_helps(cloud, places, first);
  if (radius > 0)
    return what + "; `max_edge: " + short_number(std::ceil(1.05 * gap->spacings)) +
           "` with `radius: " + short_number(radius) + "` closes it";
  return what + ", and no radius up to " + short_number(kWidest) + " closes it: choose both ends in one part";
}

}  // namespace leastcost
