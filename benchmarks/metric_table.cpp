// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Energy and gradient of a path on a torus under metrics of several makes: nanoseconds per segment, evaluations per
// second and how many times the constant tensor. Tensors on data are interpolated from the 32,768 vertices of a mesh.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <numbers>

#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>

namespace {

using namespace leastcost;

constexpr int kSegments = 1000;
constexpr int kRepetitions = 50;

Eigen::Vector3d on_torus(double u, double v) {
  return {(2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v)};
}

std::shared_ptr<const MeshManifold> torus_mesh(int m, int n) {
  constexpr double kTurn = 2 * std::numbers::pi;
  PolygonSoup soup;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) soup.positions.push_back(on_torus(kTurn * i / m, kTurn * j / n));
  const auto vertex = [&](int i, int j) { return i % m * n + j % n; };
  soup.polygon_begin.push_back(0);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      for (const int v :
           {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)})
        soup.corners.push_back(v);
      for (int k = 0; k < 2; ++k) soup.polygon_begin.push_back(soup.polygon_begin.back() + 3);
    }
  return std::make_shared<MeshManifold>(TriangleMesh(soup));
}

/// Nanoseconds per segment, the best of several runs.
double measure(const SegmentCost& cost, const Points& x) {
  Points gradient(x.rows(), x.cols());
  const KernelOf<Square> kernel;
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kRepetitions; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    cost.energy_and_gradient({{x.data(), x.rows(), x.cols()}, {}, false}, kernel, 1, gradient);
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
    best = std::min(best, time.count() / kSegments);
  }
  return best;
}

std::shared_ptr<const SegmentCost> field(const metric::Field& field, TensorRule rule,
                                         const ConstraintManifold& domain) {
  return make_metric_field_cost({.field = field, .rule = rule}, 3, &domain);
}

}  // namespace

int main() {
  const auto mesh = torus_mesh(256, 128);
  Points x(3, kSegments + 1);
  for (int i = 0; i <= kSegments; ++i) x.col(i) = on_torus(3.0 * i / kSegments, 2.0 * i / kSegments);
  MetricTensorOptions constant;
  constant.matrix = Eigen::Vector3d(1, 2, 3).asDiagonal();
  const double base = measure(*make_metric_tensor_cost(constant, 3), x);
  std::printf("| %-28s | ns per segment | million per second | ratio |\n", "energy and gradient");
  const auto row = [&](const char* what, double ns) {
    std::printf("| %-28s | %14.0f | %18.2f | %5.0f |\n", what, ns, 1e3 / ns, ns / base);
  };
  row("constant tensor", base);
  const metric::Formula formula{.entries = {"2 + sin(x)", "0.3 * cos(y)", "0", "1 + 0.2 * x^2", "0.1 * z", "1"}};
  const CurvatureMetricOptions curvature{.weight = 0.5};
  row("formula, midpoint", measure(*field(formula, TensorRule::midpoint, *mesh), x));
  row("formula, average", measure(*field(formula, TensorRule::average, *mesh), x));
  row("tensors on data, midpoint", measure(*field(curvature, TensorRule::midpoint, *mesh), x));
  row("tensors on data, average", measure(*field(curvature, TensorRule::average, *mesh), x));
}
