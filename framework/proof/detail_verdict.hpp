// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

namespace leastcost {

/// Whether a metric varies in a tube on a scale finer than the segments of the chain in its middle, by bounds of its
/// third derivatives in interval arithmetic.
enum class DetailVerdict {
  none,      ///< it does not, nowhere
  kink,      ///< but for kinks (abs, min, max), it does not
  found,     ///< it does, at a place
  undecided  ///< the bounds are too wide
};

}  // namespace leastcost
