// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// A symmetric block-tridiagonal matrix with k x k blocks, the shape of every chain Hessian; with corner blocks for a
/// ring. Block Cholesky in O(n k^3), reusable without allocation.
///
///     A_0  B_0            B_{n-1}'     ring only: B_{n-1} couples x_{n-1} (rows) with x_0 (columns)
///     B_0' A_1  B_1
///          B_1' A_2  ...
///     B_{n-1}             A_{n-1}
///
/// A ring is factored as the chain x_1 .. x_{n-1}, then the Schur complement of x_0 (docs/numerics.md Sec. 3.5).
class ChainSystem {
 public:
  /// Room for `count` blocks of this size, with a last coupling in a ring.
  void resize(int block, Index count, bool ring);
  /// All entries become 0.
  void set_zero();
  int block() const { return k_; }        ///< rows of a block
  Index count() const { return n_; }      ///< number of blocks
  Index size() const { return k_ * n_; }  ///< rows of the matrix
  bool ring() const { return ring_; }     ///< whether the last block is coupled to the first

  Eigen::Block<Points> diagonal(Index i) { return a_.block(0, k_ * i, k_, k_); }  ///< the block of point i with itself
  Eigen::Block<const Points> diagonal(Index i) const { return a_.block(0, k_ * i, k_, k_); }
  /// Block (i, i + 1); in a ring (n - 1, 0) for i = n - 1.
  Eigen::Block<Points> coupling(Index i) { return b_.block(0, k_ * i, k_, k_); }
  Eigen::Block<const Points> coupling(Index i) const { return b_.block(0, k_ * i, k_, k_); }

  /// this += factor * other, of the same shape.
  void add(double factor, const ChainSystem& other);

  /// Block Cholesky. False when the matrix is not (numerically) positive definite; solve() then means nothing.
  /// Throws Interrupted when it meets the deadline; so does every other pass through the chain that takes one.
  bool factor(const Deadline& deadline = {});
  /// x := A^-1 x, after factor() returned true.
  void solve(Eigen::VectorXd& x) const;
  /// x := L^-1 x and x := L^-T x for A = L L', the two halves of solve(): with z = L' x the quadratic x'Ax is |z|^2,
  /// which makes a change of variables of them (docs/numerics.md Sec. 3.6).
  void solve_lower(Eigen::VectorXd& x) const;
  void solve_upper(Eigen::VectorXd& x) const;  ///< x := L^-T x, see solve_lower().
  /// y := A x.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;
  /// Number of negative eigenvalues, from the signs of all block pivots (Sylvester). Independent of factor().
  int negative_eigenvalues(const Deadline& deadline = {}) const;
  /// A vector x with x'Ax < 0 from the first negative pivot, by back substitution; empty where there is none.
  Eigen::VectorXd negative_direction(const Deadline& deadline = {}) const;

 private:
  /// Block elimination that goes on through indefinite pivots. The inverse of a pivot is never formed: with R =
  /// |D|^-1/2 V' of its eigenvalues D and vectors V it is R' sign(D) R, and what R does to a stiff coupling is right to
  /// rounding where the inverse would lose the square of the condition.
  struct Elimination {
    std::vector<Points> root, border;    ///< R of the pivots; ring: their coupling to x_0
    std::vector<Eigen::VectorXd> signs;  ///< of D
    int negatives = 0;
    Index first_negative = -1;  ///< pivot, -1: none
    Eigen::VectorXd negative;   ///< its eigenvector
  };
  Elimination eliminate(const Deadline& deadline) const;

  template <class Kernels>
  bool factor_blocks(const Kernels& of, const Deadline& deadline);
  template <class Kernels>
  void solve_lower_blocks(const Kernels& of, double* x) const;
  template <class Kernels>
  void solve_upper_blocks(const Kernels& of, double* x) const;
  template <class Kernels>
  void multiply_blocks(const Kernels& of, const double* x, double* y) const;

  int k_ = 0;
  Index n_ = 0;
  bool ring_ = false;
  Points a_, b_;           ///< diagonal and coupling blocks side by side, k x kn
  Points l_, w_, border_;  ///< Cholesky factors L_i; W_i = L_i^-1 B_i; ring: L_i^-1 (coupling to x_0)
};

}  // namespace leastcost
