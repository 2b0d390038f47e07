// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <leastcost/framework/base/ability.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include <leastcost/problems/shapes/capsule_obstacle.hpp>
#include <leastcost/problems/shapes/cone.hpp>
#include <leastcost/problems/shapes/cylinder.hpp>
#include <leastcost/problems/shapes/half_space.hpp>
#include <leastcost/problems/shapes/point_obstacle.hpp>
#include "problems/obstacles/triangle_foot.hpp"
#include "tests/support/catch.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Vector = Eigen::VectorXd;
using Triangle = std::array<Vector3d, 3>;
using Sizes = std::array<double, 3>;

/// The nearest point of a shape in its own frame: what the library is judged by, written anew here.
using Foot = std::function<Vector3d(const Vector3d&)>;

Vector3d on_axis_and_off(double off, double z, const Vector3d& x) {
  const double from_axis = std::hypot(x[0], x[1]);
  return from_axis > 0 ? Vector3d(off * x[0] / from_axis, off * x[1] / from_axis, z) : Vector3d(off, 0, z);
}

Foot box_foot(const Sizes& s) {
  return [s](const Vector3d& x) -> Vector3d {
    const Vector3d half(s[0] / 2, s[1] / 2, s[2] / 2);
    return x.cwiseMax(-half).cwiseMin(half);
  };
}

Foot cylinder_foot(double radius, double height) {
  return [=](const Vector3d& x) {
    return on_axis_and_off(std::min(radius, std::hypot(x[0], x[1])), std::clamp(x[2], -height / 2, height / 2), x);
  };
}

/// Of the quadrilateral through the axis, as two triangles.
Foot cone_foot(double radius, double top, double height) {
  return [=](const Vector3d& x) {
    const Vector3d place(std::hypot(x[0], x[1]), x[2], 0);
    const Vector3d a(0, -height / 2, 0), b(radius, -height / 2, 0), c(top, height / 2, 0), d(0, height / 2, 0);
    const Vector3d first = foot_on_triangle({a, b, c}, place), second = foot_on_triangle({a, c, d}, place);
    const Vector3d best = (first - place).norm() < (second - place).norm() ? first : second;
    return on_axis_and_off(best[0], best[1], x);
  };
}

/// By alternating projections, with samples first: as near as a segment comes to a convex set, from above.
double sampled_distance(const Foot& foot, const Vector3d& a, const Vector3d& b) {
  constexpr int kSamples = 60, kSteps = 4000;
  double least = 1e300, at = 0;
  const auto distance = [&](double t) {
    const Vector3d x = a + t * (b - a);
    return (x - foot(x)).norm();
  };
  for (int i = 0; i <= kSamples; ++i) {
    const double d = distance(static_cast<double>(i) / kSamples);
    if (d < least) least = d, at = static_cast<double>(i) / kSamples;
  }
  double low = std::max(0.0, at - 1.0 / kSamples), high = std::min(1.0, at + 1.0 / kSamples);
  for (int k = 0; k < kSteps && high - low > 1e-15; ++k) {  // thirds: the distance is convex
    const double first = low + (high - low) / 3, second = high - (high - low) / 3;
    (distance(first) < distance(second) ? high : low) = distance(first) < distance(second) ? second : first;
  }
  return std::min(least, distance((low + high) / 2));
}

struct Random {
  std::mt19937 engine{20261127};
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  Vector3d point(double spread) { return {number(-spread, spread), number(-spread, spread), number(-spread, spread)}; }
  Eigen::Isometry3d pose(double spread) {
    Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
    const Vector3d axis = point(1).normalized();
    out.linear() = Eigen::AngleAxisd(number(-3, 3), axis).toRotationMatrix();
    out.translation() = point(spread);
    return out;
  }
};

struct Drawn {
  std::string name;
  Foot foot;
  std::function<std::shared_ptr<const Obstacle>(const ShapePose&)> make;
};

Drawn shape(int kind, const Sizes& s) {
  if (kind == 0)
    return {"box", box_foot(s),
            [s](const ShapePose& pose) { return make_box({.size = Vector3d(s[0], s[1], s[2]), .pose = pose}); }};
  if (kind == 1)
    return {"cylinder", cylinder_foot(s[0], s[1]), [s](const ShapePose& pose) {
              return make_cylinder({s[0], s[1], pose});
            }};
  const double top = kind == 2 ? 0 : s[2];
  return {"cone", cone_foot(s[0], top, s[1]), [s, top](const ShapePose& pose) {
            return make_cone({s[0], s[1], top, pose});
          }};
}

/// A segment of one of the kinds that go wrong: any, along and across the axis, ending on the surface, touching it, a
/// point.
std::array<Vector3d, 2> segment(Random& random, int kind, const Drawn& shape, double spread) {
  Vector3d a = random.point(spread), b = random.point(spread);
  if (kind == 1) b = a + Vector3d(0, 0, random.number(-spread, spread));
  if (kind == 2) b[2] = a[2];
  if (kind == 3) b = shape.foot(b);
  if (kind == 4) {  // in the plane that the shape lies behind
    const Vector3d foot = shape.foot(a), normal = a - foot;
    if (normal.norm() > 0) {
      const Vector3d along = normal.normalized().cross(random.point(1));
      a = foot - random.number(0, spread) * along;
      b = foot + random.number(0, spread) * along;
    }
  }
  if (kind == 5) b = a;
  return {a, b};
}

}  // namespace

TEST_CASE("posed obstacles: boxes, cylinders and cones in random poses against thirds of convex distances") {
  Random random;
  double largest_short = 0;
  for (int k = 0; k < 3000; ++k) {
    const double unit = std::array{1.0, 1.0, 1e-3, 300.0}[static_cast<std::size_t>(k % 4)];
    const Sizes sizes = {unit * random.number(0.05, 1), unit * random.number(0.05, 1),
                         unit * random.number(0.05, k % 5 == 0 ? 5 : 1)};
    const Drawn tried = shape(k % 4 == 3 ? (k / 4) % 4 : k % 4, sizes);
    const Eigen::Isometry3d pose = k % 7 == 0 ? Eigen::Isometry3d::Identity() : random.pose(2 * unit);
    const auto obstacle = tried.make(shape_pose(pose));
    const auto [a, b] = segment(random, k % 6, tried, 2 * unit);
    const Vector from = pose * a, to = pose * b;
    const double size = std::max(from.cwiseAbs().maxCoeff(), to.cwiseAbs().maxCoeff()) + 3 * unit;
    CAPTURE(k, tried.name, sizes[0], sizes[1], sizes[2], from.transpose(), to.transpose());
    double t = -1;
    const double found = obstacle->distance_of_segment(from, to, t), truth = sampled_distance(tried.foot, a, b);
    CHECK(found <= truth + 1e-14 * size);  // never more
    CHECK(found >= truth - 1e-11 * size);
    largest_short = std::max(largest_short, (truth - found) / size);
    REQUIRE((t >= 0 && t <= 1));
    Vector away(3);
    const Vector at = from + t * (to - from);
    CHECK(std::max(0.0, obstacle->distance(at, away)) <= found + 1e-12 * size);

    const double here = obstacle->distance(from, away), by_foot = (a - tried.foot(a)).norm();
    CHECK(away.norm() == Approx(1));
    CHECK(std::max(0.0, here) == Approx(by_foot).margin(1e-14 * size));
    if (by_foot > 1e-6 * size) CHECK((pose.linear() * (a - tried.foot(a)) / by_foot - away).norm() < 1e-8);
    if (here < 0) {  // the way out is as long as it says
      Vector there(3);
      CHECK(std::abs(obstacle->distance(from - here * away, there)) < 1e-12 * size);
    }
    const Obstacle::Box box = obstacle->core_bounds();
    CHECK(box.exteriorDistance(Vector(pose * tried.foot(a))) < 1e-12 * size);
  }
  CHECK(largest_short < 1e-11);
}

TEST_CASE("posed obstacles: triangles") {
  Random random;
  constexpr int kSteps = 40;
  for (int k = 0; k < 300; ++k) {
    const Sizes sizes = {random.number(0.1, 1), random.number(0.1, 1), random.number(0.1, 1)};
    const Drawn tried = shape(k % 4, sizes);
    const Eigen::Isometry3d pose = random.pose(1);
    const auto obstacle = tried.make(shape_pose(pose));
    Triangle own = {random.point(2), random.point(2), random.point(2)}, placed;
    if (k % 10 == 8) own[2] = own[1];
    if (k % 10 == 9) own[1] = own[2] = own[0];
    for (std::size_t i = 0; i < 3; ++i) placed[i] = pose * own[i];
    const auto* meets = find_ability<MeetsTriangles>(*obstacle);
    REQUIRE(meets != nullptr);
    Vector3d nearest;
    const double found = meets->distance_of_triangle(placed, nearest);
    double sampled = 10, longest = 0;
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; i + j <= kSteps; ++j) {
        const Vector3d x = own[0] + (own[1] - own[0]) * i / kSteps + (own[2] - own[0]) * j / kSteps;
        sampled = std::min(sampled, (x - tried.foot(x)).norm());
      }
    for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, (own[i] - own[(i + 1) % 3]).norm());
    CAPTURE(k, tried.name, found, sampled);
    CHECK(found <= sampled + 1e-13);
    CHECK(found >= sampled - 2 * longest / kSteps - 1e-12);
    CHECK((foot_on_triangle(placed, nearest) - nearest).norm() < 1e-12);
    Vector away(3);
    CHECK(std::max(0.0, obstacle->distance(Vector(nearest), away)) <= found + 1e-7);
  }
}

TEST_CASE("posed obstacles: a segment through a shape meets it first where it comes in") {
  const auto cylinder = make_cylinder({0.5, 2, {.position = Vector3d(1, 2, 3), .rpy = Vector3d(0, std::acos(0.0), 0)}});
  double t = -1;  // lies along x, from 0 to 2
  CHECK(cylinder->distance_of_segment(Vector3d(-1, 2, 3), Vector3d(4, 2, 3), t) == 0);
  CHECK(t == Approx(0.2));
  CHECK(cylinder->distance_of_segment(Vector3d(1, 0, 3), Vector3d(1, 4, 3), t) == 0);
  CHECK(t == Approx(1.5 / 4));
  CHECK(cylinder->distance_of_segment(Vector3d(1, 2, 3), Vector3d(9, 9, 9), t) == 0);
  CHECK(t == 0);
  CHECK(cylinder->distance_of_segment(Vector3d(-1, 3, 3), Vector3d(4, 3, 3), t) == Approx(0.5));
}

TEST_CASE("posed obstacles: a turned box of the plane is its polygon") {
  Random random;
  for (int k = 0; k < 300; ++k) {
    const double angle = random.number(-4, 4);
    const Vector2d size(random.number(0.1, 2), random.number(0.1, 2)), at(random.number(-1, 1), random.number(-1, 1));
    const auto box = make_box({.size = size, .pose = {.position = at, .angle = angle}});
    const auto polygon = make_polygon({box->corners().transpose()});
    const Vector a = random.point(3).head(2), b = random.point(3).head(2);
    CAPTURE(k, angle, size.transpose(), a.transpose(), b.transpose());
    Vector away(2), other(2);
    CHECK(box->distance(a, away) == Approx(polygon->distance(a, other)).margin(1e-13));
    CHECK((away - other).norm() < 1e-7);
    double t = 0, u = 0;
    CHECK(box->distance_of_segment(a, b, t) == Approx(polygon->distance_of_segment(a, b, u)).margin(1e-13));
    CHECK(box->core_bounds().isApprox(polygon->core_bounds(), 1e-12));
    CHECK(box->convex());
  }
  const auto moved = make_box({.lower = Vector2d(0, 0), .upper = Vector2d(1, 2), .pose = {.position = Vector2d(5, 5)}});
  CHECK(moved->name() == "the box from (5, 5) to (6, 7)");
}

TEST_CASE("capsules and half-spaces against their formulas") {
  Random random;
  for (int k = 0; k < 500; ++k) {
    const Vector3d from = random.point(1), to = k % 5 == 0 ? from : random.point(1);
    const auto capsule = make_capsule({from, to, 0.2});
    const Vector3d a = random.point(2), b = random.point(2);
    const Foot foot = [&](const Vector3d& x) { return foot_on_triangle({from, to, to}, x); };
    double t = 0;
    CAPTURE(k);
    CHECK(capsule->distance_of_segment(a, b, t) == Approx(sampled_distance(foot, a, b)).margin(1e-9));
    Vector away(3);
    CHECK(capsule->distance(a, away) == Approx((a - foot(a)).norm()));
    const Vector3d normal = random.point(2);
    const double offset = random.number(-1, 1);
    const auto behind = make_half_space({normal, offset});
    CHECK(behind->distance(a, away) == Approx(normal.normalized().dot(a) - offset).margin(1e-13));
    const double lowest = std::min(normal.normalized().dot(a), normal.normalized().dot(b)) - offset;
    CHECK(behind->distance_of_segment(a, b, t) == Approx(std::max(0.0, lowest)).margin(1e-13));
    Vector there(3);
    if (lowest > 0) CHECK(behind->distance(a + t * (b - a), there) == Approx(lowest));
    if (lowest <= 0) CHECK(behind->distance(a + t * (b - a), there) <= 1e-13);
  }
}

TEST_CASE("half-spaces: walls among other obstacles, near and far") {
  const ObstacleWalls walls(3,
                            {make_half_space({Vector3d(0, 0, 2), -1}),
                             make_box({.size = Vector3d(1, 1, 1), .pose = {.position = Vector3d(0, 0, 2)}})},
                            0.1);
  std::vector<Wall> found;
  walls.near(Vector3d(50, -70, -0.5), 1, found);
  REQUIRE(found.size() == 1);
  CHECK(found[0].gap == Approx(0.4));
  CHECK(found[0].slope.isApprox(Vector(Vector3d(0, 0, 1))));
  const MoveClearance through = walls.clearance(Vector3d(3, 3, 1), Vector3d(3, 3, -4));
  CHECK(through.obstacle == 0);
  CHECK(through.upper == Approx(-3.1));  // as deep as its end
  CHECK(std::isfinite(walls.size()));
  CHECK(walls.clearance(Vector3d(-3, 0, 2), Vector3d(3, 0, 2)).obstacle == 1);
  const ObstacleWalls plane(2, {make_half_space({Vector2d(0, 1), 0})}, 0.1);
  CHECK(find_ability<HasRounds>(plane) == nullptr);
}

TEST_CASE("point obstacles: the nearest of all points") {
  Random random;
  std::vector<Vector3d> points;
  for (int i = 0; i < 700; ++i) points.push_back(random.point(1));
  const auto cloud = make_point_obstacle(points, 0.05, "the cloud");
  const auto* meets = find_ability<MeetsTriangles>(*cloud);
  for (int k = 0; k < 200; ++k) {
    const Vector3d a = random.point(2), b = k % 9 == 0 ? a : random.point(2), c = random.point(2);
    double by_place = 10, by_segment = 10, by_triangle = 10, t = 0;
    for (const Vector3d& p : points) {
      by_place = std::min(by_place, (p - a).norm());
      by_segment = std::min(by_segment, (p - foot_on_triangle({a, b, b}, p)).norm());
      by_triangle = std::min(by_triangle, (p - foot_on_triangle({a, b, c}, p)).norm());
    }
    Vector away(3);
    Vector3d nearest;
    CHECK(cloud->distance(a, away) == Approx(by_place));
    CHECK(cloud->distance_of_segment(a, b, t) == Approx(by_segment));
    CHECK(cloud->distance(Vector(a + t * (b - a)), away) == Approx(by_segment));
    CHECK(meets->distance_of_triangle({a, b, c}, nearest) == Approx(by_triangle).margin(1e-14));
  }
}

TEST_CASE("posed obstacles: faults name their option") {
  const auto key_of = [](const std::function<void()>& make) {
    try {
      make();
    } catch (const OptionError& e) {
      return e.key() + ": " + e.reason();
    }
    return std::string("none");
  };
  using Catch::StartsWith;
  const Vector3d one(1, 1, 1);
  const double nan = std::nan("");
  CHECK_THAT(key_of([] { make_cylinder({0.1, 0, {}}); }), StartsWith("height: must be a number greater than 0"));
  CHECK_THAT(key_of([&] { make_cylinder({nan, 1, {}}); }), StartsWith("radius"));
  CHECK_THAT(key_of([] { make_cone({1, 1, -1, {}}); }), StartsWith("top_radius"));
  CHECK_THAT(key_of([] { make_half_space({Vector3d::Zero(), 0}); }), StartsWith("normal"));
  CHECK_THAT(key_of([] {
               make_capsule({Vector3d::Zero(), Vector2d::Zero(), 1});
             }),
             StartsWith("to: must have as many"));
  CHECK_THAT(key_of([] { make_capsule({Vector::Zero(4), Vector::Zero(4), 1}); }), StartsWith("from"));
  CHECK_THAT(key_of([] { make_box({}); }), StartsWith("lower: is missing"));
  CHECK_THAT(key_of([&] { make_box({.lower = one, .upper = one, .size = one}); }), StartsWith("size"));
  CHECK_THAT(key_of([&] { make_box({.size = -one}); }), StartsWith("size"));
  CHECK_THAT(key_of([&] { make_box({.size = one, .pose = {.position = Vector2d(1, 2)}}); }),
             StartsWith("pose.position: must be 3 finite numbers"));
  CHECK_THAT(key_of([&] { make_box({.size = one, .pose = {.rpy = one, .rotation = one}}); }),
             StartsWith("pose: must have at most one"));
  CHECK_THAT(key_of([&] { make_box({.size = one, .pose = {.angle = 1.0}}); }), StartsWith("pose.angle"));
  CHECK_THAT(key_of([&] { make_box({.size = Vector2d(1, 1), .pose = {.rpy = one}}); }),
             StartsWith("pose: in the plane"));
  CHECK_THAT(key_of([&] { make_box({.size = one, .pose = {.quaternion = Vector::Zero(4)}}); }),
             StartsWith("pose.quaternion: must not be zero"));
  CHECK_THAT(key_of([] { make_box({.size = Vector::Ones(7), .pose = {.position = Vector::Ones(7)}}); }),
             StartsWith("pose: is for boxes in the plane"));
}

TEST_CASE("posed obstacles: the three ways to write a rotation agree") {
  const double right = std::acos(0.0);
  ShapePose rpy{.position = Vector3d(1, 2, 3), .rpy = Vector3d(0.3, -0.4, right)};
  const Eigen::Matrix3d turn = pose_of(rpy, 3).linear();
  const Eigen::Quaterniond q(turn);
  const Eigen::AngleAxisd axis(turn);
  CHECK(pose_of({.quaternion = 7 * Eigen::Vector4d(q.w(), q.x(), q.y(), q.z())}, 3).linear().isApprox(turn, 1e-14));
  CHECK(pose_of({.rotation = axis.angle() * axis.axis()}, 3).linear().isApprox(turn, 1e-14));
  CHECK(pose_of(shape_pose(pose_of(rpy, 3)), 3).isApprox(pose_of(rpy, 3), 1e-14));
  // Roll about x first: y goes to z under a quarter turn, then yaw leaves z alone.
  const Eigen::Isometry3d both = pose_of({.rpy = Vector3d(right, 0, right)}, 3);
  CHECK((both * Vector3d(0, 1, 0)).isApprox(Vector3d(0, 0, 1), 1e-14));
}

}  // namespace leastcost
