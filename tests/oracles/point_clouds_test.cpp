// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Geodesics on sampled surfaces: certified where there is a surface in the cloud, with the error of the sampling told
// apart; scans that have holes and sharp edges end in a path or in a clear reason.
#include <cstdio>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include "tests/problems/sample_clouds.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/data.hpp"
#include "tests/support/sample_domains.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector3d;

Result geodesic(const std::shared_ptr<const PointCloudManifold>& domain, const Vector3d& from, const Vector3d& to,
                int points) {
  return find(between(domain, make_euclidean_cost(3), from, to), points, DijkstraInitializer());
}

/// The sample with this number in the file, or the next one that was kept.
Vector3d sample_of_file(const PointCloud& cloud, std::int32_t number) {
  std::int32_t best = -1;
  for (std::int32_t i = 0; i < cloud.size(); ++i)
    if (cloud.in_file(i) >= number && (best < 0 || cloud.in_file(i) < cloud.in_file(best))) best = i;
  REQUIRE(best >= 0);
  return cloud.sample(best).position + cloud.centre();
}

/// The k-th of ten samples spread over the largest part.
Vector3d sample_of_largest(const PointCloudManifold& domain, int k) {
  const std::int32_t wanted = domain.graph().component_sizes()[0] / 10 * k;
  std::int32_t seen = 0, i = 0;
  while (domain.graph().component(i) != 0 || seen++ < wanted) ++i;
  return domain.cloud().sample(i).position + domain.cloud().centre();
}

std::shared_ptr<const PointCloudManifold> read(const std::filesystem::path& file) {
  return make_point_cloud_manifold({file.string(), {}}, "");
}

void print(const char* what, const Result& result) {
  const CostEstimate& e = result.certificate.estimate;
  std::printf("%-22s %-11s %.10g +- %.1g, geometry error %.1g\n", what, word_of(result.status).data(), e.value, e.error,
              result.certificate.geometry_error.value_or(-1));
}

}  // namespace

TEST_CASE("D1: geodesics of the torus, from a sampled cloud", "[oracle]") {
  struct Row {
    double u0, v0, u1, v1, length;
  };
  static const auto domain = std::make_shared<const PointCloudManifold>(PointCloud(torus_cloud(20000), {}));
  const Row row = GENERATE(Row{0, 0, 1, 2, 3.00530920550149849}, Row{0, 0, 0.5, 3, 3.11354377379390939});
  const Result result = geodesic(domain, Torus::at(row.u0, row.v0), Torus::at(row.u1, row.v1), 63);
  const Certificate& c = result.certificate;
  CAPTURE(row.length, c.estimate.value, c.estimate.error, failures(c));
  print("torus, 20,000 points", result);
  CHECK(result.status == Status::certified);
  REQUIRE(c.geometry_error);
  CHECK(std::abs(c.estimate.value - row.length) <= c.estimate.error + *c.geometry_error);
  CHECK(*c.geometry_error < 2e-4 * row.length);  // and it is no excuse: third order, spacing 0.063
}

TEST_CASE("a noisy sphere: certified, and the great circle within one part in a hundred", "[oracle]") {
  const auto file = data_file("points/sphere_21k_noisy_normals.xyz");
  if (!file) return;
  const Vector3d from(0.925416578398323353, 0.336824088833465174, 0.173648177666930349);
  const Vector3d to(-0.413175911166534826, 0.49240387650610403, 0.766044443118978035);
  const Result result = geodesic(read(*file), from, to, 63);
  const Certificate& c = result.certificate;
  CAPTURE(c.estimate.value, c.estimate.error, failures(c));
  print("noisy sphere", result);
  CHECK(result.status == Status::certified);
  CHECK(c.estimate.value == Approx(1.6543777367571768).epsilon(0.01));
  REQUIRE(c.geometry_error);
  CHECK(std::abs(c.estimate.value - 1.6543777367571768) <= c.estimate.error + *c.geometry_error);
}

TEST_CASE("kitten and hippo are certified with their geometry error", "[oracle]") {
  struct Row {
    const char* file;
    std::int32_t from, to;
    double most;  ///< geometry error, relative
  };
  const Row row = GENERATE(Row{"points/kitten.xyz", 0, 2000, 0.1}, Row{"points/kitten.xyz", 100, 4000, 0.1},
                           Row{"points/hippo1.ply", 100, 5000, 0.1});
  const auto file = data_file(row.file);
  if (!file) return;
  const auto domain = read(*file);
  const Result result =
      geodesic(domain, sample_of_file(domain->cloud(), row.from), sample_of_file(domain->cloud(), row.to), 127);
  const Certificate& c = result.certificate;
  CAPTURE(row.file, row.from, row.to, c.estimate.value, c.estimate.error, failures(c));
  print(row.file, result);
  CHECK(result.status == Status::certified);
  REQUIRE(c.geometry_error);
  CHECK(*c.geometry_error < row.most * c.estimate.value);
  CHECK(c.estimate.value >= (result.path.u.rightCols(1) - result.path.u.col(0)).norm());
}

TEST_CASE("scans end in a path with its geometry error, or in a clear reason", "[oracle]") {
  const std::string name =
      GENERATE(as<std::string>(), "points/room_scan1_113k.ply", "points/lidar_samp11_38k.ply", "points/hippo1.ply");
  const auto file = data_file(name);
  if (!file) return;
  const auto domain = read(*file);
  for (const auto& [i, j] : share<std::pair<int, int>>({{0, 9}, {3, 4}}, 2)) {
    const Vector3d from = sample_of_largest(*domain, i), to = sample_of_largest(*domain, j);
    CAPTURE(name, i, j);
    try {
      const Result result = geodesic(domain, from, to, 63);
      const Certificate& c = result.certificate;
      CAPTURE(failures(c));
      print(name.c_str(), result);
      CHECK(result.path.u.allFinite());
      CHECK(c.estimate.value >= 0.99 * (to - from).norm());  // the ends were moved onto the surface
      CHECK((c.geometry_error || failed(c, "geometry_error")));
    } catch (const Error& error) {  // an end or a point of the first path has no counterpart on the surface
      std::printf("%-22s %s\n", name.c_str(), error.what());
      CHECK(std::string(error.what()).size() > 20);
    }
  }
}

TEST_CASE("ends in different parts of a scan are named with the sizes of the parts", "[oracle]") {
  const auto file = data_file("points/hippo1.ply");
  if (!file) return;
  const auto domain = read(*file);
  const auto& sizes = domain->graph().component_sizes();
  REQUIRE(sizes.size() > 1);
  std::int32_t other = 0;
  while (domain->graph().component(other) != 1) ++other;
  const Vector3d to = domain->cloud().sample(other).position + domain->cloud().centre();
  try {
    geodesic(domain, sample_of_largest(*domain, 5), to, 31);
    FAIL("a path between two parts");
  } catch (const InitializationError& error) {
    const std::string message = error.what();
    INFO(message);
    CHECK(message.find(std::to_string(sizes[0])) != std::string::npos);
    CHECK(message.find(std::to_string(sizes[1])) != std::string::npos);
  }
}

}  // namespace leastcost::test
