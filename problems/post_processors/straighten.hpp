// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

/// The exact locally shortest polyhedral path, or closed curve of a ring, of the same class: unfolding and string
/// pulling, VFCS goes no further than the chords. Keeps the solved path only if, straightened, it is not longer than
/// the straightened first path, and a solved ring only if it does not contract while the first one holds. A ring that
/// contracts to a point is reported as collapsed. Needs a mesh and a cost with a constant metric; elsewhere apply()
/// throws InputError that says so.
class StraightenPostProcessor final : public PostProcessor {
 public:
  std::string_view name() const override { return "straighten"; }
  PostProcessed apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                      const Monitor& monitor) const override;
};

}  // namespace leastcost
