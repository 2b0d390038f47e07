// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/ompl/polish.hpp>

#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/solvers/newton.hpp>
#include "framework/base/point_text.hpp"
#include "framework/result/find_path_checks.hpp"
#include "ompl/plans/other_plans.hpp"
#include "ompl/plans/plan_space.hpp"
#include "ompl/plans/tighten.hpp"

namespace leastcost {
namespace {

namespace og = ompl::geometric;

constexpr int kPieces = 1000;                             ///< in which costs of paths are compared
constexpr int kPlaces = 60;                               ///< on the given path, between which shortcuts are looked for
constexpr int kPulled = 40;                               ///< points of a path that is not searched from
constexpr int kMostRounds = 6;                            ///< of shortcuts
constexpr int kMostSights = 3;                            ///< of shortcuts from a tight path
constexpr double kWorthARound = 1e-3;                     ///< of the cost
constexpr double kRounding = 1e-12;                       ///< relative: by so much no path is cheaper
constexpr double kDeepest = 1 - 1 / std::numbers::sqrt2;  ///< of the chord between quaternions at a right angle

/// The plan as the first path.
class PlannedPath final : public Initializer {
 public:
  explicit PlannedPath(Points x) : x_(std::move(x)) {}
  std::string_view name() const override { return "ompl"; }
  FirstPath first_path(const Problem&, const Monitor&) const override { return {{x_, {}, false}, {}, {}}; }

 private:
  Points x_;
};

std::string state_name(Index i) { return "state " + std::to_string(i) + " of the path"; }

double length_of(const Points& x) {
  return (x.rightCols(x.cols() - 1) - x.leftCols(x.cols() - 1)).colwise().norm().sum();
}

class Polishing {
 public:
  Polishing(const og::PathGeometric& path, const PolishOptions& options, const Monitor& monitor)
      : given_(path),
        options_(options),
        monitor_(monitor),
        states_(path.getSpaceInformation()->getStateSpace(), options.turn),
        domain_(options.domain ? options.domain : states_.domain()),
        space_(path.getSpaceInformation(), states_, domain_, options.cost ? options.cost : states_.length()) {
    check_parts();
    read();
    set_problem();
  }

  Polished run() {
    out_.path = std::make_shared<og::PathGeometric>(given_);
    const double given = out_.cost = out_.given_cost = space_.cost(x_, length_of(x_) / kPieces);
    if (!std::isfinite(given)) throw InputError("the given path has infinite cost, or its cost overflows");
    if (!(given > 0)) {
      out_.why = "the given path has cost 0";
      return std::move(out_);
    }
    const bool by_answer = !options_.walls && !options_.distance;
    // Then what the planner has not seen on its own path it need not see on ours.
    heeds_clearance_ = !by_answer || !touches(x_, clearance_of(x_));
    const bool pulls_first = !by_answer && can_plan(space_) && (space_.is_flat() || !options_.domain);
    Points tight = pulls_first && !space_.is_flat() ? with_shortcuts(space_, x_, kPlaces, monitor_) : short_of(x_);
    if (by_answer)
      tight = pulled_tight(space_, tight, options_.search ? *options_.find.points : kPulled, monitor_);
    else if (pulls_first)
      tight = pulled_and_short_of(cheapest_plan(space_, problem_, tight, options_.other_plans, monitor_));
    else if (!options_.search)
      tight = pulled_and_short_of(tight);
    if (options_.search)
      search(tight, by_answer);
    else
      out_.why = "no search was requested";
    const Points& found = out_.result.path.u;
    const bool worse = pulls_first && found.cols() > 1 && space_.cost(tight) < (1 - kWorthARound) * space_.cost(found);
    if (worse) out_.why = "it costs more than what was pulled tight";
    if (!worse && found.cols() > 1 && take(found, PolishOutcome::polished)) return std::move(out_);
    if (options_.search && !by_answer && !pulls_first) tight = pulled_and_short_of(tight);  // as without a search
    if (!take(tight, PolishOutcome::tightened) && worse) take(found, PolishOutcome::polished);
    if (!out_.clearance) out_.clearance = clearance_of(x_);
    return std::move(out_);
  }

 private:
  /// Places on a path with shortcuts see farther than those on the path before.
  Points short_of(const Points& x) const {
    const int rounds = options_.search ? 1 : kMostRounds;  // a search goes on from there, and takes less time than one
    Points best = with_shortcuts(space_, x, kPlaces, monitor_);
    for (int k = 1; k < rounds; ++k) {
      Points next = with_shortcuts(space_, best, kPlaces, monitor_);
      const bool enough = !(space_.cost(next) < (1 - kWorthARound) * space_.cost(best));
      best = std::move(next);
      if (enough) break;
    }
    return best;
  }

  /// A path that is tight sees shortcuts that it did not see before.
  Points pulled_and_short_of(const Points& x) const {
    Points best = pulled_among_walls(space_, x, monitor_);
    for (int k = 0; k < kMostSights && !monitor_.interrupted(); ++k) {
      const Points shorter = with_shortcuts(space_, best, kPlaces, monitor_);
      if (!(space_.cost(shorter) < (1 - kWorthARound) * space_.cost(best))) break;
      best = pulled_among_walls(space_, shorter, monitor_);
    }
    return best;
  }

  void check_parts() const {
    if (!given_.getSpaceInformation()->isSetup())
      throw InputError("the space is not set up: call setup() of its SpaceInformation");
    if (options_.walls && options_.distance) throw InputError("obstacles: give walls or a distance, not both");
    check(options_.find);
    if (options_.other_plans < 0)
      throw InputError("other_plans is a number of plans, 0 or more, but it is " +
                       std::to_string(options_.other_plans));
    if (!options_.find.points) throw InputError("polishing needs a number of points");
    if (!options_.find.post_processors.empty())
      throw InputError(
          "polishing returns the chain itself: remove the post-processors, which would make another curve");
    const Dimensions dimensions = domain_->dimensions();
    if (dimensions.coordinate != states_.rows() || dimensions.ambient != states_.rows())
      throw InputError("states of the space have " + std::to_string(states_.rows()) + " rows, but the domain has " +
                       std::to_string(dimensions.coordinate) + " coordinates in " + std::to_string(dimensions.ambient) +
                       " dimensions");
    if (find_ability<HasChart>(*domain_) != nullptr)
      throw InputError("the domain is a chart, and its coordinates are not states of the space");
    const auto cost = options_.cost ? options_.cost : states_.length();
    if (cost->dim() != states_.rows())
      throw InputError("the cost has " + std::to_string(cost->dim()) + " dimensions, but states of the space have " +
                       std::to_string(states_.rows()));
  }

  /// The given path, if it is one.
  void read() {
    if (given_.getStateCount() < 2)
      throw InputError("a path must have at least two states, but this one has " +
                       std::to_string(given_.getStateCount()));
    x_ = states_.columns(given_);
    for (Index i = 0; i < x_.cols(); ++i)
      if (!space_.is_free(x_.col(i)))
        throw InputError(state_name(i) + ", " + point_text(x_.col(i)) +
                         ", is not valid or is outside the bounds of the space");
    for (Index i = 0; i + 1 < x_.cols() && !states_.constrained(); ++i)
      if (!space_.straight(x_.col(i), x_.col(i + 1)))
        throw InputError("the move from " + state_name(i) +
                         " to the next is not straight in its coordinates: leastcost would change it");
  }

  void set_problem() {
    const std::shared_ptr<const Walls> obstacles = walls();
    problem_.manifold = std::make_shared<FreeSpace>(domain_, obstacles);
    space_.look_at(obstacles);  // they see what the planner's resolution misses, or ask at other places than it does
    problem_.cost = options_.cost ? options_.cost : states_.length();
    problem_.kernel = options_.kernel ? options_.kernel : make_kernel<Expm1Square>();
    problem_.source.u = x_.col(0);
    problem_.target.u = x_.rightCols(1);
  }

  std::shared_ptr<const Walls> walls() {
    if (options_.walls) return options_.walls;
    const Index rows = states_.rows();
    if (!options_.distance) {
      const double longest = given_.getSpaceInformation()->getStateSpace()->getLongestValidSegmentLength();
      const double size = x_.cwiseAbs().maxCoeff();
      return make_checker_walls(rows, FreeChecker{.is_free = [this](const auto& x) { return space_.is_free(x); },
                                                  .resolution = longest / states_.steepness(),
                                                  .size = size > 0 ? size : 1,
                                                  .name = "the planner's checker"});
    }
    DistanceChecker checker = *options_.distance;
    if (!checker.distance) {
      checker.distance = [this](const auto& x) { return space_.clearance(x); };
      checker.name = "the planner's checker";
    }
    if (!states_.has_quaternions()) return make_checker_walls(rows, std::move(checker));
    // A move is a chord of the sphere, which is this much shorter than its arc where it is a right angle, and a
    // quotient of lengths: what bounds the second derivative on the sphere does not bound it here.
    checker.lipschitz *= std::numbers::sqrt2;
    checker.curvature = 0;
    checker.distance = [this, known = std::move(checker.distance)](const Eigen::VectorXd& x) {
      Eigen::VectorXd unit = x;
      const bool far = !states_.settle(unit) || (x - unit).norm() > kDeepest * options_.turn;
      return far ? std::numeric_limits<double>::quiet_NaN() : known(unit);
    };
    return make_checker_walls(rows, std::move(checker));
  }

  void search(const Points& first, bool by_answer) {
    problem_.target.u = first.rightCols(1);  // the same state, perhaps by the other name of a quaternion
    const std::shared_ptr<const Solver> solver = options_.solver ? options_.solver : std::make_shared<Newton>();
    try {
      const std::optional<Points> free = by_answer ? without_obstacles(first, *solver) : std::optional<Points>(first);
      if (!free) return;
      out_.result = find_path(problem_, PlannedPath(*free), *solver, options_.find, monitor_);
      if (out_.result.path.u.cols() < 2) out_.why = "there was no time for a search";
    } catch (const InputError& error) {  // an end nearer to the obstacles than they allow
      out_.why = error.what();
    } catch (const InitializationError& error) {
      out_.why = error.what();
    }
  }

  /// Nothing comes to rest on obstacles that say yes or no. So the path is sought as if there were none, and where it
  /// then goes through one, it is held by them: nothing.
  std::optional<Points> without_obstacles(const Points& first, const Solver& solver) {
    Problem open = problem_;
    open.manifold = domain_;
    FindOptions options = options_.find;
    options.certificate.enabled = false;
    const Points x = find_path(open, PlannedPath(first), solver, options, monitor_).path.u;
    if (x.cols() < 2) {
      out_.why = "there was no time for a search";
      return {};
    }
    const std::string fault = fault_of(x, clearance_of(x));
    if (fault.empty()) return x;
    out_.why = "it touches obstacles that give only valid or invalid, not distances: without them " + fault;
    return {};
  }

  /// Takes a path where it is better than what there is and valid.
  bool take(const Points& x, PolishOutcome outcome) {
    const double cost = space_.cost(x, length_of(x) / kPieces);
    if (!(cost < (1 - kRounding) * out_.cost)) {
      say("it would cost " + short_number(cost) + ", no less than this path", outcome);
      return false;
    }
    const std::optional<Clearance> clearance = clearance_of(x);
    const std::string fault = fault_of(x, clearance);
    if (!fault.empty()) {
      say(fault, outcome);
      return false;
    }
    out_.outcome = outcome;
    out_.cost = cost;
    out_.clearance = clearance;
    out_.path = states_.path(given_.getSpaceInformation(), x);
    const auto& space = given_.getSpaceInformation();
    space->copyState(out_.path->getStates().front(), given_.getState(0));
    space->copyState(out_.path->getStates().back(), given_.getState(static_cast<unsigned>(x_.cols() - 1)));
    return true;
  }

  void say(const std::string& fault, PolishOutcome outcome) {
    if (outcome == PolishOutcome::tightened && !out_.why.empty()) out_.why += "; with shortcuts alone ";
    out_.why += fault;
  }

  std::optional<Clearance> clearance_of(const Points& x) const {
    return measure_clearance(*problem_.manifold, x, false, {});
  }

  bool touches(const Points& x, const std::optional<Clearance>& clearance) const {
    const double extent = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).norm();
    return clearance && !(clearance->lower >= -options_.find.certificate.clearance * extent);
  }

  std::string fault_of(const Points& x, const std::optional<Clearance>& clearance) const {
    if (heeds_clearance_ && touches(x, clearance))
      return "it would come " + short_number(std::abs(clearance->upper)) + " too close to " + clearance->obstacle;
    for (Index i = 0; i < x.cols(); ++i)
      if (!space_.is_free(x.col(i))) return "the planner's checker refuses its place " + point_text(x.col(i));
    for (Index i = 0; i + 1 < x.cols(); ++i)
      if (!space_.moves(x.col(i), x.col(i + 1)))
        return "the planner refuses its move from " + point_text(x.col(i)) + " to " + point_text(x.col(i + 1));
    return "";
  }

  const og::PathGeometric& given_;
  const PolishOptions& options_;
  const Monitor& monitor_;
  StateColumns states_;
  std::shared_ptr<const ConstraintManifold> domain_;
  PlanSpace space_;
  Points x_;
  Problem problem_;
  bool heeds_clearance_ = true;
  Polished out_;
};

}  // namespace

Words<PolishOutcome> words(PolishOutcome) {
  using enum PolishOutcome;
  static constexpr Word<PolishOutcome> kWords[] = {{polished, "polished"}, {tightened, "tightened"}, {given, "given"}};
  return kWords;
}

Polished polish(const og::PathGeometric& path, const PolishOptions& options, const Monitor& monitor) {
  return Polishing(path, options, monitor).run();
}

}  // namespace leastcost
