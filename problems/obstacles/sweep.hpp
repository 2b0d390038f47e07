// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// A straight move between two places.
struct Move {
  Eigen::VectorXd a, b;
};

/// Whether a move stays clear of the cores of obstacles while its ends go straight from those of `from` to those of
/// `to`: by conservative advancement, for no place of it goes farther than the end that goes farther (Mirtich 1996).
/// False also where that is not known after some hundred steps; true where the walls do not know their cores, and where
/// `from` is not clear itself, so that there is nothing to keep.
bool sweeps_clear(const Walls& walls, const Move& from, const Move& to);

}  // namespace leastcost
