// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/search/find_path.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/cost/has_notes.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/fits_segments.hpp>
#include <leastcost/framework/domain/makes_on_demand.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/framework/search/other_images.hpp>
#include "framework/base/point_text.hpp"
#include "framework/certificate/certify.hpp"
#include "framework/certificate/geometry_error.hpp"
#include "framework/domain/in_parts.hpp"
#include "framework/energy/solve_fitted.hpp"
#include "framework/energy/spacing.hpp"
#include "framework/newton/cascade.hpp"
#include "framework/newton/escape_saddle.hpp"
#include "framework/search/among_obstacles.hpp"
#include "framework/search/based_loop.hpp"
#include "framework/search/delivery.hpp"
#include "framework/search/find_path_checks.hpp"
#include "framework/search/free_passage.hpp"
#include "framework/search/never_worse.hpp"
#include "framework/search/placement.hpp"
#include "framework/search/refine_until_certified.hpp"

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

/// What may still be measured of an interrupted path: the first parts of what the contract leaves after the deadline.
Deadline last_words(const Deadline& deadline, Monitor::Clock::time_point start, int parts = 1) {
  constexpr auto kLeast = std::chrono::microseconds(300);
  constexpr int kPart = 33;  // of the budget
  if (!deadline) return {};
  return *deadline + parts * std::max<Monitor::Clock::duration>(kLeast, (*deadline - start) / kPart);
}

int point_count(const FindOptions& options, const FirstPath& first) {
  if (options.points) return *options.points;
  if (!first.graph_vertices)
    throw InputError("points: auto counts the vertices of an edge path, and this domain has no graph; give a number");
  return std::max(8, *first.graph_vertices);
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
  /// `problem`: where it is renamed, its target receives the name that the first path leads to.
  Search(Problem& problem, const Solver& solver, const FindOptions& options, const Monitor& monitor)
      : solver_(solver),
        options_(options),
        monitor_(monitor),
        last_words_(last_words(monitor.deadline, start_)),
        given_(problem) {
    check(problem);
    check(options);
    if (const auto* told = find_ability<HasNotes>(*problem.cost)) result_.notes = told->notes();
    problem_ = problem;
  }

  Result from(const Initializer& initializer) {
    return whole([&] {
      if (initializer.name() == "straight") go_over_pole();
      result_.first = first_path(initializer);
      check_path(problem_, result_.first.path, problem_.ring ? 1 : 2, "the first path");
      rename_target();
      cut_based_ring();
      domain_ = problem_.manifold;
      pin_ends(problem_, result_.first.path);
      result_.initial = sampled(point_count(options_, result_.first));
      sampled_ = true;
    });
  }

  Result from(const CoordinatePath& chain) {
    return whole([&] {
      result_.first.path = chain;
      cut_based_chain();
      place_chain(problem_, result_.first.path, monitor_.deadline);
      result_.initial = result_.first.path;
      PathEnergy energy(problem_, 1, monitor_.deadline);
      const Eigen::VectorXd costs = energy.costs(result_.initial);
      refuse_infinite(problem_, energy.ambient(result_.initial).x, costs);
    });
  }

 private:
  void place_ends() {
    problem_ = with_sites(problem_, result_.notes, monitor_.deadline);
    refuse_one_point(problem_);
    refuse_end_in_clearance(problem_);
  }

  template <class Begin>
  Result whole(Begin begin) {
    try {
      stage(Stage::initialize, monitor_, result_.seconds.initialize, [&] {
        place_ends();
        begin();
      });
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

  /// Points along the first path. A post-processor that finds the way by itself needs no moves between them.
  CoordinatePath sampled(int points) const {
    try {
      return sample_equally(problem_, result_.first.path, points, 0.05, spacing_passes(), monitor_.deadline);
    } catch (const InitializationError&) {
      if (!finds_its_own() || !(cost_of_first_path() < std::numeric_limits<double>::infinity())) throw;
      return sample_evenly(problem_, result_.first.path, points, monitor_.deadline);
    }
  }
  bool finds_its_own() const {
    const auto& steps = options_.post_processors;
    return !solver_.moves_points() &&
           std::any_of(steps.begin(), steps.end(), [](const auto& step) { return step->finds_its_own(); });
  }
  double cost_of_first_path() const { return PathEnergy(problem_, 1, monitor_.deadline).cost(result_.first.path); }

  /// Under a length, even steps along the first path are equally spaced on it; that is enough where no solver begins
  /// from the points and a post-processor makes the curve.
  int spacing_passes() const {
    constexpr int kPasses = 8;
    const bool on_curve = !solver_.moves_points() && !options_.post_processors.empty();
    return on_curve && find_ability<HasConstantMetric>(*problem_.cost) != nullptr ? 0 : kPasses;
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

  /// From one side of a pole to the other the straight line in coordinates goes round the pole, and a chain that
  /// follows it jumps.
  void go_over_pole() {
    constexpr double kAtMost = 1.5;  // of the line to the target itself: no promise beyond
    const auto* chart = find_ability<HasChart>(*problem_.manifold);
    if (options_.target_as_given || problem_.ring || problem_.based || chart == nullptr || chart->poles().size() != 2)
      return;
    Monitor quiet = monitor_;
    quiet.observe = nullptr;
    const std::vector<TriedImage> tried = other_images(problem_, quiet.deadline);
    if (tried.empty() || !(tried.front().cost < kAtMost * straight_start_cost(problem_, quiet.deadline))) return;
    if (const std::optional<CheaperImage> best = find_cheaper_image(problem_, quiet))
      given_.target.u = problem_.target.u = best->image.u;
  }

  /// Waypoints round the axis lead to another name of the target than the one nearest to the source.
  void rename_target() {
    const Points& u = result_.first.path.u;
    if (options_.target_as_given || problem_.ring || u.cols() < 2) return;
    given_.target.u = problem_.target.u = nearest_name(problem_, problem_.target.u, u.col(u.cols() - 2));
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

  void set_reference_cost() {
    result_.initial_cost = PathEnergy(problem_, 1, monitor_.deadline).cost(result_.initial);
    if (sampled_ && !std::isfinite(result_.initial_cost) && finds_its_own())
      result_.initial_cost = cost_of_first_path();
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

  /// Only where its points can be fitted to them.
  double depth_in_obstacles() const {
    if (failed(result_.solve.termination) || monitor_.interrupted()) return 0;
    if (find_ability<FitsSegments>(*problem_.manifold) == nullptr) return 0;
    return leastcost::depth_in_obstacles(problem_, result_.path, options_.certificate.clearance, monitor_.deadline);
  }

  /// Begins anew with twice as many points along the first path, where there is one and they are not too many.
  bool double_points() {
    constexpr Index kMostPointsWhenDoubled = 4000;
    const auto& steps = options_.post_processors;
    if (std::any_of(steps.begin(), steps.end(), [](const auto& step) { return step->finds_its_own(); })) return false;
    const Index points = 2 * result_.initial.free_count();
    if (!sampled_ || points > kMostPointsWhenDoubled) return false;
    return sample_anew(result_.first.path, points);
  }

  /// Begins anew with points along another path, on the domain as it was given: what it has been fitted to says nothing
  /// of another chain. False where there is no such chain, and nothing has changed.
  bool sample_anew(const CoordinatePath& path, Index points) {
    Problem given = problem_;
    given.manifold = domain_;
    CoordinatePath chain;
    try {
      chain = sample_equally(given, path, static_cast<int>(points), 0.05, 8, monitor_.deadline);
    } catch (const InitializationError&) {
      return false;
    }
    if (!(PathEnergy(given, 1, monitor_.deadline).cost(chain) > 0)) return false;
    problem_ = std::move(given);
    result_.initial = std::move(chain);
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
    const std::optional<FreePassage> joined = join_by_free_place();
    PostProcessed processed = chain_as_curve(energy, result_.path);
    processed.unsolved = !solver_.moves_points();
    std::optional<std::string> fault = make_curve(processed);
    if (processed.cheaper && !fault && !begun_anew_) {
      if (begin_anew(processed)) return deliver_and_certify();
      // What the post-processor left open for the other path's sake is done now.
      processed = chain_as_curve(energy, result_.path);
      processed.unsolved = !solver_.moves_points();
      fault = make_curve(processed);
    }
    const bool collapsed = joined || has_collapsed(result_, processed);
    deliver(processed, energy.costs(processed.chain), result_);
    result_.post_processed = true;
    if (fault) result_.certificate.failures.push_back({"post_process", "the curve stays as it was before: " + *fault});
    if (options_.certificate.enabled && !collapsed && !fault) certify_delivered(processed, to_curve);
    if (options_.certificate.enabled) judge_among_obstacles(problem_, result_);
    if (joined)
      result_.certificate.spacing = spread_where_paid(result_.costs, joined->free);
    else
      name_free_passage();
    result_.status = status_of(result_, collapsed, monitor_);
  }

  std::optional<std::string> make_curve(PostProcessed& processed) {
    std::optional<std::string> fault;
    const double before = result_.seconds.post_process;
    stage(Stage::post_process, monitor_, result_.seconds.post_process,
          [&] { fault = post_process_or_say_why(problem_, result_.first, options_, monitor_, processed); });
    if (begun_anew_) result_.seconds.post_process += before;
    return fault;
  }

  /// Solves again from a cheaper path that a post-processor has found, once. False where what comes out costs no less:
  /// then everything is as it was.
  bool begin_anew(const PostProcessed& processed) {
    begun_anew_ = true;
    if (!sampled_) return false;
    Result before = result_;
    const Problem fitted = problem_;
    if (!sample_anew(*processed.cheaper, result_.path.free_count())) return false;
    result_.first.path = *processed.cheaper;  // whose class is kept from here on
    solve();
    result_.seconds.solve += before.seconds.solve;
    const double cost = failed(result_.solve.termination)
                            ? std::numeric_limits<double>::infinity()
                            : PathEnergy(problem_, 1, monitor_.deadline).cost(result_.path);
    constexpr double kWorthSaying = 1e-9;
    if (cost < processed.curve.cost * (1 - kWorthSaying)) {
      result_.notes.push_back("a search over all paths found another way, which costs " +
                              short_number(100 * (1 - cost / processed.curve.cost)) + " % less and is delivered");
      return true;
    }
    result_ = std::move(before);
    problem_ = fitted;
    return false;
  }

  /// A path that has come to a place where moves are free is the way by it, whose two parts are joined there.
  std::optional<FreePassage> join_by_free_place() {
    if (!reaches_free_place(problem_, result_.path)) return std::nullopt;
    std::optional<FreePassage> passage = free_passage(problem_, result_.path);
    if (!passage) return std::nullopt;
    result_.path.u = passage->points;
    result_.notes.push_back(
        "collapsed: the path has come to where moves are free; delivered is the cheapest way by "
        "there, of cost " +
        short_number(passage->cost, 6) + ", whose two parts are joined by a move that costs nothing");
    return passage;
  }

  /// A path that keeps away from such places may be the least of its neighbours and dearer than the way by them.
  void name_free_passage() {
    const std::optional<FreePassage> passage = free_passage(problem_, result_.path);
    if (!passage || !(passage->cost < result_.curve.cost)) return;
    const TwoNumbers texts = told_apart(passage->cost, result_.curve.cost, 6);
    result_.notes.push_back("cheaper: the way by the places where moves are free costs " + texts.first +
                            ", this path " + texts.second + ", which is the least of its neighbours only");
  }

  void certify_delivered(const PostProcessed& processed, const ToCurve& to_curve) {
    if (monitor_.interrupted()) return not_certified();
    stage(Stage::certify, monitor_, result_.seconds.certify, [&] {
      try {
        make_coarser_versions();
        result_.certificate =
            certify(problem_, result_.reference_cost, processed, to_curve, options_.certificate, monitor_);
        if (std::string note = name_cheaper_image(); !note.empty()) result_.notes.push_back(std::move(note));
        name_free_ways();
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

  /// A certificate then speaks of the value, and not of the path.
  void name_free_ways() {
    const std::optional<Regularization>& found = result_.certificate.regularization;
    if (!found || found->free_ways.empty()) return;
    result_.notes.push_back(found->free_ways + (result_.certificate.certified()
                                                    ? ": the value is certified, the path is not unique"
                                                    : ": the path is not unique"));
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
  Problem& given_;
  Problem problem_;                                   ///< its domain may be fitted to the chain that was solved last
  std::shared_ptr<const ConstraintManifold> domain_;  ///< as it was given, where there is a first path
  Result result_;
  bool sampled_ = false;     ///< the chain, along the first path
  bool begun_anew_ = false;  ///< from a path that a post-processor has found
};

}  // namespace

Result find_path(const Problem& problem, const Initializer& initializer, const Solver& solver,
                 const FindOptions& options, const Monitor& monitor) {
  const auto start = Monitor::Clock::now();
  Problem named = problem;
  if (!options.target_as_given) name_target_near(problem.source.u, named);
  Result found = Search(named, solver, options, monitor).from(initializer);
  found = refine_until_certified(named, std::move(found), solver, options, monitor);
  return never_worse(named, std::move(found), options, last_words(monitor.deadline, start, 2));
}

Result improve_path(const Problem& problem, const CoordinatePath& chain, const Solver& solver,
                    const FindOptions& options, const Monitor& monitor) {
  const auto start = Monitor::Clock::now();
  Problem named = problem;
  if (!options.target_as_given && chain.u.cols() > 0) name_target_near(chain.u.rightCols(1), named);
  Result found = Search(named, solver, options, monitor).from(chain);
  found = refine_until_certified(named, std::move(found), solver, options, monitor);
  return never_worse(named, std::move(found), options, last_words(monitor.deadline, start, 2));
}

Result search_from(const Problem& problem, const CoordinatePath& chain, const Solver& solver,
                   const FindOptions& options, const Monitor& monitor) {
  Problem named = problem;
  return Search(named, solver, options, monitor).from(chain);
}

void prepare(const Problem& problem) {
  check(problem);
  std::shared_ptr<const ConstraintManifold> manifold = problem.manifold;
  if (const auto* parts = find_ability<MakesOnDemand>(*manifold)) parts->make({});
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
