// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/tensor/tensor_samples.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

#include "framework/base/symmetric_eigen.hpp"

namespace leastcost {
namespace {

using Entries = Eigen::Matrix<double, 6, 1>;

constexpr double kOtherSheet = -0.5;  ///< cosine of 120 degrees
constexpr double kThickness = 0.5;    ///< of a support along the normal, against its width
constexpr double kSteepest = 0.5;     ///< part of a tensor that its slope may take away within the support
constexpr double kFlattest = 1e-3;    ///< squared ratio of the spreads of the neighbours: below it they lie on a line

Entries entries_of(const Eigen::Matrix3d& t) {
  Entries out;
  out << t(0, 0), t(0, 1), t(0, 2), t(1, 1), t(1, 2), t(2, 2);
  return out;
}

Eigen::Matrix3d tensor_of(const Entries& e) {
  Eigen::Matrix3d t;
  t << e[0], e[1], e[2], e[1], e[3], e[4], e[2], e[4], e[5];
  return t;
}

/// How much of T the slope may add or take per unit of length: the largest |eigenvalue| of T^-1/2 G T^-1/2, over both
/// directions.
double relative_slope(const Eigen::Matrix3d& tensor, const Eigen::Matrix<double, 6, 2>& slopes) {
  const Eigen::LLT<Eigen::Matrix3d> root(tensor);
  double sum = 0;
  for (int k = 0; k < 2; ++k) {
    Eigen::Matrix3d m = root.matrixL().solve(tensor_of(slopes.col(k)));
    m = root.matrixL().solve(m.transpose().eval());
    const Eigen::Matrix3d symmetric = (m + m.transpose()) / 2;
    const double largest = symmetric_eigenvalues(symmetric).cwiseAbs().maxCoeff();
    sum += largest * largest;
  }
  return std::sqrt(sum);
}

/// Slopes of a tensor along x, y and z from its neighbours: least squares in the tangent plane, through the tensor
/// itself.
class SlopeFit {
 public:
  explicit SlopeFit(const Eigen::Vector3d& normal) {
    axes_.col(0) = normal.unitOrthogonal();
    axes_.col(1) = normal.cross(Eigen::Vector3d(axes_.col(0)));
  }
  void add(double weight, const Eigen::Vector3d& offset, const Entries& change) {
    const Eigen::Vector2d q = axes_.transpose() * offset;
    moments_ += weight * q * q.transpose();
    changes_ += weight * change * q.transpose();
  }
  Eigen::Matrix<double, 6, 3> slopes(const Eigen::Matrix3d& tensor, double support) const {
    const Eigen::VectorXd spread = symmetric_eigenvalues(moments_);
    if (!(spread[0] > kFlattest * spread[1])) return Eigen::Matrix<double, 6, 3>::Zero();
    Eigen::Matrix<double, 6, 2> along = changes_ * moments_.inverse();
    const double steepness = relative_slope(tensor, along) * support / kSteepest;
    if (steepness > 1) along /= steepness;
    return along * axes_.transpose();
  }

 private:
  Eigen::Matrix<double, 3, 2> axes_;
  Eigen::Matrix2d moments_ = Eigen::Matrix2d::Zero();
  Eigen::Matrix<double, 6, 2> changes_ = Eigen::Matrix<double, 6, 2>::Zero();
};

std::uint64_t next_id() {
  static std::atomic<std::uint64_t> count{0};
  return ++count;
}

/// What a thread asked for.
struct Answer {
  std::uint64_t id = 0;  ///< of the samples; 0: of none
  int order = 0;
  Eigen::Vector3d x;
  TensorJet jet;
};

/// The last two answers: a path passes on the end of a segment, a search along edges goes back to where it started
/// from.
struct Memory {
  std::array<Answer, 2> answers;
  std::size_t last = 0;
};

Memory& memory() {
  thread_local Memory instance;
  return instance;
}

/// Weighted sums, and their derivatives with respect to x.
template <int Order>
struct Sums {
  double weight = 0;
  Eigen::Vector3d weight_1 = Eigen::Vector3d::Zero();
  Entries weight_2 = Entries::Zero();
  Entries tensor = Entries::Zero();
  Eigen::Matrix<double, 6, 3> tensor_1 = Eigen::Matrix<double, 6, 3>::Zero();
  Eigen::Matrix<double, 6, 6> tensor_2 = Eigen::Matrix<double, 6, 6>::Zero();

  /// A sample at x - y whose weight is t^4, t = 1 - y'Qy, Q = across I + along n n'; tilt = along n'y.
  void add(const Eigen::Vector3d& y, double t, double across, double along, double tilt, const Eigen::Vector3d& n,
           const Eigen::Matrix<double, 6, 4>& polynomial) {
    const Entries value =
        polynomial.col(0) + polynomial.col(1) * y[0] + polynomial.col(2) * y[1] + polynomial.col(3) * y[2];
    const double t2 = t * t, w = t2 * t2;
    weight += w;
    tensor += w * value;
    if constexpr (Order >= 1) {
      const double a = -8 * t2 * t;
      const Eigen::Vector3d q = across * y + tilt * n, dw = a * q;
      weight_1 += dw;
      for (int k = 0; k < 3; ++k) tensor_1.col(k) += dw[k] * value + w * polynomial.col(k + 1);
      if constexpr (Order >= 2) {
        for (int i = 0, column = 0; i < 3; ++i)
          for (int j = i; j < 3; ++j, ++column) {
            const double ddw = 48 * t2 * q[i] * q[j] + a * ((i == j ? across : 0) + along * n[i] * n[j]);
            weight_2[column] += ddw;
            tensor_2.col(column) += ddw * value + dw[i] * polynomial.col(j + 1) + dw[j] * polynomial.col(i + 1);
          }
      }
    }
  }

  void divide(TensorJet& out) const {
    const double s = 1 / weight;
    out.value = s * tensor;
    if constexpr (Order >= 1) out.gradient = s * (tensor_1 - out.value * weight_1.transpose());
    if constexpr (Order >= 2)
      for (int i = 0, column = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j, ++column)
          out.hessian.col(column) = s * (tensor_2.col(column) - out.gradient.col(i) * weight_1[j] -
                                         out.gradient.col(j) * weight_1[i] - out.value * weight_2[column]);
  }
};

}  // namespace

TensorSamples::TensorSamples(const SurfaceSamples& samples, const std::vector<Eigen::Matrix3d>& tensors)
    : id_(next_id()),
      tree_(samples.positions, samples.support),
      place_of_(samples.positions.size()),
      search_(samples.positions) {
  for (const std::int32_t i : tree_.order()) {
    const auto k = static_cast<std::size_t>(i);
    place_of_[k] = static_cast<std::int32_t>(samples_.size());
    Eigen::Matrix<double, 6, 4> polynomial = Eigen::Matrix<double, 6, 4>::Zero();
    polynomial.col(0) = entries_of(tensors[k]);
    const double across = 1 / (samples.support[k] * samples.support[k]);
    const double along = (1 / (kThickness * kThickness) - 1) * across;
    samples_.push_back({samples.positions[k], samples.normals[k], across, along, polynomial});
  }
  fit_slopes(samples, tensors);
}

void TensorSamples::fit_slopes(const SurfaceSamples& samples, const std::vector<Eigen::Matrix3d>& tensors) {
  std::vector<Neighbour> found;
  for (std::size_t place = 0; place < samples_.size(); ++place) {
    const auto i = static_cast<std::size_t>(tree_.order()[place]);
    const Eigen::Vector3d& normal = samples.normals[i];
    if (normal.isZero(0)) continue;
    SlopeFit fit(normal);
    search_.within(samples.positions[i], samples.support[i], found);
    for (const Neighbour& near : found) {
      const auto j = static_cast<std::size_t>(near.index);
      if (samples.oriented && normal.dot(samples.normals[j]) < kOtherSheet) continue;
      const double t = 1 - near.squared_distance * samples_[place].across;
      fit.add(t * t, samples.positions[j] - samples.positions[i], entries_of(tensors[j] - tensors[i]));
    }
    samples_[place].polynomial.rightCols<3>() = fit.slopes(tensors[i], samples.support[i]);
  }
}

template <int Order>
void TensorSamples::evaluate(const Eigen::Vector3d& x, TensorJet& out) const {
  Memory& known = memory();
  const auto knows = [&](const Answer& a) { return a.id == id_ && a.order >= Order && a.x == x; };
  if (!knows(known.answers[known.last])) {
    known.last = 1 - known.last;
    Answer& older = known.answers[known.last];
    if (!knows(older)) {
      interpolate<Order>(x, older.jet);
      older.id = id_;
      older.order = Order;
      older.x = x;
    }
  }
  const Answer& last = known.answers[known.last];
  out.value = last.jet.value;
  if constexpr (Order >= 1) out.gradient = last.jet.gradient;
  if constexpr (Order >= 2) out.hessian = last.jet.hessian;
}

template <int Order>
void TensorSamples::interpolate(const Eigen::Vector3d& x, TensorJet& out) const {
  if (!x.allFinite()) {
    out.value.setConstant(std::numeric_limits<double>::quiet_NaN());
    out.gradient.setZero();
    out.hessian.setZero();
    return;
  }
  Sums<Order> sums;
  tree_.near(x, [&](std::int32_t first, std::int32_t last) {
    for (std::int32_t place = first; place < last; ++place) {
      const Sample& sample = samples_[static_cast<std::size_t>(place)];
      const Eigen::Vector3d y = x - sample.position;
      const double height = sample.normal.dot(y);
      const double t = 1 - sample.across * y.squaredNorm() - sample.along * height * height;
      if (t > 0) sums.add(y, t, sample.across, sample.along, sample.along * height, sample.normal, sample.polynomial);
    }
  });
  if (sums.weight > 0) return sums.divide(out);
  out.gradient.setZero();
  out.hessian.setZero();
  const std::int32_t nearest = search_.nearest(x).index;
  out.value = samples_[static_cast<std::size_t>(place_of_[static_cast<std::size_t>(nearest)])].polynomial.col(0);
}

template void TensorSamples::evaluate<0>(const Eigen::Vector3d&, TensorJet&) const;
template void TensorSamples::evaluate<1>(const Eigen::Vector3d&, TensorJet&) const;
template void TensorSamples::evaluate<2>(const Eigen::Vector3d&, TensorJet&) const;

}  // namespace leastcost
