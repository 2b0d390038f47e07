// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <leastcost/framework/energy/frames.hpp>

/// \file
/// Products with the small matrices of one point, for sizes that the compiler knows: surfaces in space, the plane,
/// space, arms of six and seven joints. With sizes that it does not know, each took longer than all else that an
/// iteration does at a point.

namespace leastcost {

/// Rows and columns of a point's matrix, Eigen::Dynamic where they are not among the usual ones.
template <int Rows, int Columns>
struct FrameSize {
  static constexpr int kRows = Rows, kColumns = Columns;
};

/// visit(FrameSize): with the numbers themselves where they are the usual ones.
template <class Visit>
void with_frame_size(int rows, int columns, Visit visit) {
  if (rows == 3 && columns == 2) return visit(FrameSize<3, 2>{});
  if (rows == 2 && columns == 2) return visit(FrameSize<2, 2>{});
  if (rows == 3 && columns == 3) return visit(FrameSize<3, 3>{});
  if (rows == 6 && columns == 6) return visit(FrameSize<6, 6>{});
  if (rows == 7 && columns == 7) return visit(FrameSize<7, 7>{});
  visit(FrameSize<Eigen::Dynamic, Eigen::Dynamic>{});
}

/// The matrix of point i among those that lie side by side.
template <class Size>
auto matrix_at(const Points& side_by_side, Size, int columns, Index i) {
  using Matrix = Eigen::Matrix<double, Size::kRows, Size::kColumns>;
  return Eigen::Map<const Matrix>(side_by_side.data() + side_by_side.rows() * columns * i, side_by_side.rows(),
                                  columns);
}

/// Whether the frame of point i is that of the coordinates.
template <class Size>
bool is_plain(const Points& bases, Size size, int k, Index i) {
  return matrix_at(bases, size, k, i).isIdentity(0);
}

/// A square matrix with as many rows as the frames have.
template <class Size>
auto square_of(const Points& m, Size) {
  return Eigen::Map<const Eigen::Matrix<double, Size::kRows, Size::kRows>>(m.data(), m.rows(), m.rows());
}

/// `m` added to a block of a chain, where frames are those of the coordinates.
template <class Size, class Derived>
void add_plain(Size, const Eigen::MatrixBase<Derived>& m, Eigen::Block<Points> out) {
  using Square = Eigen::Matrix<double, Size::kColumns, Size::kColumns>;
  if constexpr (Size::kRows == Size::kColumns)
    Eigen::Map<Square, 0, Eigen::OuterStride<>>(out.data(), out.rows(), out.cols(),
                                                Eigen::OuterStride<>(out.outerStride())) += m;
}

/// T' M S added to `out`, for the frames T and S of points i and j; `m`: in the coordinates of the frames' rows.
template <class Size, class Derived>
void add_in_frames(const Points& bases, Size size, int k, Index i, Index j, const Eigen::MatrixBase<Derived>& m,
                   Eigen::Block<Points> out) {
  using Turned = Eigen::Matrix<double, Size::kRows, Size::kColumns>;
  constexpr int K = Size::kColumns;
  const Turned turned = m.lazyProduct(matrix_at(bases, size, k, j));
  Eigen::Map<Eigen::Matrix<double, K, K>, 0, Eigen::OuterStride<>>(out.data(), k, k,
                                                                   Eigen::OuterStride<>(out.outerStride()))
      .noalias() += matrix_at(bases, size, k, i).transpose().lazyProduct(turned);
}

}  // namespace leastcost
