// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Paths of a Panda in the problems of MotionBenchMaker by OMPL, by polish() of OMPL's plan and by our own search, in
// one process and among the same walls: a line of CSV for each, which robots/peers.py judges and makes a table of.
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <time.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/ompl/polish.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/solvers/newton.hpp>
#include "benchmarks/mbm_scene.hpp"

namespace {

using namespace leastcost;
using namespace leastcost::bench;
namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kClearance = 1e-4;              ///< m
constexpr double kMostSeconds = 20;              ///< of RRTConnect
constexpr double kOmplRange = 1;                 ///< rad
constexpr double kOmplChecks = 0.03;             ///< rad
constexpr double kBudget = 1, kLongBudget = 60;  ///< s

/// CPU seconds of all threads.
double process_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

Monitor within(double seconds) {
  Monitor monitor;
  monitor.deadline = Monitor::Clock::now() +
                     std::chrono::duration_cast<Monitor::Clock::duration>(std::chrono::duration<double>(seconds));
  return monitor;
}

Points points_of(const og::PathGeometric& path) {
  Points out(7, static_cast<Index>(path.getStateCount()));
  for (Index i = 0; i < out.cols(); ++i)
    out.col(i) = Eigen::Map<const Eigen::VectorXd>(
        path.getState(static_cast<unsigned>(i))->as<ob::RealVectorStateSpace::StateType>()->values, 7);
  return out;
}

class Row {
 public:
  explicit Row(const MbmProblem& problem) : problem_(problem) {}
  /// `path`: 7 x m, or empty where there is none.
  void operator()(const char* method, double seconds, const char* how, const Points& path) const {
    std::printf("%s,%d,%s,%.4f,%s", problem_.scenario.c_str(), problem_.index, method, seconds, how);
    for (const double value : path.reshaped()) std::printf(",%.12g", value);
    std::printf("\n");
    std::fflush(stdout);
  }

 private:
  const MbmProblem& problem_;
};

/// OMPL's planner for one problem.
class Planner {
 public:
  Planner(const MbmProblem& problem, const Robot& robot, std::shared_ptr<const RobotWalls> walls)
      : space_(std::make_shared<ob::RealVectorStateSpace>(7)) {
    ob::RealVectorBounds bounds(7);
    for (unsigned j = 0; j < 7; ++j) {
      bounds.setLow(j, robot.kinematics->lower()[j]);
      bounds.setHigh(j, robot.kinematics->upper()[j]);
    }
    space_->setBounds(bounds);
    setup_ = std::make_unique<og::SimpleSetup>(space_);
    setup_->setStateValidityChecker([walls = std::move(walls)](const ob::State* state) {
      const Eigen::VectorXd x =
          Eigen::Map<const Eigen::VectorXd>(state->as<ob::RealVectorStateSpace::StateType>()->values, 7);
      return walls->clears(x, x);
    });
    space_->setup();
    setup_->getSpaceInformation()->setStateValidityCheckingResolution(kOmplChecks / space_->getMaximumExtent());
    ob::ScopedState<> from(space_), to(space_);
    for (unsigned j = 0; j < 7; ++j) {
      from[j] = problem.source[j];
      to[j] = problem.target[j];
    }
    setup_->setStartAndGoalStates(from, to);
    const auto planner = std::make_shared<og::RRTConnect>(setup_->getSpaceInformation());
    planner->setRange(kOmplRange);
    setup_->setPlanner(planner);
  }

  std::optional<og::PathGeometric> plan(double seconds) {
    setup_->clear();
    if (setup_->solve(seconds) != ob::PlannerStatus::EXACT_SOLUTION) return std::nullopt;
    return setup_->getSolutionPath();
  }
  void simplify(og::PathGeometric& path) const { og::PathSimplifier(setup_->getSpaceInformation()).simplifyMax(path); }

 private:
  std::shared_ptr<ob::RealVectorStateSpace> space_;
  std::unique_ptr<og::SimpleSetup> setup_;
};

/// Plans that are simplified, again and again until a second of CPU is over: the shortest.
void restart(Planner& planner, og::PathGeometric best, double begin, const Row& row) {
  while (process_seconds() - begin < kBudget) {
    auto next = planner.plan(kBudget);
    if (!next) break;
    planner.simplify(*next);
    if (next->length() < best.length()) best = *next;
  }
  row("ompl_restarts", process_seconds() - begin, "simplified", points_of(best));
}

/// One plan that is simplified again and again until a second of CPU is over.
void simplify_on(const Planner& planner, og::PathGeometric path, double spent, const Row& row) {
  const double begin = process_seconds();
  og::PathGeometric best = path;
  while (process_seconds() - begin + spent < kBudget) {
    planner.simplify(path);
    if (path.length() < best.length()) best = path;
  }
  row("ompl_simplify", process_seconds() - begin + spent, "simplified", points_of(best));
}

void polish_plan(const char* method, const og::PathGeometric& plan, const PolishOptions& options,
                 const Monitor& monitor, const Row& row) {
  const double begin = process_seconds();
  const Polished ours = polish(plan, options, monitor);
  const std::string how = std::string(word_of(ours.outcome)) + (ours.certified() ? " certified" : "");
  row(method, process_seconds() - begin, how.c_str(), points_of(*ours.path));
}

void search(const char* method, const MbmProblem& one, const Robot& robot,
            const std::shared_ptr<const RobotWalls>& walls, double seconds, const Row& row) {
  Problem problem;
  problem.manifold = std::make_shared<const FreeSpace>(
      std::make_shared<const EuclideanManifold>(
          EuclideanManifoldOptions{.dimension = 7, .box = {robot.kinematics->lower(), robot.kinematics->upper()}}),
      walls);
  problem.cost = make_euclidean_cost(7);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = one.source;
  problem.target.u = one.target;
  const double begin = process_seconds();
  try {
    const Result result = find_path(problem, RrtInitializer(), Newton(), {.points = std::nullopt}, within(seconds));
    row(method, process_seconds() - begin, std::string(word_of(result.status)).c_str(), result.path.u);
  } catch (const std::exception& error) {
    row(method, process_seconds() - begin, "failed", {});
  }
}

bool is_of(const MbmProblem& problem, const std::string& set) {
  static const std::map<std::string, int> kSets = {{"development", 0}, {"held", 2}, {"unseen", 4}};
  const auto at = kSets.find(set);
  return at != kSets.end() && problem.index % 6 == at->second;
}

}  // namespace

/// Arguments: the folder with panda_spherized.urdf, panda.srdf and panda_even.json.gz; `development`, `held` or
/// `unseen` (indices that leave 0, 2 and 4 when divided by 6); how many of each scenario; how many of them are passed
/// over; `quick`: without the long search.
int main(int count, char** arguments) {
  const std::filesystem::path folder = count > 1 ? arguments[1] : "";
  const std::string set = count > 2 ? arguments[2] : "development";
  const int most = count > 3 ? std::atoi(arguments[3]) : 2, passed = count > 4 ? std::atoi(arguments[4]) : 0;
  const bool quick = count > 5;
  if (!std::filesystem::exists(folder / "panda_even.json.gz")) {
    std::printf("skipped: the first argument is no folder with panda_even.json.gz\n");
    return 0;
  }
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(1);
  const std::shared_ptr<const Robot> robot = panda_of(folder);
  std::map<std::string, int> seen;
  for (const MbmProblem& one : mbm_problems(folder / "panda_even.json.gz")) {
    if (!is_of(one, set)) continue;
    const int place = seen[one.scenario]++;
    if (place < passed || place >= passed + most) continue;
    const Row row(one);
    const auto walls = std::make_shared<const RobotWalls>(robot, one.obstacles, kClearance);
    if (!walls->clears(one.source, one.source) || !walls->clears(one.target, one.target)) {
      row("ends", 0, "taken", {});
      continue;
    }
    Planner planner(one, *robot, walls);
    const double begin = process_seconds();
    auto plan = planner.plan(kMostSeconds);
    const double planned = process_seconds() - begin;
    row("ompl", planned, plan ? "planned" : "failed", plan ? points_of(*plan) : Points());
    if (plan) {
      planner.simplify(*plan);
      const double simplified = process_seconds() - begin;
      row("ompl_max", simplified, "simplified", points_of(*plan));
      restart(planner, *plan, process_seconds() - simplified, row);
      simplify_on(planner, *plan, simplified, row);
      PolishOptions options;
      polish_plan("polish_checker", *plan, options, within(kBudget), row);
      options.walls = walls;
      polish_plan("polish", *plan, options, within(kBudget), row);
    }
    search("search_1s", one, *robot, walls, kBudget, row);
    if (!quick) search("search", one, *robot, walls, kLongBudget, row);
  }
}
