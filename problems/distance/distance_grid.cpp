// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/distance/distance_grid.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "problems/spline/bspline_line.hpp"

namespace leastcost {

using Eigen::Vector3d;

DistanceGrid::DistanceGrid(const GridShape& shape, std::vector<double> values)
    : shape_(shape),
      row_(static_cast<std::size_t>(shape.count[0]) + 2),
      rows_(static_cast<std::size_t>(shape.count[1]) + 2) {
  if (*std::min_element(shape.count.begin(), shape.count.end()) < GridShape::kFewest)
    throw InputError("a distance grid needs at least " + std::to_string(GridShape::kFewest) +
                     " nodes along every axis, but this one has " + std::to_string(shape.count[0]) + " x " +
                     std::to_string(shape.count[1]) + " x " + std::to_string(shape.count[2]));
  if (values.size() != shape.nodes())
    throw InputError(std::to_string(values.size()) + " values for a grid of " + std::to_string(shape.nodes()) +
                     " nodes");
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    throw InputError("a distance grid has a value that is not finite");
  coefficients_.resize(row_ * rows_ * (static_cast<std::size_t>(shape.count[2]) + 2));
  for (int k = 0; k < shape.count[2]; ++k)
    for (int j = 0; j < shape.count[1]; ++j)
      std::copy_n(values.data() + shape.index(0, j, k), shape.count[0], &coefficients_[padded(1, j + 1, k + 1)]);
  values = {};
  filter();
}

void DistanceGrid::filter() {
  const auto& n = shape_.count;
  for (int k = 1; k <= n[2]; ++k) {
    for (int j = 1; j <= n[1]; ++j) to_bspline_coefficients(&coefficients_[padded(1, j, k)], n[0], 1, 1);
    to_bspline_coefficients(&coefficients_[padded(0, 1, k)], n[1], row_, row_);
  }
  to_bspline_coefficients(&coefficients_[padded(0, 0, 1)], n[2], row_ * rows_, row_ * rows_);
}

bool DistanceGrid::locate(const Vector3d& x, std::array<int, 3>& from, Vector3d& place) const {
  const Vector3d t = (x - shape_.origin) / shape_.cell;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Index>(k);
    const int last = shape_.count[k] - 1;
    if (!(t[axis] >= 0 && t[axis] <= last)) return false;
    from[k] = std::min(static_cast<int>(t[axis]), last - 1);
    place[axis] = t[axis] - from[k];
  }
  return true;
}

double DistanceGrid::evaluate(const Vector3d& x, Vector3d& gradient) const {
  std::array<int, 3> from;
  Vector3d place;
  if (!locate(x, from, place)) {
    gradient.setConstant(std::numeric_limits<double>::quiet_NaN());
    return std::numeric_limits<double>::quiet_NaN();
  }
  const BsplineWeights wx(place[0]), wy(place[1]), wz(place[2]);
  double value = 0, dx = 0, dy = 0, dz = 0;
  for (int k = 0; k < 4; ++k) {
    const double* c = &coefficients_[padded(from[0], from[1], from[2] + k)];
    double plane = 0, plane_x = 0, plane_y = 0;
    for (int j = 0; j < 4; ++j, c += row_) {
      const double line = wx.w[0] * c[0] + wx.w[1] * c[1] + wx.w[2] * c[2] + wx.w[3] * c[3];
      const double line_x = wx.d[0] * c[0] + wx.d[1] * c[1] + wx.d[2] * c[2] + wx.d[3] * c[3];
      plane += wy.w[j] * line;
      plane_x += wy.w[j] * line_x;
      plane_y += wy.d[j] * line;
    }
    value += wz.w[k] * plane;
    dx += wz.w[k] * plane_x;
    dy += wz.w[k] * plane_y;
    dz += wz.d[k] * plane;
  }
  gradient = Vector3d(dx, dy, dz) / shape_.cell;
  return value;
}

void DistanceGrid::evaluate(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> value,
                            Eigen::Ref<Points> gradients) const {
  Vector3d gradient;
  value[0] = evaluate(Vector3d(x), gradient);
  gradients.col(0) = gradient;
}

void DistanceGrid::curvature(const Eigen::Ref<const Eigen::VectorXd>& x,
                             const Eigen::Ref<const Eigen::VectorXd>& weights, Eigen::Ref<Points> out) const {
  std::array<int, 3> from;
  Vector3d place;
  if (!locate(x, from, place)) return out.setConstant(std::numeric_limits<double>::quiet_NaN()), void();
  const BsplineWeights w[3] = {BsplineWeights(place[0]), BsplineWeights(place[1]), BsplineWeights(place[2])};
  double second[3][4];
  for (int axis = 0; axis < 3; ++axis) {
    const double u = place[axis], v = 1 - u;
    const double of_axis[4] = {v, 3 * u - 2, 3 * v - 2, u};
    std::copy_n(of_axis, 4, second[axis]);
  }
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  for (int k = 0; k < 4; ++k) {
    const double* c = &coefficients_[padded(from[0], from[1], from[2] + k)];
    for (int j = 0; j < 4; ++j, c += row_) {
      double line = 0, line_x = 0, line_xx = 0;
      for (int i = 0; i < 4; ++i) {
        line += w[0].w[i] * c[i];
        line_x += w[0].d[i] * c[i];
        line_xx += second[0][i] * c[i];
      }
      xx += w[2].w[k] * w[1].w[j] * line_xx;
      xy += w[2].w[k] * w[1].d[j] * line_x;
      xz += w[2].d[k] * w[1].w[j] * line_x;
      yy += w[2].w[k] * second[1][j] * line;
      yz += w[2].d[k] * w[1].d[j] * line;
      zz += second[2][k] * w[1].w[j] * line;
    }
  }
  out << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  out *= weights[0] / (shape_.cell * shape_.cell);
}

double DistanceGrid::at_node(int i, int j, int k) const {
  constexpr double kWeights[3] = {1.0 / 6, 2.0 / 3, 1.0 / 6};
  double value = 0;
  for (int c = 0; c < 3; ++c)
    for (int b = 0; b < 3; ++b)
      for (int a = 0; a < 3; ++a)
        value += kWeights[a] * kWeights[b] * kWeights[c] * coefficients_[padded(i + a, j + b, k + c)];
  return value;
}

std::array<double, 64> DistanceGrid::coefficients_of_cell(int i, int j, int k) const {
  std::array<double, 64> all{};
  auto to = all.begin();
  for (int c = 0; c < 4; ++c)
    for (int b = 0; b < 4; ++b) to = std::copy_n(&coefficients_[padded(i, j + b, k + c)], 4, to);
  return all;
}

DistanceGrid DistanceGrid::every_second() const {
  const GridShape half = leastcost::every_second(shape_);
  std::vector<double> values;
  values.reserve(half.nodes());
  for (int k = 0; k < half.count[2]; ++k)
    for (int j = 0; j < half.count[1]; ++j)
      for (int i = 0; i < half.count[0]; ++i) values.push_back(at_node(2 * i, 2 * j, 2 * k));
  return DistanceGrid(half, std::move(values));
}

DistanceGrid DistanceGrid::raised(double rise) const {
  DistanceGrid result = *this;
  for (double& c : result.coefficients_) c += rise;  // the weights of the coefficients add up to 1
  return result;
}

}  // namespace leastcost
