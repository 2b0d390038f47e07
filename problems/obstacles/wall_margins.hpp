// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>

#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// What points keep from walls in addition to what is required, so that the moves between them keep out, too
/// (docs/numerics.md Sec. 4.1): a width for each obstacle, found by solving, looking and solving again, and no less
/// than keeps a move from passing over the core of an obstacle.
class WallMargins {
 public:
  WallMargins() = default;
  /// Fitted to nothing yet, for points whose longest move is that long.
  explicit WallMargins(double longest_move);

  double of(const Wall& wall) const;  ///< beyond the clearance, length units
  double widest() const;              ///< of all margins
  /// What points at rest kept before the last fit; they come with it.
  double before(const Wall& wall) const;
  double widest_before() const;  ///< of all margins of the chain before
  /// Whether points had come to rest before the last fit.
  bool carry() const { return fits_ > 0; }

  /// Fitted anew to points whose longest move is that long. `least`: the walls that moves were found near to, by
  /// obstacle, each with its least gap. By `agree` a move may keep away for nothing; what is less than `rounding` is
  /// none. Nothing where that would change nothing.
  std::optional<WallMargins> fitted(const std::map<int, Wall>& least, double longest_move, double agree,
                                    double rounding) const;

 private:
  /// And what the last fit knew, for a secant.
  struct Margin {
    double width = 0, before = 0, gap_before = 0;
    bool has_before = false;
  };
  static double fit(const Margin& known, double now, double gap, double to);

  std::map<int, Margin> margins_;  ///< of obstacles that have one
  double from_cores_ = 0;          ///< what points keep from any core
  std::map<int, double> widths_before_;
  double from_cores_before_ = 0;
  int fits_ = 0;
};

}  // namespace leastcost
