// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fstream>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/clearance_length.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/layers.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>
#include "tests/contracts/cost_contract.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/problems/sample_rasters.hpp"
#include "tests/support/data.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {
namespace {

CostCase euclidean(int d) {
  return {.cost = make_euclidean_cost(d),
          .draw = [d](Random& random) { return random.vector(d); },
          .linear_residual = true};
}

CostCase metric_tensor(int d) {
  Random random(3);
  const Eigen::MatrixXd root = random.matrix(d, d) + 2 * Eigen::MatrixXd::Identity(d, d);
  MetricTensorOptions options;
  options.matrix = root.transpose() * root;
  return {.cost = make_metric_tensor_cost(options, d),
          .draw = [d](Random& r) { return r.vector(d); },
          .linear_residual = true};
}

/// Points around (0, 2); the named metrics that are infinite somewhere are so below y = 0.
CostCase metric_field(const metric::Field& field, TensorReading reading, TensorRule rule) {
  const MetricFieldOptions options{.field = field, .reading = reading, .rule = rule};
  const bool bounded = !std::holds_alternative<metric::Formula>(field);
  CostCase c{.cost = make_metric_field_cost(options, 2),
             .draw = [](Random& random) -> Eigen::VectorXd { return Eigen::Vector2d(0, 2.5) + random.vector(2); }};
  if (bounded) c.outside = {Eigen::Vector2d(0, -1e-8), Eigen::Vector2d(3, -1)};
  return c;
}

double hill(double x, double y) { return 0.3 * x * x - 0.2 * x * y + 0.1 * std::sin(2 * y); }

std::shared_ptr<const ConstraintManifold> hill_mesh() {
  return std::make_shared<MeshManifold>(TriangleMesh(sheet(20, 20, [](double s, double t) -> Eigen::Vector3d {
    return {s - 0.5, t - 0.5, hill(s - 0.5, t - 0.5)};
  })));
}
std::shared_ptr<const ConstraintManifold> hill_cloud() {
  PointSamples samples = sheet_cloud(400, [](double s, double t) { return hill(s - 0.5, t - 0.5); });
  for (Eigen::Vector3d& p : samples.positions) p -= Eigen::Vector3d(0.5, 0.5, 0);
  return std::make_shared<PointCloudManifold>(PointCloud(samples, {}));
}

/// Tensors on the data of a hill; points over the middle of it, within a spacing.
CostCase on_data(const ConstraintManifold& domain, MetricFieldOptions options,
                 const std::filesystem::path& folder = {}) {
  return {.cost = make_metric_field_cost(options, 3, &domain, folder), .draw = [](Random& random) -> Eigen::VectorXd {
            const double x = random.uniform(-0.3, 0.3), y = random.uniform(-0.3, 0.3);
            return Eigen::Vector3d(x, y, hill(x, y) + random.uniform(-0.03, 0.03));
          }};
}

/// Level at height 0; points between 1 and 3 below it.
CostCase travel_time(TravelTimeRule rule, int d) {
  TravelTimeOptions options;
  options.rule = rule;
  options.level = 0;
  const Eigen::VectorXd up = Eigen::VectorXd::Unit(d, d - 1);
  const auto draw = [d](Random& random) {
    Eigen::VectorXd x = random.vector(d);
    x[d - 1] = -random.uniform(1, 3);
    return x;
  };
  return {.cost = make_travel_time_cost(options, d, std::nullopt),
          .draw = draw,
          .outside = {1e-8 * up, 0.5 * up, 100 * up}};
}

/// Three layers, parallel or dipping; points well inside them, moves through up to three. Where the dipping interfaces
/// have crossed there is no layer.
CostCase layers(int d, bool dipping) {
  LayersOptions options;
  options.interfaces = Eigen::Vector2d(0, 4);
  options.indices = Eigen::Vector3d(1, 1.7, 0.6);
  if (dipping) {
    options.normals = Eigen::MatrixXd::Zero(2, d);
    options.normals->rightCols(1).setOnes();
    options.normals->col(0) << 0.1, -0.1;
  }
  const Eigen::VectorXd up = Eigen::VectorXd::Unit(d, d - 1);
  CostCase c{.cost = make_layers_cost(options, d), .draw = [up](Random& random) -> Eigen::VectorXd {
               const double height = 4 * random.integer(-1, 1) + 2 + random.uniform(-0.5, 0.5);
               return height * up + 0.5 * random.vector(up.size()).cwiseMin(1).cwiseMax(-1).cwiseProduct(
                                              Eigen::VectorXd::Ones(up.size()) - up);
             }};
  if (dipping) c.outside = {-30 * Eigen::VectorXd::Unit(d, 0) + 2 * up};
  return c;
}

/// Among two balls that the points are beside, with a third out of reach.
CostCase clearance(int d) {
  Eigen::VectorXd here = Eigen::VectorXd::Zero(d), there = here, far = here;
  here[0] = -2.2, there[1] = 2.4, far[0] = 20;
  const ObstacleWalls::Obstacles balls = {make_ball({here, 0.5}), make_ball({there, 0.7}), make_ball({far, 0.5})};
  return {.cost = make_clearance_length({3, 4}, d, std::make_shared<const ObstacleWalls>(d, balls, 0.1)),
          .draw = [d](Random& random) -> Eigen::VectorXd { return 0.5 * random.vector(d); }};
}

/// From a raster with a gap and one without data at the upper right.
CostCase cost_map(CostMapInterpolation interpolation, int d) {
  const RasterGrid raster = with_gap(raster_of(16, 16, waves), 15, 15);
  CostCase c{.cost = make_cost_map(raster, interpolation, d), .draw = [d](Random& random) -> Eigen::VectorXd {
               Eigen::VectorXd x(d);
               x << random.uniform(0, 4.5), random.uniform(2.5, 4.5), random.vector(d - 2);
               return x;
             }};
  const double left = interpolation == CostMapInterpolation::cells ? -1.01 : -0.76;  // cells reach up to their sides
  for (const Eigen::Vector2d& at : {Eigen::Vector2d(left, 3), Eigen::Vector2d(3, 50), raster.place(15, 15)}) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(d);
    x.head<2>() = at;
    c.outside.push_back(x);
  }
  return c;
}

}  // namespace

TEST_CASE("cost contract: cost_map", "[contract]") {
  const int d = GENERATE(2, 3);
  check_cost_contract(cost_map(CostMapInterpolation::smooth, d));
  check_cost_contract(cost_map(CostMapInterpolation::bilinear, d));
  if (d == 2) check_cost_contract(cost_map(CostMapInterpolation::cells, d));
}

TEST_CASE("cost contract: euclidean", "[contract]") { check_cost_contract(euclidean(GENERATE(2, 3, 7))); }
TEST_CASE("cost contract: clearance", "[contract]") {
  for (const int d : {2, 3, 5}) check_cost_contract(clearance(d));
}

TEST_CASE("cost contract: metric_tensor", "[contract]") { check_cost_contract(metric_tensor(GENERATE(2, 3, 7))); }
TEST_CASE("cost contract: metric_field, named", "[contract]") {
  check_cost_contract(metric_field(form<metric::Field>(GENERATE("half_plane", "fisher_rao")), TensorReading::metric,
                                   TensorRule::midpoint));
}
TEST_CASE("cost contract: metric_field, formula", "[contract]") {
  const metric::Formula formula{.entries = {"2 + sin(x)", "0.3 * cos(y)", "1 + 0.2 * x^2"}};
  check_cost_contract(metric_field(formula, GENERATE(TensorReading::metric, TensorReading::root),
                                   GENERATE(TensorRule::midpoint, TensorRule::average)));
}
TEST_CASE("cost contract: metric_field, curvature", "[contract]") {
  MetricFieldOptions options;
  options.field = CurvatureMetricOptions{.weight = 0.3};
  options.reading = GENERATE(TensorReading::metric, TensorReading::root);
  options.rule = GENERATE(TensorRule::midpoint, TensorRule::average);
  check_cost_contract(on_data(*GENERATE(hill_mesh, hill_cloud)(), options));
}
TEST_CASE("cost contract: metric_field, file", "[contract]") {
  const ScratchDir folder;
  const auto [cloud, on] = GENERATE(std::pair(true, TensorPlace::automatic), std::pair(false, TensorPlace::automatic),
                                    std::pair(false, TensorPlace::faces));
  const auto domain = cloud ? hill_cloud() : hill_mesh();
  MetricFieldOptions options;
  options.field = TensorFileOptions{.file = "tensors.txt", .on = on};
  const SurfaceSamples samples =
      cloud ? point_samples(dynamic_cast<const HasPointCloud&>(*domain).cloud())
            : (on == TensorPlace::faces ? face_samples : vertex_samples)(dynamic_cast<const HasMesh&>(*domain).mesh());
  std::vector<std::string> rows(samples.in_file.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Eigen::Vector3d& p = samples.positions[i];
    rows[static_cast<std::size_t>(samples.in_file[i])] = std::to_string(2 + std::sin(3 * p[0])) + " " +
                                                         std::to_string(p[0] * p[1]) + " 0.1 3 " +
                                                         std::to_string(p[1]) + " 1.5";
  }
  std::ofstream out(folder / "tensors.txt");
  for (const std::string& row : rows) out << row << '\n';
  out.close();
  check_cost_contract(on_data(*domain, options, folder.path()));
}
TEST_CASE("cost contract: layers", "[contract]") {
  check_cost_contract(layers(GENERATE(2, 3, 7), GENERATE(false, true)));
}

TEST_CASE("layers: moves along, from and through interfaces", "[contract]") {
  LayersOptions options;
  options.interfaces = Eigen::Vector2d(0, 1);
  options.speeds = Eigen::Vector3d(2, 1, 4);
  const auto cost = make_layers_cost(options, 2);
  const auto move = [&](double ax, double ay, double bx, double by) {
    return move_cost(*cost, Eigen::Vector2d(ax, ay), Eigen::Vector2d(bx, by));
  };
  CHECK(move(0, 0, 3, 0) == 1.5);  // along an interface: the faster layer beside it
  CHECK(move(0, 1, 3, 1) == 0.75);
  CHECK(move(0, 0, 0, 1) == 1);
  CHECK(move(0, -1, 0, 2) == Approx(1.75));
  CHECK(move(0, 2, 0, -1) == Approx(1.75));
  CHECK(move(0, 0, 0, -1) == 0.5);
  CHECK(cost->line_element(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0)) == 0.5);
  CHECK(cost->line_element(Eigen::Vector2d(0, 0), Eigen::Vector2d(0, 1)) == 1);
  CHECK(cost->line_element(Eigen::Vector2d(0, 0), Eigen::Vector2d(0, -1)) == 0.5);
  CHECK(cost->traits().unit == "s");
}

TEST_CASE("layers refuses what is no stack, by name", "[contract]") {
  const auto key = [](const Eigen::VectorXd& interfaces, const Eigen::VectorXd& speeds,
                      const std::optional<Eigen::MatrixXd>& normals = {}, int dim = 2) -> std::string {
    LayersOptions options;
    options.interfaces = interfaces;
    if (speeds.size() > 0) options.speeds = speeds;
    options.normals = normals;
    try {
      make_layers_cost(options, dim);
    } catch (const OptionError& error) {
      return error.key();
    }
    return "";
  };
  const Eigen::VectorXd one = Eigen::VectorXd::Zero(1);
  CHECK(key(one, Eigen::Vector2d(1, 2)).empty());
  CHECK(key({}, Eigen::Vector2d(1, 2)) == "interfaces");
  CHECK(key(one, {}) == "speeds");
  CHECK(key(one, Eigen::Vector3d(1, 2, 3)) == "speeds");
  CHECK(key(one, Eigen::Vector2d(1, -2)) == "speeds");
  CHECK(key(Eigen::Vector2d(1, 0), Eigen::Vector3d(1, 2, 3)) == "interfaces");
  CHECK(key(one, Eigen::Vector2d(1, 2), Eigen::MatrixXd::Ones(1, 3)) == "normals");
  CHECK(key(one, Eigen::Vector2d(1, 2), Eigen::MatrixXd::Ones(2, 2)) == "normals");
  CHECK(key(one, Eigen::Vector2d(1, 2), Eigen::MatrixXd::Zero(1, 2)) == "normals");
  CHECK(key(one, Eigen::Vector2d(1, 2), {}, 1) == "interfaces");
}
TEST_CASE("cost contract: travel_time, chute", "[contract]") {
  check_cost_contract(travel_time(TravelTimeRule::chute, GENERATE(2, 3, 7)));
}
TEST_CASE("cost contract: travel_time, midpoint", "[contract]") {
  check_cost_contract(travel_time(TravelTimeRule::midpoint, GENERATE(2, 3, 7)));
}

TEST_CASE("a chute from rest: finite time, and derivatives at the other end", "[contract]") {
  const int d = GENERATE(2, 3, 7);
  TravelTimeOptions options;
  options.gravity = 1;
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(d), up = Eigen::VectorXd::Unit(d, d - 1);
  const auto cost = make_travel_time_cost(options, d, rest);
  CHECK(move_cost(*cost, rest, -2 * up) == Approx(2));  // free fall: sqrt(2 h / g)
  CHECK(move_cost(*cost, rest, rest) == 0);
  CHECK(move_cost(*cost, rest, Eigen::VectorXd::Unit(d, 0)) ==
        std::numeric_limits<double>::infinity());  // level: never starts
  Random random;
  Points x(d, 3);
  x << rest, -up + 0.3 * random.vector(d).cwiseAbs() * -1, -2 * up;
  CHECK(text(check_cost_derivatives(*cost, x, false, random.engine())) == "");
}

TEST_CASE("the level of a bead: source, start speed, or stated", "[contract]") {
  TravelTimeOptions options;
  options.gravity = 2;
  options.start_speed = 4;  // level = 1 + 16 / 4 = 5
  const Eigen::Vector2d source(0, 1), below(0, -4);
  const auto cost = make_travel_time_cost(options, 2, Eigen::VectorXd(source));
  CHECK(move_cost(*cost, source, below) == Approx(2 * 5 / (4 + 6.0)));
  CHECK_THROWS_AS(make_travel_time_cost(options, 2, std::nullopt), OptionError);
  options.level = std::numeric_limits<double>::quiet_NaN();
  options.start_speed = 0;
  CHECK_THROWS_AS(make_travel_time_cost(options, 2, std::nullopt), OptionError);
  options.start_speed = 4;
  options.level = 5;
  CHECK_THROWS_AS(make_travel_time_cost(options, 2, std::nullopt), OptionError);  // one of the two
  options.start_speed = 0;
  CHECK(move_cost(*make_travel_time_cost(options, 2, std::nullopt), source, below) == Approx(1));
}

TEST_CASE("metric_tensor refuses what is no metric, by name", "[contract]") {
  const auto refused = [](const Eigen::MatrixXd& matrix) {
    MetricTensorOptions options;
    options.matrix = matrix;
    try {
      make_metric_tensor_cost(options, 2);
    } catch (const OptionError& error) {
      return error.key() == "matrix";
    }
    return false;
  };
  CHECK(refused(Eigen::MatrixXd()));
  CHECK(refused(Eigen::MatrixXd::Identity(3, 3)));
  CHECK(refused((Eigen::Matrix2d() << 1, 0.1, 0, 1).finished()));
  CHECK(refused((Eigen::Matrix2d() << 1, 2, 2, 1).finished()));
  CHECK(refused((Eigen::Matrix2d() << 1, 1, 1, 1).finished()));
  CHECK(refused((Eigen::Matrix2d() << std::numeric_limits<double>::quiet_NaN(), 0, 0, 1).finished()));
  CHECK_FALSE(refused(Eigen::Matrix2d::Identity()));
}

}  // namespace leastcost::test
