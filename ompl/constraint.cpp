// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/ompl/constraint.hpp>

#include <ompl/base/Constraint.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/dense_solves.hpp"

namespace leastcost {
namespace {

namespace ob = ompl::base;

class DomainConstraint final : public ob::Constraint {
 public:
  DomainConstraint(std::shared_ptr<const ConstraintManifold> domain, double tolerance)
      : ob::Constraint(static_cast<unsigned>(domain->dimensions().ambient),
                       static_cast<unsigned>(domain->dimensions().ambient - domain->dimensions().tangent), tolerance),
        domain_(std::move(domain)) {}

  using ob::Constraint::distance;
  using ob::Constraint::function;
  using ob::Constraint::isSatisfied;
  using ob::Constraint::jacobian;
  using ob::Constraint::project;

  void function(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> out) const override {
    CoordinatePath foot;
    if (nearest(x, foot))
      out = normals(foot).transpose() * (x - foot.u.col(0));
    else
      out.setConstant(std::numeric_limits<double>::infinity());
  }

  void jacobian(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::MatrixXd> out) const override {
    CoordinatePath foot;
    if (nearest(x, foot))
      out = normals(foot).transpose();
    else
      out.setZero();
  }

  bool project(Eigen::Ref<Eigen::VectorXd> x) const override {
    CoordinatePath foot;
    if (!nearest(x, foot)) return false;
    x = foot.u.col(0);
    return true;
  }

  double distance(const Eigen::Ref<const Eigen::VectorXd>& x) const override {
    CoordinatePath foot;
    return nearest(x, foot) ? (x - foot.u.col(0)).norm() : std::numeric_limits<double>::infinity();
  }

  bool isSatisfied(const Eigen::Ref<const Eigen::VectorXd>& x) const override {
    return x.allFinite() && distance(x) <= getTolerance();
  }

 private:
  bool nearest(const Eigen::Ref<const Eigen::VectorXd>& x, CoordinatePath& foot) const {
    foot.u = x;
    foot.ring = true;  // a column alone, none of it fixed
    return x.allFinite() && domain_->project(foot).failed.empty();
  }

  /// Ambient x codimension, orthonormal.
  Points normals(const CoordinatePath& foot) const {
    Points tangents;
    domain_->tangent_bases(foot, tangents);
    const Points q = orthogonal_factor(tangents);
    return q.rightCols(q.cols() - tangents.cols());
  }

  std::shared_ptr<const ConstraintManifold> domain_;
};

}  // namespace

std::shared_ptr<ob::Constraint> make_constraint(std::shared_ptr<const ConstraintManifold> domain, double tolerance) {
  if (!domain) throw InputError("a constraint needs a domain");
  if (find_ability<HasChart>(*domain) != nullptr)
    throw InputError("this domain is a chart: plan in its coordinates, which need no constraint");
  const Dimensions dimensions = domain->dimensions();
  if (dimensions.tangent >= dimensions.ambient)
    throw InputError("this domain fills its space of " + std::to_string(dimensions.ambient) +
                     " dimensions, so it needs no constraint");
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw InputError("the tolerance of a constraint must be a number greater than 0");
  return std::make_shared<DomainConstraint>(std::move(domain), tolerance);
}

}  // namespace leastcost
