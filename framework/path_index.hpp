// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include <leastcost/framework/chain_model.hpp>
#include <leastcost/framework/path_energy.hpp>

namespace leastcost {

enum class IndexVerdict { not_applicable, minimum, saddle, degenerate };
std::string_view name(IndexVerdict verdict);

/// Morse index of the path by counting negative pivots of the exact chain Hessian H (Sylvester's law of inertia), and
/// of H + tau P, H - tau P with P the Gauss-Newton Hessian.
struct PathIndex {
  IndexVerdict verdict = IndexVerdict::not_applicable;
  int negatives = 0;     ///< of H
  int saddle_order = 0;  ///< negatives of H + tau P
  int nullity = 0;       ///< negatives of H - tau P, minus the above
};

/// Both chain Hessians at a path, in the same frames.
struct ChainHessians {
  ChainModel model;
  ChainSystem exact, gauss_newton;
};
/// Nothing where there is no exact one: on polyhedra, for kernels that are not strictly convex, where the energy is not
/// finite.
std::optional<ChainHessians> chain_hessians(PathEnergy& energy, const CoordinatePath& path);

/// Morse index of a path, docs/numerics.md Sec. 6.4. `shift` is tau. Not applicable on polyhedra and for kernels that
/// are not strictly convex.
PathIndex path_index(PathEnergy& energy, const CoordinatePath& path, double shift);

}  // namespace leastcost
