// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/initializer.hpp>

namespace leastcost {

/// The straight line between the ends (in coordinates; projected when it is sampled). Where the cost is infinite on it,
/// it is bowed out of the way: downwards first, which is where a bead can go.
class StraightInitializer final : public Initializer {
 public:
  std::string_view name() const override { return "straight"; }
  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override;
};

}  // namespace leastcost
