// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace leastcost {

/// Ability of a domain: it is two-dimensional and lies in R^3, so that planes cut it in curves.
class IsSurface {
 public:
  static constexpr std::string_view kAbility = "surface";
  virtual ~IsSurface() = default;
  /// Whether this one is; the zeros of a function are a surface in R^3 alone.
  virtual bool is_surface() const { return true; }
  bool present() const { return is_surface(); }
};

}  // namespace leastcost
