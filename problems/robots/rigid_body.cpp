// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/rigid_body.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Configuration = Kinematics::Vector;

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr Eigen::Index kPlanarColumns = 5, kSpatialColumns = 7;  ///< of a row of the shape

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// Least norm of a + t (b - a), 0 <= t <= 1.
double nearest_to_zero(const Vector4d& a, const Vector4d& b) {
  const Vector4d way = b - a;
  const double square = way.squaredNorm();
  const double t = square > 0 ? std::clamp(-a.dot(way) / square, 0.0, 1.0) : 0;
  return (a + t * way).norm();
}

}  // namespace

void PlanarBody::place(const Vector& x, std::vector<Frame>& links) const {
  links.resize(1);
  const double angle = x[2] / turn_, c = std::cos(angle), s = std::sin(angle);
  links[0].rotation << c, -s, 0, s, c, 0, 0, 0, 1;
  links[0].origin << x[0], x[1], 0;
}

void PlanarBody::jacobian(const Vector&, const std::vector<Frame>& links, int, const Vector3d& point,
                          Eigen::Matrix3Xd& derivative) const {
  derivative.setZero(3, 3);
  derivative(0, 0) = derivative(1, 1) = 1;
  derivative.col(2) = Vector3d::UnitZ().cross(point - links[0].origin) / turn_;
}

PlanarBody::Vector PlanarBody::reach(int, const Vector3d& local) const { return Vector3d(1, 1, local.norm() / turn_); }

double PlanarBody::steepest(const Vector& reach, int) const { return std::hypot(1.0, reach[2]); }

MotionBound PlanarBody::motion(const Vector& a, const Vector& b, const Vector& reach, int) const {
  const double turned = std::abs(b[2] - a[2]) / turn_, far = reach[2] * turn_;
  return {(b - a).head<2>().norm() + turned * far, turned * turned * far, turned * turned * turned * far};
}

PointMotion PlanarBody::moving(const Vector&, const std::vector<Frame>& links, const Vector& way, int,
                               const Vector3d& point, int) const {
  const Vector3d arm = point - links[0].origin;
  const double turned = way[2] / turn_;
  return {Vector3d(way[0], way[1], 0) + turned * Vector3d::UnitZ().cross(arm), -turned * turned * arm};
}

PlanarBody::Vector PlanarBody::lower() const { return Vector::Constant(3, -kUnlimited); }
PlanarBody::Vector PlanarBody::upper() const { return Vector::Constant(3, kUnlimited); }

void SpatialBody::place(const Vector& x, std::vector<Frame>& links) const {
  links.resize(1);
  const double square = x.tail<4>().squaredNorm();
  links[0].origin = x.head<3>();
  links[0].rotation.setIdentity();
  if (!(square > 0)) return;  // no direction is any better
  const double w = x[3];
  const Vector3d v = x.tail<3>();
  links[0].rotation =
      ((w * w - v.squaredNorm()) * Matrix3d::Identity() + 2 * v * v.transpose() + 2 * w * cross_matrix(v)) / square;
}

/// The body turns by twice the vector part of dq times the conjugate of q, over |q|^2.
void SpatialBody::jacobian(const Vector& x, const std::vector<Frame>& links, int, const Vector3d& point,
                           Eigen::Matrix3Xd& derivative) const {
  derivative.setZero(3, 7);
  derivative.leftCols<3>().setIdentity();
  const double square = x.tail<4>().squaredNorm();
  if (!(square > 0)) return;
  const Vector3d v = x.tail<3>();
  Eigen::Matrix<double, 3, 4> turn;
  turn << -v, x[3] * Matrix3d::Identity() + cross_matrix(v);
  derivative.rightCols<4>() = -2 / square * cross_matrix(point - links[0].origin) * turn;
}

/// Of a quaternion of length `turn`.
SpatialBody::Vector SpatialBody::reach(int, const Vector3d& local) const {
  Vector reach(7);
  reach << 1, 1, 1, Vector4d::Constant(2 * local.norm() / turn_);
  return reach;
}

double SpatialBody::steepest(const Vector& reach, int) const { return std::hypot(1.0, reach[3]); }

/// The direction of q turns by phi, tan phi = s / h, where h is the distance of the line through both quaternions from
/// zero and s runs along it, s' = w: phi' = w h / |q|^2, its derivatives -2 w^2 h s / |q|^4 and w^3 h (6 s^2 - 2
/// h^2) / |q|^6. With r = w / |q| they are at most r, r^2 and 2 r^3. The body turns by 2 phi about an axis that stays.
MotionBound SpatialBody::motion(const Vector& a, const Vector& b, const Vector& reach, int) const {
  const double nearest = nearest_to_zero(a.tail<4>(), b.tail<4>());
  const double way = (b - a).tail<4>().norm(), moved = (b - a).head<3>().norm();
  if (!(way > 0)) return {moved, 0, 0};
  constexpr double kClose = 1e-6;  // of a quaternion: nearer to zero its direction is not known
  if (!(nearest > kClose * turn_)) return {kUnlimited, kUnlimited, kUnlimited};
  const double r = way / nearest, far = reach[3] * turn_ / 2;
  return {moved + 2 * r * far, (4 + 2) * r * r * far, (8 + 3 * 4 + 4) * r * r * r * far};
}

PointMotion SpatialBody::moving(const Vector& x, const std::vector<Frame>& links, const Vector& way, int,
                                const Vector3d& point, int) const {
  PointMotion out{way.head<3>(), Vector3d::Zero()};
  const double square = x.tail<4>().squaredNorm();
  if (!(square > 0)) return out;
  const Vector3d v = x.tail<3>(), dv = way.tail<3>(), arm = point - links[0].origin;
  const Vector3d turning = 2 / square * (x[3] * dv - way[3] * v + v.cross(dv));  // its derivative is along it
  const Vector3d turned_more = -2 * x.tail<4>().dot(way.tail<4>()) / square * turning;
  out.velocity += turning.cross(arm);
  out.acceleration = turned_more.cross(arm) + turning.cross(turning.cross(arm));
  return out;
}

SpatialBody::Vector SpatialBody::lower() const { return Vector::Constant(7, -kUnlimited); }
SpatialBody::Vector SpatialBody::upper() const { return Vector::Constant(7, kUnlimited); }

void RigidBodyOptions::fields(FieldVisitor& visit) {
  visit.field("shape", shape,
              {.help = "Capsules in body coordinates, one per row; equal ends make a ball. In the plane: [x1, y1, x2, "
                       "y2, radius], with configurations (x, y, angle). In space: [x1, y1, z1, x2, y2, z2, radius], "
                       "with configurations (x, y, z, qw, qx, qy, qz).",
               .unit = "length",
               .required = true});
}

std::shared_ptr<const Robot> make_rigid_body(const RigidBodyOptions& options) {
  const Eigen::MatrixXd& shape = options.shape;
  const bool planar = shape.cols() == kPlanarColumns;
  if (shape.rows() == 0 || (!planar && shape.cols() != kSpatialColumns))
    throw OptionError("shape",
                      "must be rows of 5 numbers (in the plane) or 7 (in space): both ends of a segment and a "
                      "radius");
  Robot robot;
  if (planar)
    robot.kinematics = std::make_shared<const PlanarBody>();
  else
    robot.kinematics = std::make_shared<const SpatialBody>();
  for (Eigen::Index i = 0; i < shape.rows(); ++i) {
    const Configuration row = shape.row(i);
    Capsule capsule;
    capsule.from = planar ? Vector3d(row[0], row[1], 0) : Vector3d(row.head<3>());
    capsule.to = planar ? Vector3d(row[2], row[3], 0) : Vector3d(row.segment<3>(3));
    capsule.radius = row[row.size() - 1];
    robot.capsules.push_back(capsule);
  }
  return make_robot(std::move(robot));
}

}  // namespace leastcost
