// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/string_program.hpp"

#include <algorithm>
#include <cmath>

namespace leastcost {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kFirstGap = 1e-3;   ///< slacks begin at no less
constexpr double kLastGap = 1e-14;   ///< of slack times multiplier
constexpr double kGoodGap = 1e-10;   ///< the same, where rounding leaves no more
constexpr double kBold = 0.1;        ///< of that, after a step that went nearly all of its way
constexpr double kCareful = 0.5;     ///< and after one that could not
constexpr double kToBorder = 0.995;  ///< of the way to where a slack or a multiplier is 0
constexpr double kLongWay = 0.8, kNoWay = 0.01;
constexpr double kFeasible = 1e-12;
constexpr int kMostSteps = 80;

/// The inverse of a symmetric positive definite matrix by its Cholesky factor: near the border of half-spaces they are
/// as badly conditioned as can be, which cofactors do not stand.
Matrix3d inverse_of(const Matrix3d& a) {
  Matrix3d root = Matrix3d::Zero();  // the inverse of the factor, lower triangular
  const double l00 = std::sqrt(a(0, 0)), l10 = a(1, 0) / l00, l20 = a(2, 0) / l00;
  const double l11 = std::sqrt(a(1, 1) - l10 * l10), l21 = (a(2, 1) - l20 * l10) / l11;
  const double l22 = std::sqrt(a(2, 2) - l20 * l20 - l21 * l21);
  root(0, 0) = 1 / l00;
  root(1, 1) = 1 / l11;
  root(2, 2) = 1 / l22;
  root(1, 0) = -l10 * root(0, 0) / l11;
  root(2, 1) = -l21 * root(1, 1) / l22;
  root(2, 0) = -(l20 * root(0, 0) + l21 * root(1, 0)) / l22;
  return root.transpose() * root;
}

/// Springs to both neighbours and, at each vertex, a matrix of its own: solved by elimination along the string.
class BlockTridiagonal {
 public:
  explicit BlockTridiagonal(const VectorXd& rest) : springs_(rest.cwiseInverse()) {
    const Index m = rest.size() - 1;  // free vertices
    own_.resize(static_cast<std::size_t>(m));
  }
  void reset() {
    for (std::size_t i = 0; i < own_.size(); ++i)
      own_[i] = (springs_[static_cast<Index>(i)] + springs_[static_cast<Index>(i) + 1]) * Matrix3d::Identity();
  }
  /// Of the free vertex i, from 0.
  Matrix3d& own(Index i) { return own_[static_cast<std::size_t>(i)]; }
  /// Replaces b, 3 x m, by the solution.
  void solve(Eigen::Ref<Matrix3Xd> b) {
    const Index m = b.cols();
    for (Index i = 0; i < m; ++i) {
      Matrix3d& block = own(i);
      if (i > 0) {
        const double spring = springs_[i];
        block -= spring * spring * own(i - 1);  // which is the inverse there by now
        b.col(i) += spring * (own(i - 1) * b.col(i - 1));
      }
      block = inverse_of(block);
    }
    for (Index i = m - 1; i >= 0; --i) {
      if (i + 1 < m) b.col(i) += springs_[i + 1] * b.col(i + 1);
      b.col(i) = Vector3d(own(i) * b.col(i));
    }
  }

 private:
  VectorXd springs_;
  std::vector<Matrix3d> own_;
};

/// What the springs and the pull do to the free vertices: minus the gradient.
Matrix3Xd force(const Matrix3Xd& x, const VectorXd& rest, const Matrix3Xd& pull) {
  const Index m = x.cols() - 2;
  Matrix3Xd f(3, m);
  for (Index i = 0; i < m; ++i)
    f.col(i) = (x.col(i) - x.col(i + 1)) / rest[i] + (x.col(i + 2) - x.col(i + 1)) / rest[i + 1];
  if (pull.size() > 0) f += pull.middleCols(1, m);
  return f;
}

/// The longest step, at most 1, that leaves all of `values` above 0.
double step_within(const VectorXd& values, const VectorXd& change) {
  double step = 1;
  for (Index k = 0; k < values.size(); ++k)
    if (change[k] < 0) step = std::min(step, -kToBorder * values[k] / change[k]);
  return step;
}

}  // namespace

Matrix3Xd least_stretched(const Matrix3Xd& x, const VectorXd& rest, const std::vector<HalfSpace>& half_spaces,
                          const Matrix3Xd& pull) {
  const Index m = x.cols() - 2, count = static_cast<Index>(half_spaces.size());
  if (m < 1) return x;
  const auto distances = [&](const Matrix3Xd& at) {
    VectorXd all(count);
    for (Index k = 0; k < count; ++k) {
      const HalfSpace& h = half_spaces[static_cast<std::size_t>(k)];
      all[k] = h.normal.dot(at.col(h.vertex)) - h.offset;
    }
    return all;
  };
  Matrix3Xd y = x;
  VectorXd slack = distances(y).cwiseMax(kFirstGap);
  VectorXd multiplier = kFirstGap * slack.cwiseInverse();
  BlockTridiagonal system(rest);
  double gap = count > 0 ? slack.dot(multiplier) / static_cast<double>(count) : 0;
  bool bold = true;
  for (int step = 0; step < kMostSteps; ++step) {
    const VectorXd off = distances(y) - slack;
    if (step > 0 && gap <= kLastGap && (count == 0 || off.cwiseAbs().maxCoeff() <= kFeasible)) break;
    const double wanted = (bold ? kBold : kCareful) * gap;
    system.reset();
    Matrix3Xd way = force(y, rest, pull);
    for (Index k = 0; k < count; ++k) {
      const HalfSpace& h = half_spaces[static_cast<std::size_t>(k)];
      const Index i = h.vertex - 1;
      system.own(i) += multiplier[k] / slack[k] * h.normal * h.normal.transpose();
      way.col(i) += (wanted - multiplier[k] * off[k]) / slack[k] * h.normal;
    }
    system.solve(way);
    VectorXd slack_change(count), multiplier_change(count);
    for (Index k = 0; k < count; ++k) {
      const HalfSpace& h = half_spaces[static_cast<std::size_t>(k)];
      slack_change[k] = h.normal.dot(way.col(h.vertex - 1)) + off[k];
      multiplier_change[k] = (wanted - slack[k] * multiplier[k] - multiplier[k] * slack_change[k]) / slack[k];
    }
    if (!way.allFinite()) break;
    const double length = std::min(step_within(slack, slack_change), step_within(multiplier, multiplier_change));
    if (gap <= kGoodGap && length < kNoWay) break;
    bold = length > kLongWay;
    y.middleCols(1, m) += length * way;
    slack += length * slack_change;
    multiplier += length * multiplier_change;
    gap = count > 0 ? slack.dot(multiplier) / static_cast<double>(count) : 0;
  }
  const bool within = count == 0 || distances(y).minCoeff() >= -2 * kFeasible;
  return within && y.allFinite() ? y : x;
}

}  // namespace leastcost
