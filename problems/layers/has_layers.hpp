// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include <leastcost/problems/layers/layer_stack.hpp>

namespace leastcost {

/// Ability of a cost: it is the length, weighted by the index of the layers that a move passes. Refraction needs it.
class HasLayers {
 public:
  static constexpr std::string_view kAbility = "stack of layers";
  virtual ~HasLayers() = default;
  virtual const LayerStack& layers() const = 0;  ///< the layers
};

}  // namespace leastcost
