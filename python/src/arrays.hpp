// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <vector>

namespace leastcost::python {

/// Real numbers row by row, whatever was given; shapes are checked by the Python files.
using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// Points, one per column (d x n), as a new array with one per row: shape (n, d).
template <class Matrix>
pybind11::array rows_of(const Matrix& points) {
  using Scalar = typename Matrix::Scalar;
  static_assert(!Matrix::IsRowMajor, "columns must be what is contiguous");
  return pybind11::array_t<Scalar>({points.cols(), points.rows()}, points.data());
}

/// The same back: an array of shape (n, d) as d x n.
inline Eigen::MatrixXd columns_of(const Numbers& rows) {
  return Eigen::Map<const Eigen::MatrixXd>(rows.data(), rows.shape(1), rows.shape(0));
}

/// Points in space, shape (n, 3), one by one.
inline std::vector<Eigen::Vector3d> vectors_of(const Numbers& rows) {
  const Eigen::Matrix3Xd columns = columns_of(rows);
  return {columns.colwise().begin(), columns.colwise().end()};
}

}  // namespace leastcost::python
