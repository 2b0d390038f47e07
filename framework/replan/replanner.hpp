// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <leastcost/framework/base/words.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/framework/replan/open_rest.hpp>
#include <leastcost/framework/replan/rest.hpp>
#include <leastcost/framework/replan/solved_chain.hpp>
#include <leastcost/framework/search/find_path.hpp>

namespace leastcost {

/// What a replan came to: which of the paths that are valid now is the cheapest.
enum class ReplanOutcome {
  new_path,       ///< one that was found now
  old_path,       ///< the one before, which nothing found in time undercuts
  no_valid_path,  ///< none is known to be valid now
};
Words<ReplanOutcome> words(ReplanOutcome);

/// What a call of replan() found.
struct Replan {
  ReplanOutcome outcome = ReplanOutcome::no_valid_path;  ///< whether there is a path, and where it came from
  /// The path, its costs and its curve; empty without a valid one. Certified only where the options ask for it.
  Result result;
  std::optional<Clearance> clearance;    ///< of that curve; nothing where the domain has no obstacles
  std::string why_not_old, why_not_new;  ///< why there is no such path, or it is not valid; empty where it is
  bool from_initializer = false;         ///< whether a first path had to be made
};

/// What parts of a replan took last, in wall time.
struct ReplanSeconds {
  double per_move = 0;  ///< a look at a path
  double solve = 0;     ///< 0: none was made
};

/// Plans again and again while the problem changes: ends that move, obstacles that move, costs that change. It keeps
/// the last valid path, which is where the next search starts from.
///
/// What it returns is valid in the problem it was given: every move of the curve has a finite cost and, on a domain
/// that checks moves (ChecksMoves), touches nothing, by more than `certificate.clearance` of the size of the path. A
/// world that changed is another domain: obstacles are shared, and only their index is built. One thread at a time; one
/// object per thread.
class Replanner {
 public:
  /// `options`: of each search; `points` is a number, and `certificate.refine` is taken for 0: the time is that of one
  /// chain. A certificate is measured only where it is asked for:
  ///
  ///     Replanner planner(solver, initializer, {.points = 100, .certificate = {.enabled = false}});
  ///
  /// Throws InputError for options that do not fit.
  Replanner(std::shared_ptr<const Solver> solver, std::shared_ptr<const Initializer> initializer, FindOptions options);

  /// The old path is looked at first. Where it is clear, was solved, and nothing beside it has moved, it is returned:
  /// share the cost between problems, for another object may be another cost. Else the
  /// problem is solved from there: where a chain alone is asked for, with the margins of the last solve, and from what
  /// could be pushed out of obstacles if that gives nothing valid. What can be pushed out comes first where little time
  /// is left, and in other searches. At last
  /// it is solved from a first path of the initializer. An end that moved cuts the old path where it is nearest to it.
  /// The deadline of the monitor holds as in find_path(), what it takes to look at paths included. Throws InputError
  /// for a problem whose parts do not fit; an end within an obstacle and a first path that is not found are outcomes.
  Replan replan(const Problem& now, const Monitor& monitor = {});

  /// Where the next search begins: the last path that was valid when it was returned, or, after a search that ended
  /// without one, what it came to. Empty before the first.
  const CoordinatePath& path() const { return last_.path; }
  /// Forgets it: the next search begins with a first path.
  void forget() {
    last_ = {};
    rest_ = {};
    solved_ = {};
  }

 private:
  std::shared_ptr<const Solver> solver_;
  std::shared_ptr<const Initializer> initializer_;
  FindOptions options_;
  Result last_;
  Rest rest_;  ///< of the last path, where it was solved
  OpenRest open_rest_;
  SolvedChain solved_;  ///< which is the last path, unless that was cheaper
  ReplanSeconds seconds_;
};

}  // namespace leastcost
