// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include <leastcost/framework/base/words.hpp>
#include <leastcost/framework/energy/chain_model.hpp>
#include <leastcost/framework/energy/path_energy.hpp>

namespace leastcost {

/// undecidable: rounding alone could make the count.
enum class IndexVerdict { not_applicable, minimum, saddle, degenerate, undecidable };
Words<IndexVerdict> words(IndexVerdict);

/// Morse index of the path by counting negative pivots of the exact chain Hessian H (Sylvester's law of inertia), and
/// of H + tau P, H - tau P with P the Gauss-Newton Hessian.
struct PathIndex {
  IndexVerdict verdict = IndexVerdict::not_applicable;  ///< minimum, saddle, or why it is not known
  int negatives = 0;                                    ///< of H
  int saddle_order = 0;                                 ///< negatives of H + tau P
  int nullity = 0;                                      ///< negatives of H - tau P, minus the above
  /// Of a degenerate one: the least lambda with H x = lambda P x, to within a tenth; it lies between -tau and tau.
  std::optional<double> softest;
};

/// Whether every stationary path is the only minimum: the cost is a norm and straight moves stay in the domain, so that
/// the energy is a strictly convex function of the points.
bool is_convex(const Problem& problem);

/// Both chain Hessians at a path, in the same frames.
struct ChainHessians {
  ChainModel model;                 ///< energy and frames
  ChainSystem exact, gauss_newton;  ///< both kinds of Hessian, in the frames
};
/// Nothing where there is no exact one: on polyhedra, for kernels that are not strictly convex, where the energy is not
/// finite.
std::optional<ChainHessians> chain_hessians(PathEnergy& energy, const CoordinatePath& path);

/// Morse index of a path, docs/numerics.md Sec. 6.4. `shift` is tau. Not applicable on polyhedra and for kernels that
/// are not strictly convex. Nothing is counted where the problem is convex.
PathIndex path_index(PathEnergy& energy, const CoordinatePath& path, double shift);

}  // namespace leastcost
