// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

struct SwitchbackOptions {
  double width = 0;  ///< length units, greater than 0
  void fields(FieldVisitor& visit);
};

/// Draws the zigzag that a path stands for where its cost is a hull (MixesMoves; walking where it is steep): legs on
/// both sides of the path, no further from each other than `width`, that begin and end with each stretch of it. On a
/// plane they cost what the path costs, elsewhere more by a part of the order of width over the size of the terrain's
/// features; a note says how much. The chain stays as it is.
class SwitchbackPostProcessor final : public PostProcessor {
 public:
  /// Throws OptionError.
  explicit SwitchbackPostProcessor(const SwitchbackOptions& options);
  std::string_view name() const override { return "switchbacks"; }
  /// Throws InputError for a cost that is no hull, and on meshes.
  PostProcessed apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                      const Monitor& monitor) const override;

 private:
  double width_;
};

}  // namespace leastcost
