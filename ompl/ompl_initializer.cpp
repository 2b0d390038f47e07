// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/ompl/ompl_initializer.hpp>

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/stride/STRIDE.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/framework/domain/has_sample_box.hpp>
#include <leastcost/framework/domain/limits_moves.hpp>
#include <leastcost/ompl/objective.hpp>
#include "framework/base/point_text.hpp"
#include "ompl/domain_space.hpp"
#include "problems/initializers/clear_lines.hpp"

namespace leastcost {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kStepsApart = 16;  ///< steps between the ends

template <class Planner>
ob::PlannerPtr make_planner(const ob::SpaceInformationPtr& space) {
  return std::make_shared<Planner>(space);
}

struct PlannerKind {
  OmplPlanner planner;
  ob::PlannerPtr (*make)(const ob::SpaceInformationPtr&);
  bool improves = false;
};

constexpr std::array<PlannerKind, 20> kPlanners = {
    {{OmplPlanner::rrt_connect, make_planner<og::RRTConnect>},
     {OmplPlanner::rrt, make_planner<og::RRT>},
     {OmplPlanner::lazy_rrt, make_planner<og::LazyRRT>},
     {OmplPlanner::trrt, make_planner<og::TRRT>},
     {OmplPlanner::est, make_planner<og::EST>},
     {OmplPlanner::bi_est, make_planner<og::BiEST>},
     {OmplPlanner::kpiece, make_planner<og::KPIECE1>},
     {OmplPlanner::bkpiece, make_planner<og::BKPIECE1>},
     {OmplPlanner::lbkpiece, make_planner<og::LBKPIECE1>},
     {OmplPlanner::sbl, make_planner<og::SBL>},
     {OmplPlanner::stride, make_planner<og::STRIDE>},
     {OmplPlanner::pdst, make_planner<og::PDST>},
     {OmplPlanner::prm, make_planner<og::PRM>},
     {OmplPlanner::lazy_prm, make_planner<og::LazyPRM>},
     {OmplPlanner::fmt, make_planner<og::FMT>},
     {OmplPlanner::bfmt, make_planner<og::BFMT>},
     {OmplPlanner::prm_star, make_planner<og::PRMstar>, true},
     {OmplPlanner::rrt_star, make_planner<og::RRTstar>, true},
     {OmplPlanner::informed_rrt_star, make_planner<og::InformedRRTstar>, true},
     {OmplPlanner::bit_star, make_planner<og::BITstar>, true}}};

const PlannerKind& kind_of(OmplPlanner planner) {
  return *std::find_if(kPlanners.begin(), kPlanners.end(), [&](const PlannerKind& k) { return k.planner == planner; });
}

/// While it lives OMPL belongs to one thread of ours, prints nothing and draws seeds from ours.
class QuietOmpl {
 public:
  explicit QuietOmpl(int seed) : lock_(mutex()) {
    ompl::msg::noOutputHandler();
    ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed) + 1);  // 0 would be the time
  }
  ~QuietOmpl() { ompl::msg::restorePreviousOutputHandler(); }
  QuietOmpl(const QuietOmpl&) = delete;
  QuietOmpl& operator=(const QuietOmpl&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex only;
    return only;
  }
  std::lock_guard<std::mutex> lock_;
};

/// Where samples are drawn: the sides of the domain, and around the ends where it has none.
SampleBox box_of_samples(const Problem& problem, double reach) {
  const Eigen::VectorXd &a = problem.source.u, &b = problem.target.u;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  SampleBox box{Eigen::VectorXd::Constant(a.size(), -kInfinity), Eigen::VectorXd::Constant(a.size(), kInfinity)};
  if (const auto* domain = find_ability<HasSampleBox>(*problem.manifold)) box = domain->sample_box(a, b);
  if (const auto* domain = find_ability<HasBox>(*problem.manifold)) {
    box.lower = box.lower.cwiseMax(domain->box_lower());
    box.upper = box.upper.cwiseMin(domain->box_upper());
  }
  const double beyond = reach * (b - a).norm();
  for (Index i = 0; i < a.size(); ++i) {
    if (!std::isfinite(box.lower[i])) box.lower[i] = std::min(a[i], b[i]) - beyond;
    if (!std::isfinite(box.upper[i])) box.upper[i] = std::max(a[i], b[i]) + beyond;
    box.lower[i] = std::min({box.lower[i], a[i], b[i]});  // an end on a bound may be rounded beyond it
    box.upper[i] = std::max({box.upper[i], a[i], b[i]});
    if (!(box.upper[i] > box.lower[i])) box.upper[i] = std::nextafter(box.lower[i], kInfinity);
  }
  if (!(box.upper - box.lower).allFinite())
    throw InitializationError("ompl: the ends are " + short_number((b - a).norm()) +
                              " apart: a box around them overflows; bound the domain");
  return box;
}

void check_plannable(const Problem& problem) {
  if (problem.ring) throw InitializationError("a ring has no ends to join: give waypoints");
  if (problem.manifold->shape() == Shape::polyhedral)
    throw InitializationError("ompl plans on smooth domains, but a mesh has edges: use dijkstra");
  if (find_ability<HasChart>(*problem.manifold) != nullptr)
    throw InitializationError(
        "ompl plans in the space around a domain, but a chart has none: use straight, bow or waypoints");
}

void set_state(const ob::SpaceInformationPtr& space, const Eigen::VectorXd& x, ob::ScopedState<>& state) {
  for (unsigned i = 0; i < space->getStateDimension(); ++i) state[i] = x[static_cast<Index>(i)];
}

/// Planners that improve are satisfied by nothing, the others by any path.
ob::OptimizationObjectivePtr objective_of(const ob::SpaceInformationPtr& space, const Problem& problem, bool improves) {
  ob::OptimizationObjectivePtr objective = make_objective(space, problem.cost);
  objective->setCostThreshold(improves ? objective->identityCost() : objective->infiniteCost());
  return objective;
}

std::vector<Eigen::VectorXd> nodes_of(const og::PathGeometric& path, Index rows) {
  std::vector<Eigen::VectorXd> nodes;
  for (const ob::State* state : const_cast<og::PathGeometric&>(path).getStates()) {
    const double* x = state->as<ob::RealVectorStateSpace::StateType>()->values;
    nodes.emplace_back(Eigen::Map<const Eigen::VectorXd>(x, rows));
  }
  return nodes;
}

void check_positive(const char* key, const std::optional<double>& value) {
  if (value && !(*value > 0)) throw OptionError(key, "must be greater than 0");
}

/// OMPL's own choice, a fifth of the box, is longer than most clear moves of an arm: its trees hardly grow.
std::optional<double> range_of_robot(const Problem& problem, double distance) {
  constexpr double kSteps = 8;
  const bool robot = find_ability<LimitsMoves>(*problem.manifold) != nullptr;
  return robot ? std::optional<double>(distance / kSteps) : std::nullopt;
}

}  // namespace

OmplInitializer::OmplInitializer(const OmplOptions& options, int run_seed) : options_(options) {
  if (!options_.seed) options_.seed = run_seed;
  check_positive("max_seconds", options.max_seconds);
  if (!(options.max_seconds <= OmplOptions::kMostSeconds)) throw OptionError("max_seconds", "must be at most 1e6");
  check_positive("range", options.range);
  check_positive("step", options.step);
  check_positive("reach", options.reach);
  if (!options.range) return;
  const ob::SpaceInformationPtr any =
      std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(2));
  if (!kind_of(options.planner).make(any)->params().hasParam("range"))
    throw OptionError("range", std::string(word_of(options.planner)) + " has none: remove it");
}

FirstPath OmplInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  check_plannable(problem);
  const PlannerKind& chosen = kind_of(options_.planner);
  const double distance = (problem.target.u - problem.source.u).norm();
  ClearLines lines(problem, options_.step.value_or(distance / kStepsApart));
  FirstPath first;
  std::vector<Eigen::VectorXd> nodes = {problem.source.u, problem.target.u};
  if (distance > 0) {
    const QuietOmpl quiet(*options_.seed);
    const auto space = make_domain_space(problem, box_of_samples(problem, options_.reach), lines);
    const auto definition = std::make_shared<ob::ProblemDefinition>(space);
    ob::ScopedState<> source(space), target(space);
    set_state(space, problem.source.u, source);
    set_state(space, problem.target.u, target);
    definition->setStartAndGoalStates(source, target);
    definition->setOptimizationObjective(objective_of(space, problem, chosen.improves));
    const ob::PlannerPtr planner = chosen.make(space);
    planner->setProblemDefinition(definition);
    const std::optional<double> range = options_.range ? options_.range : range_of_robot(problem, distance);
    if (range && planner->params().hasParam("range")) planner->params().setParam("range", short_number(*range, 17));
    planner->setup();

    const auto end = Monitor::Clock::now() + std::chrono::duration<double>(options_.max_seconds);
    const ob::PlannerStatus status = planner->solve(
        ob::PlannerTerminationCondition([&] { return Monitor::Clock::now() >= end || monitor.interrupted(); }));
    if (!definition->hasExactSolution()) {
      const std::string came_to = std::string(word_of(chosen.planner)) + " came to: " + status.asString();
      if (monitor.interrupted()) throw Interrupted("ompl: interrupted; " + came_to);
      throw InitializationError("ompl: no path; " + came_to + ", with " + short_number(options_.max_seconds) +
                                " s to search. The ends may be on different parts of the domain; otherwise try another "
                                "planner, or a larger max_seconds or reach");
    }
    nodes = nodes_of(*definition->getSolutionPath()->as<og::PathGeometric>(), problem.source.u.size());
    first.notes.push_back("ompl: " + std::string(word_of(chosen.planner)) + ", a path of " +
                          std::to_string(nodes.size()) + " states");
  }
  std::mt19937_64 engine(static_cast<std::uint64_t>(*options_.seed));
  first.path = as_open_path(
      lines.shortened(nodes, options_.shortcuts, std::numeric_limits<double>::infinity(), engine, monitor));
  pin_ends(problem, first.path);
  return first;
}

}  // namespace leastcost
