// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// What the run-level interface costs: energy + gradient of 1000 segments against a fully templated loop, and
// allocations per solver iteration.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <numbers>

#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/newton.hpp>
#include "framework/energy/spacing.hpp"

namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace {

using namespace leastcost;

struct Euclidean3 {
  static constexpr int dim = 3;
  CostTraits traits() const { return {}; }
  template <class S>
  S value(const Point<S, 3>& a, const Point<S, 3>& b) const {
    return (b - a).squaredNorm();
  }
  double gradient(const Point<double, 3>& a, const Point<double, 3>& b, Point<double, 3>& ga,
                  Point<double, 3>& gb) const {
    gb = 2 * (b - a);
    ga = -gb;
    return (b - a).squaredNorm();
  }
};

/// The same sum with every type known: no virtual call, no blocks.
template <class Cost, class Kernel>
double templated(const Cost& cost, const Kernel& kernel, const Points& x, double s0, Points& g) {
  const double scale = 1 / (s0 * s0);
  double energy = 0;
  g.setZero();
  for (Index i = 0; i + 1 < x.cols(); ++i) {
    SegmentGradient<Cost::dim> d;
    const Jet2 phi = kernel(scale * squared_cost_gradient(cost, {x.col(i), x.col(i + 1), false, false}, d));
    energy += phi.value;
    g.col(i) += scale * phi.d1 * d.a;
    g.col(i + 1) += scale * phi.d1 * d.b;
  }
  return energy;
}

template <class F>
double microseconds(F f) {
  double best = 1e300;
  for (int r = 0; r < 200; ++r) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < 10; ++i) f();
    best = std::min(best,
                    std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count() / 10);
  }
  return best;
}

void interface_cost() {
  const int n = 1000;
  const Points x = Points::Random(3, n + 1);
  Points g(3, n + 1);
  const std::shared_ptr<const SegmentCost> cost = make_segment_cost(Euclidean3{});
  const std::shared_ptr<const Kernel> kernel = make_kernel<Expm1Square>();
  const AmbientPath path{{x.data(), 3, n + 1}, {}, false};
  double sink = 0;
  const double lifted = microseconds([&] { sink += cost->energy_and_gradient(path, *kernel, 1, g); });
  const double bare = microseconds([&] { sink += templated(Euclidean3{}, Expm1Square{}, x, 1, g); });
  std::printf(
      "energy + gradient, 1000 segments, d = 3, expm1_square: templated %.1f us, run-level %.1f us, ratio %.2f "
      "(target 1.5)%s\n",
      bare, lifted, lifted / bare, sink == 0 ? " " : "");
}

/// Allocations of a solve with twice the iterations minus those of the shorter one, per iteration.
template <class MakeSolver>
void allocations_per_iteration(const char* name, MakeSolver make) {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{});
  TravelTimeOptions options;
  problem.source.u = Eigen::Vector2d::Zero();
  problem.target.u = Eigen::Vector2d(std::numbers::pi, -2);
  problem.cost = make_travel_time_cost(options, 2, problem.source.u);
  problem.kernel = make_kernel<Expm1Square>();
  const CoordinatePath start = sample_equally(problem, StraightInitializer().first_path(problem, {}).path, 1000);
  const auto count = [&](int iterations) {
    CoordinatePath path = start;
    PathEnergy energy(problem, PathEnergy(problem, 1).cost(start) / 1001);
    const auto solver = make(iterations);
    const long before = allocations;
    solver.solve(energy, path, {});
    return allocations - before;
  };
  const long few = count(3), more = count(6);
  std::printf("%s: %.1f allocations per iteration (target 0; the history's line aside)\n", name,
              static_cast<double>(more - few) / 3);
}

}  // namespace

int main() {
  interface_cost();
  allocations_per_iteration("newton", [](int n) { return Newton(NewtonOptions{.max_iterations = n}); });
  allocations_per_iteration("lbfgs chain", [](int n) { return Lbfgs(LbfgsOptions{.max_iterations = n}); });
  allocations_per_iteration("lbfgs none", [](int n) {
    return Lbfgs(LbfgsOptions{.max_iterations = n, .precondition = Preconditioner::none});
  });
}
