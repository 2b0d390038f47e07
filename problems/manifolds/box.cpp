// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/box.hpp>

#include <limits>
#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void check_side(const std::optional<Eigen::VectorXd>& side, const char* key, int dimension) {
  if (!side) return;
  if (side->size() != dimension)
    throw OptionError(
        key, std::to_string(side->size()) + " numbers, but the space has dimension " + std::to_string(dimension));
  if (side->array().isNaN().any()) throw OptionError(key, "numbers must not be NaN");
}

}  // namespace

void BoxOptions::fields(FieldVisitor& visit) {
  visit.field("lower", lower,
              {.help = "Lower corner of a box, one number per coordinate; default: unbounded.", .unit = "length"});
  visit.field("upper", upper,
              {.help = "Upper corner of a box, one number per coordinate; default: unbounded.", .unit = "length"});
}

Box::Box(int dimension)
    : lower_(Eigen::VectorXd::Constant(dimension, -kInfinity)),
      upper_(Eigen::VectorXd::Constant(dimension, kInfinity)) {}

Box::Box(int dimension, const BoxOptions& options) : Box(dimension) {
  check_side(options.lower, "lower", dimension);
  check_side(options.upper, "upper", dimension);
  bounded_ = options.given();
  if (options.lower) lower_ = *options.lower;
  if (options.upper) upper_ = *options.upper;
  for (int i = 0; i < dimension; ++i)
    if (!(lower_[i] < upper_[i]))
      throw OptionError("lower", "the box is empty in coordinate " + std::to_string(i) + ": lower must be below upper");
}

int Box::active(const Eigen::VectorXd& x, Eigen::Ref<Eigen::MatrixXd> normals) const {
  int count = 0;
  if (!bounded_) return count;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const int side = x[i] >= upper_[i] ? 1 : x[i] <= lower_[i] ? -1 : 0;
    if (side == 0) continue;
    normals.col(count).setZero();
    normals(i, count++) = side;
  }
  return count;
}

}  // namespace leastcost
