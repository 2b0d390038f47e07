// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Shortest geodesics on ellipsoids of revolution from the tables of the data set (GeodTest and exact integrals), in a
// chart and as an implicit surface. From the straight start most pairs end on the shortest path; the family finds the
// others.
#include <cstdio>
#include <fstream>
#include <numbers>
#include <sstream>

#include <leastcost/framework/family/find_family.hpp>
#include <leastcost/problems/chart/target_images.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/data.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

struct Pair {
  double latitude1 = 0, longitude1 = 0, latitude2 = 0, longitude2 = 0, length = 0;
};

struct Table {
  const char* file;
  double a, f;
  const char* length_column;
  bool prove;  ///< in the chart; a proof is dear where there are a hundred pairs
  /// The tables give lengths to 1e-9 of the axis and coordinates to 1e-6 degrees or better.
};

std::vector<Pair> read(const std::filesystem::path& file, const std::string& length_column) {
  std::ifstream in(file);
  std::string line, word;
  std::getline(in, line);
  std::vector<std::string> header;
  for (std::istringstream words(line); std::getline(words, word, ',');) header.push_back(word);
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
  };
  std::vector<Pair> pairs;
  while (std::getline(in, line)) {
    std::vector<double> v;
    for (std::istringstream words(line); std::getline(words, word, ',');) v.push_back(std::stod(word));
    pairs.push_back({v.at(column("lat1")), v.at(column("lon1")), v.at(column("lat2")), v.at(column("lon2")),
                     v.at(column(length_column))});
  }
  return pairs;
}

Eigen::Vector3d on_unit_sphere(double latitude, double longitude) {
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
}

/// Longitude and reduced latitude, radians.
Eigen::Vector2d chart_point(double latitude, double longitude, double f) {
  return {longitude * kDegree, std::atan((1 - f) * std::tan(latitude * kDegree))};
}

struct Count {
  int pairs = 0, first = 0, family = 0, near = 0, near_found = 0;
};

/// Never below the truth by more than the error, whatever was found; a path that is not stationary has none.
void check_not_below(const Result& result, double truth) {
  const CostEstimate& estimate = result.certificate.estimate;
  if (!result.certificate.measured || std::isnan(estimate.error)) return;
  CHECK(estimate.value >= truth - estimate.error - 2e-9 * truth);
}

bool reaches(const Result& result, double truth) {
  return result.certificate.measured && std::abs(result.certificate.estimate.value - truth) <= 1e-6 * truth;
}

/// The first start alone, then all of them.
void solve_pair(const std::vector<FamilyStart>& starts, double truth, bool near_antipodal, bool prove, Count& count) {
  const Newton newton;
  FindOptions options;
  options.points = 63;
  options.certificate.proof = prove ? ProofRule::always : ProofRule::needed;
  ++(near_antipodal ? count.near : count.pairs);
  if (!near_antipodal) {
    const Result result = find_path(starts.front().problem, *starts.front().initializer, newton, options);
    check_not_below(result, truth);
    if (reaches(result, truth)) {
      ++count.first;
      ++count.family;
      return;
    }
  }
  bool found = false;
  for (const FamilyMember& member : find_family(starts, newton, options).members) {
    check_not_below(member.result, truth);
    found = found || reaches(member.result, truth);
  }
  if (found) ++(near_antipodal ? count.near_found : count.family);
}

/// Straight lines and bows to every image of the target, the given one first.
std::vector<FamilyStart> starts_in_chart(const Problem& problem) {
  std::vector<FamilyStart> starts;
  for (const TargetImage& image : target_images(problem, 1)) {
    if (std::abs(image.problem.target.u[0] - problem.source.u[0]) > 2 * std::numbers::pi) continue;
    starts.push_back({"straight", image.problem, std::make_shared<const StraightInitializer>()});
    for (const double angle : {0.0, 180.0})
      starts.push_back({"bow", image.problem, std::make_shared<const BowInitializer>(BowOptions{0.3, angle})});
  }
  return starts;
}

std::vector<FamilyStart> starts_in_space(const Problem& problem) {
  std::vector<FamilyStart> starts = {{"straight", problem, std::make_shared<const StraightInitializer>()}};
  for (const double angle : {0.0, 60.0, 120.0, 180.0, 240.0, 300.0})
    starts.push_back({"bow", problem, std::make_shared<const BowInitializer>(BowOptions{0.5, angle})});
  return starts;
}

void check_table(const Table& table, bool implicit) {
  const auto file = data_file(table.file);
  if (!file) return;
  const double scale = table.a;  // in half axes: the same problem in convenient units
  const Eigen::Vector3d axes(1, 1, 1 - table.f);
  const auto in_chart = make_parametric_manifold({.surface = parametric::Ellipsoid{axes}});
  const std::shared_ptr<const ConstraintManifold> in_space =
      make_implicit_manifold({.surface = implicit::Ellipsoid{axes}});
  Count count;
  for (const Pair& p : share(read(*file, table.length_column), 10)) {
    CAPTURE(table.file, implicit, p.latitude1, p.longitude1, p.latitude2, p.longitude2);
    const Eigen::Vector2d from = chart_point(p.latitude1, p.longitude1, table.f);
    Eigen::Vector2d to = chart_point(p.latitude2, p.longitude2, table.f);
    to[0] = from[0] + std::remainder(to[0] - from[0], 2 * std::numbers::pi);
    const double angle =
        std::acos(std::clamp(on_unit_sphere(from[1], from[0]).dot(on_unit_sphere(to[1], to[0])), -1.0, 1.0));
    const bool near_antipodal = angle > std::numbers::pi - 3 * kDegree;
    const Problem image = between(in_chart, make_euclidean_cost(3), from, to);
    const Points a = positions(*in_chart, {from, {}, true}), b = positions(*in_chart, {to, {}, true});
    solve_pair(implicit ? starts_in_space(between(in_space, make_euclidean_cost(3), a, b)) : starts_in_chart(image),
               p.length / scale, near_antipodal, table.prove && !implicit, count);
  }
  std::printf("  %-32s %-10s straight start %d of %d, with the family %d; near-antipodal %d of %d\n", table.file,
              implicit ? "implicit" : "parametric", count.first, count.pairs, count.family, count.near_found,
              count.near);
  CHECK(count.first >= 0.95 * count.pairs);
  CHECK(count.family == count.pairs);
  CHECK(count.near_found == count.near);
}

const Table kWgs84 = {"truth/GeodTest-100.csv", 6378137, 1 / 298.257223563, "s12_m", false};
const Table kOblate = {"truth/ellipsoid_oblate_f0.5.csv", 1, 0.5, "s12", true};
const Table kProlate = {"truth/ellipsoid_prolate_f-1.csv", 1, -1, "s12", true};

}  // namespace

TEST_CASE("oracles: WGS84 in a chart", "[oracle]") { check_table(kWgs84, false); }
TEST_CASE("oracles: WGS84 as an implicit surface", "[oracle]") { check_table(kWgs84, true); }
TEST_CASE("oracles: the ellipsoid f = 0.5 in a chart", "[oracle]") { check_table(kOblate, false); }
TEST_CASE("oracles: the ellipsoid f = 0.5 as an implicit surface", "[oracle]") { check_table(kOblate, true); }
TEST_CASE("oracles: the ellipsoid f = -1 in a chart", "[oracle]") { check_table(kProlate, false); }
TEST_CASE("oracles: the ellipsoid f = -1 as an implicit surface", "[oracle]") { check_table(kProlate, true); }

}  // namespace leastcost::test
