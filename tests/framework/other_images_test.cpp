// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/result/other_images.hpp>

#include <climits>
#include <cmath>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/chart/target_images.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/manifolds/constraint.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;
using Eigen::Vector2d;

Problem on_surface(const parametric::Surface& surface, const Vector2d& source, const Vector2d& target) {
  return between(make_parametric_manifold({.surface = surface}), make_euclidean_cost(3), source, target);
}

/// What a search from the straight line says of other images; empty: nothing.
std::string said_of(const Problem& problem) {
  for (const std::string& note : find(problem, 31).notes)
    if (note.find("the target is also") != std::string::npos || note.find("the same point") != std::string::npos)
      return note;
  return "";
}

/// Every image of u in `images` is the same point, and none is u itself.
void check_images(const parametric::Surface& surface, const Vector2d& u, const Vector2d& near, std::size_t least) {
  const auto chart = make_parametric_manifold({.surface = surface});
  const std::vector<PointImage> images = chart->images(u, near, 100);
  CHECK(images.size() >= least);
  const Points here = positions(*chart, {u, {}, true});
  double last = 0;
  for (const PointImage& image : images) {
    CAPTURE(image.u.transpose(), image.where);
    CHECK((positions(*chart, {image.u, {}, true}) - here).norm() <= 1e-9);
    CHECK((image.u - u).norm() > 0.1);
    CHECK((image.u - near).norm() >= last);
    last = (image.u - near).norm();
  }
  CHECK(chart->images(u, near, 3).size() == 3);
}

}  // namespace

TEST_CASE("images of a point: other names of it, nearest first, however many turns off it was given", "[framework]") {
  check_images(parametric::Sphere{}, {2.5, 0.7}, {0.1, 0.4}, 9);
  check_images(parametric::Sphere{}, {2.5 + 40 * kPi, 0.7}, {0.1, 0.4}, 9);
  check_images(parametric::Torus{}, {6, 5}, {0, 0}, 8);
  check_images(parametric::KleinBottle{}, {5, 0.4}, {1, 3}, 8);
  check_images(parametric::Paraboloid{}, {3, 1}, {0, 1}, 5);
  const auto strip = make_parametric_manifold({.surface = parametric::MoebiusStrip{}});
  const std::vector<PointImage> once = strip->images(Vector2d(3, 0.2), Vector2d(0, 0), 1);
  REQUIRE(once.size() == 1);
  CHECK((once[0].u - Vector2d(3 - kPi, -0.2)).norm() <= 1e-12);
}

TEST_CASE("a path to a dearer image says which one is cheaper", "[framework]") {
  // 5.9 radians around where 0.38 lead there as well.
  CHECK_THAT(said_of(on_surface(parametric::Cylinder{}, {0.1, 0}, {6, 0.5})),
             Contains("the target is also (-0.283185, 0.5), winding (-1)") && Contains("images tried: 2"));
  CHECK_THAT(said_of(on_surface(parametric::Torus{}, {0, 3}, {0.2, 8})), Contains("the target is also (0.2, 1.71681)"));
  CHECK_THAT(said_of(on_surface(parametric::MoebiusStrip{}, {0, 0.1}, {3, -0.1})), Contains("winding (-1)"));
  CHECK_THAT(said_of(on_surface(parametric::KleinBottle{}, {0.2, 0.1}, {6.1, 0})), Contains("winding (-1, 0)"));
}

TEST_CASE("a chain that slides over a pole to the shorter way is not certified", "[framework]") {
  FindOptions options;
  options.points = 31;
  options.target_as_given = true;
  options.certificate.refine = 0;
  const Result result =
      find_path(on_surface(parametric::Sphere{}, {0, 0.2}, {5.9, 0.2}), StraightInitializer(), Newton(), options);
  CHECK(result.curve.cost < 1);
  CHECK(failed(result.certificate, "longest_segment"));
}

TEST_CASE("on a sphere a longitude is a name: the nearest one is taken, and waypoints lead round the axis",
          "[framework]") {
  const double turn = 2 * kPi, angle = turn - 5.9;
  const double length = std::acos(std::pow(std::sin(0.2), 2) + std::pow(std::cos(0.2), 2) * std::cos(angle));
  for (const double target : {5.9, 5.9 - turn, 5.9 + 3 * turn}) {
    const Result result = find(on_surface(parametric::Sphere{}, {0, 0.2}, {target, 0.2}), 31);
    CAPTURE(target);
    CHECK(result.status == Status::certified);
    CHECK(result.certificate.estimate.value == Approx(length).epsilon(1e-9));
  }
  const Problem ellipsoid = on_surface(parametric::Ellipsoid{Eigen::Vector3d(1, 1, 0.8)}, {0, 0}, {-0.3, 0});
  const WaypointsInitializer round((Points(2, 2) << 2, 4 - turn, 0, 0).finished());
  const Result loop = find(ellipsoid, 31, round);
  CHECK(loop.path.u(0, loop.path.u.cols() - 1) == Approx(turn - 0.3));
  CHECK_FALSE(find_ability<HasImages>(*ellipsoid.manifold)->states_way(Vector2d(20, 0), Vector2d(0, 0)));
}

TEST_CASE("a path to the cheapest image says nothing", "[framework]") {
  CHECK(said_of(on_surface(parametric::Cylinder{}, {0.1, 0}, {1, 0.5})) == "");
  CHECK(said_of(on_surface(parametric::Torus{}, {0, 0}, {1, 2})) == "");
  CHECK(said_of(on_surface(parametric::Sphere{}, {0, 0.2}, {1, 0.5})) == "");
  CHECK(said_of(on_surface(parametric::MoebiusStrip{}, {0, 0.1}, {1, -0.1})) == "");
}

TEST_CASE("ends that are one point: an error at a pole, a loop that is named across a seam", "[framework]") {
  CHECK_THROWS_WITH(find(on_surface(parametric::Sphere{}, {0.3, kPi / 2}, {1.2, kPi / 2}), 15),
                    Contains("are the same point"));
  CHECK_THROWS_WITH(find(on_surface(parametric::Cone{}, {0, 0}, {1, 0}), 15), Contains("are the same point"));
  const Result loop = find(on_surface(parametric::Cylinder{}, {0, 0}, {2 * kPi, 0}), 31);
  CHECK(loop.curve.cost == Approx(2 * kPi).epsilon(0.01));  // the winding that was asked for stays
  CHECK_THAT(loop.notes.back(), Contains("both ends are the same point of the domain") && Contains("winding (-1)"));
  CHECK(ends_are_one_point(on_surface(parametric::Sphere{}, {0.3, 0.4}, {0.3 + kPi, kPi - 0.4})));
  CHECK(ends_are_one_point(on_surface(parametric::Torus{}, {0.3, 0.4}, {0.3 - 6 * kPi, 0.4 + 4 * kPi})));
  CHECK(ends_are_one_point(on_surface(parametric::KleinBottle{}, {0.3, 0.4}, {0.3 + 2 * kPi, -0.4})));
  CHECK_FALSE(ends_are_one_point(on_surface(parametric::KleinBottle{}, {0.3, 0.4}, {0.3 + 2 * kPi, 0.4})));
  CHECK_FALSE(ends_are_one_point(on_surface(parametric::Sphere{}, {0.3, 0.4}, {0.3 + kPi, 0.4})));
}

TEST_CASE("a rotation whose other quaternion is nearer is named, and -q of the source is the source", "[framework]") {
  ConstraintManifoldOptions options;
  options.set = constraint::Rotations{.nearest_image = false};
  const auto rotations = make_constraint_manifold(options);
  const Eigen::Vector4d q(1, 0, 0, 0), far(-0.8, 0.6, 0, 0);
  const auto note_to = [&](const Eigen::Vector4d& target) {
    const WaypointsInitializer start(Eigen::Vector4d(0, 1, 0.1, 0).normalized());
    const Result result = find(between(rotations, make_euclidean_cost(4), q, target), 31, start);
    return result.notes.empty() ? std::string() : result.notes.back();
  };
  CHECK_THAT(note_to(far), Contains("(0.8, -0.6, -0, -0), -q"));
  CHECK(note_to(-far) == "");
  CHECK_THAT(note_to(-q), Contains("both ends are the same point of the domain"));
}

TEST_CASE("so many images that nobody waits for them are refused by their number", "[framework]") {
  const Problem torus = on_surface(parametric::Torus{}, {0, 0}, {1, 1}),
                sphere = on_surface(parametric::Sphere{}, {0, 0}, {1, 1});
  CHECK(target_images(torus, 1).size() == 9);
  CHECK(target_images(sphere, 8).size() == 17 * 3);
  CHECK(target_images(torus, 15).size() == 961);
  CHECK_THROWS_WITH(target_images(torus, 16), Contains("at most 15 turns"));
  CHECK_THROWS_AS(target_images(torus, INT_MAX), OptionError);
  CHECK_THROWS_AS(target_images(sphere, INT_MAX), OptionError);
  CHECK_THROWS_AS(target_images(sphere, -1), OptionError);
}

}  // namespace leastcost::test
