// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/shapes/shape_pose.hpp>

#include <cmath>
#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

using Eigen::Vector3d;

/// So many finite numbers.
const Eigen::VectorXd& numbers(const char* key, const Eigen::VectorXd& given, Eigen::Index count) {
  if (given.size() != count || !given.allFinite())
    throw OptionError("pose." + std::string(key), "must be " + std::to_string(count) + " finite numbers");
  return given;
}

Eigen::Quaterniond unit_quaternion(const Eigen::VectorXd& given) {
  const double largest = numbers("quaternion", given, 4).cwiseAbs().maxCoeff();
  if (!(largest > 0)) throw OptionError("pose.quaternion", "must not be zero: no rotation is [1, 0, 0, 0]");
  const Eigen::Vector4d q = given / largest;  // its squares do not overflow
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
}

Eigen::Matrix3d rotation_of(const ShapePose& options) {
  if (options.rpy.size() > 0) {
    const Vector3d rpy = numbers("rpy", options.rpy, 3);
    return (Eigen::AngleAxisd(rpy[2], Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy[1], Vector3d::UnitY()) *
            Eigen::AngleAxisd(rpy[0], Vector3d::UnitX()))
        .toRotationMatrix();
  }
  if (options.quaternion.size() > 0) return unit_quaternion(options.quaternion).toRotationMatrix();
  if (options.rotation.size() == 0) return Eigen::Matrix3d::Identity();
  const Vector3d turn = numbers("rotation", options.rotation, 3);
  const double angle = turn.stableNorm();
  if (!(angle > 0)) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

}  // namespace

void ShapePose::fields(FieldVisitor& visit) {
  visit.field("position", position, {.help = "Position of the origin of its frame.", .unit = "length"});
  visit.field("rpy", rpy, {.help = "Roll, pitch and yaw about the fixed axes x, y, z, as in URDF.", .unit = "rad"});
  visit.field("quaternion", quaternion, {.help = "Rotation as a quaternion [w, x, y, z]."});
  visit.field("rotation", rotation, {.help = "Rotation vector, axis times angle.", .unit = "rad"});
  visit.field("angle", angle, {.help = "Rotation in the plane, counterclockwise.", .unit = "rad"});
}

void visit_pose(FieldVisitor& visit, ShapePose& pose) {
  visit.group("pose", {.help = "Position and rotation of the shape's frame."},
              [&](FieldVisitor& inner) { pose.fields(inner); });
}

Eigen::Isometry3d pose_of(const ShapePose& options, Eigen::Index dimension) {
  const bool plane = dimension == 2;
  const int rotations = (options.rpy.size() > 0) + (options.quaternion.size() > 0) + (options.rotation.size() > 0);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (options.position.size() > 0)
    pose.translation().head(dimension) = numbers("position", options.position, dimension);
  if (plane && rotations > 0)
    throw OptionError("pose", "in the plane a rotation is an angle, like {position: [1, 2], angle: 0.5}");
  if (!plane && options.angle)
    throw OptionError("pose.angle", "is a rotation in the plane: in space give rpy, quaternion or rotation");
  if (rotations > 1) throw OptionError("pose", "must have at most one of rpy, quaternion and rotation");
  if (options.angle && !std::isfinite(*options.angle)) throw OptionError("pose.angle", "must be a finite number");
  pose.linear() =
      options.angle ? Eigen::AngleAxisd(*options.angle, Vector3d::UnitZ()).toRotationMatrix() : rotation_of(options);
  return pose;
}

ShapePose shape_pose(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  ShapePose out;
  out.position = pose.translation();
  out.quaternion = Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
  return out;
}

}  // namespace leastcost
