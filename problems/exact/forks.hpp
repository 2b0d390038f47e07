// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "problems/exact/half_edges.hpp"

namespace leastcost {

/// The edges where three or more faces meet: over each of them a path may go on into any other face. Immutable.
class Forks {
 public:
  explicit Forks(const HalfEdges& mesh);

  /// The sides of all faces at the edge of h, h among them; empty where there are fewer than three.
  std::span<const std::int32_t> sides(std::int32_t h) const;

 private:
  const HalfEdges* mesh_;
  std::vector<std::int32_t> sides_;  // by the two ends of their edge
};

}  // namespace leastcost
