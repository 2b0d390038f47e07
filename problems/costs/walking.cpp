// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/walking.hpp>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include "problems/costs/walking_laws.hpp"

namespace leastcost {
namespace {

/// What the tangents of the hull leave at slope 0, as a part of the pace where they begin: so much the cost of a climb
/// still depends on the length of the way.
constexpr double kTilt = 1e-4;
/// Slopes over which a pace goes over into its tangent, in units of the rounding of the kink.
constexpr double kHullRounding = 2;

constexpr double kToblerSpeed = 6;  ///< km/h at the fastest slope
constexpr double kMetres = 1000;    ///< per kilometre

/// Convex, of degree 1: map distance times pace, continued along its tangents beyond the critical slopes.
template <class Pace>
struct Walking {
  static constexpr int dim = 3;
  Pace pace;
  double scale;  ///< units of the cost per unit of length at pace 1
  const char* unit;
  HullSide up, down, hull_up, hull_down;  ///< as they are minimised, and those of the hull itself

  CostTraits traits() const {
    return {.unit = unit, .symmetric = false, .additive = true, .below_curves = true, .quadratic_at_rest = false};
  }

  /// A move straight up or down has no map distance, whose root has no derivative.
  template <class S>
  static S along_tangent(const HullSide& side, const S& map2, const S& height) {
    using std::sqrt;
    if (innermost(map2) == 0) return side.rise * height;
    return side.base * sqrt(map2) + side.rise * height;
  }

  /// Of a move over the map distance sqrt(map2) that rises by so much.
  template <class S>
  S cost(const S& map2, const S& rise) const {
    using std::sqrt;
    const bool climbs = innermost(rise) > 0;
    const HullSide& side = climbs ? up : down;
    const S height = climbs ? rise : S(-rise);
    const double map = std::sqrt(innermost(map2));
    if (innermost(height) > side.to * map) return along_tangent(side, map2, height);
    const S length = sqrt(map2), steepness = height / length;
    if (innermost(height) > side.from * map) return length * side.going_over(steepness);
    return length * pace(climbs ? steepness : S(-steepness));
  }

  template <class S>
  S value(const Point<S, 3>& a, const Point<S, 3>& b) const {
    const Point<S, 3> d = b - a;
    if (innermost(d.squaredNorm()) == 0) return S(0.0);  // no derivative, but the square has one
    const S c = scale * cost<S>(d[0] * d[0] + d[1] * d[1], d[2]);
    return c * c;
  }
  double line_element(const Eigen::VectorXd&, const Eigen::VectorXd& v) const {
    return v.squaredNorm() == 0 ? 0 : scale * cost<double>(v.head(2).squaredNorm(), v[2]);
  }

  const HullSide& hull_of(double rise) const { return rise > 0 ? hull_up : hull_down; }
  bool is_steep(double map, double rise) const { return std::abs(rise) > hull_of(rise).to * map; }

  /// What the hull itself says of a move.
  double hull(double map, double rise) const {
    return scale * (is_steep(map, rise) ? hull_of(rise).rise * std::abs(rise) : map * pace(rise / map));
  }
};

template <class Pace>
class WalkingCostOf final : public SegmentCostOf<Walking<Pace>, WalkingCost> {
 public:
  using SegmentCostOf<Walking<Pace>, WalkingCost>::SegmentCostOf;

  Regularization regularization(const AmbientPath& path) const override {
    const Walking<Pace>& walk = this->function();
    Regularization out;
    double total = 0, climbed = 0, descended = 0;
    for (Index i = 0; i < path.segment_count(); ++i) {
      const Eigen::Vector3d d = path.x.col(i + 1) - path.x.col(i);
      const double map = d.head(2).norm(), rise = d[2], cost = walk.line_element(d, d);
      total += cost;
      if (walk.is_steep(map, rise)) (rise > 0 ? climbed : descended) += cost;
      if (std::abs(rise) > (rise > 0 ? walk.up : walk.down).from * map)
        out.above += std::max(0.0, walk.hull(map, rise) - cost);
      else if (map > 0)
        out.below += walk.scale * map * walk.pace.rounding(rise / map);
    }
    if (!(climbed + descended > 0)) return out;
    out.free_share = (climbed + descended) / total;
    out.free_ways = free_ways(climbed / total, descended / total);
    return out;
  }

  /// Both legs have the critical slope s, one to each side of the gradient g: s g / |g|^2 +- sqrt(1 - s^2 / |g|^2) n.
  std::optional<MixedMove> legs(const Points& tangents, const Eigen::VectorXd& v) const override {
    const Walking<Pace>& walk = this->function();
    const Eigen::Vector2d map = v.head(2);
    if (!walk.is_steep(map.norm(), v[2]) || tangents.cols() != 2) return std::nullopt;
    const double slope = std::copysign(walk.hull_of(v[2]).to, v[2]);
    const Eigen::Matrix2d base = tangents.topRows(2).transpose();
    const Eigen::Vector2d g = base.fullPivLu().solve(tangents.row(2).transpose());
    const double steepness = g.norm(), across = std::sqrt(std::max(0.0, 1 - slope * slope / (steepness * steepness)));
    if (!(across > 0)) return std::nullopt;
    const Eigen::Vector2d side(-g[1] / steepness, g[0] / steepness);
    const double length = v[2] / slope;  // of both legs on the map
    const double first = std::clamp((length + map.dot(side) / across) / 2, 0.0, length);
    const double share = first / length;
    if (!(share > 0 && share < 1)) return std::nullopt;
    Eigen::Vector3d beside;
    beside << first * (slope * g / (steepness * steepness) + across * side) - share * map, 0;
    return MixedMove{share, beside};
  }

 private:
  std::string free_ways(double climbed, double descended) const {
    std::ostringstream out;
    out << std::setprecision(3) << "switchbacks";
    const auto add = [&](double share, const char* what, double slope) {
      if (share > 0) out << " " << what << " (" << 100 * share << " % of the cost, at slope " << slope << ")";
    };
    add(climbed, "up", this->function().hull_up.to);
    if (climbed > 0 && descended > 0) out << " and";
    add(descended, "down", -this->function().hull_down.to);
    return out.str();
  }
};

struct LawMaker {
  double metres;  ///< per unit of length
  double rounding;

  std::shared_ptr<const WalkingCost> operator()(const walking::Tobler& law) const {
    if (!(law.speed_factor > 0) || !std::isfinite(law.speed_factor))
      throw OptionError("law.speed_factor", "must be a number greater than 0");
    double units = 1;  // per hour
    const char* unit = "h";
    if (law.unit == WalkingTime::minutes) units = 60, unit = "min";
    if (law.unit == WalkingTime::seconds) units = 3600, unit = "s";
    return lifted(ToblerPace{rounding}, units * metres / kMetres / (kToblerSpeed * law.speed_factor), unit);
  }
  std::shared_ptr<const WalkingCost> operator()(const walking::Minetti&) const {
    return lifted(MinettiPace{}, metres, "J/kg");
  }

 private:
  template <class Pace>
  std::shared_ptr<const WalkingCost> lifted(const Pace& pace, double scale, const char* unit) const {
    const double width = kHullRounding * rounding;
    return std::make_shared<WalkingCostOf<Pace>>(Walking<Pace>{pace, scale, unit, hull_side(pace, 1, width, kTilt),
                                                               hull_side(pace, -1, width, kTilt),
                                                               hull_side(pace, 1, 0, 0), hull_side(pace, -1, 0, 0)});
  }
};

}  // namespace

Words<WalkingTime> words(WalkingTime) {
  static constexpr std::array<Word<WalkingTime>, 3> kWords = {
      {{WalkingTime::hours, "h"}, {WalkingTime::minutes, "min"}, {WalkingTime::seconds, "s"}}};
  return kWords;
}

Words<MapLength> words(MapLength) {
  static constexpr std::array<Word<MapLength>, 2> kWords = {{{MapLength::metres, "m"}, {MapLength::kilometres, "km"}}};
  return kWords;
}

void walking::Tobler::fields(FieldVisitor& visit) {
  visit.field("speed_factor", speed_factor,
              {.help = "Factor of the speed: 0.6 off paths, 1.25 on horseback (Tobler).",
               .minimum = 0,
               .exclusive_minimum = true});
  visit.choice("unit", unit, {.help = "The unit of time."});
}

void WalkingOptions::fields(FieldVisitor& visit) {
  visit.variant("law", law, {.help = "Cost of walking as a function of slope, with its unit."});
  visit.choice("length", length, {.help = "The unit of the coordinates, height included."});
  visit.field("rounding", rounding,
              {.help = "Range of slope, to both sides, over which the kink of Tobler's law at -0.05 and the corners of "
                       "the hull are rounded. The error bar includes the effect; a larger range needs fewer points.",
               .unit = "slope",
               .minimum = 0,
               .maximum = -ToblerPace::kFastest,
               .exclusive_minimum = true});
}

std::shared_ptr<const WalkingCost> make_walking_cost(const WalkingOptions& options, int dim) {
  if (dim != 3)
    throw OptionError("type", "'walking' needs three dimensions, the last of which is height, but this space has " +
                                  std::to_string(dim));
  if (!(options.rounding > 0 && options.rounding < -ToblerPace::kFastest))
    throw OptionError("rounding", "must be greater than 0 and less than 0.05, so that level ground is exact");
  return std::visit(LawMaker{options.length == MapLength::metres ? 1 : kMetres, options.rounding}, options.law);
}

}  // namespace leastcost
