// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>

namespace leastcost {

/// One search from a chain, as improve_path() but for its last two steps: neither more points, nor the first path where
/// that is better. A finer search goes on from whatever it comes to.
Result search_from(const Problem& problem, const CoordinatePath& chain, const Solver& solver,
                   const FindOptions& options, const Monitor& monitor);

/// A later result of the same search: where it began, and what it took, are those of the whole.
Result continued(const Result& before, Result later);

/// A search that goes on with twice the points, again and again. What it delivers are the points that were asked for:
/// every second, fourth, ... of the finer chain, with its curve and its certificate.
class FinerSearch {
 public:
  /// `coarse`: what find_path() came to for `problem`. `options.certificate.refine`: the doublings at most.
  FinerSearch(const Problem& problem, Result coarse, const Solver& solver, const FindOptions& options,
              const Monitor& monitor);

  /// Whether the points may be doubled once more: there is time and work left for it, they would not be too many, and
  /// the last doublings have brought the value closer.
  bool may_double() const;
  /// What to say of a search that ends uncertified: with how many points it did, and why it went no further where that
  /// is for the value or the work.
  std::vector<std::string> notes_of_failure() const;
  /// Solves and certifies the chain with twice the points, from the one before it; where that one led astray (not
  /// solved, a saddle) from the first path, with four times the points. Throws as improve_path() does, and what there
  /// was before stays.
  void double_points();

  const Result& fine() const { return fine_; }  ///< of the finest chain so far
  Index factor() const { return factor_; }      ///< how many times the points that were asked for it has
  /// The points that were asked for, of `finer`, which is fine() or what was made of its chain.
  Result delivered(Result finer) const;

 private:
  /// What is known of the cost with so many points.
  struct Trial {
    int doublings = 0;
    Index points = 0;
    double uncertain = 0;  ///< relative
  };

  std::string why_stopped() const;
  void begin_anew();
  void solve_from(const CoordinatePath& start, Index factor, ProofRule proof);
  bool is_too_much_work() const;
  double most_work() const;
  bool comes_no_closer() const;
  void look_at(const Result& result);

  const Problem& problem_;
  const Solver& solver_;
  const FindOptions& options_;
  const Monitor& monitor_;
  Result fine_;
  Index factor_ = 1;
  int doublings_ = 0;
  std::vector<Trial> trials_;
  double first_work_ = 0, last_work_ = 0, work_ = 0;  ///< evaluations times points: before it, of the last, of all
  bool given_up_ = false;  ///< a solve took much more work than was to be expected, and was stopped
};

/// Whether every reason why a path was refused is one that more points may mend.
bool more_points_may_help(const Problem& problem, const Result& result);

/// Goes on with twice the points where that may help, until the path is certified, or refused for another reason, or
/// comes no closer, or there are no more doublings, points, work or time (docs/numerics.md Sec. 6.2). What is not
/// certified then stays as it came, with a note; but where the first path is better than that and not better than the
/// finer chain, the finer chain is delivered.
Result refine_until_certified(const Problem& problem, Result found, const Solver& solver, const FindOptions& options,
                              const Monitor& monitor);

}  // namespace leastcost
