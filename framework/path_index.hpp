// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/certificate.hpp"
#include "framework/path_energy.hpp"

namespace leastcost {

/// Morse index of a path, NUMERICS Sec. 6. `shift` is tau. Not applicable on polyhedra and for kernels that are not strictly convex.
PathIndex path_index(PathEnergy& energy, const CoordinatePath& path, double shift);

}  // namespace leastcost
