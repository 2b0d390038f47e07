// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/pulled_chain.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include <leastcost/framework/deadline.hpp>
#include <leastcost/framework/has_box.hpp>
#include "problems/taut/chain_program.hpp"
#include "problems/taut/polyline_length.hpp"

namespace leastcost {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kOffWalls = 1e-7;        ///< of the length: from walls, so that their proofs need not be told to rounding
constexpr double kShortestSpring = 1e-6;
constexpr double kFirstReach = 1.0 / 50, kLeastReach = 1e-5;  ///< of the length
constexpr int kCorrections = 3;
constexpr double kAgain = 0.5;
constexpr double kNearWall = 1, kFarLook = 2;  // of what a vertex may go
constexpr int kStepHalvings = 4;
constexpr int kMostPrograms = 100;
constexpr double kGained = 1e-12;  ///< relative: less is rounding

}  // namespace

PulledChain::PulledChain(const ConstraintManifold& domain, const Walls& walls, MatrixXd metric, Points start,
                         const Monitor& monitor)
    : domain_(domain),
      walls_(walls),
      monitor_(monitor),
      metric_(std::move(metric)),
      unit_(polyline_length(start)) {
  take(std::move(start));
}

void PulledChain::take(Points polyline) {
  x_ = std::move(polyline);
  looks_.clear();
  radii_ = VectorXd::Zero(x_.cols());
  for (Index i = 1; i + 1 < x_.cols(); ++i)
    radii_[i] = std::min(kFirstReach * unit_, std::min((x_.col(i) - x_.col(i - 1)).norm(), (x_.col(i + 1) - x_.col(i)).norm()) / 2);
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

/// Looks anew where the ends have gone so far that a wall may have come into the way, or that it turns.
void PulledChain::look(const Points& x, Index move, Look& look) const {
  const double wanted = std::max(radii_[move], radii_[move + 1]);
  if (look.a.size() > 0) {
    const double gone = std::max((x.col(move) - look.a).norm(), (x.col(move + 1) - look.b).norm());
    double least = look.reach;
    for (const Wall& wall : look.walls) least = std::min(least, wall.gap);
    if (gone == 0 || (least - gone > kNearWall * wanted && gone + wanted <= look.reach)) return;
  }
  look_at_clock(monitor_.deadline);
  look.a = x.col(move);
  look.b = x.col(move + 1);
  look.reach = kFarLook * wanted;
  walls_.along(look.a, look.b, look.reach, look.walls);
}

/// The step to the least stretched chain, from x_, between half-spaces that are linear about other vertices.
std::optional<Points> PulledChain::between(const Looks& looks, bool corrects) const {
  const Index m = x_.cols() - 2, k = domain_.dimensions().tangent;
  const auto basis = [&](Index vertex) { return bases_.middleCols(k * vertex, k); };
  const double length = this->length(), scale = unit_ / length;
  VectorXd rest(m + 1);
  for (Index i = 0; i <= m; ++i)
    rest[i] = std::max(kShortestSpring, length_of(VectorXd(x_.col(i)), VectorXd(x_.col(i + 1))) / length);
  ChainSystem springs;
  springs.resize(static_cast<int>(k), m, false);
  springs.set_zero();
  VectorXd force(k * m);
  const MatrixXd metric = scale * scale * metric_;
  for (Index i = 0; i < m; ++i) {
    const Index v = i + 1;
    const MatrixXd heavy = basis(v).transpose() * metric;
    springs.diagonal(i) = (1 / rest[i] + 1 / rest[i + 1]) * heavy * basis(v);
    if (i + 1 < m) springs.coupling(i) = -1 / rest[i + 1] * heavy * basis(v + 1);
    force.segment(k * i, k) =
        heavy * ((x_.col(v + 1) - x_.col(v)) / rest[i + 1] - (x_.col(v) - x_.col(v - 1)) / rest[i]) / unit_;
  }
  ChainHalfSpaces rows(static_cast<int>(k));
  for (Index i = 0; i <= m; ++i) {
    const Look& look = looks[static_cast<std::size_t>(i)];
    for (const Wall& wall : look.walls) {
      if (wall.slope.size() != x_.rows()) continue;
      const double t = wall.at;
      const VectorXd off = (1 - t) * (x_.col(i) - look.a) + t * (x_.col(i + 1) - look.b);
      const double gap = wall.gap / unit_, now = gap + wall.slope.dot(off) / unit_;
      const double kept = corrects ? kOffWalls - kAgain * std::min(0.0, gap) : std::min(kOffWalls, std::max(0.0, gap));
      const double offset = kept - now;
      if (i == 0)
        rows.add(0, t * basis(1).transpose() * wall.slope, offset);
      else if (i == m)
        rows.add(m - 1, (1 - t) * basis(m).transpose() * wall.slope, offset);
      else
        rows.add(i - 1, (1 - t) * basis(i).transpose() * wall.slope, t * basis(i + 1).transpose() * wall.slope, offset);
    }
  }
  if (const auto* box = find_ability<HasBox>(domain_); box != nullptr && k == x_.rows()) {
    for (Index i = 0; i < m; ++i) {
      for (Index j = 0; j < k; ++j) {
        const double below = x_(j, i + 1) - box->box_lower()[j], above = box->box_upper()[j] - x_(j, i + 1);
        if (below < radii_[i + 1]) rows.add(i, VectorXd::Unit(k, j), -below / unit_);
        if (above < radii_[i + 1]) rows.add(i, -VectorXd::Unit(k, j), -above / unit_);
      }
    }
  }
  for (Index i = 0; i < m; ++i) {
    for (Index j = 0; j < k; ++j) {
      rows.add(i, VectorXd::Unit(k, j), -radii_[i + 1] / unit_);
      rows.add(i, -VectorXd::Unit(k, j), -radii_[i + 1] / unit_);
    }
  }
  const auto z = least_of_chain(springs, force, rows, VectorXd::Zero(k * m));
  if (!z) return std::nullopt;
  Points step = Points::Zero(x_.rows(), x_.cols());
  for (Index i = 0; i < m; ++i) step.col(i + 1) = unit_ * basis(i + 1) * z->segment(k * i, k);
  return step;
}

Points PulledChain::moved(const Points& step) const {
  CoordinatePath from{x_, {}, false}, to;
  domain_.retract(from, step.middleCols(1, x_.cols() - 2), to);
  return to.u;
}

/// Looks at the moves of x; returns those that are not clear, unless they were no clearer before.
std::vector<Index> PulledChain::look_at(const Points& x, Looks& looks) const {
  std::vector<Index> bad;
  const auto worst = [](const Look& look) {
    double least = 0;
    for (const Wall& wall : look.walls) least = std::min(least, wall.gap);
    return least;
  };
  for (Index i = 0; i + 1 < x.cols(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    look(x, i, looks[at]);
    if (worst(looks[at]) < worst(looks_[at])) bad.push_back(i);
  }
  return bad;
}

bool PulledChain::pull() {
  if (x_.cols() < 3) return false;
  if (looks_.empty()) {
    looks_.resize(static_cast<std::size_t>(x_.cols() - 1));
    for (Index i = 0; i + 1 < x_.cols(); ++i) look(x_, i, looks_[static_cast<std::size_t>(i)]);
    domain_.tangent_bases({x_, {}, false}, bases_);
  }
  const double before = length();
  std::optional<Points> step = between(looks_, false);
  if (!step) {
    radii_ /= 4;
    return false;
  }
  Looks looks = looks_;
  Points next = moved(*step);
  std::vector<Index> bad = look_at(next, looks);
  int ncorr = 0;
  for (int k = 0; k < kCorrections && !bad.empty(); ++k) {
    const std::optional<Points> corrected = between(looks, true);
    if (!corrected) break;
    step = corrected;
    next = moved(*step);
    bad = look_at(next, looks);
    ++ncorr;
  }
  VectorXd held = VectorXd::Zero(x_.cols());
  const size_t nbad = bad.size();
  for (int k = 1; k <= kStepHalvings && !bad.empty(); ++k) {
    VectorXd share = VectorXd::Ones(x_.cols());
    for (const Index i : bad) share[i] = share[i + 1] = k < kStepHalvings ? 0.5 : 0;
    for (Index i = 0; i < x_.cols(); ++i) {
      if (share[i] == 1) continue;
      held[i] = 1;
      step->col(i) *= share[i];
    }
    next = moved(*step);
    bad = look_at(next, looks);
    ncorr += 10;
    if (k == kStepHalvings) --k, ncorr += 100;
  }
  if (std::getenv("VERBOSE_PULL"))
    std::printf("     m %d radii %.2e %.2e step %.2e before %.6f after %.6f clear %d, corrections %d, bad %d held %d\n", (int)x_.cols(),
                radii_.minCoeff() / unit_, radii_.maxCoeff() / unit_, step->colwise().norm().maxCoeff() / unit_, before, length_of(next), (int)bad.size(),
                ncorr, (int)nbad, (int)held.sum());
  if (!(length_of(next) < (1 - kGained) * before)) {
    radii_ /= 4;
    return false;
  }
  for (Index i = 1; i + 1 < x_.cols(); ++i) {
    const double went = step->col(i).cwiseAbs().maxCoeff();
    radii_[i] = std::clamp(held[i] != 0 ? std::max(went, radii_[i] / 4) : 2 * went, kLeastReach * unit_, kFirstReach * unit_);
  }
  x_ = std::move(next);
  looks_ = std::move(looks);
  domain_.tangent_bases({x_, {}, false}, bases_);
  return true;
}

void PulledChain::pull_tight(double least) {
  for (int calm = 0, k = 0; k < kMostPrograms && calm < 2; ++k) {
    if (monitor_.interrupted()) return;
    const double before = length();
    if (!pull()) {
      if (radii_.maxCoeff() < kLeastReach * unit_) return;
      continue;
    }
    calm = before - length() < least * before ? calm + 1 : 0;
  }
}

/// In radians, as seen along the domain.
double PulledChain::turn(const Points& x, Index vertex) const {
  CoordinatePath alone{x.col(vertex), {}, true};
  Points basis;
  domain_.tangent_bases(alone, basis);
  const VectorXd in = x.col(vertex) - x.col(vertex - 1), out = x.col(vertex + 1) - x.col(vertex);
  const VectorXd bend = out / std::sqrt(out.dot(metric_ * out)) - in / std::sqrt(in.dot(metric_ * in));
  const MatrixXd heavy = basis.transpose() * metric_;
  const VectorXd pull = heavy * bend;
  return std::sqrt(std::max(0.0, pull.dot(MatrixXd(heavy * basis).llt().solve(pull))));
}

bool PulledChain::refine(double least) {
  constexpr double kNone = 1e-3;  // of what is worth a vertex: bends that can be done without
  constexpr double kBeside = 1.0 / 3;
  const double length = this->length();
  std::vector<Wall> found;
  const auto keeps_off = [&](const VectorXd& a, const VectorXd& b) {
    walls_.along(a, b, kOffWalls / 2 * unit_, found);
    return found.empty();
  };
  std::vector<VectorXd> kept = {x_.col(0)};
  std::vector<double> worth = {0};
  for (Index i = 1; i + 1 < x_.cols(); ++i) {
    const double in = length_of(kept.back(), VectorXd(x_.col(i))), out = length_of(VectorXd(x_.col(i)), VectorXd(x_.col(i + 1)));
    if (!(in > 0) || !(out > 0)) continue;
    Points three(x_.rows(), 3);
    three << kept.back(), x_.col(i), x_.col(i + 1);
    const double angle = turn(three, 1), saves = angle * angle * std::min(in, out) / 8;
    if (saves < kNone * least * length && keeps_off(kept.back(), x_.col(i + 1))) continue;
    kept.emplace_back(x_.col(i));
    worth.push_back(saves);
  }
  kept.emplace_back(x_.col(x_.cols() - 1));
  worth.push_back(0);
  std::vector<VectorXd> all = {kept.front()};
  bool refined = false;
  const auto place = [&](const VectorXd& a, const VectorXd& b, double t) {
    CoordinatePath alone{(1 - t) * a + t * b, {}, true};
    domain_.project(alone);
    return VectorXd(alone.u);
  };
  const bool flat = domain_.shape() == Shape::flat;
  for (std::size_t i = 1; i < kept.size(); ++i) {
    const bool after_bend = worth[i - 1] > least * length, before_bend = worth[i] > least * length;
    std::vector<VectorXd> way;
    if (after_bend) way.push_back(place(kept[i - 1], kept[i], before_bend ? kBeside : 0.5));
    if (before_bend) way.push_back(place(kept[i - 1], kept[i], after_bend ? 1 - kBeside : 0.5));
    way.push_back(kept[i]);
    bool clear = true;
    if (!flat && way.size() > 1) {
      VectorXd from = kept[i - 1];
      for (const VectorXd& to : way) {
        clear = clear && keeps_off(from, to);
        from = to;
      }
    }
    if (!clear) way = {kept[i]};
    refined = refined || way.size() > 1;
    all.insert(all.end(), way.begin(), way.end());
  }
  Points x(x_.rows(), static_cast<Index>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) x.col(static_cast<Index>(i)) = all[i];
  take(std::move(x));
  return refined;
}

}  // namespace leastcost
