// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What a cloud can do besides being a domain: the search along its neighbour graph, its samples, its picture.
#include <cmath>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include "problems/cloud/cloud_route.hpp"
#include "problems/cloud/unresolved.hpp"
#include "problems/drawing/domain_shapes.hpp"

namespace leastcost {

FirstPath PointCloudManifold::least_cost_edges(const Problem& problem, const Monitor& monitor) const {
  const CloudRoute route = cloud_route(problem, *this, monitor);
  FirstPath first;
  first.path.u.resize(3, static_cast<Index>(route.points.size()));
  for (std::size_t i = 0; i < route.points.size(); ++i) first.path.u.col(static_cast<Index>(i)) = route.points[i];
  first.graph_vertices = route.vertices;
  return first;
}

std::string PointCloudManifold::why_unresolved(const CoordinatePath& path) const {
  for (Index i = 0; i < path.u.cols(); ++i)
    if (std::string why = why_unresolved_at(surface_, path.u.col(i)); !why.empty()) return why;
  return "";
}

std::string PointCloudManifold::why_not_projected(const Eigen::VectorXd& x) const {
  if (!x.allFinite()) return "it is not finite";
  return why_no_surface_at(cloud_, surface_, x);
}

PathEnd PointCloudManifold::vertex(int number) const {
  const std::int32_t here = cloud_.sample_of_file(number);
  if (here < 0)
    throw OptionError("vertex", "the cloud has no point " + std::to_string(number) +
                                    " (numbered from 0), or it was removed as a duplicate of an earlier one");
  return {cloud_.sample(here).position + cloud_.centre(), kNoSite};
}

std::vector<std::string> PointCloudManifold::notes() const {
  std::vector<std::string> all = cloud_.notes();
  for (std::string& note : graph_.notes()) all.push_back(std::move(note));
  return all;
}

std::vector<DataCount> PointCloudManifold::counts() const { return {{"point", "points", cloud_.size()}}; }

void PointCloudManifold::draw(const DrawnPaths&, Drawing& out) const {
  constexpr std::size_t kMostSurfels = 40000;
  const std::vector<CloudSample>& samples = cloud_.samples();
  const std::size_t step = (samples.size() + kMostSurfels - 1) / kMostSurfels;
  Surfels& surfels = out.surfels;
  for (std::size_t i = 0; i < samples.size(); i += step) {
    surfels.positions.emplace_back(samples[i].position + cloud_.centre());
    surfels.normals.push_back(samples[i].normal);
    surfels.spacing += cloud_.spacing(static_cast<std::int32_t>(i));
  }
  surfels.spacing *= std::sqrt(static_cast<double>(step)) / static_cast<double>(surfels.positions.size());
  if (step > 1)
    out.notes.push_back("drawn with " + std::to_string(surfels.positions.size()) + " of " +
                        std::to_string(samples.size()) + " points");
  out.up = up_of_data(surfels.positions);
}

}  // namespace leastcost
