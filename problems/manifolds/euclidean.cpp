// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/euclidean.hpp>

#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_derivatives.hpp>

namespace leastcost {
namespace {

int checked(int dimension) {
  if (dimension < 1 || dimension > kMaxDimension)
    throw OptionError("dimension", "must be between 1 and " + std::to_string(kMaxDimension));
  return dimension;
}

/// A side with another number of coordinates says which dimension is meant.
const BoxOptions& checked(const BoxOptions& box, int dimension) {
  for (const auto& [key, side] : {std::pair{"lower", &box.lower}, std::pair{"upper", &box.upper}}) {
    const Index given = *side ? (*side)->size() : dimension;
    if (given == dimension) continue;
    std::string message = std::to_string(given) + " numbers, but the space has dimension " + std::to_string(dimension);
    if (given >= 1 && given <= kMaxDimension) message += "; write `dimension: " + std::to_string(given) + "` for it";
    throw OptionError(key, message);
  }
  return box;
}

}  // namespace

EuclideanManifoldOptions EuclideanManifoldOptions::of(BoxOptions box) {
  EuclideanManifoldOptions options;
  if (const auto& side = box.lower ? box.lower : box.upper) options.dimension = static_cast<int>(side->size());
  options.box = std::move(box);
  return options;
}

void EuclideanManifoldOptions::fields(FieldVisitor& visit) {
  visit.field("dimension", dimension,
              {.help = "Dimension d of R^d; not needed if lower or upper is given as a list.",
               .minimum = 1,
               .maximum = kMaxDimension});
  box.fields(visit);
}

EuclideanManifold::EuclideanManifold(const EuclideanManifoldOptions& options)
    : dimension_(checked(options.dimension)), box_(dimension_, checked(options.box, dimension_)) {}

Projection EuclideanManifold::project(CoordinatePath& path) const {
  Projection result;
  if (!box_.bounded()) return result;
  const Points before = path.u;
  box_.clamp(path.u);
  result.moved = (path.u - before).colwise().norm().maxCoeff();
  return result;
}

void EuclideanManifold::tangent_bases(const CoordinatePath& path, Points& bases) const {
  bases = Points::Identity(dimension_, dimension_).replicate(1, path.u.cols());
}

void EuclideanManifold::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  prepare_like(from, to);
  auto moved = to.u.middleCols(from.free_begin(), from.free_count());
  moved = from.u.middleCols(from.free_begin(), from.free_count()) + step;
  box_.clamp(moved);
}

double EuclideanManifold::residual(const CoordinatePath& path) const {
  CoordinatePath inside = path;
  return project(inside).moved;
}

int EuclideanManifold::active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const {
  return box_.bounded() ? box_.active(path.u.col(column), normals) : 0;
}

void EuclideanManifold::draw(const DrawnPaths&, Drawing& out) const {
  if (box_.lower().array().isInf().all() && box_.upper().array().isInf().all()) return;
  out.lower = box_.lower();
  out.upper = box_.upper();
}

}  // namespace leastcost
