// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/recipes/recommended.hpp>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/initializers/cell_graph.hpp>
#include <leastcost/problems/initializers/eikonal.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/post_processors/choose_global_proof.hpp>
#include <leastcost/problems/post_processors/on_surface.hpp>
#include <leastcost/problems/post_processors/refract.hpp>
#include <leastcost/problems/post_processors/refract_cells.hpp>
#include <leastcost/recipes/facts.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/newton.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include "problems/methods/offered_methods.hpp"

namespace leastcost {
namespace {

/// The methods of a library above `core`.
template <class Methods, class Method>
const Methods& linked(const Methods* methods, const char* library, Method method) {
  if (methods != nullptr) return *methods;
  throw InputError("for this problem, find_path(problem) uses " + std::string(word_of(method)) +
                   ", a method of the library leastcost::" + library +
                   ": link it, or call find_path(problem, initializer, solver)");
}

std::shared_ptr<const Initializer> make(FirstPathMethod method, bool diagonals) {
  switch (method) {
    case FirstPathMethod::none: return nullptr;
    case FirstPathMethod::straight: return std::make_shared<const StraightInitializer>();
    case FirstPathMethod::dijkstra: return linked(mesh_methods(), "mesh", method).dijkstra(diagonals);
    case FirstPathMethod::cell_graph: return std::make_shared<const CellGraphInitializer>();
    case FirstPathMethod::grid: return std::make_shared<const GridInitializer>();
    case FirstPathMethod::eikonal: return std::make_shared<const EikonalInitializer>(EikonalOptions{.fallback = true});
    case FirstPathMethod::rrt: return std::make_shared<const RrtInitializer>();
  }
  return nullptr;
}

std::shared_ptr<const Solver> make(SolveMethod method) {
  switch (method) {
    case SolveMethod::none: return std::make_shared<const NoSolver>();
    case SolveMethod::newton: return std::make_shared<const Newton>();
    case SolveMethod::lbfgs: return std::make_shared<const Lbfgs>();
  }
  return nullptr;
}

std::shared_ptr<const PostProcessor> make(CurveMethod method) {
  switch (method) {
    case CurveMethod::on_surface: return std::make_shared<const OnSurfacePostProcessor>();
    case CurveMethod::trace: return linked(mesh_methods(), "mesh", method).trace();
    case CurveMethod::straighten: return linked(mesh_methods(), "mesh", method).straighten();
    case CurveMethod::taut: return linked(planning_methods(), "planning", method).taut();
    case CurveMethod::refract: return std::make_shared<const RefractPostProcessor>();
    case CurveMethod::refract_cells: return std::make_shared<const RefractCellsPostProcessor>();
  }
  return nullptr;
}

}  // namespace

Problem with_kernel(Problem problem) {
  if (!problem.kernel) problem.kernel = make_kernel<Expm1Square>();
  return problem;
}

std::string why_curve(const std::vector<CurveMethod>& steps) {
  if (steps.empty()) return "post-processors: none, because the points of the solver are the path";
  std::string text;
  for (const CurveMethod step : steps)
    text += (text.empty() ? "post-processors: " : "; ") + std::string(word_of(step)) + ", " + std::string(why(step));
  return text;
}

Recipe recommended(const Problem& given, const FindOptions& options) {
  if (!given.manifold || !given.cost) throw InputError("a recipe needs a problem with a manifold and a cost");
  const Problem problem = with_kernel(given);
  check(problem);
  const ProblemFacts facts = facts_of(problem);
  const FirstPathMethod first = recommended_first_path(facts);
  const FirstPathFacts start{.straight = first == FirstPathMethod::straight};
  const GlobalProof asked = options.certificate.enabled ? options.certificate.global : GlobalProof(GlobalOff{});
  const bool proved = proves_over_all_classes(facts, start, asked), exact = makes_exact_curves(facts) || proved;
  const SolveMethod solver = recommended_solver(facts, exact);

  Recipe recipe;
  recipe.initializer = make(first, exact && facts.mesh && !facts.occupancy);
  recipe.solver = make(solver);
  recipe.one_way = sees_one_way(facts, start, asked);
  const std::vector<CurveMethod> curve = recommended_curve(facts);
  for (const CurveMethod step : curve) recipe.post_processors.push_back(make(step));
  recipe.why.push_back("first path: " + std::string(recipe.initializer ? word_of(first) : "none") + ", " +
                       std::string(why(first, facts)));
  recipe.why.push_back("solver: " + std::string(word_of(solver)) + ", " + std::string(why(solver)));
  recipe.why.push_back(why_curve(curve));
  GlobalProofStep proof;
  if (proved || brackets_in_box(facts, asked)) proof = global_proof(problem, options.certificate.global);
  const std::string name = proof.step ? std::string(proof.step->name()) : "none";
  const std::string reason = proof.why_not.empty() ? std::string(why_proof(facts, start, asked)) : proof.why_not;
  recipe.why.push_back("proof over all paths: " + name + ", " + reason);
  if (proof.step) recipe.post_processors.push_back(std::move(proof.step));
  return recipe;
}

}  // namespace leastcost
