// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/certificate/certificate.hpp>
#include <leastcost/framework/certificate/to_curve.hpp>
#include <leastcost/framework/energy/path_energy.hpp>

namespace leastcost {

/// The certificate of a chain on a polyhedron that is traced and not straightened: stationarity by bundles, levels by
/// what their traced curves cost. `c`: what was measured of its points; out, the rest.
void certify_polyhedral_chain(const Problem& problem, PathEnergy& energy, const PostProcessed& path,
                              const ToCurve& to_curve, const Monitor& monitor, Certificate& c);

}  // namespace leastcost
