// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/newton/bounded_step.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "framework/domain/in_parts.hpp"
#include "framework/newton/chain_program.hpp"

namespace leastcost {
namespace {

constexpr Index kLooksAtOnce = 16;    ///< between two looks at the clock
constexpr double kPassed = 0.01;      ///< of a point's move: so far beyond a bound it is worth a program
constexpr double kHeeded = 2;         ///< of the largest move: bounds farther away than that stay out of the program
constexpr double kBeside = 0.1;       ///< of the largest move: bounds so near to the end of a step enter it at once
constexpr double kOver = 1e-9;        ///< of the largest move: a bound that is passed over by less is not
constexpr int kMostRounds = 20;       ///< in which bounds enter the program
constexpr Index kManyBounds = 16;     ///< of a point, within reach of the model's own step
constexpr double kFirstStep = 8;      ///< segments: how far a first step goes among so many
constexpr double kFarthestStep = 16;  ///< mean segments: how far a step goes once one has been shortened
constexpr double kEndsOn = 1e-7;      ///< of the largest move: nearer to a bound than that a step ends on it
constexpr double kFewer = 16;         ///< less is added to a Hessian that shortened too much

double longest_segment(const CoordinatePath& open) {
  return (open.u.rightCols(open.u.cols() - 1) - open.u.leftCols(open.u.cols() - 1)).colwise().norm().maxCoeff();
}

double mean_segment(const CoordinatePath& open) {
  return (open.u.rightCols(open.u.cols() - 1) - open.u.leftCols(open.u.cols() - 1)).colwise().norm().mean();
}

}  // namespace

BoundedStep::BoundedStep(PathEnergy& energy)
    : energy_(energy), bounds_(find_ability<SeesBounds>(*energy.problem().manifold)) {}

/// Of a first step, which no radius keeps short: by some of the points, for a look at all of them is what it is to
/// spare.
bool BoundedStep::reaches_many_bounds(const CoordinatePath& path, const Points& moves) const {
  constexpr Index kEvery = 8;
  Index looked = 0, found = 0;
  std::vector<NearBound> near;
  for (Index i = 0; i < moves.cols(); i += kEvery, ++looked) {
    bounds_->bounds_within(path, path.free_begin() + i, moves.col(i).norm(), near);
    found += static_cast<Index>(near.size());
  }
  return found > kManyBounds * looked;
}

/// Looks beside each point as far as it or a neighbour moves.
bool BoundedStep::passes_bounds(const CoordinatePath& path, const Points& moves) {
  const Index n = moves.cols();
  const Eigen::VectorXd far = moves.colwise().norm();
  near_.resize(static_cast<std::size_t>(n));
  bool passes = false;
  for (Index i = 0; i < n; ++i) {
    if (i % kLooksAtOnce == 0) look_at_clock(energy_.deadline());
    const double reach = std::max({far[std::max<Index>(0, i - 1)], far[i], far[std::min(n - 1, i + 1)]});
    std::vector<NearBound>& near = near_[static_cast<std::size_t>(i)];
    bounds_->bounds_within(path, path.free_begin() + i, reach, near);
    for (const NearBound& bound : near) {
      const double change = bound.slope.dot(moves.col(i));
      passes = passes || (change < -kPassed * far[i] && bound.gap + change < -kPassed * far[i]);
    }
  }
  return passes;
}

/// In frames in which all directions are free: what is blocked in the model is a bound like others here.
bool BoundedStep::find_hessian(const CoordinatePath& path, const ChainModel& model) {
  frames_ = model.frames;
  frames_.identity = false;
  std::fill(frames_.blocked.begin(), frames_.blocked.end(), 0);
  if (frames_.bases.cols() == 0) {
    tangent_bases(*energy_.problem().manifold, path, frames_.bases, energy_.deadline());
    const Index k = frames_.bases.cols() / path.u.cols();
    frames_.bases = frames_.bases.middleCols(k * path.free_begin(), k * path.free_count()).eval();
  }
  for (const HessianKind kind : {HessianKind::exact, HessianKind::gauss_newton}) {
    energy_.chain_hessian(path, model.gradient, frames_, kind, hessian_);
    scaled_ = hessian_;
    if (energy_.factor(scaled_)) return true;
  }
  return false;
}

/// Adds to the Hessian until the step is as long as the radius, within a factor of two: by bisection of the exponent.
bool BoundedStep::shorten(const Eigen::VectorXd& gradient) {
  constexpr int kMostFactors = 40;
  ChainSystem identity;
  identity.resize(hessian_.block(), hessian_.count(), false);
  identity.set_zero();
  double steepest = 0;
  for (Index i = 0; i < hessian_.count(); ++i) {
    identity.diagonal(i).setIdentity();
    steepest = std::max(steepest, gradient.segment(hessian_.block() * i, hessian_.block()).norm());
  }
  double most = steepest / radius_, least = 0, added = most;  // with `most` alone no point moves farther
  Eigen::VectorXd step;
  for (int k = 0; k < kMostFactors; ++k) {
    scaled_ = hessian_;
    scaled_.add(added, identity);
    if (!energy_.factor(scaled_)) return false;
    step = -gradient;
    scaled_.solve(step);
    energy_.from_tangent(frames_, step, moves_);
    const double length = moves_.colwise().norm().maxCoeff();
    if (!(length > radius_ / 2)) {
      most = added;
    } else if (length > radius_) {
      least = added;
    } else {
      hessian_.add(added, identity);
      return true;
    }
    added = least > 0 ? std::sqrt(least * most) : most / kFewer;
  }
  return false;
}

/// Lengths are in units of the largest move, energies in those of the model's decrease.
bool BoundedStep::solve(const CoordinatePath& path, const ChainModel& model) {
  if (bounds_ == nullptr || path.ring) return false;
  if (!std::isfinite(radius_) && reaches_many_bounds(path, model.moves)) radius_ = kFirstStep * longest_segment(path);
  // Small steps, one after another, double it all the same; then a Hessian that just factors asks for an enormous one.
  if (std::isfinite(radius_)) radius_ = std::min(radius_, kFarthestStep * mean_segment(path));
  moves_ = model.moves;
  double gain = model.decrement;
  Eigen::VectorXd gradient;
  const bool is_long = moves_.colwise().norm().maxCoeff() > radius_;
  if (is_long) {
    if (!find_hessian(path, model)) return false;
    energy_.to_tangent(frames_, model.gradient, gradient);
    if (!shorten(gradient)) return false;
    gain = -model.gradient.cwiseProduct(moves_).sum();
  }
  const double length = moves_.colwise().norm().maxCoeff();
  if (!(length > 0) || !(gain > 0)) return false;
  if (!passes_bounds(path, moves_)) {
    slope_ = -gain;
    ends_on_.assign(near_.size(), {});
    return is_long;
  }
  if (!is_long) {
    if (!find_hessian(path, model)) return false;
    energy_.to_tangent(frames_, model.gradient, gradient);
  }
  scaled_.set_zero();
  scaled_.add(length * length / gain, hessian_);
  const std::optional<Eigen::VectorXd> z = least_within_bounds(length, -length / gain * gradient);
  if (!z) return false;
  energy_.from_tangent(frames_, length * *z, moves_);
  slope_ = length * gradient.dot(*z);
  end_on_bounds(length);
  return slope_ < 0;
}

/// Few of the bounds within reach hold a point. The program begins with those that the model's own step comes to, and
/// takes up others as its solutions pass over them: the last solution is that with all of them.
std::optional<Eigen::VectorXd> BoundedStep::least_within_bounds(double length, const Eigen::VectorXd& force) {
  const int k = hessian_.block();
  const Index n = hessian_.count();
  std::vector<NearBound> waiting;
  std::vector<Index> points;
  for (Index i = 0; i < n; ++i)
    for (const NearBound& bound : near_[static_cast<std::size_t>(i)]) {
      if (!(bound.gap <= kHeeded * bound.slope.norm() * length)) continue;
      waiting.push_back(bound);
      points.push_back(i);
    }
  ChainHalfSpaces rows(k);
  Points moves = moves_;
  double beside = kBeside;
  std::optional<Eigen::VectorXd> z;
  for (int round = 0; round < kMostRounds; ++round) {
    std::size_t left = 0;
    for (std::size_t j = 0; j < waiting.size(); ++j) {
      const NearBound& bound = waiting[j];
      const double gap = std::max(0.0, bound.gap);
      if (gap + bound.slope.dot(moves.col(points[j])) < beside * length * bound.slope.norm()) {
        rows.add(points[j], frames_.bases.middleCols(k * points[j], k).transpose() * bound.slope, -gap / length);
        continue;
      }
      if (left < j) waiting[left] = std::move(waiting[j]);
      points[left++] = points[j];
    }
    if (left == waiting.size() && round > 0) return z;
    waiting.resize(left);
    points.resize(left);
    z = least_of_chain(scaled_, force, rows, Eigen::VectorXd::Zero(k * n), energy_.deadline());
    energy_.count({.linear_solves = 1});
    if (!z) return std::nullopt;
    energy_.from_tangent(frames_, length * *z, moves);
    beside = -kOver;
  }
  return z;
}

double BoundedStep::part_within(const Points& moves) const {
  const double length = moves.colwise().norm().maxCoeff();
  return length > radius_ ? radius_ / length : 1;
}

void BoundedStep::took(double length, bool all) {
  constexpr double kFarther = 2;
  radius_ = all ? kFarther * radius_ : length;
}

/// A program ends a hair before its bounds. Where the retraction itself stops points at a bound, a hair too far ends on
/// it.
void BoundedStep::end_on_bounds(double length) {
  ends_on_.assign(near_.size(), {});
  for (std::size_t i = 0; i < near_.size(); ++i) {
    auto move = moves_.col(static_cast<Index>(i));
    for (const NearBound& bound : near_[i]) {
      if (!(bound.gap + bound.slope.dot(move) <= kEndsOn * length)) continue;
      if (bound.number == NearBound::kNone)
        move -= 2 * kEndsOn * length * bound.slope;
      else
        ends_on_[i].push_back(bound.number);
    }
  }
}

void BoundedStep::retract(const CoordinatePath& from, CoordinatePath& to) const {
  energy_.count({.projections = 1});
  retract_onto(*bounds_, from, moves_, ends_on_, to, energy_.deadline());
}

}  // namespace leastcost
