// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/tangent_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/taut/tangent.hpp"

namespace leastcost {
namespace {

using Point2 = Eigen::Vector2d;

constexpr double kOfContact = 1e-9;  ///< of the size: by so much a tangent in contact may seem to touch
constexpr double kFullCircle = 2 * std::numbers::pi;
constexpr double kNoTurn = 1e-7;                ///< radians short of a full circle: a turn of none, for rounding
constexpr int kCells = 512;                     ///< of a circle
constexpr double kCell = kFullCircle / kCells;  ///< radians
constexpr double kOfCell = 1e-9;                ///< what counts as the border of one
constexpr double kOfLengths = 1e-12;            ///< relative: what lengths of many tangents and arcs may be off by
constexpr int kTakenAtOnce = 16;                ///< arrivals between two questions whether to stop
constexpr double kOfTangents = 16 * std::numeric_limits<double>::epsilon();  ///< of coordinates: what a tangent and an
                                                                             ///< arc may be off by

/// A disc with the side on which it is passed; one without a radius has no sides.
struct Wheel {
  Point2 center;
  double radius;
  int side;  ///< +1: counterclockwise, the disc is on the left; -1: clockwise; 0: a point
  int obstacle;
  std::vector<std::optional<bool>> cell_clear = {};  ///< of the parts of its circle, as far as they were looked at
};

/// A path that comes to a wheel along a tangent.
struct Arrival {
  int wheel, parent;  ///< parent: an arrival at the wheel where the tangent begins; -1: none
  double length;      ///< of the path to here
  double turn;        ///< along the parent's circle, before the tangent; 0 or more
  Tangent way;
};

struct Open {
  double least;  ///< of any path that goes on from there
  int arrival;
  bool operator<(const Open& other) const { return least > other.least; }
};

class Search {
 public:
  Search(const Walls& walls, const Point2& source, const Point2& target, double upper,
         const TangentSearchOptions& options)
      : walls_(walls), options_(options), target_(target), below_(upper * (1 - options.tolerance)) {
    size_ = std::max({walls.size(), source.cwiseAbs().maxCoeff(), target.cwiseAbs().maxCoeff()});
    slack_ = kOfContact * size_;
    wheels_ = {{source, 0, 0, -1}, {target, 0, 0, -1}};
    add_wheels(source, upper);
    settled_.resize(wheels_.size());
    tangents_from_.resize(wheels_.size());
  }

  TangentSearchResult run() {
    arrivals_.push_back({kSource, -1, 0, 0, {wheels_[kSource].center, wheels_[kSource].center}});
    open_.push({(target_ - wheels_[kSource].center).norm(), 0});
    for (int taken = 0; !open_.empty(); ++taken) {
      const Open next = open_.top();
      if (result_.tangents > options_.max_tangents || (taken % kTakenAtOnce == 0 && options_.stop && options_.stop()))
        return ended(next.least);
      open_.pop();
      if (!is_clear(next.arrival)) continue;
      const int wheel = arrivals_[at(next.arrival)].wheel;
      if (const int before = settled_before(next.arrival); before >= 0) {
        go_on_from(next.arrival, before);
        continue;
      }
      settled_[at(wheel)].push_back(next.arrival);
      if (wheel == kTarget) {
        result_.shorter = result_.finished = true;
        trace(next.arrival);
        return ended(next.least);
      }
      go_on_from(next.arrival, -1);
    }
    result_.finished = true;
    return ended(below_);
  }

 private:
  static constexpr int kSource = 0, kTarget = 1;

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  /// As much rounding as if a path came to every wheel.
  TangentSearchResult ended(double least) {
    result_.rounding = kOfLengths * least + kOfTangents * size_ * static_cast<double>(wheels_.size());
    result_.lower_bound = std::max(0.0, least - result_.rounding);
    return std::move(result_);
  }

  /// All discs that a path below the bound can come to.
  void add_wheels(const Point2& source, double upper) {
    const Point2 middle = (source + target_) / 2;
    const Eigen::AlignedBox2d reach(middle.array() - upper / 2, middle.array() + upper / 2);
    const auto* made = find_ability<HasRounds>(walls_);
    if (made == nullptr) throw InputError("tangents need obstacles that are balls, boxes, polygons or maps");
    for (const Round& round : made->rounds(reach)) {
      if ((round.center - source).norm() + (round.center - target_).norm() - 2 * round.radius > upper + slack_)
        continue;
      if (round.radius > 0)
        for (const int side : {1, -1}) wheels_.push_back({round.center, round.radius, side, round.obstacle});
      else
        wheels_.push_back({round.center, 0, 0, round.obstacle});
    }
  }

  /// How far a path turns on a wheel between two of its places.
  static double turn_on(const Wheel& wheel, const Point2& from, const Point2& to) {
    if (wheel.side == 0) return 0;
    const Point2 a = from - wheel.center, b = to - wheel.center;
    double turn = wheel.side * turn_between(a, b);
    if (turn < 0) turn += kFullCircle;
    return turn > kFullCircle - kNoTurn ? 0 : turn;
  }

  struct Leg {
    int wheel;
    Tangent way;
    std::optional<bool> clear = {};
  };

  /// An end in contact may lie within a disc, for rounding.
  std::optional<Tangent> tangent_between(const Wheel& a, const Wheel& b) const {
    return tangent(a.center, a.side * a.radius, b.center, b.side * b.radius, slack_);
  }

  /// All tangents that begin at a wheel, drawn once.
  std::vector<Leg>& tangents_from(int wheel) {
    auto& known = tangents_from_[at(wheel)];
    if (known) return *known;
    known.emplace();
    for (int to = kTarget; at(to) < wheels_.size(); ++to)
      if (to != wheel)
        if (const auto way = tangent_between(wheels_[at(wheel)], wheels_[at(to)])) known->push_back({to, *way});
    result_.tangents += static_cast<std::int64_t>(known->size());
    return *known;
  }

  /// More than half around a disc the tangents before and after it meet; from there it would be shorter without it.
  static bool crosses_itself(const Wheel& wheel, double turn, double shorter_tangent) {
    return turn > std::numbers::pi && shorter_tangent > wheel.radius * std::abs(std::tan(turn / 2));
  }

  bool would_cross_itself(int number, const Leg& leg, double out) const {
    const Arrival& arrival = arrivals_[at(number)];
    const Wheel& wheel = wheels_[at(arrival.wheel)];
    return crosses_itself(wheel, turn_on(wheel, arrival.way.to, leg.way.from),
                          std::min((arrival.way.to - arrival.way.from).norm(), out));
  }

  /// `before`: goes on as well, but for where it would cross itself; -1: none does.
  void go_on_from(int from, int before) {
    if (before >= 0 && wheels_[at(arrivals_[at(from)].wheel)].side == 0) return;
    const Arrival here = arrivals_[at(from)];
    const Wheel& wheel = wheels_[at(here.wheel)];
    for (const Leg& leg : tangents_from(here.wheel)) {
      if (leg.clear == false || (wheels_[at(leg.wheel)].side == 0 && !settled_[at(leg.wheel)].empty())) continue;
      const double turn = turn_on(wheel, here.way.to, leg.way.from), out = (leg.way.to - leg.way.from).norm();
      if (crosses_itself(wheel, turn, std::min((here.way.to - here.way.from).norm(), out))) continue;
      if (before >= 0 && !would_cross_itself(before, leg, out)) continue;
      const double length = here.length + wheel.radius * turn + out;
      const double least = length + (target_ - leg.way.to).norm();
      if (least >= below_) continue;
      ++result_.tangents;
      arrivals_.push_back({leg.wheel, from, length, turn, leg.way});
      open_.push({least, static_cast<int>(arrivals_.size()) - 1});
    }
  }

  /// An arrival that is no longer and could go on along the circle to here: what goes on from here goes on from there.
  /// All parts of the circle between the two must be clear, also those that the arc has only a piece of, so that an arc
  /// from there is clear where the one from here is. -1: none.
  int settled_before(int number) {
    const Arrival& arrival = arrivals_[at(number)];
    Wheel& wheel = wheels_[at(arrival.wheel)];
    for (const int other : settled_[at(arrival.wheel)]) {
      const Arrival& before = arrivals_[at(other)];
      const double turn = turn_on(wheel, before.way.to, arrival.way.to);
      if (before.length + wheel.radius * turn <= arrival.length && is_arc_clear(wheel, before.way.to, turn, -kOfCell))
        return other;
    }
    return -1;
  }

  bool is_clear(int number) {
    const Arrival& arrival = arrivals_[at(number)];
    if (arrival.parent < 0) return true;
    const Arrival& parent = arrivals_[at(arrival.parent)];
    std::vector<Leg>& legs = tangents_from(parent.wheel);
    const auto leg = std::lower_bound(legs.begin(), legs.end(), arrival.wheel,
                                      [](const Leg& a, int wheel) { return a.wheel < wheel; });
    if (!leg->clear)
      leg->clear = is_within(arrival.way.from, slack_) && is_within(arrival.way.to, slack_) &&
                   is_move_clear(arrival.way.from, arrival.way.to, slack_);
    return *leg->clear && is_arc_clear(wheels_[at(parent.wheel)], parent.way.to, arrival.turn, kOfCell);
  }

  bool is_move_clear(const Point2& a, const Point2& b, double slack) const {
    const MoveClearance clearance = walls_.clearance(a, b);
    return clearance.obstacle < 0 || clearance.upper >= -slack;
  }

  bool is_within(const Point2& place, double slack) const {
    return options_.box.isEmpty() || options_.box.squaredExteriorDistance(place) <= slack * slack;
  }

  /// By the parts of the circle that the arc has whole (`inside` > 0) or a piece of (`inside` < 0).
  bool is_arc_clear(Wheel& wheel, const Point2& begin, double turn, double inside) {
    if (wheel.side == 0 || turn == 0) return true;
    const Point2 from_center = begin - wheel.center;
    const double angle = std::atan2(from_center.y(), from_center.x());
    const double low = (wheel.side > 0 ? angle : angle - turn) / kCell, high = low + turn / kCell;
    const int first = static_cast<int>(inside > 0 ? std::ceil(low + inside) : std::floor(low + inside));
    const int end = static_cast<int>(inside > 0 ? std::floor(high - inside) : std::ceil(high - inside));
    for (int cell = first; cell < std::min(end, first + kCells); ++cell)
      if (!is_cell_clear(wheel, (cell % kCells + kCells) % kCells)) return false;
    return true;
  }

  /// By the tangents at its ends; by how far these are outside is allowed.
  bool is_cell_clear(Wheel& wheel, int cell) const {
    wheel.cell_clear.resize(kCells);
    std::optional<bool>& known = wheel.cell_clear[at(cell)];
    if (known) return *known;
    const double far = 1 / std::cos(kCell / 2), off = slack_ + wheel.radius * (far - 1);
    const auto place = [&](double times, double cells) {
      return Point2(wheel.center + times * wheel.radius * Point2(std::cos(cells * kCell), std::sin(cells * kCell)));
    };
    const Point2 begin = place(1, cell), middle = place(far, cell + 0.5), end = place(1, cell + 1);
    known = is_within(begin, off) && is_within(end, off) && is_move_clear(begin, middle, off) &&
            is_move_clear(middle, end, off);
    return *known;
  }

  void trace(int number) {
    for (int i = number; arrivals_[at(i)].parent > 0; i = arrivals_[at(i)].parent) {
      const Arrival& to = arrivals_[at(i)];
      const Arrival& from = arrivals_[at(to.parent)];
      const Wheel& wheel = wheels_[at(from.wheel)];
      const Point2 in = from.way.to - from.way.from, out = to.way.to - to.way.from;
      const double turn = turn_between(in, out);
      const int side = wheel.side != 0 ? wheel.side : turn < 0 ? -1 : 1;
      result_.bends.push_back(
          {{wheel.obstacle, wheel.center, wheel.radius}, side, wheel.side != 0 ? side * to.turn : turn});
    }
    std::reverse(result_.bends.begin(), result_.bends.end());
  }

  const Walls& walls_;
  const TangentSearchOptions& options_;
  Point2 target_;
  double below_, size_ = 0, slack_ = 0;
  std::vector<Wheel> wheels_;
  std::vector<Arrival> arrivals_;
  std::vector<std::vector<int>> settled_;                       ///< by wheel: arrivals
  std::vector<std::optional<std::vector<Leg>>> tangents_from_;  ///< by wheel, ascending
  std::priority_queue<Open> open_;
  TangentSearchResult result_;
};

}  // namespace

TangentSearchResult shorter_tangent_path(const Walls& walls, const Point2& source, const Point2& target, double upper,
                                         const TangentSearchOptions& options) {
  if (source == target) throw InputError("a path between equal ends has no length");
  return Search(walls, source, target, upper, options).run();
}

}  // namespace leastcost
