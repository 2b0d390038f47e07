// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/ompl/polish.hpp>

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>
#include <leastcost/problems/robots/dh_arm.hpp>
#include <leastcost/problems/robots/rigid_body.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include "tests/ompl/plans.hpp"

namespace leastcost::test {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kPi = std::numbers::pi;
constexpr double kContact = -1e-9;

/// Around a disc of radius 1 from (-2, 0) to (2, 0): two tangents and the arc between them.
const Discs kOneDisc = {{5, 5, 1}};
const double kAroundOne = 2 * std::sqrt(3) + kPi / 3;

Points detour() {
  Points x(2, 5);
  x << 3, 3.2, 5, 7.5, 7,  //
      5, 8, 7.5, 7, 5;
  return x;
}

/// The distance of the planner's checker, which is a true one, bent no more than by a disc of radius `least`.
PolishOptions with_distance(double least) {
  PolishOptions options;
  options.distance = DistanceChecker{.curvature = 2 / least, .curvature_from = -least / 2, .size = 10};
  return options;
}

PolishOptions with_discs(const Discs& discs) {
  ObstacleWalls::Obstacles obstacles;
  for (const Disc& disc : discs)
    obstacles.push_back(make_ball({.center = Eigen::Vector2d(disc.x, disc.y), .radius = disc.r}));
  PolishOptions options;
  options.walls = std::make_shared<ObstacleWalls>(2, std::move(obstacles), 0);
  return options;
}

Discs random_discs(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> along(0, 10), radius(0.3, 1);
  Discs discs;
  while (discs.size() < 25) {
    const Disc disc{along(random), along(random), radius(random)};
    if (std::min(std::hypot(disc.x - 0.5, disc.y - 0.5), std::hypot(disc.x - 9.5, disc.y - 9.5)) > disc.r + 0.1)
      discs.push_back(disc);
  }
  return discs;
}

double length_of_line(const Points& x) {
  return (x.rightCols(x.cols() - 1) - x.leftCols(x.cols() - 1)).colwise().norm().sum();
}

/// Length under the metric 1 + x^2.
std::shared_ptr<const SegmentCost> heavier_to_the_right() {
  return make_metric_field_cost({.field = metric::Formula{{"1+x*x", "0", "1+x*x"}, {}}}, 2);
}

}  // namespace

/// Planners that sample within ellipsoids do so with OMPL's own Eigen, whatever the program was compiled with.
TEST_CASE("polish: plans of informed planners") {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  ompl::RNG::setSeed(1);
  og::SimpleSetup setup(square(3, -3, 3));
  setup.setStateValidityChecker([](const ob::State* state) {
    const double* x = state->as<ob::RealVectorStateSpace::StateType>()->values;
    return std::hypot(x[0], x[1], x[2]) > 1;
  });
  ob::ScopedState<> from(setup.getStateSpace()), to(setup.getStateSpace());
  for (unsigned k = 0; k < 3; ++k) {
    from[k] = -2;
    to[k] = 2;
  }
  setup.setStartAndGoalStates(from, to);
  const auto& space = setup.getSpaceInformation();
  setup.setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(space));
  if (GENERATE(true, false))
    setup.setPlanner(std::make_shared<og::BITstar>(space));
  else
    setup.setPlanner(std::make_shared<og::InformedRRTstar>(space));
  REQUIRE(setup.solve(0.3) == ob::PlannerStatus::EXACT_SOLUTION);
  const Polished plan = polish(setup.getSolutionPath());
  CHECK(plan.cost <= plan.given_cost);
  CHECK(plan.cost > 2 * std::sqrt(12.0));
}

TEST_CASE("polish: around a disc, by what is known of it") {
  const PlannerSpace space = among(square(), kOneDisc);
  const PlannerPath plan = path_through(space, detour());
  REQUIRE(plan.check());
  SECTION("the disc itself: proved, certified") {
    const Polished ours = polish(plan, with_discs(kOneDisc));
    CHECK(ours.certified());
    REQUIRE(ours.clearance);
    CHECK(ours.clearance->proved);
    CHECK(ours.result.certificate.estimate.value == Approx(kAroundOne).epsilon(1e-4));
    CHECK(ours.cost == Approx(kAroundOne).epsilon(1e-3));
  }
  SECTION("the planner's distance: proved, certified") {
    const Polished ours = polish(plan, with_distance(1));
    CHECK(ours.certified());
    REQUIRE(ours.clearance);
    CHECK(ours.clearance->proved);
    CHECK(ours.clearance->lower >= 0);
    CHECK(ours.cost == Approx(kAroundOne).epsilon(1e-3));
  }
  SECTION("yes or no: sampled, and the certificate is not of this path") {
    const Polished ours = polish(plan);
    CHECK(ours.outcome == PolishOutcome::tightened);
    CHECK_FALSE(ours.certified());
    CHECK_THAT(ours.why, Catch::Contains("only valid or invalid"));
    REQUIRE(ours.clearance);
    CHECK_FALSE(ours.clearance->proved);
    CHECK(ours.cost == Approx(kAroundOne).epsilon(2e-3));
    CHECK(ours.path->check());
  }
}

TEST_CASE("polish: a straight way that nothing holds is certified by yes or no as well") {
  const PlannerSpace space = among(square(), {{5, 8, 1}});
  const Polished ours = polish(path_through(space, detour().colwise() - Eigen::Vector2d(0, 4)));
  CHECK(ours.certified());
  CHECK(ours.cost == Approx(4).epsilon(1e-12));
}

TEST_CASE("polish: random scenes: never longer than the plan, never in a disc, ends to the last digit") {
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  int solved = 0;
  for (unsigned seed = 1000; seed < 1006; ++seed) {
    CAPTURE(seed);
    const Discs discs = random_discs(seed);
    const PlannerSpace space = among(square(), discs);
    og::SimpleSetup setup(space);
    ob::ScopedState<> start(space), goal(space);
    start[0] = start[1] = 0.5;
    goal[0] = goal[1] = 9.5;
    setup.setStartAndGoalStates(start, goal);
    setup.setPlanner(std::make_shared<og::RRTConnect>(space));
    if (setup.solve(2.0) != ob::PlannerStatus::EXACT_SOLUTION) continue;
    const og::PathGeometric plan = setup.getSolutionPath();
    if (clearance_of(columns_of(plan), discs) < kContact) continue;  // between the places where the planner looked
    for (PolishOptions options : {with_discs(discs), with_distance(0.3), PolishOptions{}}) {
      const bool measured = options.walls || options.distance;
      options.find.certificate.enabled = false;
      const Polished ours = polish(plan, options);
      const Points x = columns_of(*ours.path), given = columns_of(plan);
      CHECK(length_of_line(x) <= length_of_line(given));
      CHECK(ours.cost == Approx(length_of_line(x)));
      CHECK(ours.given_cost == Approx(length_of_line(given)));
      CHECK(ours.path->check());
      CHECK(clearance_of(x, discs) >= (measured ? kContact : -1e-3));  // yes or no: as finely as the planner looks
      CHECK(x.leftCols(1) == given.leftCols(1));
      CHECK(x.rightCols(1) == given.rightCols(1));
      CHECK((ours.outcome == PolishOutcome::polished) == ours.why.empty());
      ++solved;
    }
  }
  CHECK(solved >= 12);
}

TEST_CASE("polish: planar poses take the short way around the seam of their angle") {
  const PlannerSpace space = open_space(planar_poses());
  Points given(3, 4);   // from 3 to -3, which is 3.28
  given << 0, 1, 1, 2,  //
      0, 1, -1, 0,      //
      3, 3.4, 2.9, 2 * kPi - 3;
  const Polished ours = polish(path_through(space, given));
  CHECK(ours.certified());
  CHECK(ours.cost == Approx(std::hypot(2, 0.5 * (2 * kPi - 6))));
  for (unsigned i = 0; i < ours.path->getStateCount(); ++i) {
    const double yaw = ours.path->getState(i)->as<ob::SE2StateSpace::StateType>()->getYaw();
    CHECK(std::abs(yaw) >= 3 - 1e-9);
    CHECK(std::abs(yaw) <= kPi);
  }
}

TEST_CASE("polish: planar poses among discs") {
  const PlannerSpace space = among(planar_poses(), {{0, 0, 1}});
  Points given(3, 4);
  given << -2, -1, 2, 2,  //
      0, 3, 2, 0,         //
      0, 1, 2, 1;
  const Polished ours = polish(path_through(space, given), with_distance(1));
  CHECK(ours.certified());
  // The angle turns evenly along the way: by Pythagoras.
  CHECK(ours.result.certificate.estimate.value == Approx(std::hypot(kAroundOne, 0.5 * 1)).epsilon(1e-4));
  CHECK(clearance_of(columns_of(*ours.path).topRows(2), {{0, 0, 1}}) >= kContact);
}

TEST_CASE("polish: planar poses by yes or no are shorter and valid") {
  const PlannerSpace space = among(planar_poses(), {{0, 0, 1}});
  Points given(3, 4);
  given << -2, -1, 2, 2,  //
      0, 3, 2, 0,         //
      3, 4, 5, 4;
  const PlannerPath plan = path_through(space, given);
  REQUIRE(plan.check());
  const Polished ours = polish(plan);
  CHECK(ours.outcome == PolishOutcome::tightened);
  CHECK(ours.path->check());
  CHECK(ours.cost < 0.7 * ours.given_cost);
  CHECK(ours.cost == Approx(std::hypot(kAroundOne, 0.5 * 1)).epsilon(0.01));
  CHECK(clearance_of(columns_of(*ours.path).topRows(2), {{0, 0, 1}}) >= -1e-3);
}

TEST_CASE("polish: poses in space: a straight line and the shortest turn, weighed as the space weighs them") {
  const PlannerSpace space = open_space(poses());
  Points given = Points::Zero(7, 4);
  given.row(0) << 0, 1, 2, 4;
  given.row(1) << 0, 2, -1, 0;
  given.row(6) << 1, 0.8, 0.9, std::cos(0.6);  // about z, by 1.2 in the end
  given.row(3) << 0, 0.6, 0, 0;
  given.row(4) << 0, 0, std::sqrt(1 - 0.81), 0;
  given.row(5) << 0, 0, 0, std::sin(0.6);
  const Polished ours = polish(path_through(space, given));
  CHECK(ours.certified());
  CHECK(ours.result.certificate.estimate.value == Approx(std::hypot(4, 0.6)).epsilon(1e-8));
  CHECK(ours.path->check());
}

TEST_CASE("polish: a clearance is kept, and proved, between quaternions as well") {
  const PlannerSpace space = among(poses(), {{0, 0, 1}});
  Points given = Points::Zero(7, 4);
  given.row(0) << -2, -1, 1, 2;
  given.row(1) << 0, 2, 2, 0;
  given.row(6) << 1, 1, 1, std::cos(0.4);
  given.row(5) << 0, 0, 0, std::sin(0.4);
  PolishOptions options;
  options.distance = DistanceChecker{.clearance = 0.2, .size = 10};
  options.find = {.points = 40, .certificate = {.enabled = false}};
  const Polished ours = polish(path_through(space, given), options);
  CHECK(ours.outcome == PolishOutcome::polished);
  REQUIRE(ours.clearance);
  CHECK(ours.clearance->proved);
  CHECK(clearance_of(columns_of(*ours.path).topRows(2), {{0, 0, 1.2}}) >= kContact);
}

TEST_CASE("polish: parts of a move with a turn are other motions, and are not taken for valid ones") {
  // The tip of a long body passes close by balls on the chord of its turn, then goes a detour in the open.
  Robot body;
  body.kinematics = std::make_shared<const SpatialBody>();
  body.capsules = {{0, {3, 0, 0}, {3, 0, 0}, 0.1}};
  Points given = Points::Zero(7, 4);
  given.row(0) << 0, 2, 3, 4;
  given.row(1) << 0, 0, -4, 0;
  const double half = 1.3;  // of the turn about z
  given.row(5) << 0, std::sin(half), std::sin(half), std::sin(half);
  given.row(6) << 1, std::cos(half), std::cos(half), std::cos(half);
  const auto tip = [&](double t) {
    const double angle = 2 * std::atan2(t * std::sin(half), (1 - t) + t * std::cos(half));
    return Eigen::Vector3d(2 * t + 3 * std::cos(angle), 3 * std::sin(angle), 0);
  };
  RobotWalls::Obstacles balls;
  for (int k = 1; k < 16; ++k) {
    constexpr double kRadius = 0.05, kRoom = 0.001, kStep = 1e-4;
    const double t = k / 16.0;
    const Eigen::Vector3d aside = (tip(t + kStep) - tip(t - kStep)).cross(Eigen::Vector3d::UnitZ()).normalized();
    for (const double side : {-1.0, 1.0})
      balls.push_back(make_ball({Eigen::Vector3d(tip(t) + side * (0.1 + kRadius + kRoom) * aside), kRadius}));
  }
  const PlannerSpace space = open_space(poses());
  PolishOptions options;
  options.walls = make_pose_walls(StateColumns(space->getStateSpace()),
                                  std::make_shared<RobotWalls>(make_robot(std::move(body)), std::move(balls), 0));
  options.search = false;
  const Polished ours = polish(path_through(space, given), options);
  CAPTURE(ours.why);
  CHECK(ours.outcome == PolishOutcome::tightened);
  CHECK(ours.cost < 0.8 * ours.given_cost);
  REQUIRE(ours.clearance);
  CHECK(ours.clearance->lower >= kContact);
}

TEST_CASE("polish: of a body in space the best pieces of several plans are put together") {
  // A wall with a hole on the way; the given plan goes around the wall.
  Robot body;
  body.kinematics = std::make_shared<const SpatialBody>();
  body.capsules = {{0, {-0.8, 0, 0}, {0.8, 0, 0}, 0.2}};
  const auto slab = [](double low, double high) {
    ShapePose pose;
    pose.position = Eigen::Vector3d(0, (low + high) / 2, 0);
    return make_box({.size = Eigen::Vector3d(0.6, high - low, 20), .pose = pose});
  };
  const PlannerSpace space = open_space(poses());
  PolishOptions options;
  options.walls =
      make_pose_walls(StateColumns(space->getStateSpace()),
                      std::make_shared<RobotWalls>(make_robot(std::move(body)),
                                                   RobotWalls::Obstacles{slab(-20, 0.6), slab(1.8, 9.3)}, 0));
  options.search = false;
  Points given = Points::Zero(7, 4);
  given.row(0) << -3, -1.5, 1.5, 3;
  given.row(6).setOnes();
  const auto clear = [&](const Polished& ours) {
    REQUIRE(ours.clearance);
    CHECK(ours.clearance->lower >= 20 * kContact);
    CHECK(ours.path->check());
  };
  SECTION("another side of the wall is cheaper") {
    given.row(1) << 0, 9.8, 9.8, 0;
    const Polished ours = polish(path_through(space, given), options);
    clear(ours);
    CAPTURE(ours.why);
    CHECK(ours.cost < 7);
    CHECK(polish(path_through(space, given), options).cost == ours.cost);
  }
  SECTION("a given plan in collision is replaced") {  // the planner sees no wall
    const Polished ours = polish(path_through(space, given), options);
    CHECK(ours.outcome == PolishOutcome::given);  // a clear one costs more
    given.row(1) << 0, 9, 8, 0;
    const Polished other = polish(path_through(space, given), options);
    CAPTURE(other.why);
    CHECK(other.outcome == PolishOutcome::tightened);
    clear(other);
  }
}

TEST_CASE("pose walls: a robot keeps its cache, its quick answer and its pictures over OMPL's columns") {
  Robot body;
  body.kinematics = std::make_shared<const SpatialBody>();
  body.capsules = {{0, {-1, 0, 0}, {1, 0, 0}, 0.1}};
  const auto robot = std::make_shared<RobotWalls>(
      make_robot(std::move(body)), RobotWalls::Obstacles{make_ball({Eigen::Vector3d(0, 0, 1), 0.2})}, 0.05);
  const PlannerSpace space = open_space(poses());
  const auto walls = make_pose_walls(StateColumns(space->getStateSpace()), robot);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  Eigen::VectorXd pose(7), column(7);
  pose << 0.1, 0.2, 0.3, turn.w(), turn.vec();
  column << 0.1, 0.2, 0.3, turn.vec(), turn.w();
  std::vector<Wall> near_pose, near_column;
  robot->near(pose, 10, near_pose);
  const std::shared_ptr<const Walls> cached = remembering(*walls);
  REQUIRE(cached);
  for (const Walls* each : {walls.get(), cached.get()}) {
    each->near(column, 10, near_column);
    REQUIRE(near_column.size() == 1);
    CHECK(near_column[0].gap == near_pose[0].gap);
    CHECK(near_column[0].slope.segment(3, 3) == near_pose[0].slope.tail(3));
    CHECK(near_column[0].slope[6] == near_pose[0].slope[3]);
    CHECK(find_ability<DecidesMoves>(*each) != nullptr);
    const auto* drawn = find_ability<DrawsPoses>(*each);
    REQUIRE(drawn != nullptr);
    CHECK(drawn->pose_strip(column).poses == robot->pose_strip(pose).poses);
  }
}

TEST_CASE("polish: another cost than the length") {
  const PlannerSpace space = open_space(square(2, -10, 10));
  Points given(2, 3);
  given << 2, 5, 2,  //
      -2, 0, 2;
  const auto cost = heavier_to_the_right();
  const Polished ours = polish(path_through(space, given), {.cost = cost});
  CHECK(ours.certified());
  CHECK(ours.cost < ours.given_cost / 2);
  CHECK(columns_of(*ours.path).row(0).minCoeff() < 1);  // not straight: it goes where it is cheaper
  CHECK(ours.cost == Approx(ours.result.certificate.estimate.value).epsilon(1e-3));
}

/// A planar arm of three links beside a ball, and a plan that takes the long way round.
TEST_CASE("polish: an arm before a deadline: never dearer than given, always clear, and on the cheaper side") {
  DhTable table;
  table.rows = Points::Zero(3, 4);
  table.rows.col(0) << 0.5, 0.5, 0.4;
  table.lower = Eigen::VectorXd::Constant(3, -kPi);
  table.upper = -table.lower;
  Robot arm;
  arm.kinematics = std::make_shared<const DhArm>(table);
  for (int link = 1; link <= 3; ++link)
    arm.capsules.push_back({link, {-table.rows(link - 1, 0), 0, 0}, {0, 0, 0}, 0.04});
  const auto walls = std::make_shared<const RobotWalls>(
      make_robot(std::move(arm)), RobotWalls::Obstacles{make_ball({Eigen::Vector3d(0.9, 0.5, 0), 0.15})}, 0.001);
  const auto space = std::make_shared<ob::SpaceInformation>(square(3, -kPi, kPi));
  space->setStateValidityChecker([&](const ob::State* state) {
    const Eigen::VectorXd x =
        Eigen::Map<const Eigen::VectorXd>(state->as<ob::RealVectorStateSpace::StateType>()->values, 3);
    return walls->clears(x, x);
  });
  space->setStateValidityCheckingResolution(0.003);
  space->setup();
  Points given(3, 5);
  given << -0.3, -1.5, -2.5, 1.8, 1.3,  //
      0, 2.5, 2.8, 2.8, 0,              //
      0, 0.5, 0.3, 0.2, 0;
  const PlannerPath plan = path_through(space, given);
  REQUIRE(plan.check());
  PolishOptions options;
  options.walls = walls;
  const auto polished_within = [&](int other_plans, std::chrono::milliseconds time) {
    options.other_plans = other_plans;
    Monitor monitor;
    monitor.deadline = Monitor::Clock::now() + time;
    return polish(plan, options, monitor);
  };
  const auto least_gap = [&](const Points& x) {
    double least = std::numeric_limits<double>::infinity();
    std::vector<Wall> found;
    for (Index i = 0; i + 1 < x.cols(); ++i)
      for (int k = 0; k <= 400; ++k) {
        walls->near(x.col(i) + k / 400.0 * (x.col(i + 1) - x.col(i)), 0.1, found);
        for (const Wall& wall : found) least = std::min(least, wall.gap);
      }
    return least;
  };
  for (const int time : {0, 2, 20, 300}) {
    CAPTURE(time);
    const Polished ours = polished_within(16, std::chrono::milliseconds(time));
    CHECK(ours.cost <= ours.given_cost);
    CHECK(ours.cost == Approx(length_of_line(columns_of(*ours.path))));
    CHECK(least_gap(columns_of(*ours.path)) >= kContact);
    CHECK(ours.path->check());
  }
  options.search = false;
  const Polished alone = polished_within(0, std::chrono::seconds(20));
  const Polished ours = polished_within(16, std::chrono::seconds(20));
  CHECK(alone.outcome == PolishOutcome::tightened);
  CHECK(ours.cost < 0.95 * alone.cost);
  CHECK(least_gap(columns_of(*ours.path)) >= kContact);
  options.other_plans = -1;
  CHECK_THROWS_WITH(polish(plan, options), Catch::Contains("other_plans is a number of plans"));
}

TEST_CASE("polish: the same plan gives the same path, and OMPL finds the cost that is said") {
  const PlannerSpace space = among(square(), {{5, 5, 1}, {6, 6.2, 0.5}});
  const PlannerPath plan = path_through(space, detour());
  REQUIRE(plan.check());
  for (const PolishOptions& options : {with_distance(0.5), PolishOptions{}}) {
    const Polished one = polish(plan, options), other = polish(plan, options);
    CHECK(columns_of(*one.path) == columns_of(*other.path));
    CHECK(one.path->cost(make_objective(space, make_euclidean_cost(2))).value() == Approx(one.cost).epsilon(1e-12));
    CHECK(one.path->length() == Approx(one.cost).epsilon(1e-12));
  }
}

TEST_CASE("polish: what cannot be improved comes back as it was given") {
  const PlannerSpace space = open_space(square());
  Points straight(2, 2);
  straight << 1, 4, 1, 5;
  const PlannerPath plan = path_through(space, straight);
  const Polished ours = polish(plan);
  CHECK(ours.outcome == PolishOutcome::given);
  CHECK(ours.cost == 5);
  CHECK(ours.given_cost == 5);
  CHECK(columns_of(*ours.path) == straight);
  CHECK_FALSE(ours.why.empty());
  const Polished nothing = polish(path_through(space, Points::Ones(2, 3)));
  CHECK(nothing.outcome == PolishOutcome::given);
  CHECK(nothing.why == "the given path has cost 0");
  CHECK(polish(path_through(space, Points::Zero(2, 2))).outcome == PolishOutcome::given);
}

TEST_CASE("polish: no time: the given path, valid and at most as dear") {
  const PlannerSpace space = among(square(), kOneDisc);
  const PlannerPath plan = path_through(space, detour());
  Monitor late;
  late.deadline = Monitor::Clock::now() - std::chrono::seconds(1);
  const Polished ours = polish(plan, with_distance(1), late);
  CHECK_FALSE(ours.certified());
  CHECK(ours.cost <= ours.given_cost);
  CHECK(ours.path->check());
  CHECK_FALSE(ours.why.empty());
}

TEST_CASE("polish: a path that is none is refused by its state") {
  const PlannerSpace space = among(square(), kOneDisc);
  CHECK_THROWS_AS(polish(PlannerPath(space)), InputError);
  CHECK_THROWS_WITH(polish(PlannerPath(space)), Catch::Contains("at least two states, but this one has 0"));
  CHECK_THROWS_WITH(polish(path_through(space, Points::Ones(2, 1))),
                    Catch::Contains("at least two states, but this one has 1"));
  Points through = detour();
  through.col(2) << 5, 5.5;
  CHECK_THROWS_AS(polish(path_through(space, through)), InputError);
  CHECK_THROWS_WITH(polish(path_through(space, through)),
                    Catch::Contains("state 2 of the path, (5, 5.5), is not valid"));
  through.col(2) << 5, 12;
  CHECK_THROWS_WITH(polish(path_through(space, through)), Catch::Contains("outside the bounds of the space"));
}

TEST_CASE("polish: parts that do not fit") {
  const PlannerSpace space = among(square(), kOneDisc);
  const PlannerPath plan = path_through(space, detour());
  CHECK_THROWS_WITH(polish(plan, {.cost = make_euclidean_cost(3)}), Catch::Contains("the cost has 3 dimensions"));
  const auto room = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 3});
  CHECK_THROWS_WITH(polish(plan, {.domain = room}), Catch::Contains("states of the space have 2 rows"));
  PolishOptions both = with_discs(kOneDisc);
  both.distance = DistanceChecker{};
  CHECK_THROWS_WITH(polish(plan, both), Catch::Contains("walls or a distance, not both"));
  PolishOptions wrong = with_distance(1);
  wrong.distance->lipschitz = -1;
  CHECK_THROWS_AS(polish(plan, wrong), OptionError);
  CHECK_THROWS_AS(polish(plan, {.find = {.points = 0}}), InputError);
  CHECK_THROWS_WITH(polish(plan, {.find = {.points = std::nullopt}}), Catch::Contains("a number of points"));
  const auto ball = make_implicit_manifold({.surface = implicit::Sphere{}});
  CHECK_THROWS_WITH(polish(plan, {.domain = ball}), Catch::Contains("states of the space have 2 rows"));
  const auto new_space = std::make_shared<ob::SpaceInformation>(square());
  CHECK_THROWS_WITH(polish(path_through(new_space, detour())), Catch::Contains("the space is not set up"));
}

TEST_CASE("polish: moves that are not straight in the columns are refused") {
  const auto cars = std::make_shared<ob::DubinsStateSpace>(1.0);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(-10);
  bounds.setHigh(10);
  cars->setBounds(bounds);
  const PlannerSpace space = open_space(cars);
  Points given(3, 2);
  given << 0, 1, 0, 3, 0, 1;
  CHECK_THROWS_AS(polish(path_through(space, given)), InputError);
  CHECK_THROWS_WITH(polish(path_through(space, given)), Catch::Contains("is not straight in its coordinates"));
}

TEST_CASE("polish: what a user's checker throws passes through") {
  const auto space = std::make_shared<ob::SpaceInformation>(square());
  int calls = 0;
  space->setStateValidityChecker([&](const ob::State*) -> bool {
    if (++calls > 30) throw std::domain_error("the map is gone");
    return true;
  });
  space->setup();
  CHECK_THROWS_AS(polish(path_through(space, detour())), std::domain_error);
}

}  // namespace leastcost::test
