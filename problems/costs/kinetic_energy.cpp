// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/kinetic_energy.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_notes.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/cost/starts_straight.hpp>
#include "framework/base/symmetric_eigen.hpp"
#include "problems/costs/arm_motion.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr int kLinkNumbers = 10;  ///< mass, centre, inertia

/// In the frame of its row.
struct LinkInertia {
  double mass = 0;
  Vector3d center = Vector3d::Zero();
  Eigen::Matrix3d about_center = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d root = Eigen::Matrix3d::Zero();  ///< about_center = root root'
};

struct MovingArm {
  DhTable table;
  std::vector<LinkInertia> links;
};

/// Masses, centres and inertias (about the centre: xx, yy, zz, xy, xz, yz) that Franka publishes for its arm
/// (franka_description, inertial parameters of the FER; identified by Gaz, Cognetti, Oliva, Robuffo Giordano, De Luca,
/// IEEE Robotics and Automation Letters 4(4), 2019).
Eigen::MatrixXd panda_links() {
  Eigen::MatrixXd links(7, kLinkNumbers);
  links << 4.970684, 0.003875, 0.002081, -0.04762, 0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169,  //
      0.646926, -0.003141, -0.02872, 0.003495, 0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704,     //
      3.228604, 0.027518, 0.039252, -0.066502, 0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805,   //
      3.587895, -0.05317, 0.104419, 0.027454, 0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641,     //
      1.225946, -0.011953, 0.041065, -0.038437, 0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229,  //
      1.666555, 0.060149, -0.014117, -0.010517, 0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341,   //
      0.735522, 0.010517, -0.004252, 0.061597, 0.012516, 0.010027, 0.004815, -0.000428, -0.001196, -0.000741;
  return links;
}

/// Masses and centres: Universal Robots, "DH parameters for calculations of kinematics and dynamics". Inertias: none
/// are published there; these are of solid cylinders of about the size of the links, ours.
Eigen::MatrixXd ur5_links() {
  Eigen::MatrixXd links = Eigen::MatrixXd::Zero(6, kLinkNumbers);
  links.leftCols(4) << 3.7, 0, -0.02561, 0.00193,  //
      8.393, 0.2125, 0, 0.11336,                   //
      2.33, 0.15, 0, 0.0265,                       //
      1.219, 0, -0.0018, 0.01634,                  //
      1.219, 0, 0.0018, 0.01634,                   //
      0.1879, 0, 0, -0.001159;
  struct Cylinder {
    int axis;
    double radius, length;
  };
  const Cylinder cylinders[] = {{1, 0.06, 0.14},  {0, 0.055, 0.5},  {0, 0.05, 0.45},
                                {1, 0.045, 0.12}, {1, 0.045, 0.12}, {2, 0.0375, 0.04}};
  for (Index i = 0; i < 6; ++i) {
    const auto [axis, radius, length] = cylinders[i];
    const double square = radius * radius;
    links.row(i).segment<3>(4).setConstant(links(i, 0) * (3 * square + length * length) / 12);
    links(i, 4 + axis) = links(i, 0) * square / 2;
  }
  return links;
}

std::vector<LinkInertia> links_of(const Eigen::MatrixXd& numbers) {
  std::vector<LinkInertia> links;
  for (Index i = 0; i < numbers.rows(); ++i) {
    const auto row = numbers.row(i);
    LinkInertia link{row[0], row.segment<3>(1).transpose()};
    link.about_center << row[4], row[7], row[8], row[7], row[5], row[9], row[8], row[9], row[6];
    const std::string which = "link " + std::to_string(i + 1);
    if (!row.allFinite() || !(link.mass >= 0))
      throw OptionError("links", which + " must have finite numbers, and a mass of at least 0");
    const SymmetricEigen eigen = symmetric_eigen(link.about_center);
    const Eigen::VectorXd& moments = eigen.values;
    if (moments.minCoeff() < -1e-12 * std::abs(moments.maxCoeff()))
      throw OptionError("links", which +
                                     " has moments of inertia below 0: as a matrix [xx, xy, xz; xy, yy, yz; xz, yz, "
                                     "zz] about the centre it must have no negative eigenvalue");
    link.root = eigen.vectors * moments.cwiseMax(0).cwiseSqrt().asDiagonal();
    links.push_back(link);
  }
  return links;
}

struct MovingArmOf {
  MovingArm operator()(const arm_inertia::Panda&) const {
    return {joints_of(arm_model::Panda{}), links_of(panda_links())};
  }
  MovingArm operator()(const arm_inertia::Ur5&) const { return {joints_of(arm_model::Ur5{}), links_of(ur5_links())}; }
  MovingArm operator()(const arm_inertia::Table& given) const {
    DhTable table{given.convention, given.rows};
    table.upper = Eigen::VectorXd::Constant(given.rows.rows(), std::numeric_limits<double>::infinity());
    table.lower = -table.upper;
    table = DhArm(table).table();  // which checks it
    if (given.links.rows() != given.rows.rows() || given.links.cols() != kLinkNumbers)
      throw OptionError("links", "must be a row of 10 numbers for each of the " + std::to_string(given.rows.rows()) +
                                     " joints: mass, centre x, y, z, inertia xx, yy, zz, xy, xz, yz");
    return {table, links_of(given.links)};
  }
};

/// d' M(m) d.
struct KineticEnergy {
  static constexpr int dim = Eigen::Dynamic;
  template <class S>
  using Joints = Point<S, Eigen::Dynamic>;

  MovingArm arm;

  CostTraits traits() const { return {.unit = "sqrt(kg) m", .symmetric = true}; }

  /// Six numbers for each link: roots of its mass times the velocity of its centre, of its inertia times how it turns.
  template <class S>
  Joints<S> residual(const Joints<S>& a, const Joints<S>& b) const {
    const Joints<S> rates = b - a;
    const ArmFrames<S> frames = arm_frames<S>(arm.table, Joints<S>(0.5 * (a + b)));
    Joints<S> r(6 * static_cast<Index>(arm.links.size()));
    Vector3<S> turning = Vector3<S>::Zero();
    for (std::size_t i = 0; i < arm.links.size(); ++i) {
      const LinkInertia& link = arm.links[i];
      const Vector3<S> center = frames.at(i, link.center);
      Vector3<S> velocity = Vector3<S>::Zero();
      for (std::size_t j = 0; j <= i; ++j) velocity += rates[static_cast<Index>(j)] * frames.swept(j, center);
      turning += rates[static_cast<Index>(i)] * frames.axes[i];
      const Vector3<S> in_frame = frames.rotations[i].transpose() * turning;
      r.template segment<3>(6 * static_cast<Index>(i)) = S(std::sqrt(link.mass)) * velocity;
      r.template segment<3>(6 * static_cast<Index>(i) + 3) = link.root.transpose().cast<S>() * in_frame;
    }
    return r;
  }

  template <class S>
  S value(const Joints<S>& a, const Joints<S>& b) const {
    return residual<S>(a, b).squaredNorm();
  }

  /// By the middle and by the rates. With V the velocity of a centre by joints j >= k alone, W the turning by joints
  /// before k and s = z_k x (c - o_k): the velocity changes with angle k by z_k x V + W x s; with h the angular
  /// momentum about the centre, the energy of turning by -2 h . (z_k x W), because the tensor turns along.
  template <class S>
  S slopes(const Joints<S>& middle, const Joints<S>& rates, Joints<S>& by_middle, Joints<S>& by_rates) const {
    const ArmFrames<S> frames = arm_frames<S>(arm.table, middle);
    const std::size_t joints = arm.links.size();
    by_middle = Joints<S>::Constant(rates.size(), S(0.0));
    by_rates = by_middle;
    std::vector<Vector3<S>> before = {Vector3<S>::Zero()};  // how the joints before each turn it
    for (std::size_t j = 0; j < joints; ++j)
      before.push_back(before[j] + rates[static_cast<Index>(j)] * frames.axes[j]);
    std::vector<Vector3<S>> swept(joints);
    S square(0.0);
    for (std::size_t i = 0; i < joints; ++i) {
      const LinkInertia& link = arm.links[i];
      const Vector3<S> center = frames.at(i, link.center);
      Vector3<S> velocity = Vector3<S>::Zero();
      for (std::size_t j = 0; j <= i; ++j) {
        swept[j] = frames.swept(j, center);
        velocity += rates[static_cast<Index>(j)] * swept[j];
      }
      const Vector3<S>& turning = before[i + 1];
      const Vector3<S> momentum = S(link.mass) * velocity;
      const Vector3<S> in_frame = frames.rotations[i].transpose() * turning;
      const Vector3<S> angular = frames.rotations[i] * Vector3<S>(link.about_center.cast<S>() * in_frame);
      square += momentum.dot(velocity) + angular.dot(turning);
      Vector3<S> onward = velocity;
      for (std::size_t k = 0; k <= i; ++k) {
        const auto at = static_cast<Index>(k);
        const Vector3<S>& axis = frames.axes[k];
        const Vector3<S> change = cross_product<S, S>(axis, onward) + cross_product<S, S>(before[k], swept[k]);
        by_middle[at] += 2.0 * (momentum.dot(change) - angular.dot(cross_product<S, S>(axis, before[k])));
        by_rates[at] += 2.0 * (momentum.dot(swept[k]) + angular.dot(axis));
        onward -= rates[at] * swept[k];
      }
    }
    return square;
  }

  double gradient(const Joints<double>& a, const Joints<double>& b, Joints<double>& ga, Joints<double>& gb) const {
    Joints<double> by_middle, by_rates;
    const double square = slopes<double>(0.5 * (a + b), b - a, by_middle, by_rates);
    ga = 0.5 * by_middle - by_rates;
    gb = 0.5 * by_middle + by_rates;
    return square;
  }

  /// The slopes once more by some directions at a time.
  void hessian(const Joints<double>& a, const Joints<double>& b, Eigen::Ref<Points> h) const {
    constexpr Index kTogether = 4;
    using S = Dual<double, kTogether>;
    const Index d = a.size();
    const Joints<double> middle = 0.5 * (a + b), rates = b - a;
    Points in_middle(d, 2 * d), in_rates(d, 2 * d);  // slopes by middle and rates, once more by both
    Joints<S> m(d), v(d), by_middle, by_rates;
    for (Index i = 0; i < d; ++i) m[i] = S(middle[i]), v[i] = S(rates[i]);
    const auto variable = [&](Index k) -> S& { return k < d ? m[k] : v[k - d]; };
    for (Index first = 0; first < 2 * d; first += kTogether) {
      const Index count = std::min(kTogether, 2 * d - first);
      for (Index k = 0; k < count; ++k) variable(first + k).d[static_cast<std::size_t>(k)] = 1;
      slopes<S>(m, v, by_middle, by_rates);
      for (Index k = 0; k < count; ++k) {
        for (Index i = 0; i < d; ++i) {
          in_middle(i, first + k) = by_middle[i].d[static_cast<std::size_t>(k)];
          in_rates(i, first + k) = by_rates[i].d[static_cast<std::size_t>(k)];
        }
        variable(first + k).d[static_cast<std::size_t>(k)] = 0;
      }
    }
    const Points mm = in_middle.leftCols(d) / 4, mv = in_middle.rightCols(d) / 2, vv = in_rates.rightCols(d);
    h.topLeftCorner(d, d) = mm - mv - mv.transpose() + vv;
    h.bottomRightCorner(d, d) = mm + mv + mv.transpose() + vv;
    h.topRightCorner(d, d) = mm + mv - mv.transpose() - vv;
    h.bottomLeftCorner(d, d) = h.topRightCorner(d, d).transpose();
  }

  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    return residual<double>(x - 0.5 * v, x + 0.5 * v).norm();
  }
};

/// Whether every joint moves some mass wherever the others are cannot be seen in a few places, but that one moves none
/// in several of them is a mistake.
void check_moves_mass(const KineticEnergy& cost) {
  const Index d = cost.arm.table.rows.rows();
  for (Index k = 0; k < d; ++k) {
    double most = 0;
    for (int place = 0; place < 3; ++place) {
      const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(d, 0.3 + place, 1.1 * place - 0.7);
      most = std::max(most, cost.line_element(x, Eigen::VectorXd::Unit(d, k)));
    }
    if (!(most > 0))
      throw OptionError("links", "nothing that joint " + std::to_string(k + 1) +
                                     " moves has a mass or an inertia, so its motion would cost nothing");
  }
}

class KineticEnergyCost final : public SegmentCostOf<KineticEnergy>, public StartsStraight, public HasNotes {
 public:
  KineticEnergyCost(KineticEnergy cost, int dim, std::string model)
      : SegmentCostOf<KineticEnergy>(std::move(cost), dim), model_(std::move(model)) {}
  /// Of a robot from a file too: its masses are not read.
  std::vector<std::string> notes() const override {
    if (model_.empty()) return {};
    return {"kinetic_energy: masses and inertias are those of the model '" + model_ +
            "', not of a robot's file; for others, give model: {type: table, ..}"};
  }

 private:
  std::string model_;  ///< empty: a table
};

}  // namespace

void arm_inertia::Table::fields(FieldVisitor& visit) {
  visit.choice("convention", convention,
               {.help = "standard: joint i turns about z of frame i - 1; modified (Craig): about z of frame i."});
  visit.field("rows", rows, {.help = "One row per joint: [a, alpha, d, offset of the angle].", .required = true});
  visit.field("links", links,
              {.help = "One row per joint, for its link, in the frame of the joint's row: [mass, centre x, y, z, "
                       "inertia about the centre xx, yy, zz, xy, xz, yz].",
               .required = true});
}

void KineticEnergyOptions::fields(FieldVisitor& visit) {
  visit.variant("model", model, {.help = "The arm: a named model, or a table."});
}

std::shared_ptr<const SegmentCost> make_kinetic_energy_cost(const KineticEnergyOptions& options, int dim) {
  KineticEnergy cost;
  const bool is_table = std::holds_alternative<arm_inertia::Table>(options.model);
  const std::string model =
      is_table ? ""
               : std::string(std::visit([](const auto& m) { return std::decay_t<decltype(m)>::kType; }, options.model));
  try {
    cost.arm = std::visit(MovingArmOf{}, options.model);
    if (cost.arm.table.rows.rows() != dim)
      throw OptionError(
          "",
          "has " + std::to_string(cost.arm.table.rows.rows()) + " joints, but points of the domain have " +
              std::to_string(dim) + " coordinates" +
              (is_table ? "" : ": it is '" + model + "'; give the masses of another arm as model: {type: table, ..}"));
    check_moves_mass(cost);
  } catch (const OptionError& error) {
    throw error.under("model");
  }
  return std::make_shared<const KineticEnergyCost>(std::move(cost), dim, model);
}

}  // namespace leastcost
