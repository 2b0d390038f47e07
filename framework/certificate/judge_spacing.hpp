// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/certificate/certificate.hpp>
#include <leastcost/framework/energy/path_energy.hpp>

namespace leastcost {

/// Judges the spacing of a chain by that of its levels (docs/numerics.md Sec. 6.1). `hugs_bound`: a point rests on a
/// bound.
void judge_spacing(const Problem& problem, PathEnergy& energy, const CoordinatePath& chain,
                   const CertificateOptions& options, bool hugs_bound, Certificate& c);

}  // namespace leastcost
