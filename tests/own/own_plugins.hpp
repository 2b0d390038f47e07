// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <leastcost/catalogue/registry/register.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/result/result.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include "examples/own_program/own_parts.hpp"

namespace leastcost::test {

/// The plane, by another name.
class OwnPlane final : public EmbeddedManifold {
 public:
  OwnPlane() : EmbeddedManifold({.coordinate = 2, .ambient = 2, .tangent = 2}) {}

 private:
  bool project_point(Eigen::Ref<Eigen::VectorXd>) const override { return true; }
  void tangent_basis(const Eigen::VectorXd&, Eigen::Ref<Points> basis) const override { basis.setIdentity(); }
};

/// The straight line, by another name.
class OwnStart final : public Initializer {
 public:
  std::string_view name() const override { return "own_start"; }
  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override {
    FirstPath first = StraightInitializer().first_path(problem, monitor);
    first.notes.emplace_back("from own_start");
    return first;
  }
};

/// Leaves everything as it is, and says so.
class OwnStep final : public PostProcessor {
 public:
  std::string_view name() const override { return "own_step"; }
  PostProcessed apply(const Problem&, const FirstPath&, PostProcessed current, const Monitor&) const override {
    current.notes.emplace_back("through own_step");
    return current;
  }
};

/// cosh s - 1, as in examples/extend/own_kernel.cpp.
struct OwnCosh {
  static constexpr KernelKind kind = KernelKind::quadratic_at_zero;
  Jet2 operator()(double q) const {
    if (q < 1e-4) return {q / 2 + q * q / 24, 0.5 + q / 12 + q * q / 240, 1.0 / 12 + q / 120};
    const double s = std::sqrt(q), c = std::cosh(s), by_s = std::sinh(s) / s;
    return {c - 1, by_s / 2, (c - by_s) / (4 * q)};
  }
};

struct OwnPegsOptions {
  double radius = 0.5;
  void fields(FieldVisitor& visit) {
    visit.field("radius", radius, {.help = "Radius of both pegs.", .unit = "length", .minimum = 0});
  }
};

/// Registers one plug-in of every kind, once in this process.
inline void register_own_plugins() {
  static const bool done = [] {
    register_cost<own::RayTimeOptions>(
        "own_ray_time", "Time of a ray through a medium whose speed grows with depth.",
        [](const own::RayTimeOptions& o, const BuildContext&) { return make_segment_cost(own::RayTime{o.gain}); });
    register_solver<own::GaussNewton, own::GaussNewtonOptions>("own_gauss_newton", "Gauss-Newton steps on the chain.");
    register_manifold<OwnPlane>("own_plane", "The plane.");
    register_kernel<OwnCosh>("own_cosh", "H(s) = cosh(s) - 1.");
    register_initializer<OwnStart>("own_start", "The straight line.");
    register_post_processor<OwnStep>("own_step", "No change.");
    register_obstacle<OwnPegsOptions>("own_pegs", "Two discs.", [](const OwnPegsOptions& o, const BuildContext&) {
      return std::vector<std::shared_ptr<const Obstacle>>{make_ball({Eigen::Vector2d(1, 0), o.radius}),
                                                          make_ball({Eigen::Vector2d(3, 0), o.radius})};
    });
    return true;
  }();
  static_cast<void>(done);
}

/// A configuration of a ray, whose exact time is 2 acosh(3).
inline const std::string kRay = R"(manifold: own_plane
cost: {type: own_ray_time, gain: 0.5}
kernel: own_cosh
initializer: own_start
solver: {type: own_gauss_newton, max_iterations: 150}
post_process: [own_step]
ends: {source: {point: [0, 0]}, target: {point: [4, 0]}}
path: {points: 60}
)";

inline std::filesystem::path written(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

}  // namespace leastcost::test
