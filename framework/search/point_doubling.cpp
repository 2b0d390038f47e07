// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/point_doubling.hpp"

#include <algorithm>
#include <limits>

#include <leastcost/framework/domain/manifold.hpp>
#include "framework/base/point_text.hpp"
#include "framework/energy/spacing.hpp"
#include "framework/proof/calibrate.hpp"
#include "framework/search/begin.hpp"
#include "framework/search/dearer_than_first.hpp"
#include "framework/search/more_points_may_help.hpp"
#include "framework/search/run_search.hpp"

namespace leastcost {
namespace {

constexpr Index kMostPoints = 20'000;  ///< of a finer chain: what a certificate takes grows with them

/// A smaller search counts as one of this work (evaluations times points): what is over in a moment may double on.
constexpr double kSmallSearch = 4e4;
/// Doublings that are given to bring the value closer, and by how much. A feature that is narrower than a segment is
/// missed or half seen at first; on a mesh the data have a scale of their own.
constexpr int kPatience = 3, kPatienceOnMesh = 2;
constexpr double kCloser = 0.6;
constexpr double kKnown = 1e-4;  ///< a cost that is known so well, relative, is not what the certificate lacks

double work_of(const Result& search) {
  const Counters& n = search.solve.counters;
  double work =
      static_cast<double>(n.energies + n.gradients + n.hessians) * static_cast<double>(search.path.segment_count());
  for (const RefinementLevel& level : search.certificate.levels)
    work += static_cast<double>(level.evaluations) * static_cast<double>(level.segments);
  return work;
}

/// How far apart the costs are that the levels and the delivered curve have, as a part of the cost: never a matter of
/// how the points lie along the path.
double uncertainty(const Result& result) {
  const auto& levels = result.certificate.levels;
  if (levels.size() < 3) return std::numeric_limits<double>::infinity();
  double low = result.curve.cost, high = low;
  for (const RefinementLevel& level : levels) {
    low = std::min(low, level.cost);
    high = std::max(high, level.cost);
  }
  return (high - low) / high;
}

std::string points_of(const Result& result) { return std::to_string(result.path.free_count()) + " points"; }

}  // namespace

PointDoubling::PointDoubling(const Problem& problem, Result coarse, const Search& search)
    : problem_(problem), search_(search), fine_(std::move(coarse)) {
  first_work_ = last_work_ = work_of(fine_);
  look_at(fine_);
}

bool PointDoubling::may_double() const {
  return search_.solver.moves_points() && doublings_ < search_.options.certificate.refine &&
         2 * fine_.path.free_count() <= kMostPoints && !search_.monitor.interrupted() && !comes_no_closer() &&
         !is_too_much_work();
}

void PointDoubling::look_at(const Result& result) {
  trials_.push_back({doublings_, result.path.free_count(), uncertainty(result)});
}

void PointDoubling::double_points() {
  if (is_astray(problem_, fine_.certificate)) {
    start_again();
  } else {
    ++doublings_;
    solve_from(leastcost::refine(problem_, fine_.path, search_.monitor.limit()), 2 * factor_, ProofRule::never);
  }
  const bool provable = search_.options.certificate.proof == ProofRule::always && can_calibrate(problem_);
  if (fine_.status == Status::certified && provable) solve_from(fine_.path, factor_, ProofRule::always);
}

/// From the first path with four times the points, where there may be so many: as long as a chain sees another cost
/// than there is, its solves take long and come to nothing.
void PointDoubling::start_again() {
  const int times =
      doublings_ + 2 <= search_.options.certificate.refine && 4 * fine_.path.free_count() <= kMostPoints ? 4 : 2;
  doublings_ += times / 2;
  const Index segments = times * fine_.path.segment_count();
  const Index points = fine_.path.ring ? segments : segments - 1;
  const CoordinatePath start =
      sample_equally(problem_, fine_.first.path, static_cast<int>(points), search_.monitor.limit());
  solve_from(start, times * factor_, ProofRule::never);
}

/// A proof takes longer than all the rest, so that it is left to the chain that would be certified without it.
void PointDoubling::solve_from(const CoordinatePath& start, Index factor, ProofRule proof) {
  FindOptions finer = search_.options;
  finer.reference_cost = fine_.reference_cost / static_cast<double>(factor);
  finer.cascade = false;
  finer.certificate.refine = 0;
  finer.certificate.proof = proof;
  const MorePoints more{static_cast<long>(start.free_count()), doublings_, search_.options.certificate.refine};
  double spent = 0;
  long evaluations = 0;  // of the solve that goes on
  Monitor telling = search_.monitor;
  telling.observe = [&](const Progress& progress) {
    if (progress.iteration != nullptr) {
      const long now = progress.iteration->evaluations;
      spent += static_cast<double>(now < evaluations ? now : now - evaluations) * static_cast<double>(start.u.cols());
      evaluations = now;
    }
    Progress told = progress;
    told.more_points = &more;
    search_.monitor.report(told);
  };
  telling.stop_requested = [&] {
    given_up_ = given_up_ || work_ + spent > most_work();
    return given_up_ || search_.monitor.cancelled();
  };
  Problem problem = problem_;
  Result next = run_search(problem, from_chain(start), {search_.solver, finer, telling});
  if (given_up_) {
    fine_.seconds = joined(fine_, std::move(next)).seconds;
    return;
  }
  judge_delivered_spacing(problem_, factor, next);
  last_work_ = work_of(next);
  work_ += last_work_;
  fine_ = joined(fine_, std::move(next));
  refuse_dearer(problem_, search_, fine_);
  factor_ = factor;
  look_at(fine_);
}

/// The work of a chain grows as its points do.
bool PointDoubling::is_too_much_work() const {
  const double growth = is_astray(problem_, fine_.certificate) ? 4 : 2;
  return given_up_ || work_ + growth * last_work_ > most_work();
}

double PointDoubling::most_work() const {
  return search_.options.certificate.refine_work * std::max(first_work_, kSmallSearch);
}

bool PointDoubling::comes_no_closer() const {
  const int patience = problem_.manifold->shape() == Shape::polyhedral ? kPatienceOnMesh : kPatience;
  const Trial& last = trials_.back();
  const auto before = std::find_if(trials_.rbegin(), trials_.rend(),
                                   [&](const Trial& t) { return t.doublings <= last.doublings - patience; });
  return before != trials_.rend() && last.uncertain > kKnown && !(last.uncertain < kCloser * before->uncertain);
}

std::string PointDoubling::why_stopped() const {
  if (comes_no_closer()) {
    constexpr std::size_t kShown = 3;
    std::string text = "more points do not help: the cost is uncertain by";
    for (std::size_t i = trials_.size() - std::min(trials_.size(), kShown); i < trials_.size(); ++i)
      text += " " + short_number(100 * trials_[i].uncertain) + " % with " + std::to_string(trials_[i].points) +
              (i + 1 < trials_.size() ? " points," : " points. ");
    return text +
           "The cost or its data have kinks or noise between the points: smooth the data or the field, or give the "
           "field a smaller weight";
  }
  if (given_up_ || (doublings_ < search_.options.certificate.refine && is_too_much_work()))
    return "the search with more points stopped: it would take more than " +
           short_number(search_.options.certificate.refine_work) +
           " times the work of the search before it; to continue, increase certificate.refine_work";
  return "";
}

std::vector<std::string> PointDoubling::notes_of_failure() const {
  std::vector<std::string> notes;
  const auto& failures = fine_.certificate.failures;
  if (factor_ > 1)
    notes.push_back("with " + points_of(fine_) + " the path is not certified either" +
                    (failures.empty() ? "" : ": " + failures.front().name()));
  std::string why = more_points_may_help(problem_, fine_) ? why_stopped() : "";
  if (!why.empty()) notes.push_back(std::move(why));
  return notes;
}

}  // namespace leastcost
