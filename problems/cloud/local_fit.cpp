// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cloud/local_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace leastcost {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int kFitRounds = 3;
constexpr int kRoundsFromNormal = 2;
constexpr double kApart = 0.125;  // of the radius
constexpr int kFewestForPlane = 5;
constexpr double kMadToSigma = 1.4826;    // of a normal distribution
constexpr double kTukey = 4.685;          // 95 % efficiency on normal residuals
constexpr double kSmallestScale = 1e-10;  // of the radius: exact data has no scale
constexpr double kLine = 1e-6;            // middle eigenvalue over the largest: the points lie on a line

double compact_weight(double squared, double radius) {
  const double t = 1 - squared / (radius * radius);
  return t > 0 ? t * t : 0;
}

/// The direction of least spread; zero where the points lie on a line or coincide.
Eigen::Vector3d principal_normal(const std::vector<Eigen::Vector3d>& offsets, double radius) {
  double sum = 0;
  int count = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& q : offsets) {
    const double w = compact_weight(q.squaredNorm(), radius);
    sum += w;
    mean += w * q;
    if (w > 0) ++count;
  }
  if (count < kFewestForPlane) return Eigen::Vector3d::Zero();
  mean /= sum;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& q : offsets)
    covariance += compact_weight(q.squaredNorm(), radius) * (q - mean) * (q - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  if (!(solver.eigenvalues()[1] > kLine * solver.eigenvalues()[2])) return Eigen::Vector3d::Zero();
  return solver.eigenvectors().col(0);
}

/// One least-squares problem after the other over the same neighbourhood.
class HeightField {
 public:
  HeightField(const std::vector<Eigen::Vector3d>& offsets, double radius)
      : offsets_(offsets), radius_(radius), trust_(offsets.size(), 1.0), residuals_(offsets.size()) {}

  bool fit(const Eigen::Vector3d& normal) {
    normal_ = normal;
    e1_ = normal.unitOrthogonal();
    e2_ = normal.cross(e1_);
    Matrix6 a = Matrix6::Zero();
    Vector6 b = Vector6::Zero();
    for (std::size_t i = 0; i < offsets_.size(); ++i) {
      const double w = trust_[i] * compact_weight(offsets_[i].squaredNorm(), radius_);
      if (!(w > 0)) continue;
      const Vector6 row = terms(offsets_[i]);
      a.selfadjointView<Eigen::Lower>().rankUpdate(row, w);
      b += w * normal_.dot(offsets_[i]) / radius_ * row;
    }
    const Eigen::LDLT<Matrix6> factors(a.selfadjointView<Eigen::Lower>());
    const Vector6 pivots = factors.vectorD();
    if (!(pivots.minCoeff() > 1e-12 * pivots.maxCoeff())) return false;
    coefficients_ = factors.solve(b);
    return true;
  }

  /// Robust scale of the residuals; trust from it.
  double reweight() {
    for (std::size_t i = 0; i < offsets_.size(); ++i)
      residuals_[i] = std::abs(normal_.dot(offsets_[i]) - radius_ * coefficients_.dot(terms(offsets_[i])));
    sorted_ = residuals_;
    const auto middle = sorted_.begin() + static_cast<std::ptrdiff_t>(sorted_.size() / 2);
    std::nth_element(sorted_.begin(), middle, sorted_.end());
    const double scale = std::max(kMadToSigma * *middle, kSmallestScale * radius_);
    for (std::size_t i = 0; i < offsets_.size(); ++i) {
      const double t = residuals_[i] / (kTukey * scale);
      trust_[i] = t < 1 ? (1 - t * t) * (1 - t * t) : 0;
    }
    return scale;
  }

  /// Part of the neighbours that are no noise: another sheet, or the far side of an edge.
  double apart() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < residuals_.size(); ++i)
      if (!(trust_[i] > 0) && residuals_[i] > kApart * radius_) ++count;
    return static_cast<double>(count) / static_cast<double>(residuals_.size());
  }

  Eigen::Vector3d surface_normal() const {
    return (normal_ - coefficients_[1] * e1_ - coefficients_[2] * e2_).normalized();
  }
  /// Second fundamental form with both indices raised, carried to R^3.
  Eigen::Matrix3d shape() const {
    const double slope_u = coefficients_[1], slope_v = coefficients_[2];
    Eigen::Matrix<double, 3, 2> tangents;
    tangents << e1_ + slope_u * normal_, e2_ + slope_v * normal_;
    Eigen::Matrix2d second;
    second << 2 * coefficients_[3], coefficients_[4], coefficients_[4], 2 * coefficients_[5];
    second /= radius_ * std::sqrt(1 + slope_u * slope_u + slope_v * slope_v);
    const Eigen::Matrix2d inverse = (tangents.transpose() * tangents).inverse();
    return tangents * inverse * second * inverse * tangents.transpose();
  }
  /// Of the centre, along the fitted normal.
  double height() const {
    return -radius_ * coefficients_[0] /
           std::sqrt(1 + coefficients_[1] * coefficients_[1] + coefficients_[2] * coefficients_[2]);
  }

 private:
  Vector6 terms(const Eigen::Vector3d& q) const {
    const double u = e1_.dot(q) / radius_, v = e2_.dot(q) / radius_;
    Vector6 row;
    row << 1, u, v, u * u, u * v, v * v;
    return row;
  }

  const std::vector<Eigen::Vector3d>& offsets_;
  double radius_;
  std::vector<double> trust_, residuals_, sorted_;
  Eigen::Vector3d normal_, e1_, e2_;
  Vector6 coefficients_;
};

}  // namespace

LocalFit fit_locally(const std::vector<Eigen::Vector3d>& offsets, double radius) {
  LocalFit result;
  if (offsets.size() < kFewestForFit) return result;
  // The inner half sees less of another sheet, if it sees enough at all.
  Eigen::Vector3d normal = principal_normal(offsets, radius / 2);
  if (normal.isZero(0)) normal = principal_normal(offsets, radius);
  if (normal.isZero(0)) return result;
  HeightField field(offsets, radius);
  for (int round = 0; round < kFitRounds; ++round) {
    if (!field.fit(normal)) return result;
    normal = field.surface_normal();
    result.scale = field.reweight();
    result.normal = normal;
    result.height = field.height();
    result.apart = field.apart();
    result.valid = true;
  }
  result.shape = field.shape();
  return result;
}

LocalFit fit_locally(const std::vector<Eigen::Vector3d>& offsets, double radius, const Eigen::Vector3d& normal) {
  LocalFit result;
  if (offsets.size() < kFewestForFit) return result;
  HeightField field(offsets, radius);
  result.normal = normal;
  for (int round = 0; round < kRoundsFromNormal; ++round) {
    if (!field.fit(result.normal)) return result;
    result.normal = field.surface_normal();
  }
  result.height = field.height();
  result.shape = field.shape();
  result.valid = true;
  return result;
}

}  // namespace leastcost
