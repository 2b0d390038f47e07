// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/manifolds/euclidean.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "framework/errors.hpp"
#include "framework/segment_derivatives.hpp"

namespace leastcost {
namespace {

void check_side(const Eigen::VectorXd& side, const char* key, int dimension) {
  if (side.size() != 0 && side.size() != dimension)
    throw OptionError(key,
                      std::to_string(side.size()) + " numbers, the space has dimension " + std::to_string(dimension));
  if (side.array().isNaN().any()) throw OptionError(key, "numbers must not be NaN");
}

}  // namespace

void EuclideanManifoldOptions::fields(FieldVisitor& visit) {
  visit.field("dimension", dimension, {.help = "Dimension d of R^d.", .minimum = 1, .maximum = kMaxDimension});
  visit.field("lower", lower,
              {.help = "Lower corner of a box, one number per coordinate; default: unbounded.", .unit = "length"});
  visit.field("upper", upper,
              {.help = "Upper corner of a box, one number per coordinate; default: unbounded.", .unit = "length"});
}

EuclideanManifold::EuclideanManifold(const EuclideanManifoldOptions& options) : dimension_(options.dimension) {
  if (dimension_ < 1 || dimension_ > kMaxDimension)
    throw OptionError("dimension", "must be between 1 and " + std::to_string(kMaxDimension));
  check_side(options.lower, "lower", dimension_);
  check_side(options.upper, "upper", dimension_);
  bounded_ = options.lower.size() + options.upper.size() > 0;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  lower_ = options.lower.size() ? options.lower : Eigen::VectorXd::Constant(dimension_, -kInfinity);
  upper_ = options.upper.size() ? options.upper : Eigen::VectorXd::Constant(dimension_, kInfinity);
  for (int i = 0; i < dimension_; ++i)
    if (!(lower_[i] < upper_[i]))
      throw OptionError("lower", "the box is empty in coordinate " + std::to_string(i) + ": lower must be below upper");
}

Projection EuclideanManifold::project(CoordinatePath& path) const {
  Projection result;
  if (!bounded_) return result;
  for (auto x : path.u.colwise()) {
    const Eigen::VectorXd inside = x.cwiseMax(lower_).cwiseMin(upper_);
    result.moved = std::max(result.moved, (inside - x).norm());
    x = inside;
  }
  return result;
}

void EuclideanManifold::tangent_bases(const CoordinatePath& path, Points& bases) const {
  bases = Points::Identity(dimension_, dimension_).replicate(1, path.u.cols());
}

void EuclideanManifold::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  prepare_like(from, to);
  auto moved = to.u.middleCols(from.free_begin(), from.free_count());
  moved = from.u.middleCols(from.free_begin(), from.free_count()) + step;
  if (!bounded_) return;
  for (auto x : moved.colwise()) x = x.cwiseMax(lower_).cwiseMin(upper_);
}

double EuclideanManifold::residual(const CoordinatePath& path) const {
  CoordinatePath inside = path;
  return project(inside).moved;
}

int EuclideanManifold::active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const {
  int count = 0;
  if (!bounded_) return count;
  for (int i = 0; i < dimension_; ++i) {
    const double x = path.u(i, column);
    const int side = x >= upper_[i] ? 1 : x <= lower_[i] ? -1 : 0;
    if (side == 0) continue;
    normals.col(count).setZero();
    normals(i, count++) = side;
  }
  return count;
}

}  // namespace leastcost
