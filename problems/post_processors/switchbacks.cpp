// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/switchbacks.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/mixes_moves.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include "framework/base/dense_solves.hpp"
#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

constexpr int kPiecesOfLeg = 4;            ///< so that legs follow the terrain
constexpr Index kMostCorners = 1'000'000;  ///< of a zigzag that people could want

/// A place of the zigzag: how far along the chain, and how far beside it.
struct ZigzagPlace {
  double at = 0;      ///< in segments
  double beside = 0;  ///< in lengths along the `across` of its segment
};

struct ZigzagLine {
  std::vector<ZigzagPlace> places = {{0, 0}};
  int teeth = 0;
};

/// Offset of a tooth of height 1 at the part f of its way: half of the first leg, the second, the other half.
double tooth(double f, double share) {
  if (f < share / 2) return f / share;
  if (f > 1 - share / 2) return (f - 1) / share;
  return 0.5 - (f - share / 2) / (1 - share);
}

class Zigzag {
 public:
  Zigzag(const Problem& problem, const CoordinatePath& chain, double width)
      : manifold_(*problem.manifold), chain_(chain), width_(width) {
    const auto* mixes = find_ability<MixesMoves>(*problem.cost);
    if (mixes == nullptr) throw InputError("switchbacks need a cost that is a hull, such as 'walking'");
    if (manifold_.shape() == Shape::polyhedral) throw InputError("switchbacks are not drawn on meshes");
    find_legs(*mixes);
  }

  /// From the first point of the chain to the last one, or once around.
  ZigzagLine line() const {
    ZigzagLine out;
    const auto segments = static_cast<Index>(legs_.size());
    for (Index i = 0; i < segments;) {
      if (!legs_[static_cast<std::size_t>(i)]) {
        out.places.push_back({static_cast<double>(++i), 0});
        continue;
      }
      Index end = i;
      while (end < segments && goes_on(end, i)) ++end;
      append_teeth(i, end, out);
      i = end;
    }
    return out;
  }

  /// Onto the domain. Nothing where a place has no point on it.
  std::optional<Points> positions(const std::vector<ZigzagPlace>& places) const {
    CoordinatePath path{Points(chain_.u.rows(), static_cast<Index>(places.size())), {}, false};
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Index i = segment_of(places[k]);
      const double t = places[k].at - static_cast<double>(i);
      path.u.col(static_cast<Index>(k)) = (1 - t) * chain_.column(i) + t * chain_.column(i + 1);
    }
    Points slopes;
    const auto* chart = find_ability<HasChart>(manifold_);
    if (chart != nullptr) chart->jacobians(path, slopes);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const auto& legs = legs_[static_cast<std::size_t>(segment_of(places[k]))];
      if (places[k].beside == 0 || !legs) continue;
      Eigen::VectorXd offset = places[k].beside * legs->across.normalized();
      const Index d = path.u.rows(), column = static_cast<Index>(k);
      if (chart != nullptr) offset = least_squares(slopes.middleCols(d * column, d), offset);
      path.u.col(column) += offset;
    }
    if (!manifold_.project(path).failed.empty()) return std::nullopt;
    return leastcost::positions(manifold_, path);
  }

 private:
  Index segment_of(const ZigzagPlace& place) const {
    return std::min(static_cast<Index>(place.at), static_cast<Index>(legs_.size()) - 1);
  }

  void find_legs(const MixesMoves& mixes) {
    const Index segments = chain_.segment_count();
    const Points x = leastcost::positions(manifold_, chain_);
    const auto* chart = find_ability<HasChart>(manifold_);
    Points tangents;
    if (chart != nullptr)
      chart->jacobians(chain_, tangents);
    else
      manifold_.tangent_bases(chain_, tangents);
    const Index width = tangents.cols() / chain_.u.cols();
    for (Index i = 0; i < segments; ++i) {
      const Index next = (i + 1) % x.cols();
      legs_.push_back(mixes.legs(tangents.middleCols(width * i, width), x.col(next) - x.col(i)));
    }
  }

  /// Whether a stretch that began with segment `first` has segment i as well: climbs and descents have legs of their
  /// own.
  bool goes_on(Index i, Index first) const {
    const auto& legs = legs_[static_cast<std::size_t>(i)];
    return legs && (i == first || legs->across.dot(legs_[static_cast<std::size_t>(i) - 1]->across) > 0);
  }

  /// A stretch of segments that all have legs, in teeth of the same extent.
  void append_teeth(Index begin, Index end, ZigzagLine& out) const {
    std::vector<double> reach = {0};  // of the first leg beside the path, up to each point
    for (Index i = begin; i < end; ++i)
      reach.push_back(reach.back() + legs_[static_cast<std::size_t>(i)]->across.norm());
    const double count = std::max(1.0, std::ceil(reach.back() / width_));
    if (!(count * 4 * kPiecesOfLeg < static_cast<double>(kMostCorners)))
      throw InputError("switchbacks of width " + short_number(width_) + " would have more than " +
                       std::to_string(kMostCorners) + " points; give a larger width");
    const auto at = [&](double r) {
      const auto above = std::upper_bound(reach.begin() + 1, reach.end() - 1, r);
      const double low = *(above - 1), step = *above - low;
      return static_cast<double>(begin + (above - reach.begin()) - 1) +
             (step > 0 ? std::min(1.0, (r - low) / step) : 0);
    };
    const double height = reach.back() / count;
    for (int k = 0; k < static_cast<int>(count); ++k) {
      const double middle = at((k + 0.5) * height);
      const double share = legs_[static_cast<std::size_t>(segment_of({middle, 0}))]->share;
      const std::array<double, 3> corners = {share / 2, 1 - share / 2, 1};
      double from = 0;
      for (const double corner : corners) {
        for (int piece = 1; piece <= kPiecesOfLeg; ++piece) {
          const double f = from + (corner - from) * piece / kPiecesOfLeg;
          if (f < 1) out.places.push_back({at((k + f) * height), height * tooth(f, share)});
        }
        from = corner;
      }
      out.places.push_back({at((k + 1) * height), 0});
    }
    out.places.back().at = static_cast<double>(end);
    out.teeth += static_cast<int>(count);
  }

  const ConstraintManifold& manifold_;
  const CoordinatePath& chain_;
  double width_;
  std::vector<std::optional<MixedMove>> legs_;
};

/// What the pieces of the curve cost between the points of the chain; a piece over several segments counts for each by
/// its part.
Eigen::VectorXd costs_between(const std::vector<ZigzagPlace>& places, const Eigen::VectorXd& pieces, Index segments) {
  Eigen::VectorXd costs = Eigen::VectorXd::Zero(segments);
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const double from = places[k].at, to = places[k + 1].at, cost = pieces[static_cast<Index>(k)];
    const Index first = std::min(static_cast<Index>(from), segments - 1);
    if (!(to > from)) costs[first] += cost;
    for (Index i = first; i < segments && static_cast<double>(i) < to; ++i) {
      const double begin = std::max(from, static_cast<double>(i)), end = std::min(to, static_cast<double>(i + 1));
      costs[i] += cost * (end - begin) / (to - from);
    }
  }
  return costs;
}

}  // namespace

void SwitchbackOptions::fields(FieldVisitor& visit) {
  visit.field("width", width,
              {.help = "Largest total width of the zigzag across the path.",
               .unit = "length",
               .minimum = 0,
               .exclusive_minimum = true,
               .required = true});
}

SwitchbackPostProcessor::SwitchbackPostProcessor(const SwitchbackOptions& options) : width_(options.width) {
  if (!(options.width > 0) || !std::isfinite(options.width)) throw OptionError("width", "must be greater than 0");
}

PostProcessed SwitchbackPostProcessor::apply(const Problem& problem, const FirstPath&, PostProcessed current,
                                             const Monitor& monitor) const {
  if (monitor.interrupted()) return current;
  const Zigzag zigzag(problem, current.chain, width_);
  const auto [places, teeth] = zigzag.line();
  if (teeth == 0) {
    current.notes.emplace_back("switchbacks: none, because the path is nowhere steep enough");
    return current;
  }
  const std::optional<Points> x = zigzag.positions(places);
  if (!x) {
    current.notes.emplace_back("switchbacks: the zigzag would leave the domain; give a smaller width");
    return current;
  }
  const Eigen::VectorXd pieces = segment_costs(*problem.cost, {{x->data(), x->rows(), x->cols()}, {}, false});
  const double before = current.curve.cost;
  current.curve.x = *x;
  current.curve.cost = pieces.sum();
  current.curve_costs = costs_between(places, pieces, current.chain.segment_count());
  std::ostringstream note;
  note << "switchbacks: " << teeth << " to each side, drawn as the curve; they cost " << current.curve.cost / before - 1
       << " (relative) more than the path that they replace";
  current.notes.push_back(note.str());
  return current;
}

}  // namespace leastcost
