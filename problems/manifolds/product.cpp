// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/product.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_derivatives.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include "problems/formula/coordinate_names.hpp"

namespace leastcost {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// Why a domain can be no factor; empty: it can.
std::string why_no_factor(const ConstraintManifold* domain) {
  if (domain == nullptr) return "is missing";
  if (find_ability<HasChart>(*domain) != nullptr)
    return "is a chart, and its coordinates are not positions in a space; give the surface by an equation";
  if (domain->shape() == Shape::polyhedral || find_ability<HasPieces>(*domain) != nullptr)
    return "is made of flat pieces (a mesh, a map), and a point of a product does not determine its piece";
  if (find_ability<HasCoarserVersion>(*domain) != nullptr || find_ability<HasUnresolvedPlaces>(*domain) != nullptr)
    return "is made from data, and a product cannot estimate its effect on the cost";
  if (find_ability<ChecksMoves>(*domain) != nullptr)
    return "has obstacles: give the product without them, and add them to the product";
  const Dimensions d = domain->dimensions();
  if (d.coordinate < 1 || d.coordinate != d.ambient) return "has coordinates other than those of its space";
  return "";
}

/// The sides of a factor's box; infinite where it has none.
std::pair<Eigen::VectorXd, Eigen::VectorXd> box_of_factor(const ConstraintManifold& domain) {
  if (const auto* box = find_ability<HasBox>(domain)) return {box->box_lower(), box->box_upper()};
  const Index size = domain.dimensions().coordinate;
  return {Eigen::VectorXd::Constant(size, -kNoBound), Eigen::VectorXd::Constant(size, kNoBound)};
}

/// The bounds of a factor, where there are some: a box without sides bounds nothing.
const HasBounds* bounds_of_factor(const ConstraintManifold& domain) {
  const auto* bounds = find_ability<HasBounds>(domain);
  const auto* box = find_ability<HasBox>(domain);
  const bool open = domain.shape() == Shape::flat && box != nullptr && box->box_lower().array().isInf().all() &&
                    box->box_upper().array().isInf().all();
  return open ? nullptr : bounds;
}

void check_names(const std::vector<std::string>& names, int count) {
  if (static_cast<int>(names.size()) != count)
    throw InputError("the product has " + std::to_string(count) + " coordinates, but " + std::to_string(names.size()) +
                     " names were given");
  for (const std::string& name : names)
    if (name.empty() || std::count(names.begin(), names.end(), name) > 1)
      throw InputError("the coordinates of a product need different names, but '" + name + "' appears twice");
}

/// What a point may also be called, and how far that is from a reference.
struct NamedPoint {
  PointImage image;
  double squared_distance = 0;
  bool itself = true;  ///< no factor has another name
};

/// Names of a point in the first factors, joined with those in one more: the `most` nearest.
std::vector<NamedPoint> joined(const std::vector<NamedPoint>& before, const std::vector<NamedPoint>& more,
                               std::size_t most) {
  std::vector<NamedPoint> all;
  for (const NamedPoint& a : before)
    for (const NamedPoint& b : more) {
      NamedPoint both = a;
      both.image.u.conservativeResize(a.image.u.size() + b.image.u.size());
      both.image.u.tail(b.image.u.size()) = b.image.u;
      if (!b.image.where.empty()) both.image.where += (a.image.where.empty() ? "" : ", ") + b.image.where;
      both.squared_distance += b.squared_distance;
      both.itself = a.itself && b.itself;
      all.push_back(std::move(both));
    }
  std::stable_sort(all.begin(), all.end(),
                   [](const NamedPoint& a, const NamedPoint& b) { return a.squared_distance < b.squared_distance; });
  if (all.size() > most) all.resize(most);
  return all;
}

}  // namespace

ProductManifold::ProductManifold(Factors factors, std::vector<std::string> names)
    : factors_(std::move(factors)), names_(std::move(names)) {
  if (factors_.empty()) throw InputError("a product needs at least one factor");
  for (std::size_t i = 0; i < factors_.size(); ++i) {
    const std::string why = why_no_factor(factors_[i].get());
    if (!why.empty()) throw InputError("factor " + std::to_string(i + 1) + " of the product " + why);
    const ConstraintManifold& domain = *factors_[i];
    const Dimensions d = domain.dimensions();
    const HasBounds* bounds = bounds_of_factor(domain);
    const bool flat = domain.shape() == Shape::flat;
    parts_.push_back({&domain, dimensions_.coordinate, d.coordinate, d.tangent, bounds, flat && bounds == nullptr});
    dimensions_.coordinate += d.coordinate;
    dimensions_.tangent += d.tangent;
    if (!flat) shape_ = Shape::smooth;
  }
  dimensions_.ambient = dimensions_.coordinate;
  if (dimensions_.coordinate > kMaxDimension)
    throw InputError("the product has " + std::to_string(dimensions_.coordinate) + " coordinates; the limit is " +
                     std::to_string(kMaxDimension));
  if (names_.empty()) names_ = leastcost::coordinate_names(dimensions_.coordinate);
  check_names(names_, dimensions_.coordinate);
  lower_.resize(dimensions_.coordinate);
  upper_.resize(dimensions_.coordinate);
  for (const Part& part : parts_) {
    const auto [lower, upper] = box_of_factor(*part.domain);
    lower_.segment(part.first, part.size) = lower;
    upper_.segment(part.first, part.size) = upper;
  }
}

/// The coordinates of a path in one factor.
CoordinatePath ProductManifold::of(const Part& part, const CoordinatePath& path) {
  return {path.u.middleRows(part.first, part.size), {}, path.ring};
}

Projection ProductManifold::project(CoordinatePath& path) const {
  const Points before = path.u;
  Projection result;
  for (const Part& part : parts_) {
    if (part.adds) continue;
    CoordinatePath own = of(part, path);
    const Projection projection = part.domain->project(own);
    path.u.middleRows(part.first, part.size) = own.u;
    result.failed.insert(result.failed.end(), projection.failed.begin(), projection.failed.end());
  }
  std::sort(result.failed.begin(), result.failed.end());
  result.failed.erase(std::unique(result.failed.begin(), result.failed.end()), result.failed.end());
  for (const Index column : result.failed) path.u.col(column) = before.col(column);
  if (path.u.cols() > 0) result.moved = (path.u - before).colwise().norm().maxCoeff();
  return result;
}

void ProductManifold::tangent_bases(const CoordinatePath& path, Points& bases) const {
  const Index width = dimensions_.tangent;
  bases.setZero(path.u.rows(), width * path.u.cols());
  Points own;
  Index first = 0;  // of the part's columns in a basis
  for (const Part& part : parts_) {
    part.domain->tangent_bases(of(part, path), own);
    for (Index i = 0; i < path.u.cols(); ++i)
      bases.block(part.first, width * i + first, part.size, part.tangent) =
          own.middleCols(part.tangent * i, part.tangent);
    first += part.tangent;
  }
}

/// Moves factor by factor; move_part(part, from, step, to) where a step is more than an addition.
template <class Move>
void ProductManifold::move(const CoordinatePath& from, const Points& step, CoordinatePath& to, Move move_part) const {
  prepare_like(from, to);
  const Index first = from.free_begin(), count = from.free_count();
  CoordinatePath moved;
  for (const Part& part : parts_) {
    auto rows = to.u.middleRows(part.first, part.size);
    if (part.adds) {
      rows.middleCols(first, count) =
          from.u.block(part.first, first, part.size, count) + step.middleRows(part.first, part.size);
    } else {
      move_part(part, of(part, from), step.middleRows(part.first, part.size), moved);
      rows = moved.u;
    }
  }
}

void ProductManifold::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  move(from, step, to, [](const Part& part, const CoordinatePath& own, const Points& own_step, CoordinatePath& moved) {
    part.domain->retract(own, own_step, moved);
  });
}

void ProductManifold::retract_beyond(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  move(from, step, to, [](const Part& part, const CoordinatePath& own, const Points& own_step, CoordinatePath& moved) {
    if (const auto* beyond = find_ability<GoesBeyondBounds>(*part.domain))
      return beyond->retract_beyond(own, own_step, moved);
    if (part.domain->shape() != Shape::flat) return part.domain->retract(own, own_step, moved);
    prepare_like(own, moved);  // a step along a bound stays on it
    moved.u.middleCols(own.free_begin(), own.free_count()) =
        own.u.middleCols(own.free_begin(), own.free_count()) + own_step;
  });
}

double ProductManifold::residual(const CoordinatePath& path) const {
  double worst = 0;
  int off = 0;  // factors that the path is off
  for (const Part& part : parts_) {
    if (part.adds) continue;
    const double own = part.domain->residual(of(part, path));
    if (std::isnan(own)) return own;
    if (own > 0) ++off;
    worst = std::max(worst, own);
  }
  if (off < 2) return worst;
  for (Index i = 0; i < path.u.cols(); ++i) {  // the worst of one column in all of them
    double squared = 0;
    for (const Part& part : parts_) {
      if (part.adds) continue;
      const CoordinatePath point{path.u.block(part.first, i, part.size, 1), {}, true};
      squared += std::pow(part.domain->residual(point), 2);
    }
    worst = std::max(worst, std::sqrt(squared));
  }
  return worst;
}

int ProductManifold::active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const {
  int count = 0;
  for (const Part& part : parts_) {
    if (part.bounds == nullptr) continue;
    const CoordinatePath point{path.u.block(part.first, column, part.size, 1), {}, true};
    Points own(part.size, part.size);
    const int active = part.bounds->active_bounds(point, 0, own);
    for (int k = 0; k < active; ++k, ++count) {
      normals.col(count).setZero();
      normals.col(count).segment(part.first, part.size) = own.col(k);
    }
  }
  return count;
}

std::vector<PointImage> ProductManifold::images(const Eigen::VectorXd& x, const Eigen::VectorXd& reference,
                                                std::size_t most) const {
  std::vector<NamedPoint> all(1);
  for (const Part& part : parts_) {
    const Eigen::VectorXd own = x.segment(part.first, part.size), near = reference.segment(part.first, part.size);
    std::vector<NamedPoint> names = {{{own, ""}, (own - near).squaredNorm(), true}};
    if (const auto* domain = find_ability<HasImages>(*part.domain))
      for (PointImage& image : domain->images(own, near, most)) {
        const double squared = (image.u - near).squaredNorm();
        names.push_back({std::move(image), squared, false});
      }
    all = joined(all, names, most + 1);  // x itself may be among them
  }
  std::vector<PointImage> images;
  for (NamedPoint& point : all)
    if (!point.itself && images.size() < most) images.push_back(std::move(point.image));
  return images;
}

bool ProductManifold::states_way(const Eigen::VectorXd& target, const Eigen::VectorXd& source) const {
  return std::any_of(parts_.begin(), parts_.end(), [&](const Part& part) {
    const auto* domain = find_ability<HasImages>(*part.domain);
    return domain != nullptr &&
           domain->states_way(target.segment(part.first, part.size), source.segment(part.first, part.size));
  });
}

std::vector<CoordinateBlock> ProductManifold::blocks() const {
  std::vector<CoordinateBlock> all;
  for (const Part& part : parts_) {
    const auto* domain = find_ability<HasBlocks>(*part.domain);
    const std::vector<CoordinateBlock> own =
        domain != nullptr ? domain->blocks() : std::vector<CoordinateBlock>{{0, part.size}};
    for (const CoordinateBlock& block : own) all.push_back({part.first + block.first, block.size, block.unit});
  }
  return all;
}

SampleBox ProductManifold::sample_box(const Eigen::VectorXd& source, const Eigen::VectorXd& target) const {
  SampleBox all{lower_, upper_};
  for (const Part& part : parts_) {
    const auto* domain = find_ability<HasSampleBox>(*part.domain);
    if (domain == nullptr) continue;
    const SampleBox own =
        domain->sample_box(source.segment(part.first, part.size), target.segment(part.first, part.size));
    all.lower.segment(part.first, part.size) = own.lower;
    all.upper.segment(part.first, part.size) = own.upper;
  }
  return all;
}

std::string ProductManifold::why_not_projected(const Eigen::VectorXd& x) const {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    const Eigen::VectorXd own = x.segment(part.first, part.size);
    CoordinatePath point{own, {}, true};
    if (part.domain->project(point).failed.empty()) continue;
    return "factor " + std::to_string(i + 1) + " of the product has none" + reason_for_failure(*part.domain, own);
  }
  return "every factor has one";
}

}  // namespace leastcost
