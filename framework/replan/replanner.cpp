// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/replan/replanner.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <typeinfo>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/fits_segments.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/base/grace_deadline.hpp"
#include "framework/base/point_text.hpp"
#include "framework/domain/in_parts.hpp"
#include "framework/energy/solve_fitted.hpp"
#include "framework/energy/spacing.hpp"
#include "framework/replan/shortened.hpp"
#include "framework/result/find_path_checks.hpp"

namespace leastcost {
namespace {

using Clock = Monitor::Clock;

Clock::duration clock_duration(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// A path that may be delivered.
struct Candidate {
  Result result;
  std::optional<Clearance> clearance;
  std::string why_not = "there is none";  ///< empty: it is valid now
  bool valid() const { return why_not.empty(); }
};

/// One replan: the problem, the budget, and what is known so far.
class OneReplan {
 public:
  OneReplan(const Problem& now, const Solver& solver, const Initializer& initializer, const FindOptions& options,
            const Monitor& monitor, const Rest& rest, OpenRest& open_rest, const SolvedChain& solved,
            ReplanSeconds& seconds)
      : problem_(now),
        solver_(solver),
        initializer_(initializer),
        options_(options),
        monitor_(monitor),
        rest_(rest),
        open_rest_(open_rest),
        before_(solved),
        seconds_(seconds) {}

  Replan from(const Result& last) {
    Replan out;
    const bool ends_stay = begins_and_ends_as(last);
    if (!ends_stay && has_no_end(out)) return out;
    old_.result = carried_over(last);
    look_at(old_);
    if (ends_stay && !old_.valid() && has_no_end(out)) return out;
    const bool solve_first = asks_for_chain_alone() && has_time_to_solve();
    if (!solver_.moves_points() || (!old_.valid() && !solve_first)) push_clear();
    if (!still_at_rest()) improve();
    if (solve_first && !old_.valid() && !new_.valid()) push_and_improve();
    if (!old_.valid() && !pushed_.valid() && !new_.valid() && !monitor_.interrupted()) {
      unfinished_ = new_.result.path;
      begin_anew();
      out.from_initializer = true;
    }
    out.why_not_old = old_.why_not;
    out.why_not_new = new_.why_not;
    if (pushed_.valid() && (!new_.valid() || pushed_.result.curve.cost < new_.result.curve.cost))
      new_ = std::move(pushed_), at_rest_ = false;
    at_rest_ = at_rest_ && new_.valid();  // an old path that a solve found nothing better than is solved
    const bool take_new =
        new_.valid() && (!old_.valid() || shortened_ || new_.result.curve.cost < old_.result.curve.cost);
    if (take_new) return delivered(std::move(out), ReplanOutcome::new_path, std::move(new_));
    if (old_.valid()) return delivered(std::move(out), ReplanOutcome::old_path, std::move(old_));
    if (unfinished_.u.cols() == 0) unfinished_ = new_.result.path;
    return out;
  }

  /// Whether the old path was kept without a solve, and else whether what is delivered was solved.
  bool still() const { return still_; }
  bool at_rest() const { return at_rest_; }
  /// What a solve came to, delivered or not.
  SolvedChain solved() { return std::move(solved_); }

  /// Without a valid path, what the search came to: the next one goes on from there.
  CoordinatePath unfinished() { return std::move(unfinished_); }

 private:
  static Replan delivered(Replan out, ReplanOutcome outcome, Candidate path) {
    out.outcome = outcome;
    out.result = std::move(path.result);
    out.clearance = std::move(path.clearance);
    return out;
  }

  /// Then a look at the last path is one at the ends, too.
  bool begins_and_ends_as(const Result& last) const {
    const Points &u = last.path.u, &x = last.curve.x;
    const auto joins = [&](const Points& path) {
      return path.cols() > 1 && path.rows() == problem_.source.u.size() && path.col(0) == problem_.source.u &&
             path.rightCols(1) == problem_.target.u;
    };
    return !problem_.ring && find_ability<HasChart>(*problem_.manifold) == nullptr && joins(u) && joins(x);
  }

  bool has_no_end(Replan& out) const {
    out.why_not_old = out.why_not_new = why_no_end();
    return !out.why_not_old.empty();
  }

  /// An end within an obstacle: whatever is searched, there is no path now.
  std::string why_no_end() const {
    if (problem_.ring && !problem_.based) return "";
    std::string why = why_in_clearance(problem_, problem_.source);
    if (!why.empty()) return "the source " + why;
    if (problem_.ring) return "";
    why = why_in_clearance(problem_, problem_.target);
    return why.empty() ? "" : "the target " + why;
  }

  /// The last path between the ends of now. Empty where there is none.
  Result carried_over(const Result& last) {
    if (last.path.u.cols() == 0 || last.path.u.rows() != problem_.manifold->dimensions().coordinate) return {};
    Result old;
    old.path = last.path;
    old.curve = last.curve;
    old.post_processed = last.post_processed;
    shortened_ = shorten_to_ends(problem_, old.path);
    if (!shortened_) return old;
    const auto& steps = options_.post_processors;
    if (std::any_of(steps.begin(), steps.end(), [](const auto& step) { return !step->finds_its_own(); }))
      return {};  // its curve was made for other ends
    old.curve = {};
    old.curve.x = chain_of(old.path);
    return old;
  }

  /// Whether a path may be delivered, and what it costs now.
  void look_at(Candidate& path) {
    Result& result = path.result;
    if (result.curve.x.cols() < 2) return;
    if (&path != &old_ && asks_for_chain_alone() && has_curve_of_old(result)) return look_as_at_old(path);
    const Clock::time_point begin = Clock::now();
    try {
      const Points& x = result.curve.x;
      result.curve_costs = segment_costs(*problem_.cost, {{x.data(), x.rows(), x.cols()}, {}, false});
      result.curve.cost = result.curve_costs.sum();
      result.costs = PathEnergy(problem_, 1, last_look()).costs(result.path);
      path.clearance = measure_clearance(*problem_.manifold, x, false, last_look());
      path.why_not = why_not(result, path.clearance);
      seconds_.per_move = seconds_since(begin) / static_cast<double>(x.cols() - 1);
    } catch (const Interrupted&) {
      path.why_not = "there was no time to check it";
    }
  }

  bool has_curve_of_old(const Result& result) const {
    const Points &x = result.curve.x, &old = old_.result.curve.x;
    return old_.valid() && x.rows() == old.rows() && x.cols() == old.cols() && x == old;
  }

  void look_as_at_old(Candidate& path) const {
    path.result.curve.cost = old_.result.curve.cost;
    path.result.curve_costs = old_.result.curve_costs;
    path.result.costs = old_.result.costs;
    path.clearance = old_.clearance;
    path.why_not.clear();
  }

  std::string why_not(const Result& result, const std::optional<Clearance>& clearance) const {
    if (!std::isfinite(result.curve.cost)) return "it has infinite cost";
    const Points& x = result.curve.x;
    const double extent = extent_of(x);
    if (!clearance || clearance->lower >= -options_.certificate.clearance * extent) return "";
    return "it comes " + short_number(std::abs(clearance->upper)) + " too close to " + clearance->obstacle;
  }

  /// What an obstacle has moved onto is pushed out of it, without a solve, until no move touches. So is a chain whose
  /// curve is valid, but not the moves between its points, if there is no solver to do it.
  void push_clear() {
    constexpr int kMostPushes = 8;
    const auto* fits = find_ability<FitsSegments>(*problem_.manifold);
    if (fits == nullptr || old_.result.path.u.cols() == 0 || monitor_.interrupted()) return;
    try {
      CoordinatePath& path = pushed_.result.path = with_points(old_.result.path, monitor_.limit());
      std::shared_ptr<const ConstraintManifold> domain = fits->unfitted(path);
      for (int k = 0; k < kMostPushes && domain != nullptr; ++k) {
        CoordinatePath moved = path;
        if (!project(*domain, moved, monitor_.limit()).failed.empty()) return;
        path.u.middleCols(path.free_begin(), path.free_count()) =
            moved.u.middleCols(path.free_begin(), path.free_count());
        pushed_.result.curve.x = chain_of(path);
        look_at(pushed_);
        if (pushed_.valid() || monitor_.interrupted()) return;
        domain = find_ability<FitsSegments>(*domain)->fitted(path).domain;
      }
    } catch (const InitializationError&) {  // too few places left for its points
    } catch (const Interrupted&) {
    }
  }

  /// Else what can be pushed out of obstacles is what can be returned, most likely.
  bool has_time_to_solve() const {
    constexpr double kSure = 10;  // times as much as the last one took
    if (!monitor_.deadline) return true;
    const double left = std::chrono::duration<double>(*monitor_.deadline - Clock::now()).count();
    return seconds_.solve > 0 && kShareOfWarmStart * left >= kSure * seconds_.solve;
  }

  /// What a solve from the old path made nothing valid of may still be pushed out of obstacles, and solved from there.
  void push_and_improve() {
    push_clear();
    before_ = {};
    improve();
  }

  /// From the old path, or what could be made of it.
  void improve() {
    const CoordinatePath& from = continues() ? before_.path : pushed_.valid() ? pushed_.result.path : old_.result.path;
    if (from.u.cols() == 0 || monitor_.interrupted()) return;
    const Monitor within = with_deadline(old_.valid() || pushed_.valid() ? 1 : kShareOfWarmStart);
    attempt([&] {
      const CoordinatePath start = with_points(from, within.limit());
      return asks_for_chain_alone() ? solved_chain(start, within)
                                    : improve_path(problem_, start, solver_, options_, within);
    });
  }

  /// Whether the last solve was between these ends: where its chain was no better than the old path, it is what the
  /// margins are of.
  bool continues() const {
    const Points &u = before_.path.u, &old = old_.result.path.u;
    return u.cols() > 1 && !shortened_ && asks_for_chain_alone() && u.rows() == old.rows() && u.cols() == old.cols() &&
           u.col(0) == old.col(0) && u.rightCols(1) == old.rightCols(1);
  }

  /// Then its looks at the path do what else a search does.
  bool asks_for_chain_alone() const {
    return !options_.certificate.enabled && options_.post_processors.empty() && !options_.cascade &&
           !options_.escape_saddle && solver_.moves_points() && !problem_.ring &&
           find_ability<FitsSegments>(*problem_.manifold) != nullptr;
  }

  bool rests_without_obstacles() {
    const Result& old = old_.result;
    return !before_.is_held() && old.path.free_count() == options_.points.value() &&
           open_rest_.holds(problem_, old.path, old.curve.cost, monitor_.limit());
  }

  /// Whether the old path needs no solve: it is clear, and what held it is where it was, or nothing need hold it.
  bool still_at_rest() {
    if (!old_.valid() || shortened_ || !asks_for_chain_alone() || monitor_.interrupted()) return false;
    new_.why_not = "nothing that holds the old path has moved";
    still_ = rests_without_obstacles() || rest_.holds(problem_, old_.result.path);
    if (!still_) new_ = {};
    return still_;
  }

  /// Margins are fitted as closely as makes a difference to who drives along the path now.
  Result solved_chain(const CoordinatePath& start, const Monitor& within) {
    constexpr double kAgreement = 1e-4;  // of the extent
    Result out;
    out.initial = out.path = start;
    out.initial_cost = PathEnergy(problem_, 1, within.limit()).cost(start);
    out.reference_cost =
        options_.reference_cost.value_or(out.initial_cost / static_cast<double>(start.segment_count()));
    if (!(out.reference_cost > 0) || !std::isfinite(out.reference_cost))
      throw InitializationError("the path has no cost to begin with that is finite and above 0");
    const Clock::time_point begin = Clock::now();
    const Fitting fitting{kAgreement, continues() ? &before_.margins : nullptr};
    FittedSolve solved = solve_fitted(problem_, solver_, out.reference_cost, out.path, within, fitting);
    out.solve = std::move(solved.report);
    at_rest_ = is_solved(out.solve.termination) && !out.solve.cycling;
    const auto* reuses = find_ability<ReusesMargins>(*solved.problem.manifold);
    if (at_rest_ && reuses != nullptr && !within.interrupted())
      solved_ = {out.path, reuses->kept_margins(out.path, solved.gaps)};
    out.seconds.solve = seconds_.solve = seconds_since(begin);
    out.status = within.interrupted() ? Status::interrupted : Status::uncertified;
    return out;
  }

  void begin_anew() {
    at_rest_ = false;
    const Monitor within = with_deadline(1);
    attempt([&] { return find_path(problem_, initializer_, solver_, options_, within); });
    if (new_.valid() || new_.result.first.path.u.cols() == 0) return;
    // Its samples may cut corners that the first path goes around.
    Candidate first;
    first.result.path = new_.result.first.path;
    first.result.curve.x = chain_of(first.result.path);
    look_at(first);
    if (first.valid()) new_ = std::move(first);
  }

  template <class Search>
  void attempt(Search search) {
    new_ = {};
    try {
      new_.result = search();
      if (new_.result.path.u.cols() == 0) new_.why_not = "the time budget is used up";
      if (new_.result.curve.x.cols() < 2 && new_.result.path.u.cols() > 0)
        new_.result.curve.x = chain_of(new_.result.path);
      look_at(new_);
    } catch (const InputError& error) {  // a point of the path has no nearest place now
      new_.why_not = error.what();
    } catch (const InitializationError& error) {
      new_.why_not = error.what();
    } catch (const Interrupted& error) {
      new_.why_not = error.what();
    }
  }

  /// Its points as a curve; a ring is closed by its first one.
  Points chain_of(const CoordinatePath& path) const { return PathEnergy(problem_, 1).ambient(path).x; }

  /// A chain of as many points as are asked for.
  CoordinatePath with_points(const CoordinatePath& path, const Deadline& deadline) const {
    const int points = options_.points.value();
    if (path.free_count() == points) return path;
    return sample_equally(problem_, path, points, deadline);
  }

  /// Leaves a part of the remaining time to the search, and what it takes to look at its path.
  Monitor with_deadline(double part) const {
    Monitor within = monitor_;
    if (!monitor_.deadline) return within;
    const double moves = options_.points.value() + 1;
    const Clock::time_point now = Clock::now(),
                            end = *monitor_.deadline - clock_duration(1.5 * moves * seconds_.per_move);
    within.deadline = now + clock_duration(part * std::max(0.0, std::chrono::duration<double>(end - now).count()));
    return within;
  }

  /// Until when a path may be looked at.
  Deadline last_look() const { return grace_deadline(monitor_.deadline, start_, 1); }

  static double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }

  static constexpr double kShareOfWarmStart = 0.4;  ///< of the time, where the old path is not valid

  const Clock::time_point start_ = Clock::now();
  const Problem& problem_;
  const Solver& solver_;
  const Initializer& initializer_;
  const FindOptions& options_;
  const Monitor& monitor_;
  const Rest& rest_;  ///< of the last path
  OpenRest& open_rest_;
  SolvedChain before_, solved_;
  ReplanSeconds& seconds_;
  Candidate old_, pushed_, new_;
  CoordinatePath unfinished_;
  bool at_rest_ = false, still_ = false;
  bool shortened_ =
      false;  ///< the old path, which led between other ends: it is spaced unevenly, hence only a last resort
};

}  // namespace

Words<ReplanOutcome> words(ReplanOutcome) {
  using enum ReplanOutcome;
  static constexpr Word<ReplanOutcome> kWords[] = {
      {new_path, "new_path"}, {old_path, "old_path"}, {no_valid_path, "no_valid_path"}};
  return kWords;
}

Replanner::Replanner(std::shared_ptr<const Solver> solver, std::shared_ptr<const Initializer> initializer,
                     FindOptions options)
    : solver_(std::move(solver)), initializer_(std::move(initializer)), options_(std::move(options)) {
  if (!solver_ || !initializer_) throw InputError("a replanner needs a solver and an initializer");
  if (!options_.points) throw InputError("a replanner needs a number of points");
  check(options_);
  options_.certificate.refine = 0;  // the time is that of one search
  options_.certificate.global = GlobalOff{};
}

Replan Replanner::replan(const Problem& now, const Monitor& monitor) {
  check(now);
  OneReplan once(now, *solver_, *initializer_, options_, monitor, rest_, open_rest_, solved_, seconds_);
  Replan out = once.from(last_);
  if (out.outcome == ReplanOutcome::no_valid_path) {
    rest_ = {};
    solved_ = {};
    if (CoordinatePath unfinished = once.unfinished(); unfinished.u.cols() > 0) {
      last_ = {};
      last_.curve.x = PathEnergy(now, 1).ambient(unfinished).x;
      last_.path = std::move(unfinished);
    }
    return out;
  }
  last_.path = out.result.path;
  last_.curve = out.result.curve;
  const bool solved = once.at_rest() && !monitor.interrupted();
  if (once.still()) return out;
  solved_ = solved ? once.solved() : SolvedChain{};
  rest_ = solved ? Rest(now, last_.path, solved_) : Rest();
  return out;
}

}  // namespace leastcost
