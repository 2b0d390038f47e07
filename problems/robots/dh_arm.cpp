// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/dh_arm.hpp>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <utility>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

enum Column { kA, kAlpha, kD, kOffset };  // of a table

Matrix3d about_x(double cosine, double sine) {
  Matrix3d turn;
  turn << 1, 0, 0, 0, cosine, -sine, 0, sine, cosine;
  return turn;
}

/// A turn or tilt by its cosine and sine.
struct Turn {
  double cosine, sine;
};

/// One row of the next frame in the convention "modified": tilted about the last x, then turned about the new z. Row by
/// row in numbers, for this is the innermost of what collision checks do.
void tilt_and_turn(const Frame& last, const Turn& tilt, const Turn& turn, double a, double d, Frame& next) {
  for (int i = 0; i < 3; ++i) {
    const double x = last.rotation(i, 0), y0 = last.rotation(i, 1), z0 = last.rotation(i, 2);
    const double y = tilt.cosine * y0 + tilt.sine * z0, z = tilt.cosine * z0 - tilt.sine * y0;
    next.origin[i] = last.origin[i] + a * x + d * z;
    next.rotation(i, 0) = turn.cosine * x + turn.sine * y;
    next.rotation(i, 1) = turn.cosine * y - turn.sine * x;
    next.rotation(i, 2) = z;
  }
}

/// The same in the convention "standard": turned about the last z, then tilted about the new x.
void turn_and_tilt(const Frame& last, const Turn& tilt, const Turn& turn, double a, double d, Frame& next) {
  for (int i = 0; i < 3; ++i) {
    const double x0 = last.rotation(i, 0), y0 = last.rotation(i, 1), z0 = last.rotation(i, 2);
    const double x = turn.cosine * x0 + turn.sine * y0, y = turn.cosine * y0 - turn.sine * x0;
    next.origin[i] = last.origin[i] + a * x + d * z0;
    next.rotation(i, 0) = x;
    next.rotation(i, 1) = tilt.cosine * y + tilt.sine * z0;
    next.rotation(i, 2) = tilt.cosine * z0 - tilt.sine * y;
  }
}

void check_table(const DhTable& table) {
  if (table.rows.rows() == 0 || table.rows.cols() != 4 || !table.rows.allFinite())
    throw OptionError("rows", "must have a row of four finite numbers for each joint: a, alpha, d, offset");
  const Eigen::Index joints = table.rows.rows();
  for (const auto& [key, side] : {std::pair{"lower", &table.lower}, std::pair{"upper", &table.upper}})
    if (side->size() != joints || side->array().isNaN().any())
      throw OptionError(key, "must be an angle for each of the " + std::to_string(joints) + " joints");
  for (Eigen::Index j = 0; j < joints; ++j)
    if (!(table.lower[j] <= table.upper[j]))
      throw OptionError("upper", "must be at least lower for joint " + std::to_string(j + 1));
  if (!table.base.allFinite()) throw OptionError("base", "must be a point, with finite coordinates");
}

}  // namespace

Words<DhConvention> words(DhConvention) {
  static constexpr std::array<Word<DhConvention>, 2> kWords = {
      {{DhConvention::standard, "standard"}, {DhConvention::modified, "modified"}}};
  return kWords;
}

DhArm::DhArm(DhTable table) : table_(std::move(table)) {
  check_table(table_);
  for (const double alpha : table_.rows.col(kAlpha)) tilts_.push_back(about_x(std::cos(alpha), std::sin(alpha)));
}

std::string DhArm::link_name(int link) const { return link == 0 ? "the base" : "link " + std::to_string(link); }

const Frame& DhArm::axis_frame(const std::vector<Frame>& links, int joint) const {
  return links[static_cast<std::size_t>(table_.convention == DhConvention::standard ? joint : joint + 1)];
}

void DhArm::place(const Vector& configuration, std::vector<Frame>& links) const {
  links.resize(static_cast<std::size_t>(link_count()));
  links[0] = Frame{Matrix3d::Identity(), table_.base};
  for (int j = 0; j < static_cast<int>(dimension()); ++j) {
    const Frame& last = links[static_cast<std::size_t>(j)];
    Frame& next = links[static_cast<std::size_t>(j) + 1];
    const double angle = configuration[j] + table_.rows(j, kOffset), a = table_.rows(j, kA), d = table_.rows(j, kD);
    const Matrix3d& tilted = tilts_[static_cast<std::size_t>(j)];
    const Turn turn{std::cos(angle), std::sin(angle)}, tilt{tilted(1, 1), tilted(2, 1)};
    if (table_.convention == DhConvention::standard)
      turn_and_tilt(last, tilt, turn, a, d, next);
    else
      tilt_and_turn(last, tilt, turn, a, d, next);
  }
}

void DhArm::jacobian(const Vector&, const std::vector<Frame>& links, int link, const Vector3d& point,
                     Eigen::Matrix3Xd& derivative) const {
  derivative.setZero(3, dimension());
  for (int j = 0; j < link; ++j) {
    const Frame& axis = axis_frame(links, j);
    derivative.col(j) = axis.rotation.col(2).cross(point - axis.origin);
  }
}

/// Where the point can be, a ball, is followed from the link down to the base. Seen from a joint it is turned about
/// the axis; so it stays in the ball around the nearest point of the axis that holds the whole ring.
DhArm::Vector DhArm::reach(int link, const Vector3d& local) const {
  Vector farthest = Vector::Zero(dimension());
  Vector3d center = local;
  double radius = 0;
  for (int j = link - 1; j >= 0; --j) {
    const bool standard = table_.convention == DhConvention::standard;
    const double a = table_.rows(j, kA), d = table_.rows(j, kD);
    const Matrix3d& tilt = tilts_[static_cast<std::size_t>(j)];
    if (standard) center = tilt * center + Vector3d(a, 0, d);  // now seen from the axis
    radius += center.head<2>().norm();
    farthest[j] = radius;
    center = Vector3d(0, 0, center.z());
    if (!standard) center = tilt * (center + Vector3d(0, 0, d)) + Vector3d(a, 0, 0);
  }
  return farthest;
}

double DhArm::steepest(const Vector& reach, int seen_from) const { return reach.tail(reach.size() - seen_from).norm(); }

/// The derivative by angles i <= j <= k is z_i x (z_j x (z_k x (p - o_k))), no longer than the distance from axis k; so
/// it is with one and two. Seen from a link, the joints before it are at rest.
MotionBound DhArm::motion(const Vector& a, const Vector& b, const Vector& reach, int seen_from) const {
  MotionBound bound;
  double before = 0;  // of the rates of the joints nearer to the base
  for (Eigen::Index j = seen_from; j < reach.size(); ++j) {
    const double rates = before + std::abs(b[j] - a[j]);
    bound.speed += (rates - before) * reach[j];
    bound.acceleration += (rates * rates - before * before) * reach[j];
    bound.jerk += (rates * rates * rates - before * before * before) * reach[j];
    before = rates;
  }
  return bound;
}

PointMotion DhArm::moving(const Vector&, const std::vector<Frame>& links, const Vector& way, int link,
                          const Vector3d& point, int seen_from) const {
  PointMotion out{Vector3d::Zero(), Vector3d::Zero()};
  Vector3d turning = Vector3d::Zero();  // of the joints nearer to the base
  for (int j = seen_from; j < link; ++j) {
    const Frame& axis = axis_frame(links, j);
    const Vector3d z = axis.rotation.col(2), swept = z.cross(point - axis.origin);
    out.velocity += way[j] * swept;
    out.acceleration += way[j] * (way[j] * z + 2 * turning).cross(swept);
    turning += way[j] * z;
  }
  return out;
}

}  // namespace leastcost
