// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/end_effector_length.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/cost/starts_straight.hpp>
#include "problems/costs/arm_motion.hpp"

namespace leastcost {
namespace {

struct EndEffectorLength {
  static constexpr int dim = Eigen::Dynamic;
  template <class S>
  using Joints = Point<S, Eigen::Dynamic>;

  DhTable table;
  Eigen::Vector3d tool;
  double weight = 0;

  CostTraits traits() const { return {.unit = "length", .symmetric = true, .below_curves = true}; }

  template <class S>
  Joints<S> residual(const Joints<S>& a, const Joints<S>& b) const {
    const std::size_t last = static_cast<std::size_t>(table.rows.rows()) - 1;
    Joints<S> r(3 + a.size());
    r.template head<3>() = arm_frames<S>(table, b).at(last, tool) - arm_frames<S>(table, a).at(last, tool);
    r.tail(a.size()) = S(weight) * (b - a);
    return r;
  }
  template <class S>
  S value(const Joints<S>& a, const Joints<S>& b) const {
    return residual<S>(a, b).squaredNorm();
  }

  double gradient(const Joints<double>& a, const Joints<double>& b, Joints<double>& ga, Joints<double>& gb) const {
    const Place from = place(a), to = place(b);
    const Eigen::Vector3d way = to.tool - from.tool;
    const Joints<double> turned = weight * weight * (b - a);
    ga = -2 * (from.swept.transpose() * way + turned);
    gb = 2 * (to.swept.transpose() * way + turned);
    return way.squaredNorm() + weight * weight * (b - a).squaredNorm();
  }

  void hessian(const Joints<double>& a, const Joints<double>& b, Eigen::Ref<Points> h) const {
    const Index d = a.size();
    const Place from = place(a), to = place(b);
    const Eigen::Vector3d way = to.tool - from.tool;
    const Points turned = 2 * weight * weight * Points::Identity(d, d);
    h.topLeftCorner(d, d) = 2 * (from.swept.transpose() * from.swept - from.bend(way)) + turned;
    h.bottomRightCorner(d, d) = 2 * (to.swept.transpose() * to.swept + to.bend(way)) + turned;
    h.topRightCorner(d, d) = -2 * from.swept.transpose() * to.swept - turned;
    h.bottomLeftCorner(d, d) = h.topRightCorner(d, d).transpose();
  }

  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    return std::hypot((place(x).swept * v).norm(), weight * v.norm());
  }

 private:
  /// Of the tool in one configuration.
  struct Place {
    ArmFrames<double> frames;
    Eigen::Vector3d tool;
    Eigen::Matrix3Xd swept;  ///< its derivative by the joints

    /// The second derivative of way . tool: by joints j <= k it is way . (z_j x swept_k).
    Points bend(const Eigen::Vector3d& way) const {
      const Index d = swept.cols();
      Points out(d, d);
      for (Index k = 0; k < d; ++k)
        for (Index j = 0; j <= k; ++j)
          out(j, k) = out(k, j) =
              way.dot(cross_product<double, double>(frames.axes[static_cast<std::size_t>(j)], swept.col(k)));
      return out;
    }
  };

  Place place(const Joints<double>& x) const {
    Place out{arm_frames<double>(table, x), Eigen::Vector3d::Zero(), Eigen::Matrix3Xd(3, x.size())};
    out.tool = out.frames.at(static_cast<std::size_t>(x.size()) - 1, tool);
    for (Index k = 0; k < x.size(); ++k) out.swept.col(k) = out.frames.swept(static_cast<std::size_t>(k), out.tool);
    return out;
  }
};

struct JointsOf {
  DhTable operator()(const arm_joints::Table& given) const {
    DhTable table{given.convention, given.rows};
    table.upper = Eigen::VectorXd::Constant(given.rows.rows(), std::numeric_limits<double>::infinity());
    table.lower = -table.upper;
    return DhArm(table).table();  // which checks it
  }
  template <class Named>
  DhTable operator()(const Named& named) const {
    return joints_of(named);
  }
};

class EndEffectorLengthCost final : public SegmentCostOf<EndEffectorLength>, public StartsStraight {
 public:
  using SegmentCostOf<EndEffectorLength>::SegmentCostOf;
};

}  // namespace

void arm_joints::Table::fields(FieldVisitor& visit) {
  visit.choice("convention", convention,
               {.help = "standard: joint i turns about z of frame i - 1; modified (Craig): about z of frame i."});
  visit.field("rows", rows, {.help = "One row per joint: [a, alpha, d, offset of the angle].", .required = true});
}

void EndEffectorLengthOptions::fields(FieldVisitor& visit) {
  visit.variant("model", model, {.help = "The arm: a named model, or a table."});
  visit.field("tool", tool, {.help = "Position of the tool in the frame of the last row.", .unit = "length"});
  visit.field("joint_weight", joint_weight,
              {.help = "Weight of joint rotation relative to the path of the tool.",
               .unit = "length per rad",
               .minimum = 0,
               .exclusive_minimum = true});
}

std::shared_ptr<const SegmentCost> make_end_effector_length(const EndEffectorLengthOptions& options, int dim) {
  EndEffectorLength cost;
  try {
    cost.table = std::visit(JointsOf{}, options.model);
  } catch (const OptionError& error) {
    throw error.under("model");
  }
  if (cost.table.rows.rows() != dim)
    throw OptionError("model", "has " + std::to_string(cost.table.rows.rows()) +
                                   " joints, but points of the domain have " + std::to_string(dim) + " coordinates");
  if (options.tool.size() != 3 || !options.tool.allFinite())
    throw OptionError("tool", "must be a point in the frame of the last row, three finite numbers");
  if (!(options.joint_weight > 0) || !std::isfinite(options.joint_weight))
    throw OptionError("joint_weight",
                      "must be greater than 0, or motions that do not move the tool would cost nothing");
  cost.tool = options.tool;
  cost.weight = options.joint_weight;
  return std::make_shared<const EndEffectorLengthCost>(std::move(cost), dim);
}

}  // namespace leastcost
