// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Products of domains, angles and poses, and the cost that weighs their factors: contracts, names of one point, and
// what is no product.
#include <cmath>
#include <limits>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/result/other_images.hpp>
#include <leastcost/problems/costs/weighted_length.hpp>
#include <leastcost/problems/manifolds/angle.hpp>
#include <leastcost/problems/manifolds/constraint.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/manifolds/pose.hpp>
#include <leastcost/problems/manifolds/product.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include "framework/check/observed_order.hpp"
#include "tests/contracts/cost_contract.hpp"
#include "tests/contracts/manifold_contract.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {
namespace {

using Domain = std::shared_ptr<const ConstraintManifold>;

std::shared_ptr<const ProductManifold> product_of(ProductManifold::Factors factors) {
  return std::make_shared<const ProductManifold>(std::move(factors));
}
Domain rotation_quaternions() {
  ConstraintManifoldOptions options;
  options.set = constraint::Rotations{};
  return make_constraint_manifold(options);
}
Domain angle_between(std::optional<double> lower = {}, std::optional<double> upper = {}) {
  return std::make_shared<const AngleManifold>(AngleOptions{lower, upper});
}
/// A sphere around the origin, the part of it above z = 0, or all.
Domain ball_surface(double radius, bool upper_half = false) {
  ImplicitManifoldOptions options{.surface = leastcost::implicit::Sphere{radius}};
  if (upper_half) options.box.lower = Eigen::Vector3d(-10, -10, 0);
  return make_implicit_manifold(options);
}

/// Within 3 % of the last coordinates' unit quaternion, and anywhere in the first.
ManifoldCase spatial_case(const PoseOptions& options) {
  const auto near = [](Random& random) -> Eigen::VectorXd {
    Eigen::VectorXd x = random.vector(7);
    x.tail(4) *= (1 + random.uniform(-0.03, 0.03)) / x.tail(4).norm();
    return x;
  };
  ManifoldCase c{.manifold = make_spatial_poses(options), .near = near, .size = 3, .step = 0.5};
  Eigen::VectorXd corner(7);
  corner << 1, 1, -1, 1, 0, 0, 0;  // of the box that the test gives
  for (const double off : {0.0, 1e-8, -1e-8}) c.special.emplace_back(corner + off * Eigen::VectorXd::Ones(7));
  return c;
}

std::string refused_product(const ProductManifold::Factors& factors, const std::vector<std::string>& names = {}) {
  try {
    const ProductManifold product(factors, names);
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string refused_weights(const ConstraintManifold& domain, const Eigen::VectorXd& weights) {
  try {
    make_weighted_length({weights}, domain);
    return "accepted";
  } catch (const OptionError& error) {
    return error.key() + ": " + error.reason();
  }
}

std::string refused_point(const ConstraintManifold& domain, const Eigen::VectorXd& x) {
  try {
    project_end(domain, x);
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

Eigen::VectorXd pose(double x, double y, double angle) { return Eigen::Vector3d(x, y, angle); }
Eigen::VectorXd pose(const Eigen::Vector3d& place, const Eigen::Vector4d& q) {
  Eigen::VectorXd all(7);
  all << place, q;
  return all;
}

}  // namespace

TEST_CASE("manifold contract: se2", "[contract]") {
  const auto near = [](Random& random) -> Eigen::VectorXd { return 2 * random.vector(3); };
  check_manifold_contract({.manifold = make_planar_poses(), .near = near, .size = 4});
  const PoseOptions boxed{.box = {Eigen::Vector2d(-1, -1), Eigen::Vector2d(2, 1)}};
  ManifoldCase c{.manifold = make_planar_poses(boxed), .near = near, .size = 4};
  for (const double off : {0.0, 1e-8, -1e-8}) c.special.emplace_back(pose(2 + off, 1 - off, 7));
  check_manifold_contract(c);
}

TEST_CASE("manifold contract: se3", "[contract]") {
  check_manifold_contract(spatial_case({}));
  check_manifold_contract(spatial_case({.box = {Eigen::Vector3d(-1, -2, -1), Eigen::Vector3d(1, 1, 2)}}));
}

TEST_CASE("manifold contract: product", "[contract]") {
  const auto sphere_and_more = [](Random& random) -> Eigen::VectorXd {  // on a sphere of radius 2, angles, a quaternion
    Eigen::VectorXd x = random.vector(9);
    x.head(3) *= 2 * (1 + random.uniform(-0.02, 0.02)) / x.head(3).norm();
    x[2] = std::abs(x[2]);
    x.segment(4, 4) *= (1 + random.uniform(-0.02, 0.02)) / x.segment(4, 4).norm();
    return x;
  };
  check_manifold_contract({.manifold = product_of({ball_surface(2), angle_between(), rotation_quaternions(), space(1)}),
                           .near = sphere_and_more,
                           .size = 4,
                           .step = 0.5});
  ManifoldCase bounded{.manifold = product_of({ball_surface(2, true), angle_between(-0.5, 1), rotation_quaternions(),
                                               box(Eigen::VectorXd::Constant(1, -1), Eigen::VectorXd::Constant(1, 1))}),
                       .near = sphere_and_more,
                       .size = 4,
                       .step = 0.5};
  Eigen::VectorXd edge(9);  // the rim of the half sphere and the limit of the angle at once
  edge << 2, 0, 0, 1, 0, 1, 0, 0, -1;
  bounded.special = {edge};
  check_manifold_contract(bounded);
  Points normals(9, 9);
  REQUIRE(find_ability<HasBounds>(*bounded.manifold)->active_bounds({edge, {}, true}, 0, normals) == 3);
  Points expected = Points::Zero(9, 3);
  expected(2, 0) = expected(8, 2) = -1;
  expected(3, 1) = 1;
  CHECK((normals.leftCols(3) - expected).norm() <= 1e-12);
  // A product in a product is the same domain.
  const auto nested = product_of(
      {product_of({ball_surface(2), angle_between()}), product_of({product_of({rotation_quaternions()}), space(1)})});
  check_manifold_contract({.manifold = nested, .near = sphere_and_more, .size = 4, .step = 0.5});
  CHECK(nested->blocks().size() == 4);
  CHECK(nested->blocks()[2].first == 4);
  CHECK(nested->blocks()[2].unit == 2);
}

TEST_CASE("product: the dimensions, the shape and the box are those of the factors", "[contract]") {
  const auto poses = make_planar_poses({.box = {Eigen::Vector2d(-1, -2), Eigen::Vector2d(3, 4)}});
  CHECK(poses->shape() == Shape::flat);
  CHECK(poses->box_lower().head(2) == Eigen::Vector2d(-1, -2));
  CHECK(poses->box_upper()[2] == std::numeric_limits<double>::infinity());
  CHECK(make_spatial_poses()->shape() == Shape::smooth);
  CHECK(make_spatial_poses()->dimensions().coordinate == 7);
  CHECK(make_spatial_poses()->dimensions().tangent == 6);
  using Names = std::vector<std::string>;
  CHECK(poses->coordinate_names() == Names{"x", "y", "angle"});
  CHECK(make_spatial_poses()->coordinate_names().back() == "qz");
  CHECK(product_of({space(2), angle_between()})->coordinate_names() == Names{"x", "y", "z"});
  CHECK(product_of({space(2), rotation_quaternions()})->coordinate_names()[5] == "x5");
  CHECK(ProductManifold({space(2), angle_between()}, {"a", "b", "turn"}).coordinate_names()[2] == "turn");
}

TEST_CASE("product: distances off several factors add up as squares, column by column", "[contract]") {
  const auto poses = make_spatial_poses({.box = {Eigen::Vector3d::Zero(), {}}});
  CoordinatePath path{Points::Zero(7, 3), {}, false};
  path.u.row(3).setOnes();
  path.u(0, 0) = -4;   // off the box alone
  path.u(3, 1) = 4.5;  // off the rotations alone
  path.u(1, 2) = -3, path.u(3, 2) = 5;
  CHECK(poses->residual(path) == Approx(5));
  CHECK(poses->project(path).moved == Approx(5));
  CHECK(poses->residual(path) == 0);
  CoordinatePath lost{Points::Zero(7, 2), {}, true};  // a quaternion that is none: the whole column is left alone
  lost.u(3, 1) = 1;
  lost.u(0, 0) = lost.u(0, 1) = -1;
  const Projection projection = poses->project(lost);
  CHECK(projection.failed == std::vector<Index>{0});
  CHECK(lost.u(0, 0) == -1);
  CHECK(lost.u(0, 1) == 0);
}

TEST_CASE("product: beyond its bounds it goes on, to second order", "[contract]") {
  const auto bounded = make_spatial_poses({.box = {Eigen::Vector3d::Zero(), {}}});
  const auto whole = make_spatial_poses();
  Random random;
  for (int repeat = 0; repeat < 10; ++repeat) {
    CoordinatePath on{pose(Eigen::Vector3d(0, 1, 0), random.vector(4).normalized()), {}, true}, to, nearest;
    Points basis;
    bounded->tangent_bases(on, basis);
    Points step = basis * random.vector(6);
    step(0, 0) = -1;  // through the first bound, along the third
    step(2, 0) = 0;
    const auto error = [&](double h) {
      bounded->retract_beyond(on, h * step, to);
      nearest = on;
      nearest.u += h * step;
      whole->project(nearest);
      return (to.u - nearest.u).norm();
    };
    CHECK(observed_order(error, 0.1, 1e-14) >= 3 - 0.3);
    bounded->retract_beyond(on, 0.5 * step, to);
    CHECK(to.u(0, 0) == -0.5);
    CHECK(to.u(2, 0) == 0);
    bounded->retract(on, 0.5 * step, to);
    CHECK(to.u(0, 0) == 0);
  }
}

TEST_CASE("angle: images are whole turns, nearest first, within the limits", "[contract]") {
  const AngleManifold free;
  const auto at = [](double u) { return Eigen::VectorXd::Constant(1, u); };
  const std::vector<PointImage> images = free.images(at(-3), at(3), 12);
  REQUIRE(images.size() == 2);
  CHECK(images[0].u[0] == Approx(2 * kPi - 3));
  CHECK(images[0].where == "winding (1)");
  CHECK(images[1].where == "winding (2)");
  CHECK(free.images(at(-3), at(3), 1).size() == 1);
  CHECK(free.images(at(-3), at(3), 0).empty());
  CHECK(free.images(at(-3 + 200 * kPi), at(3), 12)[0].u[0] == Approx(2 * kPi - 3));  // however far off
  CHECK(free.images(at(1e300), at(0), 12).empty());
  CHECK_FALSE(free.states_way(at(-3), at(3)));
  CHECK(free.states_way(at(3 + 2 * kPi), at(3)));
  const AngleManifold joint({-3.1, 3.1});
  CHECK(joint.images(at(-3), at(3), 12).empty());
  const AngleManifold wrist({-6, 6});
  REQUIRE(wrist.images(at(-3), at(3), 12).size() == 1);
  CHECK(wrist.images(at(-3), at(3), 12)[0].u[0] == Approx(2 * kPi - 3));
  CHECK_THROWS_AS(AngleManifold({2, 1}), OptionError);
  CHECK_THROWS_AS(AngleManifold({std::nan(""), {}}), OptionError);
}

TEST_CASE("product: images are those of the factors in all combinations, nearest first", "[contract]") {
  const auto domain = product_of({angle_between(), space(2), rotation_quaternions(), angle_between()});
  Random random;
  for (int repeat = 0; repeat < 20; ++repeat) {
    Eigen::VectorXd x = 3 * random.vector(8), reference = 3 * random.vector(8);
    x.segment(3, 4).normalize();
    reference.segment(3, 4).normalize();
    std::vector<Eigen::VectorXd> all;  // every combination but x itself
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (const double sign : {1.0, -1.0}) {
          Eigen::VectorXd other = x;
          other[0] = reference[0] + std::remainder(x[0] - reference[0], 2 * kPi) + 2 * kPi * i;
          other[7] = reference[7] + std::remainder(x[7] - reference[7], 2 * kPi) + 2 * kPi * j;
          other.segment(3, 4) *= sign;
          if ((other - x).norm() > 1e-9) all.push_back(other);
        }
    std::sort(all.begin(), all.end(),
              [&](const auto& a, const auto& b) { return (a - reference).norm() < (b - reference).norm(); });
    const std::vector<PointImage> images = domain->images(x, reference, 12);
    REQUIRE(images.size() == 12);
    for (std::size_t k = 0; k < images.size(); ++k) {
      CHECK((images[k].u - reference).norm() == Approx((all[k] - reference).norm()).epsilon(1e-12));
      CHECK_FALSE(images[k].where.empty());
      CHECK(std::any_of(all.begin(), all.end(), [&](const auto& u) { return (u - images[k].u).norm() < 1e-9; }));
    }
  }
  CHECK(
      product_of({space(2), ball_surface(1)})->images(Eigen::VectorXd::Ones(5), Eigen::VectorXd::Ones(5), 12).empty());
}

TEST_CASE("poses: samples are of use within a turn, unit quaternions and the box", "[contract]") {
  const SampleBox plane =
      make_planar_poses({.box = {Eigen::Vector2d(-1, -2), {}}})->sample_box(pose(0, 0, 1), pose(1, 1, -2));
  CHECK(plane.lower == pose(-1, -2, -2 - kPi));
  CHECK(plane.upper[2] == 1 + kPi);
  CHECK(plane.upper[0] == std::numeric_limits<double>::infinity());
  const auto wrist = angle_between(-3, 4);
  const SampleBox limited =
      find_ability<HasSampleBox>(*wrist)->sample_box(Eigen::VectorXd::Constant(1, 1), Eigen::VectorXd::Constant(1, 2));
  CHECK(limited.lower[0] == 1 - kPi);
  CHECK(limited.upper[0] == 4);
  const Eigen::VectorXd a = pose(Eigen::Vector3d(1, 2, 3), Eigen::Vector4d(1, 0, 0, 0));
  const SampleBox room = make_spatial_poses()->sample_box(a, a);
  CHECK(room.lower.tail(4) == Eigen::Vector4d::Constant(-1));
  CHECK(room.upper.tail(4) == Eigen::Vector4d::Constant(1));
}

TEST_CASE("poses: ends that are one pose by other coordinates are recognised", "[contract]") {
  const auto one = [](const Domain& domain, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    const auto cost = make_euclidean_cost(domain->dimensions().ambient);
    return ends_are_one_point(between(domain, cost, a, b));
  };
  const Domain plane = make_planar_poses(), room = make_spatial_poses();
  CHECK(one(plane, pose(1, 2, 3), pose(1, 2, 3 + 2 * kPi)));
  CHECK(one(plane, pose(1, 2, 3), pose(1, 2, 3 - 8 * kPi)));
  CHECK_FALSE(one(plane, pose(1, 2, 3), pose(1, 2.001, 3 + 2 * kPi)));
  CHECK_FALSE(one(plane, pose(1, 2, 3), pose(1, 2, 3 + kPi)));
  const Eigen::Vector4d q(0.5, 0.5, -0.5, 0.5);
  CHECK(one(room, pose(Eigen::Vector3d(1, 2, 3), q), pose(Eigen::Vector3d(1, 2, 3), -q)));
  CHECK_FALSE(one(room, pose(Eigen::Vector3d(1, 2, 3), q), pose(Eigen::Vector3d(1, 2, 3.001), -q)));
}

TEST_CASE("cost contract: weighted_length", "[contract]") {
  const auto weighted_case = [](const Domain& domain, const Eigen::VectorXd& weights) {
    const int d = domain->dimensions().ambient;
    return CostCase{.cost = make_weighted_length({weights}, *domain),
                    .draw = [d](Random& random) { return random.vector(d); },
                    .linear_residual = true};
  };
  check_cost_contract(weighted_case(space(2), Eigen::Vector2d(1, 3)));
  check_cost_contract(weighted_case(make_planar_poses(), Eigen::Vector2d(1, 0.5)));
  check_cost_contract(weighted_case(make_spatial_poses(), Eigen::Vector2d(1, 0.5)));
}

TEST_CASE("weighted_length: weights per factor and per coordinate", "[contract]") {
  const Eigen::Vector4d q(1, 0, 0, 0);
  const Eigen::VectorXd a = pose(Eigen::Vector3d(0, 0, 0), q), b = pose(Eigen::Vector3d(3, 4, 12), q);
  const auto room = make_spatial_poses();
  CHECK(move_cost(*make_weighted_length({Eigen::Vector2d(2, 7)}, *room), a, b) == Approx(26));
  // A turn by phi is 4 sin(phi / 4) of its weight as one move.
  const double phi = 0.7;
  const Eigen::VectorXd turned = pose(Eigen::Vector3d(0, 0, 0), {std::cos(phi / 2), 0, std::sin(phi / 2), 0});
  CHECK(move_cost(*make_weighted_length({Eigen::Vector2d(2, 7)}, *room), a, turned) ==
        Approx(7 * 4 * std::sin(phi / 4)));
  CHECK(move_cost(*make_weighted_length({Eigen::VectorXd::Constant(7, 3)}, *room), a, turned) ==
        Approx(3 * 2 * std::sin(phi / 4)));  // chords
  CHECK(move_cost(*make_weighted_length({Eigen::VectorXd::Constant(1, 7)}, *rotation_quaternions()), q,
                  turned.tail(4)) == Approx(7 * 4 * std::sin(phi / 4)));
  CHECK(move_cost(*make_weighted_length({Eigen::Vector3d(1, 2, 3)}, *space(3)), Eigen::Vector3d::Zero(),
                  Eigen::Vector3d(2, 1, 1)) == Approx(std::sqrt(4 + 4 + 9)));
  Points metric = find_ability<HasConstantMetric>(*make_weighted_length({Eigen::Vector2d(2, 7)}, *room))->metric();
  CHECK(metric.diagonal()[0] == 4);
  CHECK(metric.diagonal()[6] == 14 * 14);
  metric.diagonal().setZero();
  CHECK(metric.norm() == 0);
}

TEST_CASE("weighted_length: weights that do not fit are refused with what would", "[contract]") {
  using Catch::Contains;
  const auto room = make_spatial_poses();
  CHECK_THAT(refused_weights(*room, Eigen::Vector3d(1, 1, 1)),
             Contains("weights: has 3 numbers; give 2, one per factor of the domain, or 7, one per coordinate"));
  CHECK_THAT(refused_weights(*space(2), Eigen::Vector3d(1, 1, 1)), Contains("give 2, one per coordinate"));
  CHECK_THAT(refused_weights(*room, Eigen::VectorXd()), Contains("weights: missing"));
  for (const double wrong : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    CHECK_THAT(refused_weights(*room, Eigen::Vector2d(1, wrong)), Contains("number 2 must be greater than 0"));
}

TEST_CASE("product: what is no factor is refused with a reason", "[contract]") {
  using Catch::Contains;
  CHECK_THAT(refused_product({}), Contains("needs at least one factor"));
  CHECK_THAT(refused_product({space(2), nullptr}), Contains("factor 2 of the product is missing"));
  CHECK_THAT(
      refused_product({std::make_shared<MeshManifold>(TriangleMesh(sheet(2, 2,
                                                                         [](double s, double t) -> Eigen::Vector3d {
                                                                           return {s, t, 0};
                                                                         })))}),
      Contains("factor 1 of the product is made of flat pieces"));
  CHECK_THAT(refused_product({space(2), make_parametric_manifold({.surface = form<parametric::Surface>("torus")})}),
             Contains("factor 2 of the product is a chart"));
  CHECK_THAT(refused_product({std::make_shared<PointCloudManifold>(PointCloud(torus_cloud(3000, 10), {}))}),
             Contains("made from data"));
  const auto obstacles = std::make_shared<const FreeSpace>(
      space(2), FreeSpace::Obstacles{make_ball({.center = Eigen::Vector2d(0, 0), .radius = 1})}, 0);
  CHECK_THAT(refused_product({obstacles, angle_between()}), Contains("add them to the product"));
  CHECK_THAT(refused_product({space(2)}, {"a"}), Contains("has 2 coordinates, but 1 names were given"));
  CHECK_THAT(refused_product({space(2)}, {"a", "a"}), Contains("need different names, but 'a' appears twice"));
  CHECK_THAT(refused_product({space(60), space(5)}), Contains("has 65 coordinates; the limit is 64"));
}

TEST_CASE("poses: points that are none are refused with a reason", "[contract]") {
  using Catch::Contains;
  const auto room = make_spatial_poses();
  CHECK_THAT(refused_point(*room, Eigen::VectorXd::Zero(7)),
             Contains("factor 2 of the product has none") && Contains("gradients of the equations are zero"));
  CHECK_THAT(refused_point(*room, Eigen::VectorXd::Zero(6)), Contains("6 coordinates, but the domain has 7"));
  CHECK_THAT(refused_point(*room, Eigen::VectorXd::Constant(7, std::nan(""))), Contains("must be finite"));
  CHECK_THROWS_AS(make_planar_poses({.box = {Eigen::Vector3d(0, 0, 0), {}}}), OptionError);
  CHECK_THROWS_AS(make_spatial_poses({.box = {Eigen::Vector3d(0, 0, 2), Eigen::Vector3d(1, 1, 1)}}), OptionError);
}

}  // namespace leastcost::test
