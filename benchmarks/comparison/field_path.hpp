// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/fields/descent.hpp>
#include "benchmarks/comparison/methods.hpp"

namespace leastcost::comparison {

/// The distance that a field of a source has at the target, and the path traced down the field.
inline Answer path_down(const TriangleMesh& mesh, const std::vector<double>& field, std::int32_t source,
                        std::int32_t target) {
  Answer answer;
  answer.distance = field[static_cast<std::size_t>(target)];
  Descent descent = descend(mesh, field, vertex_point(mesh, target), vertex_point(mesh, source));
  answer.path = reversed(descent.path);
  if (descent.by_edges) answer.note = "the field has a minimum of its own";
  return answer;
}

}  // namespace leastcost::comparison
