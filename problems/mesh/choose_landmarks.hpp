// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/mesh/edge_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include "problems/mesh/edge_landmarks.hpp"

namespace leastcost {

/// As many landmarks as asked for, far from each other; fewer where a component has fewer vertices or `stop` said so. A
/// search over the whole component each. The first lie in the largest component.
EdgeLandmarks choose_landmarks(const TriangleMesh& mesh, int count, const MetricRoot& metric = {},
                               const StopPredicate& stop = {});

}  // namespace leastcost
