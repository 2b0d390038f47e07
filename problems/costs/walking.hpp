// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>
#include <variant>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/mixes_moves.hpp>
#include <leastcost/framework/cost/regularized.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>

namespace leastcost {

/// Unit of the cost.
enum class WalkingTime { hours, minutes, seconds };
Words<WalkingTime> words(WalkingTime);

/// Unit of the coordinates.
enum class MapLength { metres, kilometres };
Words<MapLength> words(MapLength);

/// What walking costs at a slope.
namespace walking {

struct Tobler {
  static constexpr std::string_view kType = "tobler";
  static constexpr std::string_view kHelp = "Time, at 6 exp(-3.5 |slope + 0.05|) km/h of map distance (Tobler 1993).";
  double speed_factor = 1;
  WalkingTime unit = WalkingTime::hours;
  void fields(FieldVisitor& visit);
};

struct Minetti {
  static constexpr std::string_view kType = "minetti";
  static constexpr std::string_view kHelp = "Metabolic energy in J/kg, per metre of path (Minetti et al. 2002).";
};

using Law = std::variant<Tobler, Minetti>;

}  // namespace walking

struct WalkingOptions {
  walking::Law law = {};
  MapLength length = MapLength::metres;
  double rounding = 0.01;  ///< slopes; of kinks, less than 0.05
  void fields(FieldVisitor& visit);
};

/// What a cost of walking can do besides.
class WalkingCost : public SegmentCost, public Regularized, public MixesMoves {};

/// Time or energy of walking over terrain; the last of three coordinates is height, in the unit of the others. A move
/// over the map distance l that rises by h costs l f(h / l), f the law's pace per map distance, and where it is steeper
/// than the critical slope what switchbacks of that slope cost: the convex hull of the law, 3.5 e^1.175 / 6 h per km
/// climbed beyond 2/7 and 3.5 e^0.825 / 6 h per km descended beyond -2/7 for Tobler. Not symmetric. Beyond the critical
/// slopes all ways cost the same; the cost has a slight preference there for the shortest one, so that there is one
/// path, says so (Regularized), and knows the switchbacks (MixesMoves). Throws OptionError.
std::shared_ptr<const WalkingCost> make_walking_cost(const WalkingOptions& options, int dim);

}  // namespace leastcost
