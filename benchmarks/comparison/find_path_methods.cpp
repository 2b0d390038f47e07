// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/post_processors/shortest.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include "benchmarks/comparison/methods.hpp"
#include "problems/mesh/mesh_curve.hpp"

namespace leastcost::comparison {
namespace {

/// The paper's stopping test, a gradient below 1e-8, in terms of ours: the predicted error of the cost.
constexpr double kCostError = 1e-14;
/// Iterations after which the traced path is measured for the history.
constexpr int kLooks[] = {0, 1, 2, 5, 10, 15, 20, 30, 40, 60, 80, 120, 160, 240, 320, 480, 640, 1000};

/// What leastcost does on a mesh.
class FindPathMethod : public Method {
 public:
  void prepare(const TriangleMesh& mesh, const Stop&) override { domain_ = std::make_shared<MeshManifold>(mesh); }

 protected:
  Problem problem(std::int32_t source, std::int32_t target, std::shared_ptr<const Kernel> kernel) const {
    const TriangleMesh& mesh = domain_->mesh();
    return {domain_,
            make_euclidean_cost(3),
            std::move(kernel),
            {mesh.position(source), vertex_point(mesh, source).face},
            {mesh.position(target), vertex_point(mesh, target).face}};
  }
  Result run(const Problem& p, const Solver& solver, const FindOptions& options, const Stop& stop) const {
    Monitor monitor;
    monitor.stop_requested = stop;
    return find_path(p, DijkstraInitializer(), solver, options, monitor);
  }

  std::shared_ptr<const MeshManifold> domain_;
};

/// A chain of as many points as the path along edges has vertices, solved and traced on the faces.
template <class KernelOf>
class ChainMethod final : public FindPathMethod {
 public:
  Answer shortest(std::int32_t source, std::int32_t target, const Stop& stop) override {
    return solve(source, target, LbfgsOptions().max_iterations, stop);
  }

  /// The solver knows energies of the chain alone: so it is stopped after each of some numbers of iterations.
  void measure_lengths(std::int32_t source, std::int32_t target, const Stop& stop, Answer& answer) override {
    for (const int look : kLooks) {
      if (look >= answer.iterations || (stop && stop())) break;
      const Answer part = solve(source, target, look, stop);
      if (part.outcome != Outcome::found) break;
      answer.looks.push_back(look);
      answer.lengths.push_back(path_length(part.path));
    }
    answer.looks.push_back(answer.iterations);
    answer.lengths.push_back(path_length(answer.path));
  }

 private:
  Answer solve(std::int32_t source, std::int32_t target, int iterations, const Stop& stop) const {
    Answer answer;
    const Problem p = this->problem(source, target, make_kernel<KernelOf>());
    FindOptions options;
    options.points = {};
    options.certificate.enabled = false;
    options.post_processors = {std::make_shared<const TracePostProcessor>()};
    LbfgsOptions limits;
    limits.tolerance = kCostError;
    limits.max_iterations = iterations;
    try {
      const Result result = this->run(p, Lbfgs(limits), options, stop);
      answer.path = as_surface_path(result.curve);
      answer.distance = path_length(answer.path);
      answer.iterations = result.solve.iterations;
      answer.note = std::to_string(result.path.u.cols() - 2) + " points";
      if (stop && stop()) answer.outcome = Outcome::out_of_time;
    } catch (const Error& error) {
      answer.outcome = stop && stop() ? Outcome::out_of_time : Outcome::failed;
      answer.note = error.what();
    }
    return answer;
  }
};

/// The default: the first path straightened, and proved to be the shortest or replaced by it.
class OurDefault final : public FindPathMethod {
 public:
  Answer shortest(std::int32_t source, std::int32_t target, const Stop& stop) override {
    Answer answer;
    FindOptions options;
    options.certificate.enabled = false;
    options.post_processors = {std::make_shared<const StraightenPostProcessor>(),
                               std::make_shared<const ShortestPostProcessor>(GlobalBudget{})};
    try {
      const Result result = run(problem(source, target, make_kernel<Expm1Square>()), NoSolver(), options, stop);
      answer.path = as_surface_path(result.curve);
      answer.distance = path_length(answer.path);
      if (stop && stop()) answer.outcome = Outcome::out_of_time;
    } catch (const Error& error) {
      answer.outcome = stop && stop() ? Outcome::out_of_time : Outcome::failed;
      answer.note = error.what();
    }
    return answer;
  }
};

}  // namespace

std::unique_ptr<Method> make_squared_length() { return std::make_unique<ChainMethod<Square>>(); }
std::unique_ptr<Method> make_vfcs() { return std::make_unique<ChainMethod<Expm1Square>>(); }
std::unique_ptr<Method> make_ours() { return std::make_unique<OurDefault>(); }

}  // namespace leastcost::comparison
