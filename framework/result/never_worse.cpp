// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/result/never_worse.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include "framework/base/point_text.hpp"
#include "framework/energy/spacing.hpp"
#include "framework/result/delivery.hpp"
#include "framework/result/feasible_cost.hpp"

namespace leastcost {
namespace {

constexpr double kCheaperPart = 1e-8;  ///< relative: what costs measured in two ways may differ by

/// What decides between two paths: first how deep in obstacles (0: clear), then the cost. Of a curve on the domain and
/// of the moves between its points: where points are too few to see all of the cost, one of them alone says little.
struct Standing {
  double depth = 0;
  double cost = std::numeric_limits<double>::infinity();
  double moves = std::numeric_limits<double>::infinity();

  bool better_than(const Standing& other) const {
    if (depth != other.depth) return depth < other.depth;
    return cost < other.cost * (1 - kCheaperPart) && moves < other.moves * (1 - kCheaperPart);
  }
};

struct Offer {
  PostProcessed curve;
  Standing standing;
};

/// A based ring is open in its result, and ends where it begins.
Problem as_solved(const Problem& problem, const CoordinatePath& path) {
  Problem out = problem;
  if (!problem.ring || path.ring) return out;
  out.ring = false;
  out.target = {path.u.rightCols(1), problem.source.site};
  return out;
}

double depth_of(const Problem& problem, const CoordinatePath& chain, const Points& curve, const FindOptions& options,
                const Deadline& deadline) {
  const double allowed = options.certificate.clearance;
  // Moves between the points are delivered where the curve is made of them, or where there was no time for one.
  if (curve.cols() < 2 || curve.cols() == chain.segment_count() + 1)
    return depth_in_obstacles(problem, chain, allowed, deadline);
  const auto clearance = measure_clearance(*problem.manifold, curve, chain.ring, deadline);
  if (!clearance) return 0;
  return clearance->lower < -contact_tolerance(curve, allowed) ? -clearance->lower : 0;
}

Standing standing_of(const Problem& problem, const Result& result, const FindOptions& options,
                     const Deadline& deadline) {
  Result bare;  // without its certificate, whose bounds are those of the chains that it has solved
  bare.path = result.path;
  bare.curve = result.curve;
  const double depth = depth_of(problem, result.path, result.curve.x, options, deadline);
  const double chain = PathEnergy(problem, 1, deadline).cost(result.path);
  if (result.curve.x.cols() < 2) return {depth, chain, chain};
  const bool known = std::isfinite(result.curve.cost) && !moves_are_exact(problem);
  const double cost = known ? feasible_cost(problem, bare, deadline) : result.curve.cost;
  const bool mesh = problem.manifold->shape() == Shape::polyhedral;
  return {depth, cost, mesh || !std::isfinite(cost) ? result.curve.cost : chain};
}

/// The points of a first path as its method found them, each once.
CoordinatePath own_points(const CoordinatePath& path) {
  CoordinatePath out{Points(path.u.rows(), path.u.cols()), {}, path.ring, path.closing};
  Index kept = 0;
  for (Index i = 0; i < path.u.cols(); ++i) {
    if (kept > 0 && path.u.col(i) == out.u.col(kept - 1)) continue;
    out.u.col(kept++) = path.u.col(i);
    if (!path.sites.empty()) out.sites.push_back(path.site(i));
  }
  out.u.conservativeResize(Eigen::NoChange, kept);
  return out;
}

/// The ways to deliver a first path, the points that were asked for first. On a mesh only edges are known to lie on it.
std::vector<CoordinatePath> ways_to_deliver(const Problem& problem, const Result& result) {
  const bool mesh = problem.manifold->shape() == Shape::polyhedral;
  std::vector<CoordinatePath> ways;
  if (!mesh && result.initial.u.size() > 0) ways.push_back(result.initial);
  const bool own =
      mesh ? result.first.graph_vertices.has_value() : find_ability<ChecksMoves>(*problem.manifold) != nullptr;
  if (!own || result.first.path.u.size() == 0) return ways;
  CoordinatePath points = own_points(result.first.path);
  if (points.free_count() >= 1) ways.push_back(std::move(points));
  return ways;
}

std::optional<Offer> best_offer(const Problem& problem, const Result& result, const FindOptions& options,
                                const Deadline& deadline) {
  const bool mesh = problem.manifold->shape() == Shape::polyhedral;
  Monitor stopped;  // on a mesh the moves are traced over the faces, and no more
  stopped.stop_requested = [] { return true; };
  std::optional<Offer> best;
  PathEnergy energy(problem, 1, deadline);
  for (const CoordinatePath& chain : ways_to_deliver(problem, result)) {
    Result trial;
    PostProcessed curve = chain_as_curve(energy, chain);
    if (mesh &&
        (post_process_or_say_why(problem, result.first, options, stopped, curve) || curve.curve.segment_sites.empty()))
      continue;
    trial.path = chain;
    trial.curve = curve.curve;
    Offer offer{curve, standing_of(problem, trial, options, deadline)};
    if (!std::isfinite(offer.standing.cost)) continue;
    if (!best || offer.standing.depth < best->standing.depth) best = std::move(offer);
  }
  return best;
}

/// Whether there is anything to compare, decided by what is known already. A certified path is looked at again only
/// where sums of moves are true costs and say that the first path is cheaper by more than the bar.
bool worth_comparing(const Problem& problem, const Result& result) {
  if (result.status == Status::collapsed || result.path.u.size() == 0) return false;
  const CostEstimate& estimate = result.certificate.estimate;
  if (result.status == Status::certified)
    return moves_are_exact(problem) && result.initial_cost < (estimate.value - estimate.error) * (1 - kCheaperPart);
  const bool obstacles = find_ability<ChecksMoves>(*problem.manifold) != nullptr;
  if (result.status == Status::interrupted) return obstacles || result.curve.cost > result.initial_cost;
  return true;
}

/// The first path where it is better than what the search came to.
std::optional<Offer> better_offer(const Problem& given, const Result& result, const FindOptions& options,
                                  const Deadline& deadline, Standing& searched) {
  if (!worth_comparing(given, result)) return std::nullopt;
  const Problem problem = as_solved(given, result.path);
  std::optional<Offer> offer = best_offer(problem, result, options, deadline);
  if (!offer) return std::nullopt;
  searched = standing_of(problem, result, options, deadline);
  if (!offer->standing.better_than(searched)) return std::nullopt;
  return offer;
}

std::string why(const Offer& offer, const Standing& searched) {
  const TwoNumbers costs = told_apart(offer.curve.curve.cost, searched.cost, 9);
  std::string text = "the first path is delivered; its cost is " + costs.first;
  if (offer.standing.depth < searched.depth) {
    text += offer.standing.depth > 0 ? ", and it penetrates obstacles less" : ", and it does not touch the obstacles";
    return text + "; the path found from it goes " + short_number(searched.depth) + " too far into one";
  }
  return text + "; the path found from it " +
         (std::isfinite(searched.cost) ? "costs " + costs.second : std::string("is not a curve on the domain"));
}

/// The certificate says what is measured of the delivered path, and why the other one was refused.
void refuse(const Problem& problem, const Offer& offer, const Deadline& deadline, Result& result) {
  Certificate refused;
  refused.failures = std::move(result.certificate.failures);
  for (CertificateFailure& failure : refused.failures)
    failure.message = "of the path that was found but is not delivered: " + failure.message;
  if (result.status == Status::certified)
    refused.failures.push_back(
        {Failure::dearer_than_first, "the locally cheapest path costs more than the first path"});
  refused.clearance = measure_clearance(*problem.manifold, offer.curve.curve.x, offer.curve.chain.ring, deadline);
  refused.spacing = spread(offer.curve.curve_costs);
  if (std::optional<GlobalBound>& bound = result.certificate.global) {  // of all paths, so of this one too
    bound->gap = std::max(0.0, 1 - bound->lower_bound / offer.curve.curve.cost);
    if (bound->proved) bound->outcome = ProofOutcome::bounded;
    bound->proved = false;
    refused.global = std::move(bound);
  }
  result.certificate = std::move(refused);
  if (result.status == Status::certified) result.status = Status::uncertified;
}

/// Whether a moment is enough to see that the moves of a chain touch an obstacle.
bool touches_at_once(const Problem& problem, const CoordinatePath& chain, const FindOptions& options) {
  constexpr std::chrono::milliseconds kMoment{2};
  try {
    return depth_in_obstacles(problem, chain, options.certificate.clearance, Monitor::Clock::now() + kMoment) > 0;
  } catch (const Interrupted&) {
    return false;
  }
}

/// Of an interrupted search, where there was no time to compare. Among obstacles nothing says that the solver's chain
/// is clear of them, while most methods plan a first path that is; elsewhere sums of moves decide.
void prefer_first(const Problem& given, const FindOptions& options, Result& result) {
  if (result.status != Status::interrupted || result.path.u.size() == 0) return;
  if (given.manifold->shape() == Shape::polyhedral) return;  // moves that are not traced say nothing there
  const Problem problem = as_solved(given, result.path);
  const std::vector<CoordinatePath> ways = ways_to_deliver(problem, result);
  if (ways.empty()) return;
  PathEnergy energy(problem, 1);
  const bool obstacles = find_ability<ChecksMoves>(*problem.manifold) != nullptr;
  if (!obstacles && energy.cost(result.path) <= result.initial_cost) return;
  if (obstacles && touches_at_once(problem, ways.back(), options)) return;  // a straight one, or one by waypoints
  const PostProcessed first = chain_as_curve(energy, ways.back());
  if (!std::isfinite(first.curve.cost)) return;
  result.notes.emplace_back(
      "the first path is delivered: there was no time to compare it with the path that was found from it");
  deliver(first, first.curve_costs, result);
}

}  // namespace

bool moves_are_exact(const Problem& problem) {
  if (find_ability<HasChart>(*problem.manifold) != nullptr) return false;
  const ConstraintManifold* domain = problem.manifold.get();
  while (domain != nullptr && domain->shape() != Shape::flat) domain = domain->decorated(typeid(void));
  return domain != nullptr && problem.cost->traits().additive;
}

bool first_path_is_better(const Problem& problem, const Result& result, const FindOptions& options,
                          const Deadline& deadline) {
  Standing searched;
  return better_offer(problem, result, options, deadline, searched).has_value();
}

Result never_worse(const Problem& problem, Result result, const FindOptions& options, const Deadline& deadline) {
  try {
    Standing searched;
    std::optional<Offer> offer = better_offer(problem, result, options, deadline, searched);
    if (!offer) return result;
    refuse(problem, *offer, deadline, result);
    result.notes.push_back(why(*offer, searched));
    Eigen::VectorXd costs = offer->curve.curve_costs;
    deliver(offer->curve, std::move(costs), result);
    result.post_processed = true;
  } catch (const Interrupted&) {
    prefer_first(problem, options, result);
  } catch (const std::exception&) {  // a part that throws: what there is stays
  }
  return result;
}

}  // namespace leastcost
