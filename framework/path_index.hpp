// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/certificate.hpp>
#include <leastcost/framework/chain_model.hpp>
#include <leastcost/framework/path_energy.hpp>

namespace leastcost {

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
