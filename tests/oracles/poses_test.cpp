// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Geodesics of products are those of their factors, side by side: among poses a straight line with a constant turn, of
// cost sqrt(L^2 + (w phi)^2).
#include <Eigen/Geometry>
#include <cmath>

#include <leastcost/framework/result/other_images.hpp>
#include <leastcost/problems/costs/weighted_length.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/manifolds/angle.hpp>
#include <leastcost/problems/manifolds/constraint.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/pose.hpp>
#include <leastcost/problems/manifolds/product.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/random.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

constexpr double kTurnWeight = 0.5;  ///< length per radian

Eigen::VectorXd spatial_pose(const Eigen::Vector3d& place, const Eigen::Quaterniond& q) {
  Eigen::VectorXd all(7);
  all << place, q.w(), q.x(), q.y(), q.z();
  return all;
}

Eigen::Matrix3d turn_of(const Eigen::VectorXd& pose) {
  return Eigen::Quaterniond(pose[3], pose[4], pose[5], pose[6]).toRotationMatrix();
}

/// The angle between two rotations, from their matrices.
double angle_between_turns(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const Eigen::Matrix3d r = a.transpose() * b;
  const double sine = Eigen::Vector3d(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)).norm();
  return std::atan2(sine, r.trace() - 1);
}

Problem among_poses(const std::shared_ptr<const ConstraintManifold>& domain, const Eigen::VectorXd& a,
                    const Eigen::VectorXd& b) {
  return between(domain, make_weighted_length({Eigen::Vector2d(1, kTurnWeight)}, *domain), a, b);
}

/// Certified, and the bar covers the closed form and is not wider than `widest` of it.
void check_value(const Result& result, double exact, double widest) {
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(result.path.u.cols(), e.value, e.error, e.method, exact, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - exact) <= e.error + 1e-15 * exact);
  CHECK(e.error <= widest * exact);
}

/// Two tangents of a disc of radius r around the origin and the arc between them, on the shorter side or on the other.
double around_disc(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double r, bool shorter = true) {
  const double angle = std::acos(a.dot(b) / (a.norm() * b.norm()));
  const double turn = (shorter ? angle : 2 * kPi - angle) - std::acos(r / a.norm()) - std::acos(r / b.norm());
  return std::sqrt(a.squaredNorm() - r * r) + std::sqrt(b.squaredNorm() - r * r) + r * turn;
}

}  // namespace

TEST_CASE("se2: a straight line with a constant turn", "[oracle]") {
  const auto poses = make_planar_poses();
  const Eigen::Vector3d a(0, 0, 0.3), b(3, -1, 2.5);
  const double exact = std::hypot(std::sqrt(10.0), kTurnWeight * 2.2);
  for (const int n : {32, 64, 200}) {
    const Result result = find(among_poses(poses, a, b), n);
    check_value(result, exact, 1e-10);
    for (Index i = 0; i < result.path.u.cols(); ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(n + 1);
      CHECK((result.path.u.col(i) - (1 - t) * a - t * b).norm() <= 1e-7);
    }
  }
}

TEST_CASE("se3: a straight line with a constant turn about a fixed axis", "[oracle]") {
  Random random;
  const auto poses = make_spatial_poses();
  for (const int n : {32, 64, 200}) {
    const Eigen::Vector3d from = random.vector(3), to = 2 * random.vector(3);
    const Eigen::Vector3d axis = random.vector(3).normalized();
    const double phi = random.uniform(0.5, 2.8);
    const Eigen::Quaterniond start(Eigen::AngleAxisd(random.uniform(-3, 3), random.vector(3).normalized()));
    const Eigen::Quaterniond end = start * Eigen::Quaterniond(Eigen::AngleAxisd(phi, axis));
    const Eigen::VectorXd a = spatial_pose(from, start), b = spatial_pose(to, end);
    const double exact = std::hypot((to - from).norm(), kTurnWeight * phi);
    REQUIRE(angle_between_turns(turn_of(a), turn_of(b)) == Approx(phi).epsilon(1e-12));
    Problem problem = among_poses(poses, a, b);
    if (start.dot(end) < 0) problem.target.u.tail(4) *= -1;  // the straight start goes to the nearer name
    const Result result = find(problem, n);
    check_value(result, exact, 1e-6);
    double worst_line = 0, worst_turn = 0;
    for (Index i = 0; i < result.path.u.cols(); ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(n + 1);
      worst_line = std::max(worst_line, (result.path.u.col(i).head(3) - (1 - t) * from - t * to).norm());
      const Eigen::Matrix3d expected = turn_of(a) * Eigen::AngleAxisd(t * phi, axis).toRotationMatrix();
      worst_turn = std::max(worst_turn, (turn_of(result.path.u.col(i)) - expected).norm());
    }
    CHECK(worst_line <= 1e-6);
    CHECK(worst_turn <= 1e-6);
  }
}

TEST_CASE("se3: a turn alone costs its weight times the angle, up to half a turn", "[oracle]") {
  const auto poses = make_spatial_poses();
  const Eigen::Vector3d place(1, 2, 3), axis = Eigen::Vector3d(1, -2, 2) / 3;
  for (const double phi : {1e-3, 0.1, 1.0, 3.0, 3.14}) {
    CAPTURE(phi);
    const Eigen::VectorXd a = spatial_pose(place, Eigen::Quaterniond::Identity());
    const Eigen::VectorXd b = spatial_pose(place, Eigen::Quaterniond(Eigen::AngleAxisd(phi, axis)));
    check_value(find(among_poses(poses, a, b), 64), kTurnWeight * phi, 1e-6);
  }
}

TEST_CASE("poses: the opposite quaternion and whole turns are found to name the target more cheaply", "[oracle]") {
  const Eigen::Quaterniond start = Eigen::Quaterniond::Identity(), end(Eigen::AngleAxisd(2, Eigen::Vector3d::UnitY()));
  const Eigen::VectorXd a = spatial_pose(Eigen::Vector3d::Zero(), start);
  Eigen::VectorXd b = spatial_pose(Eigen::Vector3d(1, 2, -1), end);
  const double exact = std::hypot(std::sqrt(6.0), kTurnWeight * 2);
  b.tail(4) *= -1;
  Problem room = among_poses(make_spatial_poses(), a, b);
  const std::optional<CheaperImage> opposite = find_cheaper_image(room);
  REQUIRE(opposite);
  CHECK(opposite->image.u.tail(4) == -b.tail(4));
  CHECK(opposite->given > 1.2 * opposite->cost);  // 23 % too long
  CHECK_THAT(cheaper_image(room, opposite->given, {}), Catch::Contains("-q"));
  room.target.u = opposite->image.u;
  check_value(find(room, 64), exact, 1e-6);
  CHECK_FALSE(find_cheaper_image(room));

  // 3 and -3 radians are 0.283 apart, not 6: 133 % too long.
  Problem plane = among_poses(make_planar_poses(), Eigen::Vector3d(0, 0, 3), Eigen::Vector3d(1, 1, -3));
  const double turn = 2 * kPi - 6;
  for (int turns = -2; turns <= 2; ++turns) {
    CAPTURE(turns);
    plane.target.u[2] = -3 + 2 * kPi * turns;
    const std::optional<CheaperImage> nearer = find_cheaper_image(plane);
    CHECK(nearer.has_value() == (turns != 1));
    if (nearer) plane.target.u = nearer->image.u;
    CHECK(plane.target.u[2] == Approx(2 * kPi - 3));
    check_value(find(plane, 64), std::hypot(std::sqrt(2.0), kTurnWeight * turn), 1e-10);
  }
}

TEST_CASE("poses: the nearer name is found also where the turn is a small part of the cost", "[oracle]") {
  const double far = 100;  // a turn by 2 pi - 2 in place of 2 costs 0.04 % more
  const Eigen::Quaterniond end(Eigen::AngleAxisd(2, Eigen::Vector3d::UnitY()));
  Eigen::VectorXd b = spatial_pose(Eigen::Vector3d(far, 0, 0), end);
  b.tail(4) *= -1;
  const Problem room =
      among_poses(make_spatial_poses(), spatial_pose(Eigen::Vector3d::Zero(), Eigen::Quaterniond::Identity()), b);
  const std::optional<CheaperImage> opposite = find_cheaper_image(room);
  REQUIRE(opposite);
  CHECK(opposite->image.u.tail(4) == -b.tail(4));
  const Problem plane = among_poses(make_planar_poses(), Eigen::Vector3d(0, 0, 3), Eigen::Vector3d(10 * far, 0, -3));
  const std::optional<CheaperImage> turned = find_cheaper_image(plane);
  REQUIRE(turned);
  CHECK(turned->image.where == "winding (1)");
}

TEST_CASE("products: a sphere, an angle and rotations side by side", "[oracle]") {
  ConstraintManifoldOptions rotations;
  rotations.set = constraint::Rotations{};
  const auto domain = std::make_shared<const ProductManifold>(
      ProductManifold::Factors{make_implicit_manifold({.surface = leastcost::implicit::Sphere{2}}),
                               std::make_shared<const AngleManifold>(), make_constraint_manifold(rotations)});
  const Eigen::Quaterniond end(Eigen::AngleAxisd(1.2, Eigen::Vector3d(2, 1, 2) / 3));
  Eigen::VectorXd a(8), b(8);
  a << 2, 0, 0, 1, 1, 0, 0, 0;
  b << 2 * std::cos(0.9), 0, 2 * std::sin(0.9), -0.5, end.w(), end.x(), end.y(), end.z();
  const Problem problem = between(domain, make_weighted_length({Eigen::Vector3d(1, 2, 0.5)}, *domain), a, b);
  const double exact = std::sqrt(std::pow(2 * 0.9, 2) + std::pow(2 * 1.5, 2) + std::pow(0.5 * 1.2, 2));
  for (const int n : {32, 64, 200}) check_value(find(problem, n), exact, 1e-6);
  for (const auto& first : {std::pair<int, int>{1, 0}, {2, 0}})
    check_value(find(problem, 64, RrtInitializer({}, first.first)), exact, 1e-6);
  check_value(find(problem, 64, StraightInitializer(), Lbfgs()), exact, 1e-6);
}

TEST_CASE("poses: an rrt finds the way from any start", "[oracle]") {
  for (int seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    const Problem plane = among_poses(make_planar_poses(), Eigen::Vector3d(0, 0, 3), Eigen::Vector3d(1, 1, 4));
    check_value(find(plane, 64, RrtInitializer({}, seed)), std::hypot(std::sqrt(2.0), kTurnWeight), 1e-10);
    const Eigen::Quaterniond end(Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitX()));
    const Problem room =
        among_poses(make_spatial_poses(), spatial_pose(Eigen::Vector3d::Zero(), Eigen::Quaterniond::Identity()),
                    spatial_pose(Eigen::Vector3d(1, 1, 0), end));
    check_value(find(room, 64, RrtInitializer({}, seed)), std::hypot(std::sqrt(2.0), kTurnWeight * 2.5), 1e-6);
  }
}

TEST_CASE("poses: an rrt finds the way around a wall, though angles make the space one larger", "[oracle]") {
  FreeSpace::Obstacles wall;
  for (int i = -2; i <= 2; ++i) wall.push_back(make_ball({.center = Eigen::Vector2d(0, i), .radius = 0.7}));
  const auto poses = std::make_shared<const FreeSpace>(make_planar_poses(), wall, 0);
  const Problem problem = among_poses(poses, Eigen::Vector3d(-2, 0.2, 3), Eigen::Vector3d(2, 0, 1));
  for (int seed = 1; seed <= (nightly() ? 10 : 2); ++seed) {
    CAPTURE(seed);
    const Result result = find(problem, 100, RrtInitializer({}, seed));
    CHECK(result.status == Status::certified);
    REQUIRE(result.certificate.clearance);
    CHECK(result.certificate.clearance->lower >= -1e-9);
  }
}

TEST_CASE("poses: the origin of a body goes around a disc and a ball while it turns", "[oracle]") {
  const auto among = [](const std::shared_ptr<const ConstraintManifold>& domain, const Eigen::VectorXd& center) {
    return std::make_shared<const FreeSpace>(domain, FreeSpace::Obstacles{make_ball({.center = center, .radius = 1})},
                                             0);
  };
  for (const int n : {64, 200}) {
    const Eigen::Vector3d a(-2, 0.3, 0), b(1.5, 0.5, 1.2);
    const Problem plane = among_poses(among(make_planar_poses(), Eigen::Vector2d::Zero()), a, b);
    const Result flat = find(plane, n, RrtInitializer());
    const bool above = flat.path.u(1, n / 2) > 0;  // the rrt's choice; both ends lie above the centre
    const double length = around_disc(a.head(2), b.head(2), 1, above);
    check_value(flat, std::hypot(length, kTurnWeight * 1.2), 1e-3);
    REQUIRE(flat.certificate.clearance);
    CHECK(flat.certificate.clearance->lower >= -1e-9);
    CHECK(flat.certificate.clearance->proved);

    const Eigen::Vector3d from(-2, 0.3, 0.2), to(1.5, 0.5, -0.1);
    const Problem room = among_poses(
        among(make_spatial_poses(), Eigen::Vector3d::Zero()), spatial_pose(from, Eigen::Quaterniond::Identity()),
        spatial_pose(to, Eigen::Quaterniond(Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitZ()))));
    const Result round = find(room, n, RrtInitializer());
    check_value(round, std::hypot(around_disc(from, to, 1), kTurnWeight * 1.2), 1e-3);
    REQUIRE(round.certificate.clearance);
    CHECK(round.certificate.clearance->lower >= -1e-9);
  }
}

}  // namespace leastcost::test
