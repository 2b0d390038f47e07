// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// First paths of a Panda in the problems of MotionBenchMaker: CPU time, length over that of the straight line, and
// whether each is clear by an independent look at dense places; the same of OMPL's RRTConnect, alone and with its
// simplifier, among the same walls and with the same checks of places; and by our initializer of OMPL with some ranges.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include "benchmarks/mbm_scene.hpp"
#include "benchmarks/thread_time.hpp"
#ifdef LEASTCOST_HAS_OMPL
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <leastcost/ompl/ompl_initializer.hpp>
#endif

namespace {

using namespace leastcost;
using namespace leastcost::bench;

constexpr double kClearance = 1e-4;           ///< m
constexpr double kLookEvery = 0.004;          ///< rad
constexpr double kTouches = 1e-7;             ///< rad: gaps below minus this are collisions
constexpr double kMostSeconds = 20;           ///< of OMPL
constexpr double kOmplRange = 1;              ///< rad
constexpr double kRanges[] = {0, 0.5, 1, 2};  ///< rad, of our initializer; 0: its default
constexpr double kOmplChecks = 0.03;          ///< rad

struct Row {
  int failed = 0, touching = 0;
  std::vector<double> seconds, lengths;  ///< lengths over the straight line

  void take(double time, const Points& path, const Walls& walls) {
    double length = 0;
    bool touches = false;
    std::vector<Wall> found;
    for (Index i = 0; i + 1 < path.cols(); ++i) {
      const Eigen::VectorXd way = path.col(i + 1) - path.col(i);
      length += way.norm();
      const int places = 1 + static_cast<int>(way.norm() / kLookEvery);
      for (int k = 0; k < places && !touches; ++k) {
        walls.near(path.col(i) + way * k / places, 0, found);
        for (const Wall& wall : found) touches = touches || wall.gap < -kTouches;
      }
    }
    seconds.push_back(time);
    lengths.push_back(length / (path.rightCols(1) - path.leftCols(1)).norm());
    touching += touches ? 1 : 0;
  }
  void print(const char* what) const {
    double sum = 0;
    for (const double s : seconds) sum += s;
    std::printf("| %-28s | %4zu | %4d | %4d | %8.2f | %8.2f | %8.2f | %8.2f | %6.3f | %6.3f |\n", what, seconds.size(),
                failed, touching, 1e3 * quantile_of(seconds, 0.5), 1e3 * quantile_of(seconds, 0.95),
                1e3 * quantile_of(seconds, 1), 1e3 * sum / std::max<double>(1, static_cast<double>(seconds.size())),
                quantile_of(lengths, 0.5), quantile_of(lengths, 0.95));
    std::fflush(stdout);
  }
};

#ifdef LEASTCOST_HAS_OMPL
namespace ob = ompl::base;
namespace og = ompl::geometric;

Points points_of(og::PathGeometric& path) {
  Points out(7, static_cast<Index>(path.getStateCount()));
  for (Index i = 0; i < out.cols(); ++i)
    out.col(i) = Eigen::Map<const Eigen::VectorXd>(
        path.getState(static_cast<unsigned>(i))->as<ob::RealVectorStateSpace::StateType>()->values, 7);
  return out;
}

void plan_with_ompl(const bench::MbmProblem& problem, const Robot& robot,
                    const std::shared_ptr<const RobotWalls>& walls, Row& plain, Row& simplified) {
  const auto space = std::make_shared<ob::RealVectorStateSpace>(7);
  ob::RealVectorBounds bounds(7);
  for (unsigned j = 0; j < 7; ++j) {
    bounds.setLow(j, robot.kinematics->lower()[j]);
    bounds.setHigh(j, robot.kinematics->upper()[j]);
  }
  space->setBounds(bounds);
  const double begin = thread_seconds();
  og::SimpleSetup setup(space);
  setup.setStateValidityChecker([&](const ob::State* state) {
    const Eigen::VectorXd x =
        Eigen::Map<const Eigen::VectorXd>(state->as<ob::RealVectorStateSpace::StateType>()->values, 7);
    return walls->clears(x, x);
  });
  space->setup();
  setup.getSpaceInformation()->setStateValidityCheckingResolution(kOmplChecks / space->getMaximumExtent());
  ob::ScopedState<> from(space), to(space);
  for (unsigned j = 0; j < 7; ++j) {
    from[j] = problem.source[j];
    to[j] = problem.target[j];
  }
  setup.setStartAndGoalStates(from, to);
  const auto planner = std::make_shared<og::RRTConnect>(setup.getSpaceInformation());
  planner->setRange(kOmplRange);
  setup.setPlanner(planner);
  if (setup.solve(kMostSeconds) != ob::PlannerStatus::EXACT_SOLUTION) {
    ++plain.failed;
    return;
  }
  og::PathGeometric path = setup.getSolutionPath();
  plain.take(thread_seconds() - begin, points_of(path), *walls);
  const double after = thread_seconds();
  og::PathSimplifier(setup.getSpaceInformation()).simplifyMax(path);
  simplified.take(plain.seconds.back() + thread_seconds() - after, points_of(path), *walls);
}
#endif

}  // namespace

/// Arguments: the folder with panda_spherized.urdf, panda.srdf and panda_even.json.gz; `development` (indices that are
/// multiples of 6) or `others`; how many seeds; options of rrt: paths, step (0: the default), shortcuts (-1).
int main(int count, char** arguments) {
  const std::filesystem::path folder = count > 1 ? arguments[1] : "";
  const bool development = count <= 2 || std::string(arguments[2]) == "development";
  const int seeds = count > 3 ? std::atoi(arguments[3]) : 1;
  RrtOptions options;
  if (count > 4) options.paths = std::atoi(arguments[4]);
  if (count > 5 && std::atof(arguments[5]) > 0) options.step = std::atof(arguments[5]);
  if (count > 6 && std::atoi(arguments[6]) >= 0) options.shortcuts = std::atoi(arguments[6]);
  const bool with_ompl = count <= 7;
  if (!std::filesystem::exists(folder / "panda_even.json.gz")) {
    std::printf("skipped: the first argument is no folder with panda_even.json.gz\n");
    return 0;
  }
  const std::shared_ptr<const Robot> robot = bench::panda_of(folder);
  std::printf("%zu capsules, %zu pairs of them\n", robot->capsules.size(), robot->self.size());
  Row rrt, plain, simplified;
  std::map<std::string, Row> by_range;
  std::map<std::string, Row> by_scenario;
  int no_ends = 0;
#ifdef LEASTCOST_HAS_OMPL
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(1);
#endif
  for (const bench::MbmProblem& one : bench::mbm_problems(folder / "panda_even.json.gz")) {
    if ((one.index % 6 == 0) != development) continue;
    const auto walls = std::make_shared<const RobotWalls>(robot, one.obstacles, kClearance);
    if (!walls->clears(one.source, one.source) || !walls->clears(one.target, one.target)) {
      ++no_ends;
      continue;
    }
    Problem problem;
    problem.manifold = std::make_shared<const FreeSpace>(
        std::make_shared<const EuclideanManifold>(
            EuclideanManifoldOptions{.dimension = 7, .box = {robot->kinematics->lower(), robot->kinematics->upper()}}),
        walls);
    problem.cost = make_euclidean_cost(7);
    problem.kernel = make_kernel<Expm1Square>();
    problem.source.u = one.source;
    problem.target.u = one.target;
    for (int seed = 1; seed <= seeds; ++seed) {
      const double begin = thread_seconds();
      options.seed = seed;
      try {
        const FirstPath first = RrtInitializer(options).first_path(problem, {});
        const double time = thread_seconds() - begin;
        rrt.take(time, first.path.u, *walls);
        by_scenario[one.scenario].take(time, first.path.u, *walls);
      } catch (const std::exception& error) {
        std::printf("%s %d, seed %d: %s\n", one.scenario.c_str(), one.index, seed, error.what());
        ++rrt.failed;
      }
    }
#ifdef LEASTCOST_HAS_OMPL
    for (const double range : kRanges) {
      const std::string name = range > 0 ? "ompl, range " + std::to_string(range).substr(0, 4) : "ompl, its default";
      try {
        const double begin = thread_seconds();
        OmplOptions initializer{.max_seconds = kMostSeconds, .seed = 1};
        if (range > 0) initializer.range = range;
        const FirstPath first = OmplInitializer(initializer).first_path(problem, {});
        by_range[name].take(thread_seconds() - begin, first.path.u, *walls);
      } catch (const std::exception&) {
        ++by_range[name].failed;
      }
    }
    if (with_ompl) plan_with_ompl(one, *robot, walls, plain, simplified);
#endif
  }
  std::printf("%d problems without free ends\n", no_ends);
  std::printf(
      "| method, CPU [ms]             | runs | none | touch|   median |      p95 |    worst |     mean | length |    "
      "p95 |\n");
  rrt.print("rrt");
  for (const auto& [scenario, row] : by_scenario) row.print(("  " + scenario).c_str());
#ifdef LEASTCOST_HAS_OMPL
  for (const auto& [range, row] : by_range) row.print(range.c_str());
#endif
  if (with_ompl && !plain.seconds.empty()) {
    plain.print("OMPL RRTConnect");
    simplified.print("OMPL RRTConnect, simplifyMax");
  }
}
