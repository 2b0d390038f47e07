// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Replanning of arms when one box moves by 1 cm: processor time of a replan in solves of the same chain without
// obstacles, and what an independent check finds penetrating.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <leastcost/framework/replan/replanner.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/solvers/newton.hpp>
#include "benchmarks/arm_scene.hpp"
#include "benchmarks/mbm_scene.hpp"
#include "benchmarks/thread_time.hpp"

namespace {

using namespace leastcost;
using namespace leastcost::bench;

constexpr int kPoints = 50, kSteps = 4, kPlaces = 20;
constexpr double kMoved = 0.01;      ///< m
constexpr double kNothing = 1e-8;    ///< m
constexpr double kStraight = 1e-9;   ///< relative: longer than a straight line is a way round something
constexpr double kMostSeconds = 20;  ///< for the first plan
constexpr double kTolerance = 1e-8;  ///< of the cost, relative
constexpr double kMbmClearance = 1e-4;

struct Figures {
  std::vector<double> replans;  ///< in free solves
  int fresh = 0, kept = 0, none = 0, penetrating = 0;
  std::vector<double> excess;  ///< of a replan's cost over that of a solve with the defaults from there, relative
  void print(const char* what) const {
    std::printf(
        "%-12s %zu replans: median %.1f, p90 %.1f, worst %.1f free solves; new %d, kept %d, none %d; penetrating %d; "
        "excess median %.1e, p90 %.1e, worst %.1e\n",
        what, replans.size(), quantile_of(replans, 0.5), quantile_of(replans, 0.9), quantile_of(replans, 1), fresh,
        kept, none, penetrating, quantile_of(excess, 0.5), quantile_of(excess, 0.9), quantile_of(excess, 1));
  }
};

/// Of one kind of scene: a world whose box number k stands elsewhere, and what touches there.
struct Scene {
  std::string name;
  Problem free;
  std::function<Problem(const Vector3d& shift)> world;
  std::function<double(const Points& curve, const Vector3d& shift)> least_gap;
};

Monitor within(double seconds) {
  Monitor monitor;
  monitor.deadline = Monitor::Clock::now() +
                     std::chrono::duration_cast<Monitor::Clock::duration>(std::chrono::duration<double>(seconds));
  return monitor;
}

double seconds_of(const Problem& problem, const CoordinatePath& chain) {
  std::vector<double> all;
  for (int k = 0; k < 7; ++k) {
    const double begin = thread_seconds();
    improve_path(problem, chain, Newton({.tolerance = kTolerance}), {.certificate = {.enabled = false}});
    all.push_back(thread_seconds() - begin);
  }
  return quantile_of(all, 0.5);
}

void replan(const Scene& scene, unsigned seed, Figures& straight, Figures& round) {
  Replanner planner(std::make_shared<Newton>(NewtonOptions{.tolerance = kTolerance}),
                    std::make_shared<RrtInitializer>(), {.points = kPoints, .certificate = {.enabled = false}});
  const Replan first = planner.replan(scene.world(Vector3d::Zero()), within(kMostSeconds));
  if (first.outcome == ReplanOutcome::no_valid_path) {
    std::printf("%s: no first plan: %s\n", scene.name.c_str(), first.why_not_new.c_str());
    return;
  }
  // As after a longer run: the chain is at rest.
  planner.replan(scene.world(Vector3d::Zero()), within(kMostSeconds));
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  Vector3d shift = Vector3d::Zero();
  for (int step = 0; step < kSteps; ++step) {
    shift += kMoved * Vector3d::NullaryExpr([&] { return unit(engine); }).normalized();
    const Problem now = scene.world(shift);
    const CoordinatePath before = planner.path();
    const double begin = thread_seconds();
    const Replan plan = planner.replan(now, within(kMostSeconds));
    const double seconds = thread_seconds() - begin;
    const bool valid = plan.outcome != ReplanOutcome::no_valid_path;
    const double line = (now.target.u - now.source.u).norm();
    const bool goes_round = !valid || plan.result.curve.cost > line * (1 + kStraight);
    Figures& figures = goes_round ? round : straight;
    const double unit_seconds = seconds_of(scene.free, before);
    figures.replans.push_back(seconds / unit_seconds);
    figures.none += valid ? 0 : 1;
    figures.fresh += plan.outcome == ReplanOutcome::new_path ? 1 : 0;
    figures.kept += plan.outcome == ReplanOutcome::old_path ? 1 : 0;
    std::string touches;
    if (valid && scene.least_gap(plan.result.curve.x, shift) < -kNothing) {
      ++figures.penetrating;
      touches = ", TOUCHES";
    }
    double excess = 0;
    if (valid) {
      const Result solved =
          improve_path(now, plan.result.path, Newton(), {.certificate = {.enabled = false}}, within(kMostSeconds));
      excess = (plan.result.curve.cost - solved.curve.cost) / solved.curve.cost;
      if (is_solved(solved.solve.termination) && solved.curve.cost > 0) figures.excess.push_back(excess);
    }
    std::printf("%s step %d: %s%s, %s, %.2f ms, free %.3f ms: %.1f (%d iterations) excess %.1e\n", scene.name.c_str(),
                step,
                plan.outcome == ReplanOutcome::old_path ? "kept"
                : valid                                 ? "new"
                                                        : "none",
                touches.c_str(), goes_round ? "round" : "straight", 1e3 * seconds, 1e3 * unit_seconds,
                seconds / unit_seconds, plan.result.solve.iterations, excess);
    if (!valid) std::printf("    old: %s; new: %s\n", plan.why_not_old.c_str(), plan.why_not_new.c_str());
  }
  std::fflush(stdout);
}

/// Least own gap at dense places of a curve.
template <class Gap>
double least_along(const Points& x, const Gap& gap) {
  double least = 1e9;
  for (Index i = 0; i + 1 < x.cols(); ++i)
    for (int place = 0; place <= kPlaces; ++place)
      least = std::min(least, gap(Vector(x.col(i) + (x.col(i + 1) - x.col(i)) * place / kPlaces)));
  return least;
}

/// The obstacle that a path without it would meet, or is nearest to: moved boxes that nothing is near are no test.
std::size_t nearest_of(std::size_t count, const std::function<double(std::size_t)>& gap) {
  std::size_t nearest = 0;
  double least = 1e9;
  for (std::size_t k = 0; k < count; ++k) {
    const double g = gap(k);
    if (g >= least) continue;
    least = g;
    nearest = k;
  }
  return nearest;
}

void built_in(const Arm& arm, unsigned seed, Figures& straight, Figures& round) {
  const Query query = query_of(arm, seed, 0);
  if (query.source.size() == 0 || query.target.size() == 0) return;
  const Points line = [&] {
    Points x(query.source.size(), 2);
    x << query.source, query.target;
    return x;
  }();
  const std::size_t moves = nearest_of(query.things.size(), [&](std::size_t k) {
    return least_along(line, [&](const Vector& q) { return own_gap(arm, {query.things[k]}, q); });
  });
  const auto things = [=](const Vector3d& shift) {
    std::vector<Thing> now = query.things;
    now[moves].center += shift;
    return now;
  };
  Scene scene{arm.name + std::string(" ") + std::to_string(seed), problem_of(arm, query, nullptr), {}, {}};
  scene.world = [=, &arm, cost = scene.free.cost](const Vector3d& shift) {
    const std::vector<Thing> now = things(shift);
    Problem problem = problem_of(arm, query, &now);
    problem.cost = cost;
    return problem;
  };
  scene.least_gap = [=, &arm](const Points& curve, const Vector3d& shift) {
    const std::vector<Thing> now = things(shift);
    return least_along(curve, [&](const Vector& q) { return own_gap(arm, now, q); });
  };
  replan(scene, seed, straight, round);
}

/// An obstacle that stands elsewhere, as it was read.
void public_problem(const std::shared_ptr<const Robot>& robot, const MbmProblem& one, Figures& straight,
                    Figures& round) {
  const auto walls_of = [=](const RobotWalls::Obstacles& obstacles) {
    return std::make_shared<const RobotWalls>(robot, obstacles, kMbmClearance);
  };
  const auto all = walls_of(one.obstacles);
  if (!all->clears(one.source, one.source) || !all->clears(one.target, one.target)) return;
  std::vector<std::size_t> boxes;
  for (std::size_t k = 0; k < one.obstacles.size(); ++k)
    if (one.movable[k]) boxes.push_back(k);
  if (boxes.empty()) return;
  const std::size_t moves = boxes[nearest_of(boxes.size(), [&](std::size_t k) {
    return walls_of({one.obstacles[boxes[k]]})->clearance(one.source, one.target).upper;
  })];
  Problem free;
  free.manifold = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = 7});
  free.cost = make_euclidean_cost(7);
  free.kernel = make_kernel<Expm1Square>();
  free.source.u = one.source;
  free.target.u = one.target;
  Scene scene{one.scenario + " " + std::to_string(one.index), free, {}, {}};
  const auto obstacles = [=](const Vector3d& shift) {
    RobotWalls::Obstacles now = one.obstacles;
    now[moves] = one.movable[moves](shift);
    return now;
  };
  scene.world = [=](const Vector3d& shift) {
    Problem problem = free;
    problem.manifold = std::make_shared<const FreeSpace>(
        std::make_shared<const EuclideanManifold>(
            EuclideanManifoldOptions{.dimension = 7, .box = {robot->kinematics->lower(), robot->kinematics->upper()}}),
        walls_of(obstacles(shift)));
    return problem;
  };
  scene.least_gap = [=](const Points& curve, const Vector3d& shift) {
    const auto walls = walls_of(obstacles(shift));
    std::vector<Wall> found;
    return least_along(curve, [&](const Vector& q) {
      walls->near(q, 0, found);
      double least = 0;
      for (const Wall& wall : found) least = std::min(least, wall.gap);
      return least;
    });
  };
  replan(scene, static_cast<unsigned>(one.index), straight, round);
}

}  // namespace

/// Arguments: how many queries of the built-in Panda (50), the first seed (the next ones are two apart); the folder of
/// MotionBenchMaker, 0 or 2: what indices leave divided by 6, how many problems of each scenario.
int main(int count, char** arguments) {
  const int queries = count > 1 ? std::atoi(arguments[1]) : 50;
  const auto first = static_cast<unsigned>(count > 2 ? std::atoi(arguments[2]) : 300001);
  Figures straight, round;
  const Arm arm = arms().front();
  for (int k = 0; k < queries; ++k) built_in(arm, first + 2 * static_cast<unsigned>(k), straight, round);
  const std::filesystem::path folder = count > 3 ? arguments[3] : "";
  Figures public_straight, public_round;
  if (!std::filesystem::exists(folder / "panda_even.json.gz")) {
    std::printf("skipped: problems of MotionBenchMaker: give a folder with panda_even.json.gz as the third argument\n");
  } else {
    const int rest = count > 4 ? std::atoi(arguments[4]) : 0, most = count > 5 ? std::atoi(arguments[5]) : 5;
    const std::shared_ptr<const Robot> robot = panda_of(folder);
    std::map<std::string, int> taken;
    for (const MbmProblem& one : mbm_problems(folder / "panda_even.json.gz"))
      if (one.index % 6 == rest && taken[one.scenario]++ < most)
        public_problem(robot, one, public_straight, public_round);
  }
  straight.print("straight");
  round.print("round");
  public_straight.print("MBM straight");
  public_round.print("MBM round");
}
