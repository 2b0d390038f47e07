// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Every dirty mesh of the data set ends in a path that holds up or in an error that says why: never in a NaN, never in
// a certified path that is not one.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/mesh/surface_path.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace {

using namespace leastcost;

PathEnd end_at(const TriangleMesh& mesh, std::int32_t v) { return {mesh.position(v), vertex_point(mesh, v).face}; }

/// "certified", "uncertified", or the error's message.
std::string outcome(const std::shared_ptr<const MeshManifold>& domain, std::int32_t source, std::int32_t target) {
  const TriangleMesh& mesh = domain->mesh();
  const Lbfgs solver;
  FindOptions options;
  options.points = 32;
  options.post_processors = {std::make_shared<const TracePostProcessor>(),
                             std::make_shared<const StraightenPostProcessor>()};
  const Problem problem{domain, make_euclidean_cost(3), make_kernel<Expm1Square>(), end_at(mesh, source),
                        end_at(mesh, target)};
  try {
    const Result result = find_path(problem, DijkstraInitializer(), solver, options);
    CHECK(std::isfinite(result.curve.cost));
    CHECK(result.path.u.allFinite());
    // A path is no shorter than the straight line, and no longer than the edge path that it came from; but where the
    // mesh cannot be straightened, the curve is the traced one, and the result says so.
    CHECK(result.curve.cost >= (problem.target.u - problem.source.u).norm() * (1 - 1e-12));
    const Points& edges = result.first.path.u;
    const Index m = edges.cols() - 1;
    const auto& failures = result.certificate.failures;
    const bool straightened = std::none_of(failures.begin(), failures.end(),
                                           [](const CertificateFailure& f) { return f.name() == "post_process"; });
    if (straightened)
      CHECK(result.curve.cost <= (edges.rightCols(m) - edges.leftCols(m)).colwise().norm().sum() * (1 + 1e-12));
    // What is certified is straight by the independent checker; what is not says why.
    if (result.status == Status::certified) {
      REQUIRE(result.curve.straightness);
      CHECK(*result.curve.straightness >= -1e-9);
    } else {
      CHECK_FALSE(result.certificate.failures.empty());
    }
    return std::string(word_of(result.status));
  } catch (const InputError& error) {
    return error.what();
  } catch (const InitializationError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("dirty meshes end in a path or in a clear error", "[oracles]") {
  const std::string file =
      GENERATE(as<std::string>(), "dragon_48k_dirty.ply", "horse_dirty.obj", "teapot_dirty.obj", "wuson_dirty.off",
               "blobby_shuffled.off", "fan3.obj", "hourglass.obj", "moebius.obj", "bunny_holes_soup.stl",
               "motor_soup.stl", "cow.off", "anchor_dense.off");
  const auto found = test::data_file("meshes/" + file);
  if (!found) return;
  for (const bool weld : {false, true}) {
    const auto domain = make_mesh_manifold({found->string(), weld, 0}, "");
    const std::int32_t n = domain->mesh().vertex_count();
    int certified = 0, uncertified = 0, errors = 0;
    for (int i = 1; i <= 6; ++i) {
      const std::string end = outcome(domain, 0, static_cast<std::int32_t>(static_cast<long>(i) * (n - 1) / 6));
      CAPTURE(file, weld, i, end);
      ++(end == "certified" ? certified : end == "uncertified" ? uncertified : errors);
      CHECK(end.size() > 5);
    }
    std::printf("%-24s weld %d: %d certified, %d uncertified, %d refused with a reason\n", file.c_str(), weld,
                certified, uncertified, errors);
  }
}

TEST_CASE("ends in different components are named with the components' sizes", "[oracles]") {
  const auto found = test::data_file("meshes/teapot_dirty.obj");
  if (!found) return;
  const auto domain = make_mesh_manifold({found->string(), false, 0}, "");
  const TriangleMesh& mesh = domain->mesh();
  std::int32_t other = 0;
  while (mesh.component(other) == mesh.component(0)) ++other;
  const std::string message = outcome(domain, 0, other);
  const auto size = [&](std::int32_t v) {
    return std::to_string(mesh.component_sizes()[static_cast<std::size_t>(mesh.component(v))]);
  };
  INFO(message);
  CHECK(message.find(size(0)) != std::string::npos);
  CHECK(message.find(size(other)) != std::string::npos);
}
