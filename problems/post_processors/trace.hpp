// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

/// The chain as a polyline on the mesh: face sequence and edge crossings. VFCS 4.4.3, Fig. 5, Eq. (16).
class TracePostProcessor final : public PostProcessor {
 public:
  std::string_view name() const override { return "trace"; }
  PostProcessed apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                      const Monitor& monitor) const override;
};

}  // namespace leastcost
