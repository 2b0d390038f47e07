// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/pulled_chain.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include "problems/taut/polyline_length.hpp"

namespace leastcost {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFarthestPull = 0.01, kShortestPull = 1e-5;  ///< of the length: radii of vertices
constexpr double kLessFar = 4;            ///< radii of vertices that were held back are so much less
constexpr double kFarLook = 1.5;          ///< radii: so that looks last a while
constexpr double kShortestSpring = 1e-6;  ///< of the length
constexpr int kCorrections = 3;
constexpr double kAgain = 0.5;  ///< of what was missing is asked for beyond it in a correction
constexpr int kStepHalvings = 4;
constexpr int kMostPrograms = 100;
constexpr double kGained = 1e-12;  ///< relative: less is rounding

/// How deep a move is in walls, at most 0.
double depth(const std::vector<Wall>& walls) {
  double least = 0;
  for (const Wall& wall : walls) least = std::min(least, wall.gap);
  return least;
}

std::vector<Index> all_moves(const Points& x) {
  std::vector<Index> all(static_cast<std::size_t>(x.cols() - 1));
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

}  // namespace

PulledChain::PulledChain(const ConstraintManifold& domain, const Walls& walls, MatrixXd metric, Points start,
                         double kept, const Monitor& monitor)
    : domain_(domain),
      walls_(walls),
      monitor_(monitor),
      metric_(std::move(metric)),
      unit_(polyline_length(start)),
      kept_(kept) {
  const Index d = start.rows();
  if (walls.dimension() != d || domain.dimensions().coordinate != d || metric_.rows() != d || metric_.cols() != d)
    throw InputError("a chain, its domain, obstacles and metric must have the same dimension");
  if (domain.shape() != Shape::flat || find_ability<HasChart>(domain) != nullptr)
    throw InputError("a chain can be pulled only in a flat domain without a chart");
  if (start.cols() < 2 || !(unit_ > 0))
    throw InputError("a chain that is pulled needs two vertices and a length above 0");
  take(std::move(start));
}

void PulledChain::take(Points polyline) {
  x_ = std::move(polyline);
  looks_.clear();
  radii_ = VectorXd::Zero(x_.cols());
  for (Index i = 1; i + 1 < x_.cols(); ++i) {
    const double in = (x_.col(i) - x_.col(i - 1)).norm(), out = (x_.col(i + 1) - x_.col(i)).norm();
    radii_[i] = std::clamp(std::min(in, out) / 2, kShortestPull * unit_, kFarthestPull * unit_);
  }
}

double PulledChain::length_of(const VectorXd& a, const VectorXd& b) const {
  const VectorXd way = b - a;
  return std::sqrt(way.dot(metric_ * way));
}

double PulledChain::length_of(const Points& x) const {
  double sum = 0;
  for (Index i = 0; i + 1 < x.cols(); ++i) sum += length_of(VectorXd(x.col(i)), VectorXd(x.col(i + 1)));
  return sum;
}

/// Looks anew where the ends have gone so far that a wall may be in the way, or turn, that was not or did not.
void PulledChain::look(const Points& x, Index move, Look& look) const {
  const double wanted = std::max(radii_[move], radii_[move + 1]);
  if (look.a.size() > 0) {
    const double gone = std::max((x.col(move) - look.a).norm(), (x.col(move + 1) - look.b).norm());
    double least = look.reach;
    for (const Wall& wall : look.walls) least = std::min(least, wall.gap);
    if (gone == 0 || (least - gone > wanted && gone + wanted <= look.reach)) return;
  }
  look_at_clock(monitor_.deadline);
  look.a = x.col(move);
  look.b = x.col(move + 1);
  look.reach = kFarLook * wanted;
  walls_.along(look.a, look.b, look.reach, look.walls);
}

void PulledChain::look_around() {
  looks_.resize(static_cast<std::size_t>(x_.cols() - 1));
  for (const Index i : all_moves(x_)) look(x_, i, looks_[static_cast<std::size_t>(i)]);
}

/// Those of some moves of x that are not clear, unless they were no clearer before.
std::vector<Index> PulledChain::not_clear(const Points& x, const std::vector<Index>& moves, Looks& looks) const {
  std::vector<Index> bad;
  for (const Index i : moves) {
    const auto at = static_cast<std::size_t>(i);
    look(x, i, looks[at]);
    if (depth(looks[at].walls) < depth(looks_[at].walls)) bad.push_back(i);
  }
  return bad;
}

/// Of springs that pull alike: sum |d_i|^2 / (2 |d_i before|), which is nowhere below the length but for a constant.
/// Lengths are in units of the chain.
void PulledChain::add_springs(ChainSystem& springs, VectorXd& force) const {
  const Index m = x_.cols() - 2;
  const double length = this->length(), scale = unit_ / length;
  const MatrixXd metric = scale * scale * metric_;
  VectorXd rest(m + 1);
  for (Index i = 0; i <= m; ++i)
    rest[i] = std::max(kShortestSpring, length_of(VectorXd(x_.col(i)), VectorXd(x_.col(i + 1))) / length);
  const Index d = x_.rows();
  springs.resize(static_cast<int>(d), m, false);
  springs.set_zero();
  force.resize(d * m);
  for (Index i = 0; i < m; ++i) {
    springs.diagonal(i) = (1 / rest[i] + 1 / rest[i + 1]) * metric;
    if (i + 1 < m) springs.coupling(i) = -1 / rest[i + 1] * metric;
    const VectorXd pull = (x_.col(i + 2) - x_.col(i + 1)) / rest[i + 1] - (x_.col(i + 1) - x_.col(i)) / rest[i];
    force.segment(d * i, d) = metric * pull / unit_;
  }
}

void PulledChain::add_walls(const Looks& looks, bool corrects, ChainHalfSpaces& rows) const {
  const Index m = x_.cols() - 2;
  for (const Index i : all_moves(x_)) {
    const Look& look = looks[static_cast<std::size_t>(i)];
    for (const Wall& wall : look.walls) {
      if (wall.slope.size() != x_.rows()) continue;
      const double t = wall.at, gap = wall.gap / unit_;
      const VectorXd off = (1 - t) * (x_.col(i) - look.a) + t * (x_.col(i + 1) - look.b);
      const double kept = corrects ? kept_ - kAgain * std::min(0.0, gap) : std::min(kept_, std::max(0.0, gap));
      const double offset = kept - gap - wall.slope.dot(off) / unit_;
      if (i == 0)
        rows.add(0, t * wall.slope, offset);
      else if (i == m)
        rows.add(m - 1, (1 - t) * wall.slope, offset);
      else
        rows.add(i - 1, (1 - t) * wall.slope, t * wall.slope, offset);
    }
  }
}

/// Of the radii, and of a box that the domain is.
void PulledChain::add_bounds(ChainHalfSpaces& rows) const {
  const auto* box = find_ability<HasBox>(domain_);
  for (Index i = 0; i + 2 < x_.cols(); ++i) {
    for (Index j = 0; j < x_.rows(); ++j) {
      double below = radii_[i + 1], above = below;
      if (box != nullptr) {
        below = std::min(below, x_(j, i + 1) - box->box_lower()[j]);
        above = std::min(above, box->box_upper()[j] - x_(j, i + 1));
      }
      rows.add(i, VectorXd::Unit(x_.rows(), j), -below / unit_);
      rows.add(i, -VectorXd::Unit(x_.rows(), j), -above / unit_);
    }
  }
}

std::optional<Points> PulledChain::step_between(const Looks& looks, bool corrects) const {
  const Index m = x_.cols() - 2, d = x_.rows();
  ChainSystem springs;
  VectorXd force;
  add_springs(springs, force);
  ChainHalfSpaces rows(static_cast<int>(d));
  add_walls(looks, corrects, rows);
  add_bounds(rows);
  const auto z = least_of_chain(springs, force, rows, VectorXd::Zero(d * m));
  if (!z) return std::nullopt;
  Points step = Points::Zero(d, x_.cols());
  step.middleCols(1, m) = unit_ * z->reshaped(d, m);
  return step;
}

/// Vertices of moves that are not clear go half the way only, and at last none of it, until all moves are.
Points PulledChain::held_back(Points step, std::vector<Index> bad, Looks& looks, std::vector<char>& held) const {
  Points next = x_ + step;
  for (int k = 1; !bad.empty(); ++k) {
    VectorXd shares = VectorXd::Ones(x_.cols());
    for (const Index i : bad) shares[i] = shares[i + 1] = k < kStepHalvings ? 0.5 : 0;
    for (Index i = 0; i < x_.cols(); ++i)
      if (shares[i] < 1) held[static_cast<std::size_t>(i)] = 1;
    step *= shares.asDiagonal();
    next = x_ + step;
    std::vector<Index> changed;
    for (const Index i : all_moves(x_))
      if (shares[i] < 1 || shares[i + 1] < 1) changed.push_back(i);
    bad = not_clear(next, changed, looks);
  }
  return next;
}

bool PulledChain::pull() {
  if (x_.cols() < 3) return false;
  if (looks_.empty()) look_around();
  Looks looks = looks_;
  std::vector<char> held(static_cast<std::size_t>(x_.cols()), 0);
  Points next = x_;
  if (std::optional<Points> step = step_between(looks_, false)) {
    std::vector<Index> bad = not_clear(x_ + *step, all_moves(x_), looks);
    for (int k = 0; k < kCorrections && !bad.empty(); ++k) {
      std::optional<Points> corrected = step_between(looks, true);
      if (!corrected) break;
      step = std::move(corrected);
      bad = not_clear(x_ + *step, bad, looks);
    }
    bad = not_clear(x_ + *step, all_moves(x_), looks);
    next = held_back(*step, bad, looks, held);
  }
  if (!(length_of(next) < (1 - kGained) * length())) {
    radii_ /= kLessFar;
    return false;
  }
  for (Index i = 1; i + 1 < x_.cols(); ++i) {
    const double went = (next.col(i) - x_.col(i)).cwiseAbs().maxCoeff();
    const double radius = held[static_cast<std::size_t>(i)] != 0 ? std::max(went, radii_[i] / kLessFar) : 2 * went;
    radii_[i] = std::clamp(radius, kShortestPull * unit_, kFarthestPull * unit_);
  }
  x_ = std::move(next);
  looks_ = std::move(looks);
  return true;
}

void PulledChain::pull_tight(double least) {
  constexpr int kCalmPulls = 2;
  for (int calm = 0, k = 0; k < kMostPrograms && calm < kCalmPulls && !monitor_.interrupted(); ++k) {
    const double before = length();
    if (pull())
      calm = before - length() < least * before ? calm + 1 : 0;
    else if (radii_.maxCoeff() < kShortestPull * unit_)
      return;
  }
}

/// What an arc in the place of a bend could save: its angle squared, times its shorter side, over 8.
double PulledChain::saved_by_bending(const VectorXd& before, const VectorXd& x, const VectorXd& after) const {
  const double in = length_of(before, x), out = length_of(x, after);
  if (!(in > 0) || !(out > 0)) return 0;
  const VectorXd bend = (after - x) / out - (x - before) / in;
  return bend.dot(metric_ * bend) * std::min(in, out) / 8;
}

bool PulledChain::refine(double least) {
  constexpr double kNone = 1e-3;  // of what is worth a vertex: bends that can be done without
  constexpr double kBeside = 1.0 / 3;
  const double worth = least * length();
  std::vector<Wall> found;
  std::vector<VectorXd> kept = {x_.col(0)};
  std::vector<char> bends = {0};
  for (Index i = 1; i + 1 < x_.cols(); ++i) {
    const double saved = saved_by_bending(kept.back(), x_.col(i), x_.col(i + 1));
    if (saved < kNone * worth) {
      walls_.along(kept.back(), x_.col(i + 1), kept_ / 2 * unit_, found);
      if (found.empty()) continue;
    }
    kept.emplace_back(x_.col(i));
    bends.push_back(saved > worth ? 1 : 0);
  }
  kept.emplace_back(x_.col(x_.cols() - 1));
  bends.push_back(0);
  std::vector<VectorXd> all = {kept.front()};
  for (std::size_t i = 1; i < kept.size(); ++i) {
    const VectorXd &a = kept[i - 1], &b = kept[i];
    const bool first = bends[i - 1] != 0, last = bends[i] != 0;
    if (first) all.emplace_back(a + (last ? kBeside : 0.5) * (b - a));
    if (last) all.emplace_back(b - (first ? kBeside : 0.5) * (b - a));
    all.push_back(b);
  }
  const bool refined = all.size() > kept.size();
  Points x(x_.rows(), static_cast<Index>(all.size()));
  for (Index i = 0; i < x.cols(); ++i) x.col(i) = all[static_cast<std::size_t>(i)];
  take(std::move(x));
  return refined;
}

}  // namespace leastcost
