// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/ends.hpp"

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include "tests/app/config_text.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {

TEST_CASE("ends on a cloud: by the number in the file, or as a point that may be a little off") {
  PointSamples samples = sphere_cloud(1000);
  for (std::int32_t i = 0; i < 1000; ++i) samples.in_file.push_back(2 * i);  // every other point was a repetition
  const Eigen::Vector3d seventh = samples.positions[7];
  const PointCloudManifold sphere(PointCloud(std::move(samples), {}));
  EndOptions end;
  end.vertex = 14;
  const PlacedEnd placed = place_end(sphere, end, "ends.source");
  CHECK((placed.end.u - seventh).norm() <= 1e-3);  // onto the surface, third order in the spacing of 0.1
  CHECK(placed.moved == Approx((placed.end.u - seventh).norm()));
  for (const int missing : {15, 2000}) {
    end.vertex = missing;
    CHECK_THROWS_AS(place_end(sphere, end, "ends.source"), OptionError);
  }
  end = {};
  end.point = 1.01 * seventh;
  CHECK((place_end(sphere, end, "ends.source").end.u - seventh).norm() <= 2e-3);
  end.point = 1.2 * seventh;  // more than 1 % of the diameter
  CHECK_THROWS_AS(place_end(sphere, end, "ends.source"), OptionError);
}

TEST_CASE("config: points of a cloud have numbers, faces it has none") {
  const auto errors = [](const std::string& source) {
    return errors_of("manifold: {type: point_cloud, file: cloud.xyz}\ncost: euclidean\nends: {source: " + source +
                     ", target: {point: [0, 0, 1]}}\n");
  };
  CHECK(errors("{vertex: 3}").find("has no") == std::string::npos);
  CHECK(errors("{face: 3, barycentric: [1, 0, 0]}")
            .find("'point_cloud' has no faces: give the end as {point: [..]} or {vertex: ..,") != std::string::npos);
}

}  // namespace leastcost::test
