// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/trajectory/trajectory.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include "framework/trajectory/time_optimal.hpp"

namespace leastcost {
namespace {

constexpr double kNegligibleMove = 1e-9;  // of the size of a path: contact
constexpr double kLeastBlend = 1.0 / 64;
constexpr double kMostSamples = 1e6;
constexpr int kChords = 8;  // of a parabola, which leaves them by 1/64 of what it leaves its longest chord by

Eigen::VectorXd for_each(const char* key, const std::optional<Eigen::VectorXd>& given, Index dimension) {
  if (!given) throw OptionError(key, "a trajectory needs limits of both velocity and acceleration");
  if (given->size() != 1 && given->size() != dimension)
    throw OptionError(key,
                      "must have one number, or one for each of the " + std::to_string(dimension) + " coordinates");
  if (!given->allFinite() || given->minCoeff() <= 0) throw OptionError(key, "must be finite and greater than 0");
  return given->size() == 1 ? Eigen::VectorXd::Constant(dimension, (*given)[0]) : *given;
}

/// Without points that repeat the one before them.
Points moving_points(const Points& x) {
  const double negligible = 1e-14 * std::max(1e-300, x.cwiseAbs().maxCoeff());
  Points kept(x.rows(), x.cols());
  Index count = 0;
  for (Index i = 0; i < x.cols(); ++i)
    if (count == 0 || (x.col(i) - kept.col(count - 1)).norm() > negligible) kept.col(count++) = x.col(i);
  return kept.leftCols(count);
}

/// From rest to rest over a distance with these limits.
double alone(double distance, double velocity, double acceleration) {
  return distance * acceleration <= velocity * velocity ? 2 * std::sqrt(distance / acceleration)
                                                        : distance / velocity + velocity / acceleration;
}

/// Ends of the chords of a piece, the first one left out.
Points chords_of(const PathPiece& piece) {
  const int chords = piece.bend.isZero(0) ? 1 : kChords;
  Points x(piece.at.size(), chords);
  for (int k = 1; k <= chords; ++k) x.col(k - 1) = piece.place(piece.from + piece.length() * k / chords);
  return x;
}

Points chords_of(const BlendedPath& path) {
  std::vector<Points> parts;
  Index count = 1;
  for (const PathPiece& piece : path.pieces()) count += parts.emplace_back(chords_of(piece)).cols();
  Points x(path.pieces().front().at.size(), count);
  x.col(0) = path.pieces().front().at;
  Index at = 1;
  for (const Points& part : parts) {
    x.middleCols(at, part.cols()) = part;
    at += part.cols();
  }
  return x;
}

bool is_clear(const ChecksMoves& obstacles, const PathPiece& piece, double tolerance) {
  Eigen::VectorXd from = piece.at;
  for (const auto& to : chords_of(piece).colwise()) {
    if (!(obstacles.clearance(from, to).lower >= -tolerance)) return false;
    from = to;
  }
  return true;
}

/// Corners are rounded as far as the chords of their parabolas stay clear.
Eigen::VectorXd clear_blends(const ChecksMoves& obstacles, const Points& points, double tolerance) {
  Eigen::VectorXd blends = Eigen::VectorXd::Ones(points.cols() - 2);
  for (Index i = 0; i < blends.size(); ++i) {
    const auto rounded = [&] { return BlendedPath(points.middleCols(i, 3), blends.segment(i, 1)); };
    while (blends[i] > kLeastBlend && !is_clear(obstacles, rounded().corner(0), tolerance)) blends[i] /= 2;
  }
  return blends;
}

/// How far a parabola is from its chords, at most.
double off_chords(const BlendedPath& path) {
  double farthest = 0;
  for (const PathPiece& piece : path.pieces()) {
    const double chord = piece.length() / kChords;
    farthest = std::max(farthest, piece.bend.norm() * chord * chord / 8);
  }
  return farthest;
}

void sample(const BlendedPath& path, const SpeedProfile& profile, double interval, Trajectory& out) {
  const double duration = profile.duration();
  if (!(duration / interval <= kMostSamples))
    throw OptionError("interval", "would make more than a million samples: give a longer interval");
  const Index moves = std::max<Index>(1, static_cast<Index>(std::ceil(duration / interval - kNegligibleMove)));
  const Index d = path.pieces().front().at.size();
  out.time.resize(moves + 1);
  out.x.resize(d, moves + 1);
  out.velocity = out.acceleration = out.x;
  Index i = 0;  // the interval between two stations
  for (Index k = 0; k <= moves; ++k) {
    const double t = k < moves ? static_cast<double>(k) * interval : duration;
    while (i + 2 < profile.time.size() && profile.time[i + 1] <= t) ++i;
    const PathPiece& piece = path.pieces()[static_cast<std::size_t>(profile.piece[static_cast<std::size_t>(i)])];
    const double u = (profile.square[i + 1] - profile.square[i]) / (2 * (profile.s[i + 1] - profile.s[i]));
    const double since = t - profile.time[i], rate = std::sqrt(profile.square[i]);
    const double s = std::min(profile.s[i] + since * (rate + since / 2 * u), profile.s[i + 1]);
    const double fast = k == moves ? 0 : std::max(0.0, rate + since * u);
    out.time[k] = t;
    out.x.col(k) = piece.place(s);
    out.velocity.col(k) = fast * piece.direction(s);
    out.acceleration.col(k) = u * piece.direction(s) + fast * fast * piece.bend;
  }
}

}  // namespace

void TrajectoryOptions::fields(FieldVisitor& visit) {
  visit.field(
      "velocity", velocity,
      {.help = "Largest velocity: a number for all coordinates, or a list with one for each; default: that of the "
               "robot's file.",
       .unit = "coordinates/s",
       .minimum = 0,
       .exclusive_minimum = true});
  visit.field("acceleration", acceleration,
              {.help = "Largest acceleration: a number for all coordinates, or a list with one for each.",
               .unit = "coordinates/s^2",
               .minimum = 0,
               .exclusive_minimum = true});
  visit.field("interval", interval,
              {.help = "Time between two samples.", .unit = "s", .minimum = 0, .exclusive_minimum = true});
}

void check_trajectory(const Problem& problem, const TrajectoryOptions& options) {
  const ConstraintManifold& domain = *problem.manifold;
  const Dimensions d = domain.dimensions();  // the free part of a flat domain has a boundary that is not
  const bool flat = domain.shape() == Shape::flat || (find_ability<ChecksMoves>(domain) != nullptr &&
                                                      d.coordinate == d.ambient && d.tangent == d.ambient);
  if (!flat || find_ability<HasChart>(domain) != nullptr)
    throw InputError("a trajectory needs a flat domain (euclidean coordinates, or the joints of a robot)");
  if (problem.ring) throw InputError("a trajectory starts and ends at rest: a ring has no ends");
  for_each("velocity", options.velocity, domain.dimensions().ambient);
  for_each("acceleration", options.acceleration, domain.dimensions().ambient);
  if (!(options.interval > 0)) throw OptionError("interval", "must be greater than 0");
}

Trajectory make_trajectory(const Problem& problem, const Result& result, const TrajectoryOptions& options) {
  check_trajectory(problem, options);
  const ConstraintManifold& domain = *problem.manifold;
  if (result.curve.x.cols() < 2) throw InputError("there is no path to follow");
  const Points points = moving_points(result.curve.x);
  if (points.cols() < 2) throw InputError("the path has no length: there is nothing to follow");
  const Eigen::VectorXd velocity = for_each("velocity", options.velocity, points.rows());
  const Eigen::VectorXd acceleration = for_each("acceleration", options.acceleration, points.rows());

  Trajectory out;
  const auto* obstacles = find_ability<ChecksMoves>(domain);
  const double contact = contact_tolerance(points, kNegligibleMove);
  const BlendedPath path(points, obstacles != nullptr ? clear_blends(*obstacles, points, contact)
                                                      : Eigen::VectorXd::Ones(points.cols() - 2));
  out.deviation = path.deviation();
  out.clearance = measure_clearance(domain, chords_of(path), false, {});
  if (out.clearance) out.touches = !(out.clearance->lower >= -contact);
  out.checked_within = off_chords(path);
  const SpeedProfile profile = time_optimal(path, velocity, acceleration);
  out.duration = profile.duration();
  const Eigen::VectorXd way = (points.rightCols(1) - points.leftCols(1)).cwiseAbs();
  for (Index j = 0; j < way.size(); ++j)
    out.least_duration = std::max(out.least_duration, alone(way[j], velocity[j], acceleration[j]));
  sample(path, profile, options.interval, out);
  return out;
}

}  // namespace leastcost
