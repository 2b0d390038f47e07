// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/geojson.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include <leastcost/problems/chart/is_geographic.hpp>
#include "catalogue/output/json_numbers.hpp"
#include "catalogue/output/path_table.hpp"
#include "catalogue/output/unit_of_cost.hpp"
#include "problems/chart/chart_images.hpp"

namespace leastcost {
namespace {

using Json = nlohmann::ordered_json;
using LonLat = Eigen::Vector2d;  // longitude, latitude in degrees

/// The parts of the way from `from` to `to` after which it crosses first + k period, for whole k.
void add_crossings(double from, double to, double first, double period, std::vector<double>& t) {
  const double least = std::min(from, to), most = std::max(from, to);
  for (double at = first + period * std::ceil((least - first) / period); at < most; at += period)
    if (at > least) t.push_back((at - from) / (to - from));
}

/// Names of a place without seam and poles: on `sheet` (odd: over a pole) and after `turns` around the axis.
LonLat on_earth(const LonLat& cover, double sheet, double turns) {
  const double across = cover[1] - 180 * sheet, latitude = std::fmod(std::abs(sheet), 2) == 0 ? across : -across;
  return {std::clamp(cover[0] + 180 * sheet - 360 * turns, -180.0, 180.0), std::clamp(latitude, -90.0, 90.0)};
}

/// The lines as they grow.
class Cutter {
 public:
  void move(const LonLat& from, const LonLat& to) {
    std::vector<double> t;
    add_crossings(from[1], to[1], 90, 180, t);
    each_part(from, to, t, [&](const LonLat& a, const LonLat& b) {
      const double sheet = std::floor(((a[1] + b[1]) / 2 + 90) / 180);
      std::vector<double> around;
      add_crossings(a[0] + 180 * sheet, b[0] + 180 * sheet, 180, 360, around);
      each_part(a, b, around, [&](const LonLat& c, const LonLat& d) {
        add(c, d, sheet, std::floor(((c[0] + d[0]) / 2 + 180 * sheet + 180) / 360));
      });
    });
  }
  std::vector<GeographicLine> take() { return std::move(lines_); }

 private:
  template <class Take>
  static void each_part(const LonLat& from, const LonLat& to, std::vector<double>& t, const Take& take) {
    std::sort(t.begin(), t.end());
    t.push_back(1);
    LonLat at = from;
    for (const double next : t) {
      const LonLat end = next == 1 ? to : LonLat(from + next * (to - from));
      take(at, end);
      at = end;
    }
  }

  void add(const LonLat& from, const LonLat& to, double sheet, double turns) {
    if (lines_.empty() || sheet != sheet_ || turns != turns_) lines_.push_back({on_earth(from, sheet, turns)});
    lines_.back().push_back(on_earth(to, sheet, turns));
    sheet_ = sheet;
    turns_ = turns;
  }

  std::vector<GeographicLine> lines_;
  double sheet_ = 0, turns_ = 0;
};

Json position(const LonLat& place) {
  constexpr double kDigits = 1e9;  // of a degree: 0.1 mm
  return {std::round(place[0] * kDigits) / kDigits, std::round(place[1] * kDigits) / kDigits};
}

Json geometry(const std::vector<GeographicLine>& lines) {
  Json all = Json::array();
  for (const GeographicLine& line : lines) {
    Json one = Json::array();
    for (const LonLat& place : line) one.push_back(position(place));
    all.push_back(std::move(one));
  }
  if (all.size() == 1) return {{"type", "LineString"}, {"coordinates", all[0]}};
  return {{"type", "MultiLineString"}, {"coordinates", std::move(all)}};
}

Json feature(Json properties, Json geometry) {
  return {{"type", "Feature"}, {"properties", std::move(properties)}, {"geometry", std::move(geometry)}};
}

double cost_of(const Result& result) {
  const double value = result.certificate.estimate.value;
  return result.certificate.measured && !std::isnan(value) ? value : result.curve.cost;
}

}  // namespace

std::vector<GeographicLine> geographic_lines(const std::vector<Eigen::Vector2d>& cover) {
  Cutter cutter;
  for (std::size_t i = 1; i < cover.size(); ++i) cutter.move(cover[i - 1], cover[i]);
  return cutter.take();
}

namespace {

/// Places of the delivered path on the universal cover of the Earth; empty where it is not on it, or there is none.
std::vector<LonLat> cover_of(const Problem& problem, const Result& result) {
  const auto* domain = find_ability<IsGeographic>(*problem.manifold);
  if (domain == nullptr) domain = find_ability<IsGeographic>(*problem.cost);
  if (domain == nullptr || result.path.u.cols() < 2) return {};
  Points u(result.path.u.rows(), result.path.segment_count() + 1);
  for (Index i = 0; i < u.cols(); ++i) u.col(i) = result.path.column(i);
  if (const auto* images = find_ability<HasImages>(*problem.manifold)) u = continued(*images, u);
  std::vector<LonLat> cover;
  for (const auto column : u.colwise()) cover.push_back(domain->longitude_latitude(column));
  return cover;
}

}  // namespace

std::string geojson_text(const RunOutcome& outcome) {
  const Problem& problem = outcome.parts.problem;
  const Result& result = outcome.result;
  const std::vector<LonLat> cover = cover_of(problem, result);
  if (cover.empty()) return "";
  const std::string unit = unit_of_cost(problem);
  Json features = Json::array();
  features.push_back(feature({{"what", "path"},
                              {"name", outcome.name},
                              {"cost", number(cost_of(result))},
                              {"unit", unit},
                              {"status", word_of(result.status)}},
                             geometry(geographic_lines(cover))));
  return to_text({{"type", "FeatureCollection"}, {"features", std::move(features)}});
}

std::string geojson_points_text(const RunOutcome& outcome) {
  const Problem& problem = outcome.parts.problem;
  const Result& result = outcome.result;
  const std::vector<LonLat> cover = cover_of(problem, result);
  if (cover.empty()) return "";
  const PathTable points = delivered_points(problem, result);
  Json features = Json::array();
  for (Index i = 0; i < result.path.u.cols(); ++i) {
    const LonLat& at = cover[static_cast<std::size_t>(i)];
    const double sheet = std::floor((at[1] + 90) / 180), turns = std::floor((at[0] + 180 * sheet + 180) / 360);
    features.push_back(
        feature({{"what", "point"}, {"index", i}, {"cumulative_cost", number(points.cumulative_costs[i])}},
                {{"type", "Point"}, {"coordinates", position(on_earth(at, sheet, turns))}}));
  }
  return to_text({{"type", "FeatureCollection"}, {"features", std::move(features)}});
}

}  // namespace leastcost
