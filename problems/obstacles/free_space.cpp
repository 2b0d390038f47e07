// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/free_space.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include "framework/base/counted.hpp"
#include "framework/base/dense_solves.hpp"
#include "problems/obstacles/crossing_word.hpp"
#include "problems/obstacles/least_push.hpp"
#include "problems/obstacles/sweep.hpp"
#include "problems/obstacles/walls_in.hpp"

namespace leastcost {
namespace {

using Vector = Eigen::VectorXd;

constexpr double kOn = 1e-11;        ///< of the size of the scene: a point so near to a wall lies on it
constexpr double kSurely = 4;        ///< times as much: what is farther away holds no point
constexpr double kAlong = 1e-9;      ///< of a step: what of it may lead off a wall that it runs along
constexpr double kSameSide = 0.5;    ///< cosine between the ways out before and after a step along a wall
constexpr int kMostPushes = 100;     ///< between walls that push a point to and fro
constexpr int kMostIdlePushes = 10;  ///< in a row, none of which leaves half as much
constexpr int kFewIdlePushes = 4;    ///< the same where time counts more than the last point
constexpr int kOneByOne = 6;         ///< pushes out of the worst wall before all of them are taken together
constexpr int kMostHalvings = 30;
constexpr int kMostRetreats = 6;        ///< of the ends of a segment that would be drawn through an obstacle
constexpr double kLeastAdvance = 0.02;  ///< of a step: how finely walls are looked for along it
constexpr double kBending = 1e-5;       ///< of the distance from a core: the step of a difference of slopes
constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();

double longest_of(const Points& x, const CoordinatePath& path) {
  double longest = 0;
  for (Index i = 0; i < path.segment_count(); ++i)
    longest = std::max(longest, (x.col((i + 1) % x.cols()) - x.col(i)).norm());
  return longest;
}

}  // namespace

/// A column on its way: its coordinates, its place, and the walls beside it as far as was looked.
struct FreeSpace::Point {
  Point(const FreeSpace& space, const CoordinatePath& path, Index column)
      : domain_(space.domain_.get()), chart_(space.chart_), flat_(space.flat_) {
    path_.u = path.u.col(column);
    if (!path.sites.empty()) path_.sites = {path.site(column)};
    path_.ring = true;  // a column alone, none of it fixed
    place();
  }

  const Vector& u() const { return u_; }
  const Vector& x() const { return x_; }
  const CoordinatePath& path() const { return path_; }

  void go_to(const Vector& u) {
    path_.u = u;
    place();
  }

  /// A part of the way to another point, back onto a curved domain.
  void go_towards(const Vector& start, const Vector& end, double t) {
    path_.u = start + t * (end - start);
    if (chart_ == nullptr && domain_->shape() != Shape::flat) domain_->project(path_);
    place();
  }

  void step(const Vector& way) {
    CoordinatePath to;
    domain_->retract(path_, way, to);
    path_ = std::move(to);
    place();
  }

  /// The derivative of a wall's gap in coordinates, along the domain.
  Vector slope(const Wall& wall) const {
    if (chart_ != nullptr) {
      Points j;
      chart_->jacobians(path_, j);
      return j.transpose() * wall.slope;
    }
    if (flat_) return wall.slope;
    Points basis;
    domain_->tangent_bases(path_, basis);
    return basis * (basis.transpose() * wall.slope);
  }

  const Wall* find(int obstacle) const {
    const auto found = std::find_if(walls.begin(), walls.end(), [&](const Wall& w) { return w.obstacle == obstacle; });
    return found == walls.end() ? nullptr : &*found;
  }

  /// What a look around the place has found.
  void see(std::vector<Wall> found, double reach) {
    walls = std::move(found);
    looked = reach;
  }

  std::vector<Wall> walls;
  double looked = -1;  ///< how far around the place

 private:
  void place() {
    looked = -1;
    u_ = path_.u;
    x_ = chart_ == nullptr ? u_ : Vector(positions(*domain_, path_));
  }

  const ConstraintManifold* domain_;
  const HasChart* chart_;
  bool flat_;
  CoordinatePath path_;
  Vector u_, x_;
};

FreeSpace::FreeSpace(std::shared_ptr<const ConstraintManifold> domain, std::shared_ptr<const Walls> walls)
    : domain_(std::move(domain)),
      walls_(std::move(walls)),
      chart_(find_ability<HasChart>(*domain_)),
      flat_(chart_ == nullptr && domain_->shape() == Shape::flat) {
  if (domain_->shape() == Shape::polyhedral)
    throw InputError("obstacles need a flat or a smooth domain, but this one is made of flat pieces");
  if (find_ability<HasCoarserVersion>(*domain_) != nullptr)
    throw InputError("obstacles need a domain that is given exactly, but this one is made from data");
  if (walls_->dimension() != domain_->dimensions().ambient)
    throw InputError("the obstacles have " + counted(walls_->dimension(), "dimension") + ", but the domain has " +
                     std::to_string(domain_->dimensions().ambient));
}

FreeSpace::FreeSpace(const std::shared_ptr<const ConstraintManifold>& domain, Obstacles obstacles, double clearance)
    : FreeSpace(domain, walls_in(*domain, std::move(obstacles), clearance)) {}

/// By how much a point on a wall may be off it.
double FreeSpace::slack(const Vector& x) const {
  return std::max(kOn * std::max(walls_->size(), x.cwiseAbs().maxCoeff()), kRounding * walls_->computed_from());
}

void FreeSpace::look(Point& point, double reach) const {
  if (point.looked >= reach) return;
  std::vector<Wall> found = std::move(point.walls);
  anything_near(point.x(), reach, found);
  point.see(std::move(found), reach);
}

bool FreeSpace::anything_near(const Vector& x, double reach, std::vector<Wall>& found) const {
  walls_->near(x, reach + margins_.widest() + 2 * slack(x), found);
  return !found.empty();
}

/// Along the way out of a wall, as far as its gap, taken to be linear, says.
void FreeSpace::push(Point& point, const Wall& wall, double by) const {
  const Vector slope = point.slope(wall);
  const double steep = slope.squaredNorm();
  if (steep > 0) point.step(by / steep * slope);
}

/// One least step onto those that hold the point and out of all others, sides of a box among them, as their gaps, taken
/// to be linear, say. A push out of one wall alone leads into the one that faces it, and between two at an angle a what
/// is missing falls by the square of cos(a) only. Where no step clears all of them, it goes onto those that it is in.
void FreeSpace::push_out_of_all(Point& point, const std::vector<int>& held, double by) const {
  constexpr double kBeside = 4, kFarthest = 64;  // of what is missing: what is heeded, and how far to go at once
  look(point, kBeside * by);
  std::vector<WallToClear> all;
  for (const Wall& wall : point.walls) {
    const bool holds = std::find(held.begin(), held.end(), wall.obstacle) != held.end();
    all.push_back({point.slope(wall), -room(wall), holds});
  }
  const auto* box = flat_ ? find_ability<HasBox>(*domain_) : nullptr;
  for (Index i = 0; box != nullptr && i < point.u().size(); ++i) {
    const Vector side = Vector::Unit(point.u().size(), i);
    const double below = point.u()[i] - box->box_lower()[i], above = box->box_upper()[i] - point.u()[i];
    if (below < kFarthest * by) all.push_back({side, -below, false});
    if (above < kFarthest * by) all.push_back({-side, -above, false});
  }
  std::optional<Vector> step = least_push(all);
  if (!step) {
    std::erase_if(all, [](const WallToClear& wall) { return !wall.exactly && !(wall.missing > 0); });
    for (WallToClear& wall : all) wall.exactly = true;
    step = least_push(all);
  }
  if (step && step->norm() > 0) point.step(std::min(1.0, kFarthest * by / step->norm()) * *step);
}

/// Moves a point onto the walls that hold it and, if bounded, out of those that it has come into, to the nearest place;
/// false where they leave none. `reach`: how far those that hold it may be, 0 where none does.
bool FreeSpace::settle(Point& point, const std::vector<int>& held, bool bounded, double reach) const {
  const double rounding = kRounding * std::max(walls_->computed_from(), point.x().cwiseAbs().maxCoeff());
  const auto holds = [&](int i) { return std::find(held.begin(), held.end(), i) != held.end(); };
  std::vector<const Wall*> counting;
  // Walls at a sharp angle pass a point to and fro for long: the least step that is right for all of them, were they
  // straight.
  const auto push_onto_all = [&](const std::vector<const Wall*>& all) {
    Points slopes(point.u().size(), static_cast<Index>(all.size()));
    Vector off(slopes.cols());
    for (Index i = 0; i < slopes.cols(); ++i) {
      const Wall& wall = *all[static_cast<std::size_t>(i)];
      slopes.col(i) = point.slope(wall);
      off[i] = -room(wall);
    }
    point.step(least_squares(slopes.transpose(), off));
  };
  double before = std::numeric_limits<double>::infinity(), best = before;
  int idle = 0;
  const int most_idle = agreement_ > kCloseFit ? kFewIdlePushes : kMostIdlePushes;
  for (int k = 0; k < kMostPushes && idle < most_idle; ++k) {
    look(point, reach);
    const Wall* worst = nullptr;
    double by = 0;
    counting.clear();
    for (const Wall& wall : point.walls) {
      const double off = room(wall);
      const bool counts = holds(wall.obstacle) || (bounded && off < 0);
      if (counts) counting.push_back(&wall);
      if (!counts || std::abs(off) <= std::abs(by)) continue;
      worst = &wall;
      by = off;
    }
    if (std::abs(by) <= rounding) return true;
    // Two walls that both hold the point settle at first order only: rounding is not waited for.
    if (std::abs(by) <= slack(point.x()) && std::abs(by) >= before / 2) return true;
    before = std::abs(by);
    idle = before < best / 2 ? 0 : idle + 1;
    best = std::min(best, before);
    if (k >= kOneByOne && bounded && flat_)
      push_out_of_all(point, held, before);
    else if (k < kOneByOne || counting.size() == 1)
      push(point, *worst, -by);
    else
      push_onto_all(counting);
    if (!bounded) continue;
    CoordinatePath back = point.path();  // a wall may have pushed it out of the domain
    domain_->project(back);
    if (back.u != point.u()) point.go_to(back.u);
  }
  return before <= slack(point.x());
}

/// Takes a point that rested on walls before the last fit along with them, where that is not far; false where it stays.
bool FreeSpace::carry(Point& point) const {
  if (!margins_.carry()) return false;
  const double reach = margins_.widest_before();
  look(point, reach);
  std::vector<int> held;
  double gone = 0;
  for (const Wall& wall : point.walls) {
    const double before = margins_.before(wall);
    if (std::abs(wall.gap - before) > slack(point.x())) continue;
    held.push_back(wall.obstacle);
    const double steep = point.slope(wall).norm();  // below 1 where a robot's part moves less than it might
    if (steep > 0) gone = std::max(gone, std::abs(margins_.of(wall) - before) / steep);
  }
  return !held.empty() && carry_onto(point, held, gone, reach);
}

/// `gone`: how far the walls have.
bool FreeSpace::carry_onto(Point& point, const std::vector<int>& held, double gone, double reach) const {
  constexpr double kFarther = 4;  // into a corner, or past a kink
  Point carried = point;
  if (!settle(carried, held, true, reach) || (carried.x() - point.x()).norm() > kFarther * gone) return false;
  point = std::move(carried);
  return true;
}

/// How far is looked at once along a way of this length. All that is near a long way is much, and most of it far from
/// where the way leads.
double FreeSpace::look_ahead(double length) const {
  constexpr double kAhead = 4;  // of the widest margin, as far around any look goes anyway
  const double widest = std::max(margins_.widest(), margins_.from_cores());
  const double ahead = std::max(kAhead * widest, kLeastAdvance * length);
  return flat_ && widest > 0 ? std::min(length, ahead) : length;
}

/// Ends a way where it first meets a wall that does not hold it; false where it meets one.
bool FreeSpace::clear_way(const Point& start, const std::vector<int>& held, Point& end) const {
  const Vector& from = start.u();
  const Vector to = end.u(), way = to - from;
  const double length = (end.x() - start.x()).norm();
  const double farthest = look_ahead(length);
  Point at = start;
  for (double t = 0; t < 1;) {
    double free = 1 - t;
    look(at, std::min(free * length, farthest));
    if (at.looked < free * length) free = at.looked / length;  // what was not seen is farther away
    for (const Wall& wall : at.walls) {
      if (std::find(held.begin(), held.end(), wall.obstacle) != held.end()) continue;
      const Vector slope = at.slope(wall);
      const double gap = room(wall);
      const double speed = slope.norm() * way.norm();
      if (gap <= slack(at.x()) && slope.dot(way) >= 0) continue;  // on its way out
      if (gap <= slack(at.x())) free = 0;
      if (speed > 0) free = std::min(free, std::max(0.0, gap) / speed);
    }
    if (free <= 0) {
      end = at;
      return false;
    }
    t = std::min(1.0, t + std::max(free, kLeastAdvance));
    if (t < 1) at.go_towards(from, to, t);
  }
  return true;
}

/// A long step along a wall must not come out at its back.
void FreeSpace::keep_side(const Point& start, const std::vector<int>& held, Point& end) const {
  for (const int i : held) {
    const Vector before = start.slope(*start.find(i));
    for (int k = 0; k < kMostHalvings; ++k) {
      look(end, (end.x() - start.x()).norm());
      const Wall* wall = end.find(i);
      if (wall == nullptr) break;
      const Vector after = end.slope(*wall);
      if (after.dot(before) > kSameSide * after.norm() * before.norm()) break;
      end.go_towards(start.u(), end.u(), 0.5);
    }
  }
}

/// A step that runs along a wall, or into it, stays on it. One that meets another wall ends there, on the side that it
/// came from, however far it would have gone: a point never changes sides of an obstacle. Where it meets none it comes
/// to rest on those of `onto`.
void FreeSpace::move_along_walls(const CoordinatePath& from, const Points& step, bool bounded,
                                 const BoundsOfPoints* onto, CoordinatePath& to) const {
  std::vector<int> held;
  std::vector<Wall> found;
  Vector place;
  for (Index k = 0; k < step.cols(); ++k) {
    const Index column = from.free_begin() + k;
    const bool ends_on = onto != nullptr && !(*onto)[static_cast<std::size_t>(k)].empty();
    double reach = 0;
    if (flat_) {  // most points are near nothing, and places are coordinates
      place = from.u.col(column);
      const double way_length = (to.u.col(column) - place).norm();
      reach = ends_on || !bounded ? way_length : look_ahead(way_length);
      if (!anything_near(place, reach, found) && reach >= way_length) continue;
    }
    Point start(*this, from, column), end(*this, to, column);
    const double length = (end.x() - start.x()).norm();
    if (flat_) start.see(found, reach);
    if (!flat_) look(start, length);
    if (!flat_ && start.walls.empty()) continue;
    const Vector way = step.col(k);
    held.clear();
    for (const Wall& wall : start.walls) {
      if (std::abs(room(wall)) > slack(start.x())) continue;
      const Vector slope = start.slope(wall);
      const double off = way.dot(slope), along = kAlong * way.norm() * slope.norm();
      if (bounded ? off <= along : std::abs(off) <= along) held.push_back(wall.obstacle);
    }
    const std::size_t held_by_walls = held.size();
    if (ends_on)
      for (const int wall : (*onto)[static_cast<std::size_t>(k)])
        if (start.find(wall) != nullptr && std::find(held.begin(), held.end(), wall) == held.end())
          held.push_back(wall);
    if (bounded && !clear_way(start, held, end)) held.resize(held_by_walls);
    keep_side(start, held, end);
    to.u.col(column) = settle(end, held, bounded, held.empty() ? 0 : length) ? end.u() : start.u();
  }
}

/// A segment whose ends have moved so that it may have been drawn through the core of an obstacle goes half the way
/// only, and at last none of it.
void FreeSpace::keep_class(const CoordinatePath& from, CoordinatePath& to) const {
  const Points before = positions(*domain_, from);
  std::vector<char> held_back(static_cast<std::size_t>(from.u.cols()), 0);
  for (int k = 0; k <= kMostRetreats; ++k) {
    const Points after = positions(*domain_, to);
    std::fill(held_back.begin(), held_back.end(), 0);
    bool all_pass = true;
    for (Index i = 0; i < from.segment_count(); ++i) {
      const Index j = (i + 1) % from.u.cols();
      if (sweeps_clear(*walls_, {before.col(i), before.col(j)}, {after.col(i), after.col(j)})) continue;
      all_pass = false;
      held_back[static_cast<std::size_t>(i)] = held_back[static_cast<std::size_t>(j)] = 1;
    }
    if (all_pass) return;
    for (Index i = from.free_begin(); i < from.free_begin() + from.free_count(); ++i) {
      if (held_back[static_cast<std::size_t>(i)] == 0) continue;
      Point point(*this, to, i);
      point.go_towards(from.u.col(i), to.u.col(i), 0.5);
      const bool settled = k < kMostRetreats && settle(point, {}, true, 0);
      to.u.col(i) = settled ? point.u() : Vector(from.u.col(i));
    }
  }
}

Projection FreeSpace::project(CoordinatePath& path) const {
  const CoordinatePath before = path;
  Projection result = domain_->project(path);
  for (Index i = 0; i < path.u.cols(); ++i) {
    Point point(*this, path, i);
    if (carry(point) || settle(point, {}, true, 0)) {
      path.u.col(i) = point.u();
      result.moved = std::max(result.moved, (point.u() - before.u.col(i)).norm());
    } else if (std::find(result.failed.begin(), result.failed.end(), i) == result.failed.end()) {
      result.failed.push_back(i);
      path.u.col(i) = before.u.col(i);
    }
  }
  return result;
}

void FreeSpace::tangent_bases(const CoordinatePath& path, Points& bases) const { domain_->tangent_bases(path, bases); }

void FreeSpace::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  domain_->retract(from, step, to);
  move_along_walls(from, step, true, nullptr, to);
  keep_class(from, to);
}

void FreeSpace::retract_onto(const CoordinatePath& from, const Points& step, const BoundsOfPoints& bounds,
                             CoordinatePath& to) const {
  domain_->retract(from, step, to);
  move_along_walls(from, step, true, &bounds, to);
  keep_class(from, to);
}

void FreeSpace::retract_beyond(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  if (const auto* beyond = find_ability<GoesBeyondBounds>(*domain_)) {
    beyond->retract_beyond(from, step, to);
  } else if (flat_ || chart_ != nullptr) {
    prepare_like(from, to);
    to.u.middleCols(from.free_begin(), from.free_count()) =
        from.u.middleCols(from.free_begin(), from.free_count()) + step;
  } else {
    domain_->retract(from, step, to);
  }
  move_along_walls(from, step, false, nullptr, to);
}

double FreeSpace::residual(const CoordinatePath& path) const {
  double worst = domain_->residual(path);
  std::vector<Wall> found;
  const Points x = positions(*domain_, path);
  for (Index i = 0; i < x.cols(); ++i) {
    walls_->near(x.col(i), 0, found);
    for (const Wall& wall : found) worst = std::max(worst, -wall.gap);
  }
  return worst;
}

int FreeSpace::active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const {
  const auto* bounds = find_ability<HasBounds>(*domain_);
  int count = bounds != nullptr ? bounds->active_bounds(path, column, normals) : 0;
  if (flat_) {  // most points are near nothing, and places are coordinates
    thread_local std::vector<Wall> walls;
    thread_local Vector x;
    x = path.u.col(column);
    anything_near(x, 0, walls);
    const double on = slack(x);
    for (const Wall& wall : walls)
      if (count < normals.cols() && std::abs(room(wall)) <= on && wall.slope.norm() > 0)
        normals.col(count++) = -wall.slope.normalized();
    return count;
  }
  Point point(*this, path, column);
  look(point, 0);
  for (const Wall& wall : point.walls) {
    if (count == normals.cols()) break;
    if (std::abs(room(wall)) > slack(point.x())) continue;
    const Vector slope = point.slope(wall);
    if (slope.norm() > 0) normals.col(count++) = -slope.normalized();
  }
  return count;
}

void FreeSpace::bounds_within(const CoordinatePath& path, Index column, double reach,
                              std::vector<NearBound>& found) const {
  found.clear();
  if (const auto* box = find_ability<HasBox>(*domain_)) {
    const auto add = [&](Index i, double sign, double gap) {
      if (gap <= reach) found.push_back({NearBound::kNone, sign * Vector::Unit(path.u.rows(), i), gap});
    };
    for (Index i = 0; i < path.u.rows(); ++i) {
      add(i, 1, path.u(i, column) - box->box_lower()[i]);
      add(i, -1, box->box_upper()[i] - path.u(i, column));
    }
  }
  if (flat_) {  // places are coordinates
    thread_local std::vector<Wall> walls;
    thread_local Vector x;
    x = path.u.col(column);
    anything_near(x, reach, walls);
    for (Wall& wall : walls) found.push_back({wall.obstacle, std::move(wall.slope), room(wall)});
    return;
  }
  Point point(*this, path, column);
  look(point, reach);
  for (const Wall& wall : point.walls) found.push_back({wall.obstacle, point.slope(wall), room(wall)});
}

/// Of what holds the point: walls that it lies on and that keep it from going down, taking the worst one that does not
/// away until all do. Along them R(t) leaves the straight way by -slopes^+ (t'H t) / 2, H being the second derivatives
/// of their gaps, here differences of slopes.
bool FreeSpace::bend(const CoordinatePath& path, Index column, const Vector& gradient, Points& bend) const {
  const Vector x = path.u.col(column);
  const double on = slack(x);
  std::vector<Wall> found;
  if (!anything_near(x, 0, found)) return false;
  std::erase_if(found, [&](const Wall& wall) { return std::abs(room(wall)) > on; });
  Vector multipliers;
  while (!found.empty()) {
    Points slopes(x.size(), static_cast<Index>(found.size()));
    for (Index i = 0; i < slopes.cols(); ++i) slopes.col(i) = found[static_cast<std::size_t>(i)].slope;
    multipliers = least_squares(slopes, gradient);
    Index worst = 0;
    if (multipliers.minCoeff(&worst) > 0) break;
    found.erase(found.begin() + worst);
  }
  if (found.empty()) return false;
  bend.setZero(x.size(), x.size());
  const double size = std::max(walls_->size(), x.cwiseAbs().maxCoeff());
  double step = size;
  for (const Wall& wall : found) step = std::min(step, wall.required + wall.gap);
  step = kBending * std::max(step, kOn * size);
  std::vector<Wall> beside;
  Vector there = x;
  for (Index i = 0; i < x.size(); ++i) {
    there[i] = x[i] + step;
    anything_near(there, step, beside);
    for (std::size_t k = 0; k < found.size(); ++k)
      for (const Wall& wall : beside)
        if (wall.obstacle == found[k].obstacle)
          bend.col(i) -= multipliers[static_cast<Index>(k)] / step * (wall.slope - found[k].slope);
    there[i] = x[i];
  }
  bend = ((bend + bend.transpose()) / 2).eval();
  return bend.allFinite();
}

MoveClearance FreeSpace::clearance(const Vector& a, const Vector& b) const { return walls_->clearance(a, b); }

bool FreeSpace::clears(const Vector& a, const Vector& b) const { return leastcost::clears(*walls_, a, b); }

std::optional<ChainClearance> FreeSpace::chain_clearance(const Points& x) const {
  return find_ability<MeasuresChains>(*walls_)->chain_clearance(x);
}

std::optional<bool> FreeSpace::same_class(const Points& a, const Points& b) const {
  return of_one_class(*walls_, a, b);
}

std::string FreeSpace::obstacle_name(int obstacle) const { return walls_->obstacle_name(obstacle); }

std::string FreeSpace::depth_text(int obstacle, double missing) const { return walls_->depth_text(obstacle, missing); }

/// A solve begins: its walls may remember.
double FreeSpace::thinnest() const {
  const auto* cores = find_ability<HasThinnestCore>(*walls_);
  return cores != nullptr ? cores->thinnest() : 0;
}

std::shared_ptr<FreeSpace> FreeSpace::for_solve(WallMargins margins, double agreement) const {
  std::shared_ptr<const Walls> walls = remembering(*walls_);
  if (walls == nullptr) walls = walls_;
  auto out = std::make_shared<FreeSpace>(domain_, std::move(walls));
  out->margins_ = std::move(margins);
  out->agreement_ = agreement;
  return out;
}

std::shared_ptr<const ConstraintManifold> FreeSpace::unfitted(const CoordinatePath& path, double agreement) const {
  return for_solve(WallMargins(longest_of(positions(*domain_, path), path), thinnest()), agreement);
}

KeptMargins FreeSpace::kept_margins(const CoordinatePath& path, const std::map<int, double>& gaps) const {
  const auto* numbers = find_ability<NumbersWalls>(*walls_);
  if (numbers == nullptr) return {};
  KeptMargins kept{numbers->wall_count(), margins_.widths_for_next(gaps, closeness(positions(*domain_, path))), {}};
  kept.resting.resize(static_cast<std::size_t>(path.free_count()));
  for (Index i = 0; i < path.free_count(); ++i) {
    Point point(*this, path, path.free_begin() + i);
    look(point, 0);
    for (const Wall& wall : point.walls)
      if (std::abs(room(wall)) <= slack(point.x())) kept.resting[static_cast<std::size_t>(i)].push_back(wall.obstacle);
  }
  return kept;
}

void FreeSpace::carry_along(const KeptMargins& kept, CoordinatePath& path, const Deadline& deadline) const {
  constexpr Index kPointsAtOnce = 4;  // between two looks at the clock
  if (static_cast<Index>(kept.resting.size()) != path.free_count()) return;
  const double farthest = longest_of(positions(*domain_, path), path);
  std::vector<int> held;
  for (Index i = 0; i < path.free_count(); ++i) {
    const std::vector<int>& resting = kept.resting[static_cast<std::size_t>(i)];
    if (i % kPointsAtOnce == 0) look_at_clock(deadline);
    if (resting.empty()) continue;
    Point point(*this, path, path.free_begin() + i);
    look(point, farthest);
    held.clear();
    double gone = 0;
    for (const Wall& wall : point.walls) {
      const double steep = point.slope(wall).norm(), off = std::abs(room(wall));
      if (!(off < farthest * steep) || std::find(resting.begin(), resting.end(), wall.obstacle) == resting.end())
        continue;
      held.push_back(wall.obstacle);
      gone = std::max(gone, off / steep);
    }
    if (gone > slack(point.x()) && carry_onto(point, held, gone, farthest))
      path.u.col(path.free_begin() + i) = point.u();
  }
}

std::shared_ptr<const ConstraintManifold> FreeSpace::unfitted_with(const KeptMargins& kept, const CoordinatePath& path,
                                                                   double agreement) const {
  const auto* numbers = find_ability<NumbersWalls>(*walls_);
  if (numbers == nullptr || kept.walls == 0 || numbers->wall_count() != kept.walls) return nullptr;
  return for_solve(WallMargins(longest_of(positions(*domain_, path), path), thinnest(), kept.widths), agreement);
}

WallMargins::Fit FreeSpace::closeness(const Points& x) const {
  const double size = std::max(walls_->size(), x.cwiseAbs().maxCoeff());
  const double rounding = kRounding * std::max(size, walls_->computed_from()), on = std::max(kOn * size, rounding);
  return {std::max(agreement_ * extent_of(x), on), rounding, kSurely * on};
}

SegmentFit FreeSpace::fitted(const CoordinatePath& path) const {
  const Points x = positions(*domain_, path);
  const WallMargins::Fit closely = closeness(x);
  // What holds a point is found, if only there.
  std::map<int, Wall> least = least_on_moves(*walls_, x, path.segment_count(), margins_.widest() + closely.on);
  SegmentFit fit;
  for (const auto& [obstacle, wall] : least) fit.gaps[obstacle] = wall.gap;
  if (agreement_ > kCloseFit && !margins_.carry()) margins_.take_sags(*walls_, x, closely, least);
  std::optional<WallMargins> margins = margins_.fitted(least, longest_of(x, path), closely);
  if (!margins) return fit;
  auto fitted = std::make_shared<FreeSpace>(domain_, walls_);
  fitted->margins_ = std::move(*margins);
  fitted->agreement_ = agreement_;
  fit.domain = std::move(fitted);
  return fit;
}

std::vector<MarginCost> FreeSpace::margin_costs(const CoordinatePath& path, const Points& gradient) const {
  std::map<int, double> costs;
  std::vector<const Wall*> holding;
  for (Index k = 0; k < path.free_count(); ++k) {
    Point point(*this, path, path.free_begin() + k);
    look(point, 0);
    holding.clear();
    for (const Wall& wall : point.walls)
      if (std::abs(room(wall)) <= slack(point.x())) holding.push_back(&wall);
    if (holding.empty()) continue;
    Points slopes(gradient.rows(), static_cast<Index>(holding.size()));
    for (Index i = 0; i < slopes.cols(); ++i) slopes.col(i) = point.slope(*holding[static_cast<std::size_t>(i)]);
    const Vector multipliers = least_squares(slopes, gradient.col(k));
    for (Index i = 0; i < slopes.cols(); ++i) {
      const Wall& wall = *holding[static_cast<std::size_t>(i)];
      costs[wall.obstacle] += std::max(0.0, multipliers[i]) * margins_.of(wall);
    }
  }
  std::vector<MarginCost> listed;
  listed.reserve(costs.size());
  for (const auto& [obstacle, cost] : costs) listed.push_back({obstacle, cost});
  return listed;
}

double FreeSpace::longest_move() const { return 2 * find_ability<HasThinnestCore>(*walls_)->thinnest(); }

bool FreeSpace::limits_moves() const {
  const auto* cores = find_ability<HasThinnestCore>(*walls_);
  return cores != nullptr && std::isfinite(cores->thinnest());
}

void FreeSpace::draw(const DrawnPaths& paths, Drawing& out) const {
  if (const auto* drawn = find_ability<DrawsItself>(*domain_)) drawn->draw(paths, out);
  if (const auto* drawn = find_ability<DrawsItself>(*walls_)) drawn->draw(paths, out);
}

PoseStrip FreeSpace::pose_strip(const Points& configurations) const {
  const auto* poses = find_ability<DrawsPoses>(*walls_);
  return poses != nullptr ? poses->pose_strip(configurations) : PoseStrip{};
}

bool FreeSpace::has_poses() const { return find_ability<DrawsPoses>(*walls_) != nullptr; }

const ConstraintManifold* FreeSpace::decorated(const std::type_info&) const { return domain_.get(); }

}  // namespace leastcost
