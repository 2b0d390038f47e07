// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>

namespace leastcost::python {

/// Points, one per column (d x n), as a new array with one per row: shape (n, d).
template <class Matrix>
pybind11::array rows_of(const Matrix& points) {
  using Scalar = typename Matrix::Scalar;
  static_assert(!Matrix::IsRowMajor, "columns must be what is contiguous");
  return pybind11::array_t<Scalar>({points.cols(), points.rows()}, points.data());
}

}  // namespace leastcost::python
