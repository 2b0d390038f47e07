// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include <leastcost/framework/cost/segment_derivatives.hpp>
#include <leastcost/problems/robots/dh_arm.hpp>

namespace leastcost {

template <class S>
using Vector3 = Eigen::Matrix<S, 3, 1>;
template <class S>
using Matrix3 = Eigen::Matrix<S, 3, 3>;

/// As Eigen's, for duals too, whose cross product would need more of Eigen's headers than this takes to write.
template <class S, class T>
Vector3<decltype(S() * T())> cross_product(const Vector3<S>& a, const Vector3<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Where the links of an arm are, in any scalar: what costs differentiate. Link i is moved by joints 0 to i.
template <class S>
struct ArmFrames {
  std::vector<Matrix3<S>> rotations;      ///< of the frame of each row of the table
  std::vector<Vector3<S>> origins;        ///< of these
  std::vector<Vector3<S>> axes, on_axes;  ///< of the joints: directions, and points

  Vector3<S> at(std::size_t link, const Eigen::Vector3d& local) const {
    return origins[link] + rotations[link] * local.cast<S>();
  }
  /// The derivative of a point (space) of a link by a joint of it.
  Vector3<S> swept(std::size_t joint, const Vector3<S>& point) const {
    return cross_product<S, S>(axes[joint], Vector3<S>(point - on_axes[joint]));
  }
};

template <class S>
ArmFrames<S> arm_frames(const DhTable& table, const Point<S, Eigen::Dynamic>& angles) {
  using std::cos, std::sin;
  const auto joints = static_cast<std::size_t>(table.rows.rows());
  ArmFrames<S> out;
  Matrix3<S> rotation = Matrix3<S>::Identity();
  Vector3<S> origin = table.base.cast<S>();
  const auto turn = [&](int first, const S& c, const S& s) {  // two columns, about the third one
    const int second = (first + 1) % 3;
    const Vector3<S> x = rotation.col(first), y = rotation.col(second);
    rotation.col(first) = c * x + s * y;
    rotation.col(second) = c * y - s * x;
  };
  for (std::size_t i = 0; i < joints; ++i) {
    const auto row = table.rows.row(static_cast<Index>(i));
    const S angle = angles[static_cast<Index>(i)] + row[3], c = cos(angle), s = sin(angle);
    const S tilt_c = S(std::cos(row[1])), tilt_s = S(std::sin(row[1])), along_x = S(row[0]), along_z = S(row[2]);
    const auto advance = [&] { origin += along_x * rotation.col(0) + along_z * rotation.col(2); };
    const auto note_axis = [&] {
      out.axes.push_back(rotation.col(2));
      out.on_axes.push_back(origin);
    };
    if (table.convention == DhConvention::standard) {
      note_axis();
      turn(0, c, s);
      advance();
      turn(1, tilt_c, tilt_s);
    } else {
      turn(1, tilt_c, tilt_s);
      advance();
      note_axis();
      turn(0, c, s);
    }
    out.rotations.push_back(rotation);
    out.origins.push_back(origin);
  }
  return out;
}

}  // namespace leastcost
