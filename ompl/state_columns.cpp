// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/ompl/state_columns.hpp>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <ompl/base/spaces/WrapperStateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include "ompl/pose_domain.hpp"

namespace leastcost {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr Index kQuaternion = 4;  ///< numbers
constexpr double kLeastQuaternion = 1e-6;

}  // namespace

StateColumns::StateColumns(std::shared_ptr<const ob::StateSpace> space, double turn)
    : space_(std::move(space)), turn_(turn) {
  if (!(turn > 0) || !std::isfinite(turn)) throw InputError("the weight of rotation must be a number greater than 0");
  if (!space_) throw InputError("there is no state space");
  const ob::StateSpace* inner = space_.get();
  while (const auto* wrapper = dynamic_cast<const ob::WrapperStateSpace*>(inner)) {
    constrained_ = true;
    inner = wrapper->getSpace().get();
  }
  add(*inner, 1, {});
}

void StateColumns::add(const ob::StateSpace& space, double weight, const std::vector<unsigned>& within) {
  Part part{Kind::reals, rows_, 1, weight, within, &space};
  if (space.isCompound()) {
    const auto& compound = *space.as<ob::CompoundStateSpace>();
    for (unsigned i = 0; i < compound.getSubspaceCount(); ++i) {
      std::vector<unsigned> deeper = within;
      deeper.push_back(i);
      add(*compound.getSubspace(i), weight * compound.getSubspaceWeight(i), deeper);
    }
    return;
  }
  switch (space.getType()) {
    case ob::STATE_SPACE_REAL_VECTOR: part.count = static_cast<Index>(space.getDimension()); break;
    case ob::STATE_SPACE_SO2: part.kind = Kind::angle; break;
    case ob::STATE_SPACE_SO3:
      part.kind = Kind::quaternion;
      part.count = kQuaternion;
      break;
    default:
      throw InputError("the space " + space.getName() +
                       " is not R^n, SO(2), SO(3) or a compound of them: leastcost has no coordinates for it");
  }
  rows_ += part.count;
  parts_.push_back(std::move(part));
}

std::vector<Index> StateColumns::quaternions() const {
  std::vector<Index> rows;
  for (const Part& part : parts_)
    if (part.kind == Kind::quaternion) rows.push_back(part.row);
  return rows;
}

double* StateColumns::values(const Part& part, ob::State& state) const {
  ob::State* at = &state;
  const ob::StateSpace* space = space_.get();
  while (const auto* wrapper = dynamic_cast<const ob::WrapperStateSpace*>(space)) {
    at = at->as<ob::WrapperStateSpace::StateType>()->getState();
    space = wrapper->getSpace().get();
  }
  for (const unsigned i : part.within) at = at->as<ob::CompoundState>()->components[i];
  switch (part.kind) {
    case Kind::reals: return at->as<ob::RealVectorStateSpace::StateType>()->values;
    case Kind::angle: return &at->as<ob::SO2StateSpace::StateType>()->value;
    case Kind::quaternion: return part.space->getValueAddressAtIndex(at, 0);  // x, y, z, w stand side by side
  }
  return nullptr;
}

Eigen::VectorXd StateColumns::column(const ob::State& state) const {
  Eigen::VectorXd column(rows_);
  for (const Part& part : parts_)
    column.segment(part.row, part.count) =
        in_columns(part) * Eigen::Map<const Eigen::VectorXd>(values(part, const_cast<ob::State&>(state)), part.count);
  return column;
}

Points StateColumns::columns(const og::PathGeometric& path) const {
  const auto count = static_cast<Index>(path.getStateCount());
  Points columns(rows_, count);
  for (Index i = 0; i < count; ++i) {
    columns.col(i) = column(*path.getState(static_cast<unsigned>(i)));
    if (!columns.col(i).allFinite())
      throw InputError("state " + std::to_string(i) + " has a value that is not a number");
    if (!settle(columns.col(i))) throw InputError("state " + std::to_string(i) + " has a quaternion of length 0");
    if (i > 0) unwrap(columns.col(i - 1), columns.col(i));
  }
  return columns;
}

void StateColumns::write(const Eigen::VectorXd& column, ob::State& state) const {
  for (const Part& part : parts_) {
    Eigen::Map<Eigen::VectorXd> to(values(part, state), part.count);
    to = column.segment(part.row, part.count) / in_columns(part);
    if (part.kind == Kind::angle) {  // OMPL's bounds are those of [-pi, pi), and it aborts beyond them
      to[0] = std::remainder(to[0], 2 * std::numbers::pi);
      if (!(to[0] < std::numbers::pi)) to[0] = -std::numbers::pi;
    }
    if (part.kind == Kind::quaternion) to /= to.norm();
  }
}

std::shared_ptr<og::PathGeometric> StateColumns::path(const std::shared_ptr<ob::SpaceInformation>& space,
                                                      const Points& columns) const {
  if (columns.rows() != rows_)
    throw InputError("the columns have " + std::to_string(columns.rows()) + " rows, states of the space " +
                     std::to_string(rows_));
  auto path = std::make_shared<og::PathGeometric>(space);
  ob::State* state = space->allocState();
  for (const auto& column : columns.colwise()) {
    write(column, *state);
    path->append(state);
  }
  space->freeState(state);
  return path;
}

void StateColumns::unwrap(const Eigen::VectorXd& before, Eigen::Ref<Eigen::VectorXd> column) const {
  for (const Part& part : parts_) {
    auto here = column.segment(part.row, part.count);
    const auto there = before.segment(part.row, part.count);
    if (part.kind == Kind::angle) here[0] = there[0] + std::remainder(here[0] - there[0], 2 * std::numbers::pi * turn_);
    if (part.kind == Kind::quaternion && here.dot(there) < 0) here = -here;
  }
}

bool StateColumns::settle(Eigen::Ref<Eigen::VectorXd> column) const {
  for (const Part& part : parts_) {
    if (part.kind != Kind::quaternion) continue;
    auto q = column.segment(part.row, part.count);
    const double length = q.norm();
    if (!(length > kLeastQuaternion * turn_)) return false;
    q *= turn_ / length;
  }
  return true;
}

bool StateColumns::bounded() const {
  return !constrained_ && std::all_of(parts_.begin(), parts_.end(), [](const Part& part) {
    if (part.kind != Kind::reals) return true;
    const ob::RealVectorBounds& bounds = part.space->as<ob::RealVectorStateSpace>()->getBounds();
    const auto finite = [](double x) { return std::isfinite(x) && std::abs(x) < std::numeric_limits<double>::max(); };
    return std::all_of(bounds.low.begin(), bounds.low.end(), finite) &&
           std::all_of(bounds.high.begin(), bounds.high.end(), finite);
  });
}

Eigen::VectorXd StateColumns::random(std::mt19937_64& engine) const {
  Eigen::VectorXd column(rows_);
  const auto share = [&] { return std::uniform_real_distribution<double>(0, 1)(engine); };
  for (const Part& part : parts_) {
    auto here = column.segment(part.row, part.count);
    if (part.kind == Kind::reals) {
      const ob::RealVectorBounds& bounds = part.space->as<ob::RealVectorStateSpace>()->getBounds();
      for (Index i = 0; i < part.count; ++i) {
        const double low = bounds.low[static_cast<std::size_t>(i)], high = bounds.high[static_cast<std::size_t>(i)];
        here[i] = low + share() * (high - low);
      }
    } else if (part.kind == Kind::angle) {
      here[0] = turn_ * std::numbers::pi * (2 * share() - 1);
    } else {  // K. Shoemake 1992
      const double u = share(), v = 2 * std::numbers::pi * share(), w = 2 * std::numbers::pi * share();
      here << std::sqrt(1 - u) * std::sin(v), std::sqrt(1 - u) * std::cos(v), std::sqrt(u) * std::sin(w),
          std::sqrt(u) * std::cos(w);
      here *= turn_;
    }
  }
  return column;
}

std::shared_ptr<const ConstraintManifold> StateColumns::domain() const {
  if (constrained_) throw InputError("the space is constrained: give the domain of its states");
  if (has_quaternions()) return std::make_shared<PoseDomain>(static_cast<int>(rows_), quaternions(), turn_);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Eigen::VectorXd lower = Eigen::VectorXd::Constant(rows_, -kInfinity), upper = -lower;
  for (const Part& part : parts_) {
    if (part.kind != Kind::reals) continue;
    const ob::RealVectorBounds& bounds = part.space->as<ob::RealVectorStateSpace>()->getBounds();
    lower.segment(part.row, part.count) = Eigen::Map<const Eigen::VectorXd>(bounds.low.data(), part.count);
    upper.segment(part.row, part.count) = Eigen::Map<const Eigen::VectorXd>(bounds.high.data(), part.count);
  }
  return std::make_shared<EuclideanManifold>(
      EuclideanManifoldOptions{.dimension = static_cast<int>(rows_), .box = {lower, upper}});
}

std::shared_ptr<const SegmentCost> StateColumns::length() const {
  Eigen::VectorXd weights(rows_);
  for (const Part& part : parts_) weights.segment(part.row, part.count).setConstant(part.weight / in_columns(part));
  if ((weights.array() == 1).all()) return make_euclidean_cost(static_cast<int>(rows_));
  if (!(weights.array() > 0).all())
    throw InputError("a part of the space has weight 0, so length ignores it: give a cost");
  return make_metric_tensor_cost({.matrix = weights.cwiseAbs2().asDiagonal()}, static_cast<int>(rows_));
}

double StateColumns::steepness() const {
  double squares = 0;
  for (const Part& part : parts_) {
    const double arc = part.kind == Kind::quaternion ? std::numbers::pi / 2 : 1;  // over its chord, at most
    const double steep = part.weight * arc / in_columns(part);
    squares += steep * steep;
  }
  return std::sqrt(squares);
}

}  // namespace leastcost
