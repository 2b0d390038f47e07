// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

/// The least-cost path among those that pass the same layers in the same order as the first path, or the solved one if
/// that is cheaper: straight legs, crossings by Snell's law, points equally spaced in cost on that polyline. Loops that
/// no path through constant layers is worth are cut short first. Needs a cost with layers, and R^d or a box without
/// obstacles; elsewhere, and for rings, apply() throws InputError that says so.
class RefractPostProcessor final : public PostProcessor {
 public:
  std::string_view name() const override { return "refract"; }
  bool finds_its_own() const override { return true; }
  PostProcessed apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                      const Monitor& monitor) const override;
};

}  // namespace leastcost
