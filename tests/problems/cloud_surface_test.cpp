// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/cloud/cloud_surface.hpp>

#include <Eigen/Geometry>
#include <algorithm>

#include <leastcost/framework/base/errors.hpp>
#include "tests/problems/sample_clouds.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

Eigen::Vector3d on_torus(Random& random) {
  const double u = random.uniform(0, 6.2), v = random.uniform(0, 6.2);
  return {(2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v)};
}

/// Root mean square distance from the true torus of points projected onto the cloud's surface.
double error_on_torus(int count) {
  const PointCloud cloud(torus_cloud(count), {});
  const CloudSurface surface(cloud);
  Random random;
  double sum = 0;
  constexpr int kProbes = 500;
  for (int i = 0; i < kProbes; ++i) {
    Eigen::Vector3d x = on_torus(random);
    REQUIRE(surface.project(x));
    sum += off_torus(x) * off_torus(x);
  }
  return std::sqrt(sum / kProbes);
}

}  // namespace

TEST_CASE("how much of the cloud a support holds") {
  // On 1000 samples of 4 pi^2 R r = 79 the spacing is 0.28: a disc of radius 6 spacings is 11 % of the torus, one of 30
  // all of it.
  CHECK(PointCloud(torus_cloud(1000), {.radius = 6}).share_of_support() == Approx(0.11).epsilon(0.3));
  CHECK(PointCloud(torus_cloud(1000), {.radius = 30}).share_of_support() > 0.9);
}

TEST_CASE("neighbour search agrees with looking at every point") {
  Random random;
  std::vector<Eigen::Vector3d> points(300);
  for (Eigen::Vector3d& p : points) p = random.vector(3);
  const NeighbourSearch search(points);
  std::vector<Neighbour> found;
  for (int repeat = 0; repeat < 20; ++repeat) {
    const Eigen::Vector3d x = random.vector(3);
    std::vector<double> all;
    for (const Eigen::Vector3d& p : points) all.push_back((p - x).squaredNorm());
    std::sort(all.begin(), all.end());
    CHECK(search.nearest(x).squared_distance == Approx(all[0]).epsilon(1e-14));
    search.nearest(x, 7, found);
    REQUIRE(found.size() == 7);
    for (std::size_t k = 0; k < 7; ++k) CHECK(found[k].squared_distance == Approx(all[k]).epsilon(1e-14));
    search.within(x, 1.0, found);
    CHECK(found.size() ==
          static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](double d) { return d < 1; })));
  }
  search.nearest(points[0], 1000, found);
  CHECK(found.size() == points.size());
}

// Algebraic spheres reproduce a sphere, also through normals that were estimated by quadratic fits (which are exact on
// no sphere).
TEST_CASE("a sampled sphere is met at third order, and does not depend on where it lies") {
  double coarse = 0;
  for (const int count : {1000, 8000}) {
    const PointCloud cloud(sphere_cloud(count), {});
    const CloudSurface surface(cloud);
    Random random;
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
      Eigen::Vector3d x = random.vector(3).normalized();
      REQUIRE(surface.project(x));
      worst = std::max(worst, std::abs(x.norm() - 1));
    }
    CAPTURE(count, coarse, worst);
    if (count > 1000) CHECK(worst <= coarse / std::pow(std::sqrt(8.0), 3 - 0.3));
    coarse = worst;
  }
  CHECK(coarse < 2e-5);
}

TEST_CASE("the distance to a sampled torus falls at third order with the spacing") {
  const double coarse = error_on_torus(2000), fine = error_on_torus(8000);  // half the spacing
  CAPTURE(coarse, fine);
  CHECK(coarse < 2e-3);
  CHECK(std::log2(coarse / fine) > 3 - 0.3);
}

TEST_CASE("map coordinates cost no digits") {
  const Eigen::Vector3d offset(512787, 5403659, 328);
  const PointCloud here(sphere_cloud(2000), {}), there(sphere_cloud(2000, offset), {});
  const CloudSurface surface(here), moved(there);
  Random random;
  for (int i = 0; i < 50; ++i) {
    Eigen::Vector3d x = 1.01 * random.vector(3).normalized(), y = x + offset;
    REQUIRE(surface.project(x));
    REQUIRE(moved.project(y));
    CHECK((x - (y - offset)).norm() <= 1e-8);  // the samples themselves are rounded to 1e-9 there
    Eigen::Vector3d again = y;
    REQUIRE(moved.project(again));
    CHECK((again - y).norm() <= 2e-9);  // two units in the last place of 5e6
  }
}

TEST_CASE("tangent planes are those of the surface itself") {
  const PointCloud cloud(torus_cloud(3000), {});
  const CloudSurface surface(cloud);
  Random random;
  for (int i = 0; i < 50; ++i) {
    Eigen::Vector3d x = on_torus(random);
    REQUIRE(surface.project(x));
    const Eigen::Vector3d n = surface.normal(x).value();
    const Eigen::Vector3d t = n.cross(Eigen::Vector3d(random.vector(3))).normalized();
    Eigen::Vector3d a = x + 1e-4 * t, b = x - 1e-4 * t;
    REQUIRE((surface.project(a) && surface.project(b)));
    CHECK(std::abs(n.dot(a - b)) / 2e-4 <= 1e-6);  // third derivatives times the square of the step
    CHECK(std::abs(n.norm() - 1) <= 1e-15);
  }
}

TEST_CASE("there is no surface beyond the border, far away, or in a cloud that is none") {
  const PointCloud cloud(sheet_cloud(2000, [](double x, double) { return 0.1 * x * x; }), {});
  const CloudSurface surface(cloud);
  const double spacing = std::sqrt(1.0 / 2000);
  Eigen::Vector3d inside(0.5, 0.5, 0), near_border(3 * spacing, 0.5, 0);
  CHECK(surface.project(inside));
  CHECK(surface.project(near_border));
  for (Eigen::Vector3d x : {Eigen::Vector3d(-2 * spacing, 0.5, 0), Eigen::Vector3d(-0.3, 0.5, 0),
                            Eigen::Vector3d(5, 5, 5), Eigen::Vector3d(0.5, 0.5, std::nan(""))}) {
    const Eigen::Vector3d before = x;
    CHECK_FALSE(surface.project(x));
    CHECK(((x - before).isZero(0) || before.hasNaN()));
  }
  PointSamples line;
  for (int i = 0; i < 50; ++i) line.positions.emplace_back(i, 2 * i, 3 * i);
  CHECK_THROWS_AS(PointCloud(line, {}), InputError);
  PointSamples few = sphere_cloud(5);
  CHECK_THROWS_AS(PointCloud(few, {}), InputError);
  PointCloudSettings given;
  given.normals = NormalSource::given;
  CHECK_THROWS_AS(PointCloud(sphere_cloud(100), given), OptionError);
}

TEST_CASE("a number of neighbours that no neighbourhood has is refused") {
  for (const int neighbours : {-1, 0, 3, 101}) {
    PointCloudSettings settings;
    settings.neighbours = neighbours;
    CHECK_THROWS_AS(PointCloud(sphere_cloud(200), settings), OptionError);
  }
}

TEST_CASE("outliers take no part, noise is averaged") {
  Random random;
  PointSamples noisy = sphere_cloud(4000);
  for (Eigen::Vector3d& p : noisy.positions) p *= 1 + 0.02 * random.normal();  // a third of the spacing
  for (int i = 0; i < 40; ++i) noisy.positions.emplace_back(1.5 * random.vector(3).normalized());
  const PointCloud cloud(noisy, {});
  CHECK_FALSE(cloud.notes().empty());
  const CloudSurface surface(cloud);
  double sum = 0;
  constexpr int kProbes = 200;
  for (int i = 0; i < kProbes; ++i) {
    Eigen::Vector3d x = random.vector(3).normalized();
    REQUIRE(surface.project(x));
    sum += (x.norm() - 1) * (x.norm() - 1);
  }
  CHECK(std::sqrt(sum / kProbes) < 0.01);  // ten samples by weight and more: less than half of the noise
}

TEST_CASE("estimated normals point outwards on closed surfaces, given ones keep their side") {
  const PointCloud estimated(torus_cloud(2000), {});
  PointSamples inwards = sphere_cloud(2000);
  for (const Eigen::Vector3d& p : inwards.positions) inwards.normals.emplace_back(-p);
  const PointCloud given(inwards, {});
  for (std::int32_t i = 0; i < 2000; ++i) {
    const Eigen::Vector3d p = estimated.sample(i).position + estimated.centre();
    const Eigen::Vector3d core = 2 * Eigen::Vector3d(p[0], p[1], 0).normalized();
    CHECK(estimated.sample(i).normal.dot((p - core).normalized()) > 0.99);
    CHECK(given.sample(i).normal.dot((given.sample(i).position + given.centre()).normalized()) < -0.99);
  }
}

TEST_CASE("thinning keeps half of the points, evenly") {
  const PointCloud cloud(torus_cloud(4000), {});
  const PointCloud half = cloud.thinned();
  CHECK(half.size() >= 1900);
  CHECK(half.size() <= 2200);
  double largest = 0;
  for (std::int32_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d x = cloud.sample(i).position + cloud.centre() - half.centre();
    largest = std::max(largest, std::sqrt(half.search().nearest(x).squared_distance) / cloud.spacing(i));
  }
  CHECK(largest < 2);  // a point that went has a neighbour that stayed
}

}  // namespace leastcost::test
