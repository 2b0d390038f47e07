// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fstream>

#include <leastcost/framework/errors.hpp>
#include <leastcost/problems/costs/clearance_length.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/manifolds/mesh.hpp>
#include <leastcost/problems/manifolds/point_cloud.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>
#include "tests/contracts/cost_contract.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
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

/// Among two balls that the points are beside, with a third out of reach.
CostCase clearance(int d) {
  Eigen::VectorXd here = Eigen::VectorXd::Zero(d), there = here, far = here;
  here[0] = -2.2, there[1] = 2.4, far[0] = 20;
  const ObstacleWalls::Obstacles balls = {make_ball({here, 0.5}), make_ball({there, 0.7}), make_ball({far, 0.5})};
  return {.cost = make_clearance_length({3, 4}, d, std::make_shared<const ObstacleWalls>(d, balls, 0.1)),
          .draw = [d](Random& random) -> Eigen::VectorXd { return 0.5 * random.vector(d); }};
}

}  // namespace

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
