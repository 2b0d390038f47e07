// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Where a cloud has no surface the reason is said, with the radius that has one; tried here.
#include <cmath>
#include <numbers>
#include <regex>
#include <string>

#include "problems/cloud/unresolved.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;
using Eigen::Vector3d;

/// The unit sphere without the cap around the z axis, and without its lower half where `half`.
PointSamples open_sphere(int count, double hole, bool half) {
  PointSamples all = sphere_cloud(count), left;
  for (const Vector3d& p : all.positions)
    if (std::hypot(p[0], p[1]) > hole && (!half || p[2] > 0)) left.positions.push_back(p);
  return left;
}

/// Checks that there is no surface at x, and that the radius which is named, if any, has one there.
std::string reason_and_cure(const PointSamples& samples, const Vector3d& x) {
  const PointCloud cloud(samples, {});
  const CloudSurface surface(cloud);
  Vector3d moved = x;
  REQUIRE_FALSE(surface.project(moved));
  const std::string why = why_no_surface_at(cloud, surface, x);
  CAPTURE(why);
  std::smatch found;
  if (!std::regex_search(why, found, std::regex("with radius: ([0-9.]+)"))) return why;
  const PointCloud wider(samples, {.radius = std::stod(found[1])});
  CHECK(wider.share_of_support() <= PointCloud::kMostOfCloud);
  CHECK(CloudSurface(wider).project(moved));
  return why;
}

}  // namespace

TEST_CASE("a cloud says why it has no surface: a hole, with the radius that spans it") {
  constexpr int kCount = 3000;
  const double spacing = std::sqrt(4 * std::numbers::pi / kCount);
  const std::string why = reason_and_cure(open_sphere(kCount, 4.5 * spacing, false), Vector3d(0, 0, 1));
  CHECK_THAT(why, Contains("a hole") && Contains("with radius: "));
}

TEST_CASE("a cloud says why it has no surface: beyond the border, with the radius that reaches there") {
  const double below = -0.06;  // a spacing
  const Vector3d x(std::sqrt(1 - below * below), 0, below);
  const std::string why = reason_and_cure(open_sphere(3000, 0, true), x);
  CHECK_THAT(why, Contains("beyond the border") && Contains("with radius: "));
}

TEST_CASE("a cloud says why it has no surface: far beyond the border no radius helps, and that is said") {
  CHECK_THAT(reason_and_cure(open_sphere(3000, 0, true), Vector3d(0, 0, -1)),
             Contains("beyond the border") && Contains("waypoints"));
}

}  // namespace leastcost::test
