// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/find_path.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include <leastcost/framework/checks_moves.hpp>
#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/fits_segments.hpp>
#include <leastcost/framework/other_images.hpp>
#include <leastcost/framework/path_energy.hpp>
#include "framework/based_loop.hpp"
#include "framework/cascade.hpp"
#include "framework/escape_saddle.hpp"
#include "framework/find_path_checks.hpp"
#include "framework/geometry_error.hpp"
#include "framework/in_parts.hpp"
#include "framework/spacing.hpp"

namespace leastcost {
namespace {

/// Runs one stage: tells the monitor, measures its time.
template <class Work>
void stage(Stage stage, const Monitor& monitor, double& seconds, Work work) {
  monitor.report({stage, nullptr});
  const auto start = Monitor::Clock::now();
  work();
  seconds = std::chrono::duration<double>(Monitor::Clock::now() - start).count();
}

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// What may still be measured of an interrupted path: the first part of what the contract leaves after the deadline.
Deadline last_words(const Deadline& deadline, Monitor::Clock::time_point start) {
  constexpr auto kLeast = std::chrono::microseconds(300);
  constexpr int kPart = 33;  // of the budget
  if (!deadline) return {};
  return *deadline + std::max<Monitor::Clock::duration>(kLeast, (*deadline - start) / kPart);
}

/// An end that was given by its coordinates alone, on a domain that has sites: it is found.
void place(const ConstraintManifold& manifold, const char* which, PathEnd& end, std::vector<std::string>& notes) {
  constexpr double kSame = 1e-9;  // of the size of the coordinates: rounding moves no end
  if (end.site != kNoSite || end.u.size() == 0) return;
  double moved = 0;
  const PathEnd found = project_end(manifold, end.u, &moved);
  if (found.site == kNoSite) return;
  end.site = found.site;
  if (moved <= kSame * end.u.cwiseAbs().maxCoeff()) return;
  end.u = found.u;
  notes.push_back(std::string(which) + " was moved onto the domain");
}

Problem with_sites(Problem problem, std::vector<std::string>& notes) {
  if (problem.ring && !problem.based) return problem;
  place(*problem.manifold, "the source", problem.source, notes);
  if (!problem.ring) place(*problem.manifold, "the target", problem.target, notes);
  return problem;
}

int point_count(const FindOptions& options, const FirstPath& first) {
  if (options.points) return *options.points;
  if (!first.graph_vertices)
    throw InputError("points: auto counts the vertices of an edge path, and this domain has no graph; give a number");
  return std::max(8, *first.graph_vertices);
}

/// The chain as a curve, before any post-processing.
PostProcessed chain_as_curve(PathEnergy& energy, const CoordinatePath& path) {
  PostProcessed out;
  out.chain = path;
  out.curve_costs = energy.costs(path);
  out.curve.cost = out.curve_costs.sum();
  out.curve.x = energy.ambient(path).x;
  return out;
}

/// What the post-processors make of a chain. Each takes the curve that the one before it has made: `so_far` keeps it,
/// for the case that the next one throws.
void post_process(const Problem& problem, const FirstPath& first, const FindOptions& options, const Monitor& monitor,
                  PostProcessed& so_far) {
  const CoordinatePath chain = so_far.chain;
  for (const auto& step : options.post_processors) {
    look_at_clock(monitor.deadline);
    PostProcessed processed = step->apply(problem, first, so_far, monitor);
    check_processed(problem, chain, processed);
    so_far = std::move(processed);
  }
}

/// The same, but a path that is solved stays, whatever becomes of its curve: `so_far` is what there was before the step
/// that threw, and the reason is returned. Throws Interrupted only.
std::optional<std::string> post_process_or_say_why(const Problem& problem, const FirstPath& first,
                                                   const FindOptions& options, const Monitor& monitor,
                                                   PostProcessed& so_far) {
  try {
    post_process(problem, first, options, monitor, so_far);
    return std::nullopt;
  } catch (const Interrupted&) {
    throw;
  } catch (const std::bad_alloc&) {
    return "there is not enough memory";
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception that is no std::exception";
  }
}

void deliver(const PostProcessed& processed, Eigen::VectorXd costs, Result& result) {
  result.costs = std::move(costs);
  result.path = processed.chain;
  result.curve = processed.curve;
  result.curve_costs = processed.curve_costs;
  result.notes.insert(result.notes.end(), processed.notes.begin(), processed.notes.end());
}

/// A path about which nothing is measured.
void deliver_unmeasured(Result& result) {
  result.costs.setConstant(result.path.segment_count(), kUnknown);
  result.curve_costs = result.costs;
  result.curve = {};
  result.curve.cost = kUnknown;
}

/// A ring that the solver lost may still be found again from the first path, by a post-processor that certifies itself.
bool has_collapsed(const Result& result, const PostProcessed& processed) {
  return processed.collapsed || (result.solve.termination == Termination::collapsed && !processed.curve.straightness);
}

/// Whether the cost, or another part of the problem, threw or contradicted itself.
bool failed(Termination end) { return end == Termination::exception || end == Termination::inconsistent; }

/// The best path of a solve in which the cost, or another part of the problem, threw or contradicted itself. It is not
/// asked again: nothing is measured about the path.
Result unfinished(Result result, const Problem& problem) {
  deliver_unmeasured(result);
  result.curve.x = PathEnergy(problem, 1).ambient(result.path).x;
  result.certificate.failures.push_back(
      {std::string(name(result.solve.termination)), "while solving: " + result.solve.message});
  return result;
}

Status status_of(const Result& result, bool collapsed, const Monitor& monitor) {
  const Termination end = result.solve.termination;
  if (end == Termination::cancelled || end == Termination::time_limit) return Status::interrupted;
  if (monitor.interrupted() && !result.certificate.certified()) return Status::interrupted;
  if (collapsed) return Status::collapsed;
  return result.certificate.certified() ? Status::certified : Status::uncertified;
}

/// One search: the stages of find_path(), each of which may be cut short by the clock.
class Search {
 public:
  Search(const Problem& problem, const Solver& solver, const FindOptions& options, const Monitor& monitor)
      : solver_(solver), options_(options), monitor_(monitor), last_words_(last_words(monitor.deadline, start_)) {
    check(problem);
    check(options);
    problem_ = with_sites(problem, result_.notes);
    refuse_one_point(problem_);
    refuse_end_in_clearance(problem_);
  }

  Result from(const Initializer& initializer) {
    return whole([&] {
      result_.first = first_path(initializer);
      check_path(problem_, result_.first.path, problem_.ring ? 1 : 2, "the first path");
      cut_based_ring();
      pin_ends(problem_, result_.first.path);
      result_.initial = sample_equally(problem_, result_.first.path, point_count(options_, result_.first), 0.05, 8,
                                       monitor_.deadline);
      sampled_ = true;
    });
  }

  Result from(const CoordinatePath& chain) {
    return whole([&] {
      result_.first.path = chain;
      cut_based_chain();
      place_chain(result_.first.path);
      result_.initial = result_.first.path;
      PathEnergy energy(problem_, 1, monitor_.deadline);
      const Eigen::VectorXd costs = energy.costs(result_.initial);
      refuse_infinite(problem_, energy.ambient(result_.initial).x, costs);
    });
  }

 private:
  template <class Begin>
  Result whole(Begin begin) {
    try {
      stage(Stage::initialize, monitor_, result_.seconds.initialize, begin);
      result_.path = result_.initial;
      set_reference_cost();
      solve();
      if (failed(result_.solve.termination)) return with_notes(unfinished(result_, problem_));
      look_at_clock(monitor_.deadline);
      deliver_and_certify();
    } catch (const Interrupted& stopped) {
      interrupted(stopped.what());
    }
    return with_notes(std::move(result_));
  }

  /// Among obstacles its failure has a name of its own.
  FirstPath first_path(const Initializer& initializer) const {
    try {
      return initializer.first_path(problem_, monitor_);
    } catch (const InitializationError& error) {
      if (find_ability<ChecksMoves>(*problem_.manifold) == nullptr) throw;
      throw InitializationError(std::string("no_passage: ") + error.what());
    }
  }

  /// A ring with a fixed point is an open path from that point to itself.
  void cut_based_ring() {
    if (!problem_.ring || !problem_.based) return;
    BasedLoop loop = cut_at_base(problem_, result_.first);
    problem_ = std::move(loop.problem);
    result_.first = std::move(loop.first);
    check(problem_);
  }

  /// The result of such a search is open already, and ends at the image of the point that it has found.
  void cut_based_chain() {
    const CoordinatePath& chain = result_.first.path;
    if (!problem_.ring || !problem_.based) return;
    if (chain.ring) {
      check_path(problem_, chain, 1, "the chain");
      return cut_based_ring();
    }
    if (chain.u.rows() != problem_.source.u.size() || chain.u.cols() < 3) return;  // place_chain() says so
    problem_.ring = false;
    problem_.target = {chain.u.rightCols(1), problem_.source.site};
    check(problem_);
  }

  void place_chain(CoordinatePath& chain) {
    constexpr double kSame = 1e-9;
    check_path(problem_, chain, problem_.ring ? 1 : 3, "the chain");
    pin_ends(problem_, chain);
    CoordinatePath placed = chain;
    const Projection projection = project(*problem_.manifold, placed, monitor_.deadline);
    if (!projection.failed.empty())
      throw InputError("column " + std::to_string(projection.failed.front()) +
                       " of the chain has no nearest point on the domain" +
                       reason_for_failure(*problem_.manifold, chain.u.col(projection.failed.front())));
    const bool off = projection.moved > kSame * chain.u.cwiseAbs().maxCoeff();
    if (off) chain.u = placed.u;
    chain.sites = std::move(placed.sites);
    pin_ends(problem_, chain);
    if (chain.ring || chain.sites.empty()) return;
    chain.sites.front() = problem_.source.site;
    chain.sites.back() = problem_.target.site;
  }

  void set_reference_cost() {
    result_.initial_cost = PathEnergy(problem_, 1, monitor_.deadline).cost(result_.initial);
    result_.reference_cost =
        options_.reference_cost.value_or(result_.initial_cost / static_cast<double>(result_.initial.segment_count()));
    if (!(result_.reference_cost > 0))
      throw InitializationError("the first path costs nothing: there is nothing to minimise");
    if (!std::isfinite(result_.reference_cost))
      throw InitializationError("the first path costs infinitely much, or more than a number can say");
  }

  void solve() {
    stage(Stage::solve, monitor_, result_.seconds.solve, [&] {
      solve_chain();
      constexpr double kShallower = 0.75;
      const Index points = result_.path.free_count();
      for (double depth = depth_in_obstacles(), before = depth; depth > 0 && double_points(); before = depth) {
        solve_chain();
        depth = depth_in_obstacles();
        if (!(depth < kShallower * before)) break;  // points are not what it lacks
      }
      if (result_.path.free_count() > points)
        result_.notes.push_back("points: " + std::to_string(result_.path.free_count()) + " instead of " +
                                std::to_string(points) + ", whose moves would not go between the obstacles");
      if (!options_.escape_saddle || failed(result_.solve.termination)) return;
      PathEnergy energy(problem_, result_.reference_cost, monitor_.deadline);
      const int left =
          escape_saddles(energy, solver_, options_.certificate.index_shift, result_.path, result_.solve, monitor_);
      if (left > 0) result_.notes.push_back("escape_saddle: left " + std::to_string(left) + " saddles");
      if (!energy.has_exact_hessian())
        result_.notes.emplace_back(
            "escape_saddle: a path on a polyhedron, or under H = s, has no index that could show a saddle");
    });
  }

  void solve_chain() {
    SolveReport report = options_.cascade
                             ? solve_by_cascade(problem_, solver_, result_.reference_cost, result_.path, monitor_)
                             : solve_fitted(problem_, solver_, result_.reference_cost, result_.path, monitor_);
    result_.solve = result_.solve.history.empty() ? std::move(report) : joined(result_.solve, std::move(report));
  }

  /// By how much the moves of the chain touch what its points keep away from; 0 where that is not measured.
  double depth_in_obstacles() {
    if (failed(result_.solve.termination) || monitor_.interrupted()) return 0;
    if (find_ability<FitsSegments>(*problem_.manifold) == nullptr) return 0;
    const Points x = positions(*problem_.manifold, result_.path);
    const auto clearance = measure_clearance(*problem_.manifold, x, result_.path.ring, monitor_.deadline);
    const double extent = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).norm();
    return clearance && clearance->lower < -options_.certificate.clearance * extent ? -clearance->lower : 0;
  }

  /// Begins anew with twice as many points along the first path, where there is one and they are not too many.
  bool double_points() {
    constexpr Index kMostPointsWhenDoubled = 4000;
    const auto& steps = options_.post_processors;
    if (std::any_of(steps.begin(), steps.end(), [](const auto& step) { return step->finds_its_own(); })) return false;
    const Index points = 2 * result_.initial.free_count();
    if (!sampled_ || points > kMostPointsWhenDoubled) return false;
    result_.initial =
        sample_equally(problem_, result_.first.path, static_cast<int>(points), 0.05, 8, monitor_.deadline);
    result_.path = result_.initial;
    set_reference_cost();
    return true;
  }

  void deliver_and_certify() {
    PathEnergy energy(problem_, result_.reference_cost, monitor_.deadline);
    const ToCurve to_curve = [&](const CoordinatePath& chain) {
      PostProcessed curve = chain_as_curve(energy, chain);
      post_process(problem_, result_.first, options_, monitor_, curve);
      return curve;
    };
    PostProcessed processed = chain_as_curve(energy, result_.path);
    std::optional<std::string> fault;
    stage(Stage::post_process, monitor_, result_.seconds.post_process,
          [&] { fault = post_process_or_say_why(problem_, result_.first, options_, monitor_, processed); });
    const bool collapsed = has_collapsed(result_, processed);
    deliver(processed, energy.costs(processed.chain), result_);
    result_.post_processed = true;
    if (fault) result_.certificate.failures.push_back({"post_process", "the curve stays as it was before: " + *fault});
    if (options_.certificate.enabled && !collapsed && !fault) certify_delivered(processed, to_curve);
    say_what_obstacles_did();
    result_.status = status_of(result_, collapsed, monitor_);
  }

  /// A path on the other side of an obstacle than the one that was begun with is not what was asked for, unless it is
  /// shown to be the least of its class. Where the fit to the obstacles did not end, that is why the path fails.
  void say_what_obstacles_did() {
    const auto* obstacles = find_ability<ChecksMoves>(*problem_.manifold);
    if (obstacles == nullptr || !options_.certificate.enabled) return;
    auto& failures = result_.certificate.failures;
    if (!failures.empty() && result_.solve.cycling)
      failures.push_back(
          {"active_set_cycling", "what the points keep from the obstacles and where they come to rest did not agree"});
    if (problem_.ring || result_.curve.least_of_class) return;
    const Points first = positions(*problem_.manifold, result_.first.path);
    if (!obstacles->same_class(first, result_.curve.x).value_or(true))
      failures.push_back({"class_lost", "the path passes an obstacle on another side than the first path"});
  }

  void certify_delivered(const PostProcessed& processed, const ToCurve& to_curve) {
    if (monitor_.interrupted()) return not_certified();
    stage(Stage::certify, monitor_, result_.seconds.certify, [&] {
      try {
        make_coarser_versions();
        result_.certificate =
            certify(problem_, result_.reference_cost, processed, to_curve, options_.certificate, monitor_);
        if (std::string note = name_cheaper_image(); !note.empty()) result_.notes.push_back(std::move(note));
      } catch (const Interrupted&) {
        throw;
      } catch (const std::exception& error) {  // the path is found: what a part throws now takes nothing away from it
        result_.certificate.failures.push_back({"exception", std::string("while certifying: ") + error.what()});
      } catch (...) {
        result_.certificate.failures.push_back(
            {"exception", "while certifying: an exception that is no std::exception"});
      }
    });
    result_.seconds.certify -= result_.seconds.prepare;
  }

  /// The path goes to the coordinates that were given; where it would be cheaper to go to others of the same point, the
  /// result says so.
  std::string name_cheaper_image() {
    Monitor quiet = monitor_;
    quiet.observe = nullptr;
    try {
      return cheaper_image(problem_, result_.curve.cost, quiet);
    } catch (const Interrupted&) {
      return "";  // the certificate stands
    }
  }

  /// Without a deadline they are made now. With one there are those that prepare() has made, or none.
  void make_coarser_versions() {
    if (monitor_.deadline) return;
    const auto start = Monitor::Clock::now();
    prepare(problem_);
    if (find_ability<HasCoarserVersion>(*problem_.manifold) == nullptr) return;
    result_.seconds.prepare = std::chrono::duration<double>(Monitor::Clock::now() - start).count();
  }

  void not_certified() {
    result_.certificate.failures.push_back({"interrupted", "there was no time for the certificate"});
  }

  /// The best path so far, with as much as can be measured in the time that is left.
  void interrupted(const std::string& why) {
    result_.status = Status::interrupted;
    if (result_.post_processed) return;
    if (options_.certificate.enabled) not_certified();
    if (result_.path.u.size() == 0) {
      result_.notes.push_back("interrupted before there was a path: " + why);
      return;
    }
    deliver_unmeasured(result_);
    try {
      PathEnergy energy(problem_, 1, last_words_);
      const PostProcessed chain = chain_as_curve(energy, result_.path);
      deliver(chain, chain.curve_costs, result_);
    } catch (const Interrupted&) {
      result_.notes.emplace_back("interrupted: there was no time to measure the path");
    }
  }

  static Result with_notes(Result result) {
    result.notes.insert(result.notes.begin(), result.first.notes.begin(), result.first.notes.end());
    return result;
  }

  const Monitor::Clock::time_point start_ = Monitor::Clock::now();
  const Solver& solver_;
  const FindOptions& options_;
  const Monitor& monitor_;
  const Deadline last_words_;
  Problem problem_;
  Result result_;
  bool sampled_ = false;  ///< the chain, along the first path
};

}  // namespace

std::string_view name(Status status) {
  switch (status) {
    case Status::certified: return "certified";
    case Status::uncertified: return "uncertified";
    case Status::collapsed: return "collapsed";
    case Status::interrupted: return "interrupted";
  }
  return "unknown";
}

Result find_path(const Problem& problem, const Initializer& initializer, const Solver& solver,
                 const FindOptions& options, const Monitor& monitor) {
  return Search(problem, solver, options, monitor).from(initializer);
}

Result improve_path(const Problem& problem, const CoordinatePath& chain, const Solver& solver,
                    const FindOptions& options, const Monitor& monitor) {
  return Search(problem, solver, options, monitor).from(chain);
}

void complete_interrupted(const Problem& problem, const FindOptions& options, Result& result) {
  if (result.status != Status::interrupted || result.post_processed || result.path.u.size() == 0) return;
  check(problem);
  check(options);
  if (result.path.u.rows() != problem.manifold->dimensions().coordinate)  // (a based ring is open in its result)
    throw InputError("the path has " + std::to_string(result.path.u.rows()) + " coordinates, the domain " +
                     std::to_string(problem.manifold->dimensions().coordinate));
  Monitor stopped;  // post-processors that improve a path step by step return at once
  stopped.stop_requested = [] { return true; };
  PathEnergy energy(problem, 1);
  try {
    PostProcessed processed = chain_as_curve(energy, result.path);
    if (const auto fault = post_process_or_say_why(problem, result.first, options, stopped, processed))
      processed.notes.push_back("the curve stays as it was before: " + *fault);
    deliver(processed, energy.costs(processed.chain), result);
    result.post_processed = true;
  } catch (const Interrupted&) {
    const PostProcessed chain = chain_as_curve(energy, result.path);
    deliver(chain, chain.curve_costs, result);
  }
}

void prepare(const Problem& problem) {
  check(problem);
  std::shared_ptr<const ConstraintManifold> manifold = problem.manifold;
  for (int level = 0; manifold && level < kGeometryLevels; ++level) {
    const auto* domain = find_ability<HasCoarserVersion>(*manifold);
    try {
      manifold = domain != nullptr ? domain->coarser() : nullptr;
    } catch (const InputError&) {
      return;  // too little is left; the certificate says so
    }
  }
}

}  // namespace leastcost
