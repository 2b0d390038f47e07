// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Fields in space for costs that depend on the direction, in random worlds: the largest error, and whether the error
// that the field states covers it. Constant winds and metrics are compared with their closed form, others, half of
// them among balls, with a field on a lattice three times as fine.
//   space_field_table [FIRST_SEED] [WORLDS]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/costs/zermelo.hpp>
#include <leastcost/problems/fields/space_field.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>

namespace {

using namespace leastcost;
using Eigen::Vector3d;

constexpr int kCells = 16, kFiner = 3;  ///< along a side of the unit cube; of the reference

struct Cube {
  Problem problem;
  bool closed_form = false;  ///< the straight move is the cheapest
};

class CubeMaker {
 public:
  explicit CubeMaker(std::uint32_t seed) : random_(seed) {}

  Cube constant() {
    Cube cube = of(chance() ? constant_wind() : constant_metric(), false);
    cube.closed_form = true;
    return cube;
  }
  /// Of 0.1 to 0.9 of the speed.
  Cube winds() {
    std::vector<std::string> wind;
    const double most = number(0.1, 0.9) / std::sqrt(3.0);
    for (int d = 0; d < 3; ++d) wind.push_back(text(most) + " * " + wave());
    return of(make_zermelo_cost({.speed = "1", .flow = flow::Formula{wind}}, 3), chance());
  }
  /// Diagonal elements of 0.5 to 4.5, others of at most 0.2.
  Cube metrics() {
    const auto diagonal = [&] { return text(number(1, 3)) + " + " + text(number(0.2, 0.5)) + " * " + wave(); };
    const auto other = [&] { return text(number(0.05, 0.2)) + " * " + wave(); };
    const std::vector<std::string> entries = {diagonal(), other(), other(), diagonal(), other(), diagonal()};
    return of(make_metric_field_cost({metric::Formula{entries, {}}}, 3), chance());
  }

 private:
  static std::string text(double value) { return "(" + std::to_string(value) + ")"; }
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool chance() { return number(0, 1) < 0.5; }
  std::string wave() {
    return "sin(" + text(number(-5, 5)) + " * x + " + text(number(-5, 5)) + " * y + " + text(number(-5, 5)) +
           " * z + " + text(number(0, 6.3)) + ")";
  }
  std::shared_ptr<const SegmentCost> constant_wind() {
    const Vector3d w = number(0.2, 0.95) * Vector3d(number(-1, 1), number(-1, 1), number(-1, 1)).normalized();
    return make_zermelo_cost({.speed = "1", .flow = flow::Formula{{text(w[0]), text(w[1]), text(w[2])}}}, 3);
  }
  /// Lengths along the axes differ by a factor of up to about 4.
  std::shared_ptr<const SegmentCost> constant_metric() {
    Eigen::Matrix3d root;
    for (double& entry : root.reshaped()) entry = number(-0.6, 0.6);
    root += Eigen::Matrix3d(Eigen::Vector3d(number(1, 2), number(1, 2), number(1, 2)).asDiagonal());
    return make_metric_tensor_cost({Eigen::MatrixXd(root.transpose() * root)}, 3);
  }
  Cube of(std::shared_ptr<const SegmentCost> cost, bool among_balls) {
    constexpr double kApart = 0.13;
    const Vector3d source(number(0.05, 0.95), number(0.05, 0.95), number(0.05, 0.95));
    Cube cube;
    cube.problem.manifold = std::make_shared<const EuclideanManifold>(
        EuclideanManifoldOptions{3, {Eigen::VectorXd::Zero(3), Eigen::VectorXd::Ones(3)}});
    FreeSpace::Obstacles balls;
    std::vector<std::pair<Vector3d, double>> taken = {{source, 0.0}};
    for (int trial = 0; trial < 50 && balls.size() < 3 && among_balls; ++trial) {
      const double radius = number(0.1, 0.2), edge = radius + kApart;
      const Vector3d middle(number(edge, 1 - edge), number(edge, 1 - edge), number(edge, 1 - edge));
      if (std::any_of(taken.begin(), taken.end(), [&](const auto& other) {
            return (other.first - middle).norm() < other.second + radius + kApart;
          }))
        continue;
      taken.emplace_back(middle, radius);
      balls.push_back(make_ball({middle, radius}));
    }
    if (!balls.empty()) cube.problem.manifold = std::make_shared<const FreeSpace>(cube.problem.manifold, balls, 0.0);
    cube.problem.cost = std::move(cost);
    cube.problem.source.u = source;
    cube.problem.target.u = source + Vector3d(1e-3, 0, 0);
    return cube;
  }

  std::mt19937 random_;
};

struct Compared {
  double worst = 0, stated = 0, largest = 0;
};

Compared compared(const Cube& cube) {
  const Eigen::VectorXd source = cube.problem.source.u;
  const SpaceField coarse = space_costs_from(cube.problem, {source}, {.resolution = 1.0 / kCells});
  Compared result{0, coarse.error, 0};
  SpaceField fine;
  if (!cube.closed_form)
    fine = space_costs_from(cube.problem, {source}, {.resolution = 1.0 / (kCells * kFiner), .estimate_error = false});
  for (std::int32_t k = 0; k < coarse.count[2]; ++k)
    for (std::int32_t j = 0; j < coarse.count[1]; ++j)
      for (std::int32_t i = 0; i < coarse.count[0]; ++i) {
        const double value = coarse.value(i, j, k);
        if (!std::isfinite(value)) continue;
        const double right = cube.closed_form ? move_cost(*cube.problem.cost, source, coarse.node(i, j, k))
                                              : fine.value(kFiner * i, kFiner * j, kFiner * k);
        result.worst = std::max(result.worst, std::abs(value - right));
        result.largest = std::max(result.largest, right);
      }
  return result;
}

struct CubeKind {
  const char* name;
  Cube (CubeMaker::*make)();
};

}  // namespace

int main(int argc, char** argv) {
  const int first = argc > 1 ? std::atoi(argv[1]) : 1, worlds = argc > 2 ? std::atoi(argv[2]) : 20;
  std::printf("%-10s %8s %9s %22s %12s %20s\n", "kind", "worlds", "covered", "error/largest: median", "worst",
              "error/stated: worst");
  for (const CubeKind& kind : {CubeKind{"constant", &CubeMaker::constant}, CubeKind{"winds", &CubeMaker::winds},
                               CubeKind{"metrics", &CubeMaker::metrics}}) {
    std::vector<double> errors;
    int covered = 0;
    double worst_share = 0;
    for (int k = 0; k < worlds; ++k) {
      CubeMaker maker(static_cast<std::uint32_t>(first + k));
      const Compared result = compared((maker.*kind.make)());
      errors.push_back(result.worst / result.largest);
      if (result.worst <= result.stated) ++covered;
      worst_share = std::max(worst_share, result.worst / result.stated);
    }
    std::sort(errors.begin(), errors.end());
    std::printf("%-10s %8d %9d %22.2e %12.2e %20.2f\n", kind.name, worlds, covered, errors[errors.size() / 2],
                errors.back(), worst_share);
    std::fflush(stdout);
  }
}
