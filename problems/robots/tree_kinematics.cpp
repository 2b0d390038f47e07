// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/tree_kinematics.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d cross_product_with(const Vector3d& a) {
  Matrix3d cross;
  cross << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return cross;
}

bool is_rotation(const Matrix3d& turn) {
  constexpr double kRounding = 1e-9;
  return turn.allFinite() && (turn * turn.transpose()).isIdentity(kRounding) && turn.determinant() > 0;
}

void check_joint(const JointTree& tree, std::size_t i) {
  const TreeJoint& joint = tree.joints[i];
  const auto refuse = [i](const std::string& why) {
    throw OptionError("joints", "joint " + std::to_string(i) + " " + why);
  };
  if (joint.parent < 0 || joint.parent > static_cast<int>(i))
    refuse("moves link " + std::to_string(i + 1) + ", so its parent must be one of the links before");
  if (!is_rotation(joint.origin.rotation) || !joint.origin.origin.allFinite())
    refuse("must have an origin of a rotation and a finite place");
  if (!joint.axis.allFinite() || !(joint.axis.norm() > 0)) refuse("must have a finite axis that is not zero");
  if (joint.coordinate < 0 || joint.coordinate >= tree.lower.size())
    refuse("must have one of the coordinates 0 to " + std::to_string(tree.lower.size() - 1));
  if (!std::isfinite(joint.factor) || joint.factor == 0) refuse("must have a finite factor that is not zero");
  if (!std::isfinite(joint.offset)) refuse("must have a finite offset");
}

void check_tree(const JointTree& tree) {
  if (tree.joints.empty()) throw OptionError("joints", "must have at least one joint");
  if (tree.links.size() != tree.joints.size() + 1) throw OptionError("links", "must have one link more than joints");
  if (!is_rotation(tree.base.rotation) || !tree.base.origin.allFinite())
    throw OptionError("base", "must be a rotation and a finite place");
  for (const auto& [key, side] : {std::pair{"lower", &tree.lower}, std::pair{"upper", &tree.upper}})
    if (side->size() != tree.lower.size() || side->array().isNaN().any())
      throw OptionError(key, "must have a number for each coordinate");
  for (Eigen::Index c = 0; c < tree.lower.size(); ++c) {
    if (!(tree.lower[c] <= tree.upper[c]))
      throw OptionError("upper", "must be at least lower for coordinate " + std::to_string(c));
    if (std::none_of(tree.joints.begin(), tree.joints.end(), [&](const TreeJoint& j) { return j.coordinate == c; }))
      throw OptionError("joints", "must have one of coordinate " + std::to_string(c));
  }
  for (std::size_t i = 0; i < tree.joints.size(); ++i) check_joint(tree, i);
}

/// Where a point may be, seen from some link: within a radius of a segment.
struct Whereabouts {
  Vector3d from, to;
  double radius = 0;

  void move(const Frame& frame) {
    from = frame.at(from);
    to = frame.at(to);
  }
  void move_back(const Frame& frame) {
    from = frame.rotation.transpose() * (from - frame.origin);
    to = frame.rotation.transpose() * (to - frame.origin);
  }
  /// Turned about an axis (unit) through the origin by any angle; returns how far from it it reaches.
  double turn(const Vector3d& axis) {
    const Vector3d low = axis * axis.dot(from), high = axis * axis.dot(to);
    radius += std::max((from - low).norm(), (to - high).norm());
    from = low;
    to = high;
    return radius;
  }
  /// Moved along an axis (unit) by anything from `least` to `most`. The sum of two segments is a parallelogram: the
  /// longer one grows by what the other has along it, and the radius by the rest.
  void slide(const Vector3d& axis, double least, double most) {
    if (!std::isfinite(least) || !std::isfinite(most)) {
      radius = std::numeric_limits<double>::infinity();
      return;
    }
    const Vector3d middle = (from + to) / 2 + (least + most) / 2 * axis;
    Vector3d half = (to - from) / 2, other = (most - least) / 2 * axis;
    if (half.norm() < other.norm()) std::swap(half, other);
    const double length = half.norm();
    if (length > 0) {
      const Vector3d way = half / length, along = way * way.dot(other);
      half = way * (length + std::abs(way.dot(other)));
      radius += (other - along).norm();
    }
    from = middle - half;
    to = middle + half;
  }
};

}  // namespace

struct TreeKinematics::Way {
  const std::vector<int>*down, *up;
  std::size_t common;  ///< so many joints at the root belong to both and move neither link against the other
};

TreeKinematics::TreeKinematics(JointTree tree) : tree_(std::move(tree)) {
  check_tree(tree_);
  paths_.resize(tree_.links.size());
  std::vector<int> count(static_cast<std::size_t>(dimension()), 0);
  for (int i = 0; i < static_cast<int>(tree_.joints.size()); ++i) {
    TreeJoint& joint = tree_.joints[static_cast<std::size_t>(i)];
    joint.axis.normalize();
    const Matrix3d along = joint.axis * joint.axis.transpose(), &base = joint.origin.rotation;
    turns_.push_back({base * along, base * (Matrix3d::Identity() - along), base * cross_product_with(joint.axis)});
    std::vector<int>& path = paths_[static_cast<std::size_t>(i) + 1];
    path = paths_[static_cast<std::size_t>(joint.parent)];
    path.push_back(i);
    ++count[static_cast<std::size_t>(joint.coordinate)];
  }
  for (const std::vector<int>& path : paths_) {
    std::vector<int> order(path.rbegin(), path.rend());
    for (int i = 0; i < static_cast<int>(tree_.joints.size()); ++i)
      if (std::find(path.begin(), path.end(), i) == path.end()) order.push_back(i);
    std::vector<int> left = count;
    std::vector<Step>& steps = steps_.emplace_back();
    for (const int i : order) {
      const auto c = static_cast<std::size_t>(joint(i).coordinate);
      steps.push_back({i, --left[c] == 0, count[c] == 1});
    }
  }
}

TreeKinematics::Way TreeKinematics::way(int seen_from, int link) const {
  const auto &down = paths_[static_cast<std::size_t>(seen_from)], &up = paths_[static_cast<std::size_t>(link)];
  std::size_t common = 0;
  while (common < std::min(down.size(), up.size()) && down[common] == up[common]) ++common;
  return {&down, &up, common};
}

bool TreeKinematics::carries(int link, int other) const {
  return way(link, other).common == paths_[static_cast<std::size_t>(link)].size();
}

void TreeKinematics::place(const Vector& configuration, std::vector<Frame>& links) const {
  links.resize(tree_.links.size());
  links[0] = tree_.base;
  for (std::size_t i = 0; i < tree_.joints.size(); ++i) {
    const TreeJoint& joint = tree_.joints[i];
    const Frame& parent = links[static_cast<std::size_t>(joint.parent)];
    Frame& child = links[i + 1];
    const double q = joint.factor * configuration[joint.coordinate] + joint.offset;
    child.origin = parent.at(joint.origin.origin);
    if (joint.slides) {
      child.rotation.noalias() = parent.rotation * joint.origin.rotation;
      child.origin += q * (child.rotation * joint.axis);
    } else {
      const Turn& turn = turns_[i];
      const Matrix3d turned = turn.fixed + std::cos(q) * turn.cosine + std::sin(q) * turn.sine;
      child.rotation.noalias() = parent.rotation * turned;
    }
  }
}

void TreeKinematics::jacobian(const Vector&, const std::vector<Frame>& links, int link, const Vector3d& point,
                              Eigen::Matrix3Xd& derivative) const {
  derivative.setZero(3, dimension());
  for (const int i : paths_[static_cast<std::size_t>(link)]) {
    const Frame& child = links[static_cast<std::size_t>(i) + 1];
    const Vector3d axis = joint(i).factor * (child.rotation * joint(i).axis);
    derivative.col(joint(i).coordinate) += joint(i).slides ? axis : axis.cross(point - child.origin);
  }
}

/// Where the point can be is followed from its link to the other one. A joint that turns takes it to the whole ring
/// about its axis, one that slides along its range.
TreeKinematics::Vector TreeKinematics::reach_from(int seen_from, int link, const Vector3d& local) const {
  Vector farthest = Vector::Zero(dimension());
  Whereabouts point{local, local};
  const auto pass = [&](const TreeJoint& joint, double sign) {
    double& reach = farthest[joint.coordinate];
    if (joint.slides) {
      const double p = sign * (joint.factor * tree_.lower[joint.coordinate] + joint.offset),
                   q = sign * (joint.factor * tree_.upper[joint.coordinate] + joint.offset);
      reach += std::abs(joint.factor);
      point.slide(joint.axis, std::min(p, q), std::max(p, q));
    } else {
      reach += std::abs(joint.factor) * point.turn(joint.axis);
    }
  };
  const auto [down, up, common] = way(seen_from, link);
  for (std::size_t k = up->size(); k-- > common;) {
    pass(joint((*up)[k]), 1);
    point.move(joint((*up)[k]).origin);
  }
  for (std::size_t k = common; k < down->size(); ++k) {
    point.move_back(joint((*down)[k]).origin);
    pass(joint((*down)[k]), -1);
  }
  return farthest;
}

double TreeKinematics::steepest(const Vector& reach, int) const { return reach.norm(); }

/// Seen from a link, the joints on the way to the point are a chain, those of its own path first. The derivative by
/// joints i <= j <= k of the chain is z_i x (z_j x (z_k x (p - o_k))), no longer than the distance from axis k, and
/// z_i x (z_j x z_k) where k slides; it is 0 where one before the last slides. Of a coordinate with several joints all
/// are taken as if they were at the place of its last one. One that does not move the point is not on the way, or the
/// point stays on its axis.
MotionBound TreeKinematics::motion(const Vector& a, const Vector& b, const Vector& reach, int seen_from) const {
  MotionBound bound;
  double before = 0;  // of the rates at which joints turn that are nearer to the link from which it is seen
  for (const Step& step : steps_[static_cast<std::size_t>(seen_from)]) {
    const TreeJoint& joint = this->joint(step.joint);
    if (!(reach[joint.coordinate] > 0)) continue;
    const double rate = std::abs(b[joint.coordinate] - a[joint.coordinate]);
    if (rate == 0) continue;  // also where the reach is infinite
    const double turning = joint.slides ? 0 : std::abs(joint.factor) * rate, all = before + turning;
    const double speed = rate * reach[joint.coordinate];
    if (step.last) {
      bound.speed += speed;
      bound.acceleration += speed * (step.single ? before + all : 2 * all);
      bound.jerk += speed * (step.single ? 3 * before * all + turning * turning : 3 * all * all);
    }
    before = all;
  }
  return bound;
}

PointMotion TreeKinematics::moving(const Vector&, const std::vector<Frame>& links, const Vector& way_of_all, int link,
                                   const Vector3d& point, int seen_from) const {
  PointMotion out{Vector3d::Zero(), Vector3d::Zero()};
  Vector3d turning = Vector3d::Zero();  // of the joints nearer to the link from which it is seen
  const auto pass = [&](int i, double sign) {
    const TreeJoint& joint = this->joint(i);
    const Frame& child = links[static_cast<std::size_t>(i) + 1];
    const Vector3d rate = sign * joint.factor * way_of_all[joint.coordinate] * (child.rotation * joint.axis);
    if (joint.slides) {
      out.velocity += rate;
      out.acceleration += 2 * turning.cross(rate);
      return;
    }
    const Vector3d swept = rate.cross(point - child.origin);
    out.velocity += swept;
    out.acceleration += (rate + 2 * turning).cross(swept);
    turning += rate;
  };
  const auto [down, up, common] = way(seen_from, link);
  for (std::size_t k = down->size(); k-- > common;) pass((*down)[k], -1);
  for (std::size_t k = common; k < up->size(); ++k) pass((*up)[k], 1);
  return out;
}

}  // namespace leastcost
