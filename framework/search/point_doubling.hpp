// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "framework/search/search.hpp"
#include "framework/search/thinned.hpp"

namespace leastcost {

/// A search that goes on with twice the points, again and again. What it delivers are the points that were asked for:
/// every second, fourth, ... of the finer chain, with its curve and its certificate.
class PointDoubling {
 public:
  /// `coarse`: what find_path() came to for `problem`. `options.certificate.refine`: the doublings at most.
  PointDoubling(const Problem& problem, Result coarse, const Search& search);

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
  Result delivered(Result finer) const { return thinned(problem_, std::move(finer), factor_, search_); }

 private:
  /// What is known of the cost with so many points.
  struct Trial {
    int doublings = 0;
    Index points = 0;
    double uncertain = 0;  ///< relative
  };

  std::string why_stopped() const;
  void start_again();
  void solve_from(const CoordinatePath& start, Index factor, ProofRule proof);
  bool is_too_much_work() const;
  double most_work() const;
  bool comes_no_closer() const;
  void look_at(const Result& result);

  const Problem& problem_;
  const Search& search_;
  Result fine_;
  Index factor_ = 1;
  int doublings_ = 0;
  std::vector<Trial> trials_;
  double first_work_ = 0, last_work_ = 0, work_ = 0;  ///< evaluations times points: before it, of the last, of all
  bool given_up_ = false;  ///< a solve took much more work than was to be expected, and was stopped
};

}  // namespace leastcost
