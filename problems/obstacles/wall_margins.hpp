// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>

#include <leastcost/framework/path/path.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// What points keep from walls in addition to what is required, so that the moves between them keep out, too
/// (docs/numerics.md Sec. 4.1): a width for each obstacle, found by solving, looking and solving again, and no less
/// than keeps a move from passing over the core of an obstacle.
class WallMargins {
 public:
  WallMargins() = default;
  /// Fitted to nothing yet, for points whose longest move is that long, among walls all of which require at least
  /// `thinnest` of the distance from their cores.
  explicit WallMargins(double longest_move, double thinnest = 0);
  /// As a chain at rest had them, when walls were a little elsewhere.
  WallMargins(double longest_move, double thinnest, const std::map<int, double>& widths);

  double of(const Wall& wall) const;                 ///< beyond the clearance, length units
  double widest() const;                             ///< of all margins
  double from_cores() const { return from_cores_; }  ///< what points keep from any core
  /// What points at rest kept before the last fit; they come with it.
  double before(const Wall& wall) const;
  double widest_before() const;  ///< of all margins of the chain before
  /// Whether points had come to rest before the last fit.
  bool carry() const { return fits_ > 0; }

  /// How closely, length units.
  struct Fit {
    double agree = 0;     ///< by so much a move may keep away for nothing
    double rounding = 0;  ///< what is less is none
    double on = 0;        ///< a wall that moves keep away from by more than its margin and this holds no point
  };
  /// Fitted anew to points whose longest move is that long. `least`: the walls that moves were found near to, by
  /// obstacle, each with its least gap; all that hold a point are among them. Nothing where that would change nothing:
  /// neither does the margin of a wall that holds none.
  std::optional<WallMargins> fitted(const std::map<int, Wall>& least, double longest_move, const Fit& closely) const;

  std::map<int, double> widths() const;  ///< of obstacles that have one
  /// The same for the next chain: with these the moves, whose least gaps by obstacle are given, would keep away for
  /// nothing by a quarter of what a fit allows.
  std::map<int, double> widths_for_next(const std::map<int, double>& gaps, const Fit& closely) const;

  /// Of a chain that was at rest, among walls that have moved since: its moves are nearer to a wall than its points
  /// (ambient columns of x) are by about what they will be, once the points rest on it. Into the gaps of moves.
  void take_sags(const Walls& walls, const Points& x, const Fit& closely, std::map<int, Wall>& least) const;

 private:
  /// And what the last fit knew, for a secant.
  struct Margin {
    double width = 0, before = 0, gap_before = 0;
    bool has_before = false;
  };
  static double fit(const Margin& known, double now, double gap, double to);

  std::map<int, Margin> margins_;  ///< of obstacles that have one
  double from_cores_ = 0, thinnest_ = 0;
  std::map<int, double> widths_before_;
  double from_cores_before_ = 0;
  int fits_ = 0;
};

/// The walls with a gap below `reach` on some of the first moves between columns of x, where each is least.
std::map<int, Wall> least_on_moves(const Walls& walls, const Points& x, Index moves, double reach);

}  // namespace leastcost
