// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/refine_until_certified.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include "framework/base/point_text.hpp"
#include "framework/certificate/shared_failures.hpp"
#include "framework/energy/spacing.hpp"
#include "framework/proof/calibration.hpp"
#include "framework/search/never_worse.hpp"

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

/// Failures that too few points may explain.
constexpr std::array<std::string_view, 9> kOfFewPoints = {"not_asymptotic",  "unresolved", "spacing",
                                                          "longest_segment", "doubling",   "bracket",
                                                          "error_bar",       "refinement", "dearer_than_first"};
/// What may be true of a chain that sees another cost than there is, but on its own has nothing to do with points.
constexpr std::array<std::string_view, 2> kBesideThem = {"saddle", "stationarity"};

/// Whether a chain was not solved, or is none that a search should end at. On a mesh also one that jumps over a fold:
/// with points between, it stays there.
bool is_astray(const Problem& problem, const Certificate& c) {
  const bool mesh = problem.manifold->shape() == Shape::polyhedral;
  return std::any_of(c.failures.begin(), c.failures.end(), [&](const CertificateFailure& failure) {
    return std::find(kBesideThem.begin(), kBesideThem.end(), failure.name) != kBesideThem.end() ||
           (mesh && failure.name == "longest_segment");
  });
}

/// Every `factor`-th point of a chain.
CoordinatePath every(const CoordinatePath& fine, Index factor) {
  CoordinatePath path{Points(fine.u.rows(), (fine.u.cols() - 1) / factor + 1), {}, fine.ring, fine.closing};
  for (Index i = 0; i < path.u.cols(); ++i) {
    path.u.col(i) = fine.u.col(factor * i);
    if (!fine.sites.empty()) path.sites.push_back(fine.site(factor * i));
  }
  return path;
}

/// Whether the straight moves of a chain are known to touch nothing.
bool are_clear(const Problem& problem, const CoordinatePath& chain, double allowed, const Deadline& deadline) {
  try {
    return !(depth_in_obstacles(problem, chain, allowed, deadline) > 0);
  } catch (const Interrupted&) {
    return false;
  }
}

/// Among obstacles few points keep a distance that makes the moves between them clear, and may cost more than the first
/// path though the path that they stand for, which is certified, does not. Such points are not delivered.
void refuse_dearer(const Problem& problem, const FindOptions& options, const Deadline& deadline, Result& result) {
  constexpr double kDearer = 1e-5;  // relative: what the fit of those distances leaves open
  if (result.status != Status::certified || find_ability<ChecksMoves>(*problem.manifold) == nullptr) return;
  if (result.first.path.u.cols() < 2 || !moves_are_exact(problem)) return;
  if (!(result.curve.cost > result.initial_cost * (1 + kDearer))) return;
  const double first = PathEnergy(problem, 1).cost(result.first.path);
  if (!(result.curve.cost > first * (1 + kDearer))) return;
  if (!are_clear(problem, result.first.path, options.certificate.clearance, deadline)) return;
  const TwoNumbers costs = told_apart(result.curve.cost, first, 9);
  result.certificate.failures.push_back(
      {"dearer_than_first", "the points cost " + costs.first + ", the first path " + costs.second +
                                ": few points keep away from obstacles that their moves would touch; use more points"});
  result.status = Status::uncertified;
}

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

/// Beside notes that are there already.
void add_notes(const std::vector<std::string>& more, std::vector<std::string>& notes) {
  for (const std::string& note : more)
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

/// On a mesh kinks push points along the path wherever they meet them, however many points there are. What has to be
/// equally spaced are the points that are delivered, every `factor`-th of the chain.
void judge_delivered_spacing(const Problem& problem, Index factor, Result& finer) {
  Certificate& c = finer.certificate;
  const bool thinned =
      factor > 1 && finer.costs.size() >= 2 * factor && find_ability<ChecksMoves>(*problem.manifold) == nullptr;
  if (!thinned || problem.manifold->shape() != Shape::polyhedral || finer.curve.straightness || !c.measured) return;
  const Index segments = finer.costs.size() / factor;
  Eigen::VectorXd costs(segments);
  for (Index i = 0; i < segments; ++i) costs[i] = finer.costs.segment(factor * i, factor).sum();
  c.spacing = spread(costs);
  const auto is_spacing = [](const CertificateFailure& failure) { return failure.name == "spacing"; };
  if (!(c.spacing <= kPolyhedronSpacing)) return;
  c.failures.erase(std::remove_if(c.failures.begin(), c.failures.end(), is_spacing), c.failures.end());
  if (finer.status == Status::uncertified && c.certified()) finer.status = Status::certified;
}

void go_on(FinerSearch& search, const Problem& problem) {
  try {
    while (search.may_double() && more_points_may_help(problem, search.fine())) search.double_points();
  } catch (const InputError&) {  // a finer chain could not be made
  } catch (const InitializationError&) {
  } catch (const Interrupted&) {
  }
}

/// A finer chain that was not certified either, where it alone is no worse than the first path.
bool saves(const Problem& problem, const Result& finer, const Result& found, const FindOptions& options,
           const Deadline& deadline) {
  try {
    return finer.status == Status::uncertified && first_path_is_better(problem, found, options, deadline) &&
           !first_path_is_better(problem, finer, options, deadline);
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

Result continued(const Result& before, Result later) {
  later.first = before.first;
  later.initial = before.initial;
  later.initial_cost = before.initial_cost;
  later.reference_cost = before.reference_cost;
  later.solve = joined(before.solve, std::move(later.solve));
  later.seconds.initialize += before.seconds.initialize;
  later.seconds.solve += before.seconds.solve;
  later.seconds.post_process += before.seconds.post_process;
  later.seconds.prepare += before.seconds.prepare;
  later.seconds.certify += before.seconds.certify;
  const std::vector<std::string> notes = std::exchange(later.notes, before.notes);
  add_notes(notes, later.notes);
  return later;
}

FinerSearch::FinerSearch(const Problem& problem, Result coarse, const Solver& solver, const FindOptions& options,
                         const Monitor& monitor)
    : problem_(problem), solver_(solver), options_(options), monitor_(monitor), fine_(std::move(coarse)) {
  first_work_ = last_work_ = work_of(fine_);
  look_at(fine_);
}

bool FinerSearch::may_double() const {
  return solver_.moves_points() && doublings_ < options_.certificate.refine &&
         2 * fine_.path.free_count() <= kMostPoints && !monitor_.interrupted() && !comes_no_closer() &&
         !is_too_much_work();
}

void FinerSearch::look_at(const Result& result) {
  trials_.push_back({doublings_, result.path.free_count(), uncertainty(result)});
}

void FinerSearch::double_points() {
  if (is_astray(problem_, fine_.certificate)) {
    begin_anew();
  } else {
    ++doublings_;
    solve_from(leastcost::refine(problem_, fine_.path, monitor_.deadline), 2 * factor_, ProofRule::never);
  }
  const bool provable = options_.certificate.proof == ProofRule::always && can_calibrate(problem_);
  if (fine_.status == Status::certified && provable) solve_from(fine_.path, factor_, ProofRule::always);
}

/// From the first path with four times the points, where there may be so many: as long as a chain sees another cost
/// than there is, its solves take long and come to nothing.
void FinerSearch::begin_anew() {
  const int times = doublings_ + 2 <= options_.certificate.refine && 4 * fine_.path.free_count() <= kMostPoints ? 4 : 2;
  doublings_ += times / 2;
  const Index segments = times * fine_.path.segment_count();
  const Index points = fine_.path.ring ? segments : segments - 1;
  const CoordinatePath start =
      sample_equally(problem_, fine_.first.path, static_cast<int>(points), 0.05, 8, monitor_.deadline);
  solve_from(start, times * factor_, ProofRule::never);
}

/// A proof takes longer than all the rest, so that it is left to the chain that would be certified without it.
void FinerSearch::solve_from(const CoordinatePath& start, Index factor, ProofRule proof) {
  FindOptions finer = options_;
  finer.reference_cost = fine_.reference_cost / static_cast<double>(factor);
  finer.cascade = false;
  finer.certificate.refine = 0;
  finer.certificate.proof = proof;
  const MorePoints more{static_cast<long>(start.free_count()), doublings_, options_.certificate.refine};
  double spent = 0;
  long evaluations = 0;  // of the solve that goes on
  Monitor telling = monitor_;
  telling.observe = [&](const Progress& progress) {
    if (progress.iteration != nullptr) {
      const long now = progress.iteration->evaluations;
      spent += static_cast<double>(now < evaluations ? now : now - evaluations) * static_cast<double>(start.u.cols());
      evaluations = now;
    }
    Progress told = progress;
    told.more_points = &more;
    monitor_.report(told);
  };
  telling.stop_requested = [&] {
    given_up_ = given_up_ || work_ + spent > most_work();
    return given_up_ || monitor_.cancelled();
  };
  Result next = search_from(problem_, start, solver_, finer, telling);
  if (given_up_) {
    fine_.seconds = continued(fine_, std::move(next)).seconds;
    return;
  }
  judge_delivered_spacing(problem_, factor, next);
  last_work_ = work_of(next);
  work_ += last_work_;
  fine_ = continued(fine_, std::move(next));
  refuse_dearer(problem_, options_, monitor_.deadline, fine_);
  factor_ = factor;
  look_at(fine_);
}

/// The work of a chain grows as its points do.
bool FinerSearch::is_too_much_work() const {
  const double growth = is_astray(problem_, fine_.certificate) ? 4 : 2;
  return given_up_ || work_ + growth * last_work_ > most_work();
}

double FinerSearch::most_work() const { return options_.certificate.refine_work * std::max(first_work_, kSmallSearch); }

bool FinerSearch::comes_no_closer() const {
  const int patience = problem_.manifold->shape() == Shape::polyhedral ? kPatienceOnMesh : kPatience;
  const Trial& last = trials_.back();
  const auto before = std::find_if(trials_.rbegin(), trials_.rend(),
                                   [&](const Trial& t) { return t.doublings <= last.doublings - patience; });
  return before != trials_.rend() && last.uncertain > kKnown && !(last.uncertain < kCloser * before->uncertain);
}

std::string FinerSearch::why_stopped() const {
  if (comes_no_closer()) {
    constexpr std::size_t kShown = 3;
    std::string text = "more points are no help: the cost is uncertain by";
    for (std::size_t i = trials_.size() - std::min(trials_.size(), kShown); i < trials_.size(); ++i)
      text += " " + short_number(100 * trials_[i].uncertain) + " % with " + std::to_string(trials_[i].points) +
              (i + 1 < trials_.size() ? " points," : " points. ");
    return text +
           "The cost or its data have kinks or noise between the points: smooth the data or the field, or give the "
           "field a smaller weight";
  }
  if (given_up_ || (doublings_ < options_.certificate.refine && is_too_much_work()))
    return "the search for more points stopped: it would take more than " +
           short_number(options_.certificate.refine_work) +
           " times the work of the search before it; a larger certificate.refine_work lets it go on";
  return "";
}

std::vector<std::string> FinerSearch::notes_of_failure() const {
  std::vector<std::string> notes;
  const auto& failures = fine_.certificate.failures;
  if (factor_ > 1)
    notes.push_back("with " + points_of(fine_) + " it is not certified either" +
                    (failures.empty() ? "" : ": " + failures.front().name));
  std::string why = more_points_may_help(problem_, fine_) ? why_stopped() : "";
  if (!why.empty()) notes.push_back(std::move(why));
  return notes;
}

Result FinerSearch::delivered(Result finer) const {
  if (factor_ == 1) return finer;
  CoordinatePath path = every(finer.path, factor_);
  const std::string note =
      (finer.status == Status::certified ? "found and certified with " : "found with ") + points_of(finer) + "; ";
  if (!are_clear(problem_, path, options_.certificate.clearance, monitor_.deadline)) {
    finer.notes.push_back(note + "all of them are delivered: moves between fewer might touch an obstacle");
    return finer;
  }
  finer.notes.push_back(note + "every " + (factor_ == 2 ? "2nd" : std::to_string(factor_) + "th") +
                        " of them is delivered");
  finer.path = std::move(path);
  const Index segments = finer.path.segment_count();
  const Eigen::VectorXd fine = finer.curve_costs;
  finer.curve_costs.resize(segments);
  for (Index i = 0; i < segments; ++i) finer.curve_costs[i] = fine.segment(factor_ * i, factor_).sum();
  finer.costs = PathEnergy(problem_, 1).costs(finer.path);
  return finer;
}

bool more_points_may_help(const Problem& problem, const Result& result) {
  const Certificate& c = result.certificate;
  if (!c.measured || result.status != Status::uncertified || result.curve.straightness) return false;
  // Where samples do not say what the domain is, no number of points does.
  const bool sampled = find_ability<HasUnresolvedPlaces>(*problem.manifold) != nullptr;
  const auto is_one_of = [](const auto& names, const CertificateFailure& failure) {
    return std::find(names.begin(), names.end(), failure.name) != names.end();
  };
  const auto of_few_points = [&](const CertificateFailure& failure) {
    return is_one_of(kOfFewPoints, failure) && !(sampled && failure.name == "unresolved");
  };
  const auto beside_them = [&](const CertificateFailure& failure) { return is_one_of(kBesideThem, failure); };
  return std::any_of(c.failures.begin(), c.failures.end(), of_few_points) &&
         std::all_of(c.failures.begin(), c.failures.end(),
                     [&](const auto& failure) { return of_few_points(failure) || beside_them(failure); });
}

Result refine_until_certified(const Problem& problem, Result found, const Solver& solver, const FindOptions& options,
                              const Monitor& monitor) {
  refuse_dearer(problem, options, monitor.deadline, found);
  if (options.certificate.refine == 0 || !solver.moves_points() || !more_points_may_help(problem, found)) return found;
  FinerSearch search(problem, found, solver, options, monitor);
  go_on(search, problem);
  if (search.fine().status == Status::certified) return search.delivered(search.fine());
  found.seconds = search.fine().seconds;
  const std::vector<std::string> notes = search.notes_of_failure();
  if (search.factor() > 1 && saves(problem, search.fine(), found, options, monitor.deadline)) {
    Result finer = search.delivered(search.fine());
    add_notes({notes.begin() + 1, notes.end()}, finer.notes);
    return finer;
  }
  if (monitor.interrupted()) {
    found.notes.emplace_back("there was no time to see whether more points would be certified");
    return found;
  }
  add_notes(notes, found.notes);
  return found;
}

}  // namespace leastcost
