// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <string_view>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/base/words.hpp>

namespace leastcost {

/// What a search is at.
enum class Stage { initialize, solve, post_process, certify };
Words<Stage> words(Stage);

/// One line of a solver's history.
struct Iteration {
  int iteration = 0;  ///< steps so far
  double energy = 0;  ///< of the chain
  double cost_error =
      0;            ///< predicted relative cost error, docs/numerics.md Sec. 3.1; NaN where the method has none at hand
  double step = 0;  ///< largest move of a point, length units
  long evaluations = 0;  ///< energies + gradients so far
  double seconds = 0;    ///< since the solve began
};

/// A path that was refused is solved again with more points: how many, and which of the doublings this is.
struct MorePoints {
  long points = 0;           ///< of the next chain
  int doubling = 0, of = 0;  ///< which doubling it is, and how many there may be
};

/// What an observer hears.
struct Progress {
  Stage stage = Stage::initialize;          ///< what the search is at
  const Iteration* iteration = nullptr;     ///< set in Stage::solve and while the certificate solves
  const MorePoints* more_points = nullptr;  ///< set in every stage of such a search (certificate.refine)
};

/// Reaches every stage of find_path(): an observer, a stop request, a time budget. Either function may be empty; both
/// are called from the thread that runs find_path(), and must not throw.
struct Monitor {
  using Clock = std::chrono::steady_clock;
  std::function<void(const Progress&)> observe;  ///< hears of every step; empty: nobody
  /// Asked again and again, within long passes about once a millisecond; true: end with the best path so far. Once it
  /// has said so, it must go on saying so.
  std::function<bool()> stop_requested;
  Deadline deadline;  ///< none: no limit

  /// Tells the observer, if there is one.
  void report(const Progress& progress) const {
    if (observe) observe(progress);
  }
  bool cancelled() const { return stop_requested && stop_requested(); }  ///< whether a stop was asked for
  bool out_of_time() const { return deadline.is_over(Clock::now()); }    ///< whether the deadline is over
  bool interrupted() const { return cancelled() || out_of_time(); }      ///< whether to end now

  /// What a pass looks at in its midst, which hears both. What delivers the best path so far, after a stop, takes
  /// `deadline` instead. The monitor must outlive it.
  Deadline limit() const& { return stop_requested ? Deadline(deadline.time(), stop_requested) : deadline; }
  Deadline limit() && = delete;
};

}  // namespace leastcost
