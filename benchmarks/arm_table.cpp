// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Arms among balls and boxes: how many plans are found, certified and proved, what an independent look at dense places
// of the delivered curve finds, and what a solve costs, in solves of the same chain without obstacles.
#include <time.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/box.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include <leastcost/solvers/newton.hpp>

namespace {

using namespace leastcost;
using Eigen::Vector3d;
using Vector = Eigen::VectorXd;

constexpr int kPoints = 50, kBalls = 5, kBoxes = 5, kPlaces = 20;
constexpr double kClearance = 0.01;  ///< m
constexpr double kMoved = 0.005;     ///< m: how far each obstacle moves before a warm solve
constexpr double kNothing = 1e-8;    ///< m
constexpr double kStraight = 1e-9;   ///< relative: longer than a straight line is a way round something
constexpr double kReach = 0.8;       ///< m: half of the cube around the shoulder in which obstacles stand
constexpr double kFromAxis = 0.3;    ///< m: from the vertical axis, where no arm could be free
constexpr double kMostSeconds = 20;  ///< for a plan with its certificate
constexpr double kPi = std::numbers::pi;

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Thing {
  bool ball = true;
  Vector3d center = Vector3d::Zero(), half = Vector3d::Zero();  ///< of a ball the radius is half[0]
};

struct Arm {
  const char* name;
  std::shared_ptr<const Robot> robot;
  bool modified;
  std::vector<std::array<double, 3>> rows;  ///< a, alpha, d: written again, for the look that shares nothing
};

std::vector<Arm> arms() {
  return {{"Panda",
           make_dh_arm({}),
           true,
           {{0, 0, 0.333},
            {0, -kPi / 2, 0},
            {0, kPi / 2, 0.316},
            {0.0825, kPi / 2, 0},
            {-0.0825, -kPi / 2, 0.384},
            {0, kPi / 2, 0},
            {0.088, kPi / 2, 0.107}}},
          {"UR5",
           make_dh_arm({.model = arm_model::Ur5{}}),
           false,
           {{0, kPi / 2, 0.089159},
            {-0.425, 0, 0},
            {-0.39225, 0, 0},
            {0, kPi / 2, 0.10915},
            {0, -kPi / 2, 0.09465},
            {0, 0, 0.0823}}}};
}

Eigen::Affine3d own_link(const Arm& arm, const Vector& q, int link) {
  using Eigen::AngleAxisd, Eigen::Translation3d;
  Eigen::Affine3d frame = Eigen::Affine3d::Identity();
  for (int j = 0; j < link; ++j) {
    const auto& row = arm.rows[static_cast<std::size_t>(j)];
    const Translation3d along_x(row[0], 0, 0), along_z(0, 0, row[2]);
    const AngleAxisd about_x(row[1], Vector3d::UnitX()), about_z(q[j], Vector3d::UnitZ());
    frame =
        arm.modified ? frame * about_x * along_x * about_z * along_z : frame * about_z * along_z * along_x * about_x;
  }
  return frame;
}

/// The least of a convex function on [0, 1], by golden sections.
template <class Function>
double least_convex(const Function& f) {
  constexpr double kGolden = 0.6180339887498949;
  double from = 0, to = 1, a = 1 - kGolden, b = kGolden, fa = f(a), fb = f(b);
  for (int k = 0; k < 60; ++k) {
    if (fa < fb) {
      to = b, b = a, fb = fa, a = to - kGolden * (to - from), fa = f(a);
    } else {
      from = a, a = b, fa = fb, b = from + kGolden * (to - from), fb = f(b);
    }
  }
  return std::min({fa, fb, f(0.0), f(1.0)});
}

double own_distance(const Vector3d& x, const Thing& thing) {
  if (thing.ball) return (x - thing.center).norm() - thing.half[0];
  return ((x - thing.center).cwiseAbs() - thing.half).cwiseMax(0).norm();
}

/// How far an arm is from what it must not touch, less what is required.
double own_gap(const Arm& arm, const std::vector<Thing>& things, const Vector& q) {
  double least = 1e9;
  std::vector<std::pair<Vector3d, Vector3d>> axes;
  for (const Capsule& capsule : arm.robot->capsules) {
    const Eigen::Affine3d frame = own_link(arm, q, capsule.link);
    axes.emplace_back(frame * capsule.from, frame * capsule.to);
    if (capsule.link == 0) continue;
    const auto at = [&](double s) -> Vector3d {
      return axes.back().first + s * (axes.back().second - axes.back().first);
    };
    for (const Thing& thing : things) {
      const double middle = own_distance(at(0.5), thing), half = (axes.back().second - axes.back().first).norm() / 2;
      if (middle - half - capsule.radius - kClearance > 0.1) continue;
      least = std::min(
          least, least_convex([&](double s) { return own_distance(at(s), thing); }) - capsule.radius - kClearance);
    }
  }
  for (const auto& [i, j] : arm.robot->self) {
    const auto &first = axes[static_cast<std::size_t>(i)], &second = axes[static_cast<std::size_t>(j)];
    const double required = arm.robot->capsules[static_cast<std::size_t>(i)].radius +
                            arm.robot->capsules[static_cast<std::size_t>(j)].radius;
    const Vector3d way = second.second - second.first;
    const auto from_second = [&](double s) {
      const Vector3d x = first.first + s * (first.second - first.first);
      const double square = way.squaredNorm();
      const double t = square > 0 ? std::clamp((x - second.first).dot(way) / square, 0.0, 1.0) : 0;
      return (x - second.first - t * way).norm();
    };
    least = std::min(least, least_convex(from_second) - required);
  }
  return least;
}

struct Query {
  std::vector<Thing> things, moved;
  Vector source, target;
};

Query query_of(const Arm& arm, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> unit(0, 1), size(0.04, 0.12);
  Query query;
  for (int i = 0; i < kBalls + kBoxes; ++i) {
    Thing thing;
    thing.ball = i < kBalls;
    do thing.center = Vector3d::NullaryExpr([&] { return kReach * (2 * unit(engine) - 1); }) + Vector3d(0, 0, 0.4);
    while (thing.center.head<2>().norm() < kFromAxis);
    thing.half = Vector3d::NullaryExpr([&] { return size(engine); });
    query.things.push_back(thing);
    thing.center += kMoved * Vector3d::NullaryExpr([&] { return 2 * unit(engine) - 1; }).normalized();
    query.moved.push_back(thing);
  }
  const Vector lower = arm.robot->kinematics->lower().cwiseMax(-kPi),
               upper = arm.robot->kinematics->upper().cwiseMin(kPi);
  const auto free_end = [&]() -> Vector {
    for (int k = 0; k < 1000; ++k) {
      const Vector q = Vector::NullaryExpr(
          lower.size(), [&](Eigen::Index i) { return lower[i] + unit(engine) * (upper[i] - lower[i]); });
      if (std::min(own_gap(arm, query.things, q), own_gap(arm, query.moved, q)) > 0.001) return q;
    }
    return {};
  };
  query.source = free_end();
  query.target = free_end();
  return query;
}

Problem problem_of(const Arm& arm, const Query& query, const std::vector<Thing>* things) {
  const Kinematics& kinematics = *arm.robot->kinematics;
  Problem problem;
  const auto dimension = static_cast<int>(kinematics.dimension());
  std::shared_ptr<const ConstraintManifold> space =
      std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = dimension});
  if (things != nullptr) {
    RobotWalls::Obstacles obstacles;
    for (const Thing& thing : *things)
      obstacles.push_back(thing.ball ? make_ball({thing.center, thing.half[0]})
                                     : make_box_obstacle({thing.center - thing.half, thing.center + thing.half}));
    space = std::make_shared<const EuclideanManifold>(
        EuclideanManifoldOptions{.dimension = dimension, .box = {kinematics.lower(), kinematics.upper()}});
    space =
        std::make_shared<const FreeSpace>(space, std::make_shared<const RobotWalls>(arm.robot, obstacles, kClearance));
  }
  problem.manifold = space;
  problem.cost = make_euclidean_cost(dimension);
  problem.kernel = make_kernel(Expm1Square{});
  problem.source = {query.source};
  problem.target = {query.target};
  return problem;
}

struct Figures {
  std::vector<double> cold, warm, certificate, fits;
};

double quantile_of(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(part * static_cast<double>(values.size())))];
}

void print(const char* what, const Figures& f) {
  std::printf(
      "  %-9s %3zu: cold median %.1f, p90 %.1f, worst %.1f; warm %.1f, %.1f, %.1f solves; certificate %.0f ms\n", what,
      f.cold.size(), quantile_of(f.cold, 0.5), quantile_of(f.cold, 0.9), quantile_of(f.cold, 1),
      quantile_of(f.warm, 0.5), quantile_of(f.warm, 0.9), quantile_of(f.warm, 1),
      1e3 * quantile_of(f.certificate, 0.5));
}

Monitor within(double seconds) {
  Monitor monitor;
  monitor.deadline = Monitor::Clock::now() +
                     std::chrono::duration_cast<Monitor::Clock::duration>(std::chrono::duration<double>(seconds));
  return monitor;
}

/// Seconds of improve_path from a chain, without certificate; the median of some.
double seconds_of(const Problem& problem, const CoordinatePath& chain, int times, Result& result) {
  std::vector<double> all;
  for (int k = 0; k < times; ++k) {
    const double begin = thread_seconds();
    result = improve_path(problem, chain, Newton(), {.certificate = {.enabled = false}}, within(kMostSeconds));
    all.push_back(thread_seconds() - begin);
    if (all.back() > 0.1) break;  // long enough to be measured once
  }
  return quantile_of(all, 0.5);
}

}  // namespace

/// Arguments: how many queries for each arm, the first seed (the next ones are two apart), 1 to certify, the arm; 100,
/// 1, 1 and both unless given.
int main(int count, char** arguments) {
  const int queries = count > 1 ? std::atoi(arguments[1]) : 100;
  const auto first = static_cast<unsigned>(count > 2 ? std::atoi(arguments[2]) : 1);
  const bool certify = count <= 3 || std::atoi(arguments[3]) != 0;
  const std::string only = count > 4 ? arguments[4] : "";
  for (const Arm& arm : arms()) {
    if (!only.empty() && only != arm.name) continue;
    int no_ends = 0, found = 0, certified = 0, proved = 0, violations = 0;
    Figures straight, round;
    for (int k = 0; k < queries; ++k) {
      const unsigned seed = first + 2 * static_cast<unsigned>(k);
      const Query query = query_of(arm, seed);
      if (query.source.size() == 0 || query.target.size() == 0) {
        ++no_ends;
        continue;
      }
      const Problem problem = problem_of(arm, query, &query.things), free = problem_of(arm, query, nullptr);
      try {
        FindOptions options;
        options.points = kPoints;
        options.certificate.enabled = certify;
        const Result result = find_path(problem, RrtInitializer(), Newton(), options, within(kMostSeconds));
        found += result.first.path.u.cols() > 0 ? 1 : 0;
        const bool is_certified = result.status == Status::certified;
        certified += is_certified ? 1 : 0;
        const auto& clearance = result.certificate.clearance;
        proved += is_certified && clearance && clearance->proved ? 1 : 0;
        double least = 1e9;
        for (Index i = 0; i + 1 < result.curve.x.cols(); ++i)
          for (int place = 0; place <= kPlaces; ++place)
            least = std::min(least, own_gap(arm, query.things,
                                            result.curve.x.col(i) +
                                                (result.curve.x.col(i + 1) - result.curve.x.col(i)) * place / kPlaces));
        violations += is_certified && least < -kNothing ? 1 : 0;
        if (result.path.u.cols() == 0) continue;
        Result solved, freed, warmed;
        const double cold = seconds_of(problem, result.initial, 3, solved);
        const double unit = seconds_of(free, result.initial, 7, freed);
        const double warm = seconds_of(problem_of(arm, query, &query.moved), result.path, 3, warmed);
        const bool goes_round = solved.curve.cost > (query.target - query.source).norm() * (1 + kStraight);
        Figures& figures = goes_round ? round : straight;
        figures.cold.push_back(cold / unit);
        figures.warm.push_back(warm / unit);
        figures.certificate.push_back(result.seconds.certify);
        std::printf(
            "seed %u: %s%s, gap %.1e, first %.2f s, cold %.2f ms (%d iterations), warm %.2f ms (%d), free %.3f ms "
            "(%d), %s: %.1f, %.1f\n",
            seed, is_certified ? "certified" : "not certified", least < -kNothing ? ", TOUCHES" : "", least,
            result.seconds.initialize, 1e3 * cold, solved.solve.iterations, 1e3 * warm, warmed.solve.iterations,
            1e3 * unit, freed.solve.iterations, goes_round ? "round" : "straight", cold / unit, warm / unit);
        for (const auto& failure : result.certificate.failures)
          std::printf("    %s: %s\n", failure.name().c_str(), failure.message.c_str());
      } catch (const std::exception& error) {
        std::printf("seed %u: %s\n", seed, error.what());
      }
      std::fflush(stdout);
    }
    std::printf(
        "%s: %d queries, %d without free ends, %d first paths, %d certified, %d of them proved, %d of them violated\n",
        arm.name, queries, no_ends, found, certified, proved, violations);
    print("straight", straight);
    print("round", round);
  }
}
