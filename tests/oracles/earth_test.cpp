// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Geodesics of the WGS84 ellipsoid, points in degrees: values of two quadratures, GeodSolve (GeographicLib) where it is
// installed, and Karney's GeodTest.
#include <leastcost/problems/manifolds/earth.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <random>
#include <sstream>

#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/data.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/shell.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;

constexpr double kRelative = 1e-9;

struct Line {
  Vector2d from, to;  ///< latitude, longitude
  double length;      ///< m
};

const std::vector<Line> kLines = {{{40.6, -73.8}, {51.6, -0.5}, 5551759.40031867851},
                                  {{-30, 0}, {45, 100}, 13041867.3355196569},
                                  {{51.5, -0.1}, {35.7, 139.7}, 9581233.264}};

Result solved(const std::shared_ptr<const ConstraintManifold>& domain, const Vector2d& from, const Vector2d& to,
              int points) {
  FindOptions options;
  options.points = points;
  options.certificate.proof = ProofRule::never;  // dear, and not what is asked here
  return find_path(between(domain, make_euclidean_cost(3), from, to), StraightInitializer(), Newton(), options);
}

Result solved(const Vector2d& from, const Vector2d& to, int points) {
  static const auto earth = std::make_shared<const EarthManifold>();
  return solved(earth, from, to, points);
}

void check_length(const Result& result, double length) {
  const CostEstimate& estimate = result.certificate.estimate;
  CHECK(result.status == Status::certified);
  CHECK(std::abs(estimate.value - length) <= kRelative * length);
  CHECK(std::abs(estimate.value - length) <= estimate.error + 1e-6);  // the lengths have a micrometre
}

}  // namespace

TEST_CASE("oracles: the Earth, by quadrature", "[oracle]") {
  for (const Line& line : kLines) {
    CAPTURE(line.from.transpose(), line.to.transpose());
    check_length(solved(line.from, line.to, 127), line.length);
  }
}

TEST_CASE("oracles: the Earth, by GeodSolve", "[oracle]") {
  if (!has_program("GeodSolve", "geographiclib-tools")) return;
  for (const Line& line : kLines) {
    std::ostringstream command;
    command.precision(17);
    command << "GeodSolve -i -p 6 --input-string '" << line.from[0] << ' ' << line.from[1] << ' ' << line.to[0] << ' '
            << line.to[1] << "'";
    const std::string out = output_of(command.str());
    CAPTURE(command.str(), out);
    double azimuth1 = 0, azimuth2 = 0, length = 0;
    std::istringstream(out) >> azimuth1 >> azimuth2 >> length;
    REQUIRE(length > 0);
    CHECK(length == Approx(line.length).epsilon(1e-10));
    check_length(solved(line.from, line.to, 127), length);
  }
}

TEST_CASE("oracles: the Earth, a longitude by any of its names", "[oracle]") {
  const std::vector<Line> lines = {{{35.7, 139.7}, {37.6, -122.4}, 8300363.7509},
                                   {{35.7, 139.7}, {37.6, 237.6}, 8300363.7509},
                                   {{40, -100}, {42, 265}, 475597.499192},
                                   {{-17.8, 177.4}, {-13.8, -171.8}, 1238493.306911}};
  for (const Line& line : lines) {
    CAPTURE(line.from.transpose(), line.to.transpose());
    const Result result = solved(line.from, line.to, 64);
    CHECK(result.status == Status::certified);
    CHECK(std::abs(result.certificate.estimate.value - line.length) <= kRelative * line.length);
  }
}

/// Places on the Earth are known to a nanometre.
TEST_CASE("oracles: the Earth, from centimetres to a hundred metres", "[oracle]") {
  const std::vector<std::pair<double, double>> offsets = {
      {1e-3, 133.805813339}, {1e-4, 13.3806167848}, {1e-5, 1.33806203323}, {1e-6, 0.133806207}};
  for (const auto& [offset, length] : offsets)
    for (const int points : {20, 64}) {
      CAPTURE(offset, points);
      const Result result = solved({48.1334, 15.1188}, {48.1334 + offset, 15.1188 + offset}, points);
      CHECK(result.status == Status::certified);
      CHECK(std::abs(result.certificate.estimate.value - length) <= 3e-9);
      CHECK(result.certificate.estimate.error <= 1e-7);
    }
}

namespace {

/// Lengths of the shortest geodesics by GeodSolve, m. `ellipsoid`: its options, "-e 6378137 0.02" say.
std::vector<double> geodsolve(const std::vector<Line>& lines, const std::string& ellipsoid = "") {
  const ScratchDir dir;
  {
    std::ofstream out(dir / "pairs.txt");
    out.precision(17);
    for (const Line& line : lines)
      out << line.from[0] << ' ' << line.from[1] << ' ' << line.to[0] << ' ' << line.to[1] << '\n';
  }
  std::istringstream answers(
      output_of("GeodSolve -i -p 9 " + ellipsoid + " --input-file '" + (dir / "pairs.txt").string() + "'"));
  std::vector<double> lengths(lines.size());
  double azimuth = 0;
  for (double& length : lengths) answers >> azimuth >> azimuth >> length;
  REQUIRE(answers);
  return lengths;
}

/// Pairs all over the Earth, longitudes of either convention.
std::vector<Line> random_lines(unsigned seed, int count) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto place = [&] {
    const double latitude = std::asin(2 * unit(engine) - 1) / kDegree, longitude = 360 * unit(engine) - 180;
    return Vector2d(latitude, unit(engine) < 0.5 && longitude < 0 ? longitude + 360 : longitude);
  };
  std::vector<Line> lines;
  for (int i = 0; i < count; ++i) {
    const Vector2d from = place();
    lines.push_back({from, place(), 0});
  }
  return lines;
}

/// All certified and right but those within 1 % of the longest distance.
void check_sweep(unsigned seed, int count) {
  constexpr double kFarthest = 0.99 * 20003931.458625;
  const std::vector<Line> lines = random_lines(seed, count);
  const std::vector<double> lengths = geodsolve(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lengths[i] > kFarthest) continue;
    CAPTURE(i, lines[i].from.transpose(), lines[i].to.transpose(), lengths[i]);
    const Result result = solved(lines[i].from, lines[i].to, 64);
    CHECK(result.status == Status::certified);
    CHECK(std::abs(result.certificate.estimate.value - lengths[i]) <= kRelative * lengths[i]);
  }
}

/// Ellipsoids of radius 1000 with the flattening f in a chart in radians, by reduced latitudes.
void check_flattening(double f, unsigned seed, int count) {
  constexpr double kFarthest = 900 * kPi;  // conjugate points come earlier the flatter it is
  const std::vector<Line> lines = random_lines(seed, count);
  const std::vector<double> lengths = geodsolve(lines, fmt::format("-E -e 1000 {:.17g}", f));
  const auto domain =
      make_parametric_manifold({.surface = parametric::Ellipsoid{Eigen::Vector3d(1000, 1000, 1000 * (1 - f))}});
  const auto in_chart = [&](const Vector2d& place) {
    return Vector2d(place[1] * kDegree, std::atan((1 - f) * std::tan(place[0] * kDegree)));
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lengths[i] > kFarthest * std::min(1.0, 1 - f)) continue;
    CAPTURE(f, i, lines[i].from.transpose(), lines[i].to.transpose(), lengths[i]);
    const Result result = solved(domain, in_chart(lines[i].from), in_chart(lines[i].to), 64);
    CHECK(result.status == Status::certified);
    CHECK(std::abs(result.certificate.estimate.value - lengths[i]) <= kRelative * lengths[i]);
  }
}

}  // namespace

TEST_CASE("oracles: ellipsoids in radians, longitudes by any name, by GeodSolve", "[oracle]") {
  if (!has_program("GeodSolve", "geographiclib-tools")) return;
  for (const double f : {0.0, 0.05, -0.05}) check_flattening(f, 8811, 3);
}

TEST_CASE("oracles: ellipsoids in radians, hundreds of pairs, by GeodSolve", "[oracle][.slow]") {
  if (!has_program("GeodSolve", "geographiclib-tools")) return;
  for (const double f : {0.0, 0.01, 0.1, -0.05}) check_flattening(f, 8812, 100);
}

/// The longitude of a pole is no place, and from one side of a pole to the other the straight line in coordinates is no
/// short way.
TEST_CASE("oracles: the Earth, at the poles and over them", "[oracle]") {
  const std::vector<Line> lines = {{{-90, 107}, {0, 288}, 10001965.729313},
                                   {{89, 175}, {89.9999, 705}, 111704.864641},
                                   {{80, 91}, {89.9999, 271}, 1116837.026774},
                                   {{0, -35}, {89, 144}, 10113642.582551}};
  for (const Line& line : lines) {
    CAPTURE(line.from.transpose(), line.to.transpose());
    const Result result = solved(line.from, line.to, 64);
    CHECK(result.status == Status::certified);
    CHECK(std::abs(result.certificate.estimate.value - line.length) <= kRelative * line.length);
  }
}

TEST_CASE("oracles: the Earth, random pairs in both conventions, by GeodSolve", "[oracle]") {
  if (has_program("GeodSolve", "geographiclib-tools")) check_sweep(8801, 12);
}

TEST_CASE("oracles: the Earth, a thousand random pairs in both conventions, by GeodSolve", "[oracle][.slow]") {
  if (has_program("GeodSolve", "geographiclib-tools")) check_sweep(8802, 1000);
}

/// Pairs in all positions. A straight start finds one of the two locally shortest paths near the antipode, and few
/// points beside a pole are not certified; what is certified is what it says.
TEST_CASE("oracles: the Earth, by GeodTest", "[oracle]") {
  const auto file = data_file("truth/GeodTest-100.csv");
  if (!file) return;
  std::ifstream in(*file);
  std::string line;
  std::getline(in, line);
  REQUIRE(line.rfind("lat1,lon1,azi1,lat2,lon2,azi2,s12_m", 0) == 0);
  int lines = 0, pairs = 0, shortest = 0;
  while (std::getline(in, line)) {
    if (lines++ % (nightly() ? 1 : 4) != 0) continue;
    std::vector<double> v;
    std::string word;
    for (std::istringstream words(line); std::getline(words, word, ',');) v.push_back(std::stod(word));
    REQUIRE(v.size() >= 7);
    const Vector2d from(v[0], v[1]), to(v[3], v[1] + std::remainder(v[4] - v[1], 360));
    const double length = v[6];
    CAPTURE(from.transpose(), to.transpose(), length);
    ++pairs;
    const Result result = solved(from, to, 63);
    const CostEstimate& estimate = result.certificate.estimate;
    if (!result.certificate.measured || std::isnan(estimate.error)) continue;
    CHECK(estimate.value >= length - estimate.error - 1e-6);
    if (result.status == Status::certified && std::abs(estimate.value - length) <= 1e-3 * length) {
      ++shortest;
      CHECK(std::abs(estimate.value - length) <= estimate.error + 1e-6);
    }
  }
  std::printf("  GeodTest-100: certified and the shortest from the straight start, %d of %d\n", shortest, pairs);
  CHECK(lines == 100);
  CHECK(shortest >= 0.8 * pairs);
}

}  // namespace leastcost::test
