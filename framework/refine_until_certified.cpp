// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/refine_until_certified.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/manifold.hpp>
#include <leastcost/framework/path_energy.hpp>
#include "framework/among_obstacles.hpp"
#include "framework/calibration.hpp"
#include "framework/never_worse.hpp"
#include "framework/spacing.hpp"

namespace leastcost {
namespace {

constexpr Index kMostPoints = 20'000;  ///< of a finer chain: what a certificate takes grows with them

/// Failures that too few points may explain.
constexpr std::array<std::string_view, 8> kOfFewPoints = {
    "not_asymptotic", "unresolved", "spacing", "longest_segment", "doubling", "bracket", "error_bar", "refinement"};
/// What may be true of a chain that sees another cost than there is, but on its own has nothing to do with points.
constexpr std::array<std::string_view, 2> kBesideThem = {"saddle", "stationarity"};

/// Whether a chain was not solved, or is none that a search should end at.
bool is_astray(const Certificate& c) {
  return std::any_of(c.failures.begin(), c.failures.end(), [](const CertificateFailure& failure) {
    return std::find(kBesideThem.begin(), kBesideThem.end(), failure.name) != kBesideThem.end();
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

std::string points_of(const Result& result) { return std::to_string(result.path.free_count()) + " points"; }

/// Beside notes that are there already.
void add_notes(const std::vector<std::string>& more, std::vector<std::string>& notes) {
  for (const std::string& note : more)
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
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
    : problem_(problem), solver_(solver), options_(options), monitor_(monitor), fine_(std::move(coarse)) {}

bool FinerSearch::may_double() const {
  return solver_.moves_points() && doublings_ < options_.certificate.refine &&
         2 * fine_.path.free_count() <= kMostPoints && !monitor_.interrupted();
}

void FinerSearch::double_points() {
  if (is_astray(fine_.certificate)) {
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
  fine_ = continued(fine_, search_from(problem_, start, solver_, finer, monitor_));
  factor_ = factor;
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
  if (options.certificate.refine == 0 || !solver.moves_points() || !more_points_may_help(problem, found)) return found;
  FinerSearch search(problem, found, solver, options, monitor);
  go_on(search, problem);
  if (search.fine().status == Status::certified) return search.delivered(search.fine());
  found.seconds = search.fine().seconds;
  if (search.factor() > 1 && saves(problem, search.fine(), found, options, monitor.deadline))
    return search.delivered(search.fine());
  if (monitor.interrupted())
    found.notes.emplace_back("there was no time to see whether more points would be certified");
  else if (search.factor() > 1)
    found.notes.push_back(
        "with " + points_of(search.fine()) + " it is not certified either" +
        (search.fine().certificate.failures.empty() ? "" : ": " + search.fine().certificate.failures.front().name));
  return found;
}

}  // namespace leastcost
