// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/certificate/certificate.hpp>
#include <leastcost/framework/problem/post_processor.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// It certifies itself: no angle beside it is below pi, so no path nearby is shorter. Of the shortest path a proof
/// over all paths speaks, where there is one. Nothing is said about the smooth surface behind the mesh. Among
/// obstacles in the plane what is locally shortest is the shortest of its class; in space nothing is but what was
/// measured. At interfaces of the cost Snell's law takes the place of the angles.
/// `c`: what was measured of its points; out, the rest.
void certify_straightened(const Problem& problem, const PostProcessed& path, const CertificateOptions& options,
                          Certificate& c);

}  // namespace leastcost
