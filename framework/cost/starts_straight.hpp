// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

namespace leastcost {

/// Ability of a cost that depends on the place and yet has one least-cost path between two places as a rule, so that
/// the straight line is as good a first path as a search on all sides: times of a slide, lengths of an arm's motion.
class StartsStraight {
 public:
  virtual ~StartsStraight() = default;
};

}  // namespace leastcost
