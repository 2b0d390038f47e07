// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/nlopt/nlopt_solver.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlopt.hpp>
#include <string>
#include <vector>

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

/// A method of NLopt.
struct Method {
  nlopt::algorithm algorithm;
  bool gradient;
  int most_variables;  ///< beyond it a solve would take minutes: dense algebra, or evaluations in proportion to the
                       ///< square of the variables
};

constexpr int kAny = std::numeric_limits<int>::max();

Method method(NloptAlgorithm algorithm) {
  switch (algorithm) {
    case NloptAlgorithm::lbfgs: return {nlopt::LD_LBFGS, true, kAny};
    case NloptAlgorithm::tnewton: return {nlopt::LD_TNEWTON, true, kAny};
    case NloptAlgorithm::tnewton_restart: return {nlopt::LD_TNEWTON_RESTART, true, kAny};
    case NloptAlgorithm::tnewton_precond: return {nlopt::LD_TNEWTON_PRECOND, true, kAny};
    case NloptAlgorithm::tnewton_precond_restart: return {nlopt::LD_TNEWTON_PRECOND_RESTART, true, kAny};
    case NloptAlgorithm::var1: return {nlopt::LD_VAR1, true, kAny};
    case NloptAlgorithm::var2: return {nlopt::LD_VAR2, true, kAny};
    case NloptAlgorithm::mma: return {nlopt::LD_MMA, true, kAny};
    case NloptAlgorithm::ccsaq: return {nlopt::LD_CCSAQ, true, kAny};
    case NloptAlgorithm::slsqp: return {nlopt::LD_SLSQP, true, 500};
    case NloptAlgorithm::cobyla: return {nlopt::LN_COBYLA, false, 60};
    case NloptAlgorithm::bobyqa: return {nlopt::LN_BOBYQA, false, 100};
    case NloptAlgorithm::neldermead: return {nlopt::LN_NELDERMEAD, false, 40};
    case NloptAlgorithm::sbplx: return {nlopt::LN_SBPLX, false, 100};
    case NloptAlgorithm::praxis: return {nlopt::LN_PRAXIS, false, 100};
  }
  throw OptionError("algorithm", "is not an algorithm of nlopt");
}

std::string outcome(nlopt::result result) {
  switch (result) {
    case nlopt::SUCCESS: return "nlopt: success";
    case nlopt::STOPVAL_REACHED: return "nlopt: stopval reached";
    case nlopt::FTOL_REACHED: return "nlopt: ftol reached";
    case nlopt::XTOL_REACHED: return "nlopt: xtol reached";
    case nlopt::MAXEVAL_REACHED: return "nlopt: maxeval reached";
    case nlopt::MAXTIME_REACHED: return "nlopt: maxtime reached";
    default: return "nlopt: failure";
  }
}

class NloptRounds final : public RoundMinimiser {
 public:
  explicit NloptRounds(Method method) : method_(method) {}

  std::string minimise(RoundObjective& objective) override {
    nlopt::opt optimiser(method_.algorithm, static_cast<unsigned>(objective.size()));
    Context context{objective, optimiser, Eigen::VectorXd()};
    optimiser.set_min_objective(&evaluate, &context);
    if (objective.evaluations_left() < kAny) optimiser.set_maxeval(objective.evaluations_left());
    optimiser.set_initial_step(objective.typical_step());
    std::vector<double> z(static_cast<std::size_t>(objective.size()), 0.0);
    double value = 0;
    try {
      return outcome(optimiser.optimize(z, value));
    } catch (const nlopt::forced_stop&) {
      return "";  // by us
    }
  }

 private:
  struct Context {
    RoundObjective& objective;
    nlopt::opt& optimiser;
    Eigen::VectorXd gradient;
  };

  static double evaluate(const std::vector<double>& z, std::vector<double>& gradient, void* data) {
    Context& context = *static_cast<Context*>(data);
    const Eigen::Map<const Eigen::VectorXd> at(z.data(), static_cast<Index>(z.size()));
    Eigen::VectorXd* g = gradient.empty() ? nullptr : &context.gradient;
    double value = context.objective(at, g);
    if (!std::isfinite(value)) value = context.objective.finite_excess(at, g);
    if (!gradient.empty()) std::copy(context.gradient.begin(), context.gradient.end(), gradient.begin());
    if (context.objective.must_stop()) context.optimiser.force_stop();
    return value;
  }

  Method method_;
};

}  // namespace

Words<NloptAlgorithm> words(NloptAlgorithm) {
  static constexpr std::array<Word<NloptAlgorithm>, 15> kWords = {
      {{NloptAlgorithm::lbfgs, "lbfgs"},
       {NloptAlgorithm::tnewton, "tnewton"},
       {NloptAlgorithm::tnewton_restart, "tnewton_restart"},
       {NloptAlgorithm::tnewton_precond, "tnewton_precond"},
       {NloptAlgorithm::tnewton_precond_restart, "tnewton_precond_restart"},
       {NloptAlgorithm::var1, "var1"},
       {NloptAlgorithm::var2, "var2"},
       {NloptAlgorithm::mma, "mma"},
       {NloptAlgorithm::ccsaq, "ccsaq"},
       {NloptAlgorithm::slsqp, "slsqp"},
       {NloptAlgorithm::cobyla, "cobyla"},
       {NloptAlgorithm::bobyqa, "bobyqa"},
       {NloptAlgorithm::neldermead, "neldermead"},
       {NloptAlgorithm::sbplx, "sbplx"},
       {NloptAlgorithm::praxis, "praxis"}}};
  return kWords;
}

void NloptOptions::fields(FieldVisitor& visit) {
  visit.choice("algorithm", algorithm,
               {.help = "Local optimiser of NLopt; those after slsqp need no gradients and are for few points."});
  rounds.fields(visit);
}

Nlopt::Nlopt(NloptOptions options) : options_(checked(options)) {}

std::optional<std::string> Nlopt::cannot_solve(const PathEnergy& energy, const CoordinatePath& path) const {
  const Method m = method(options_.algorithm);
  const Index variables = energy.problem().manifold->dimensions().tangent * path.free_count();
  if (variables <= m.most_variables) return std::nullopt;
  return "nlopt " + std::string(word_of(options_.algorithm)) + " is for at most " + std::to_string(m.most_variables) +
         " variables, but this path has " + std::to_string(variables) +
         (m.gradient ? ": its time grows with the cube of them" : ": without gradients it needs many evaluations");
}

SolveReport Nlopt::do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  const Method m = method(options_.algorithm);
  NloptRounds minimiser(m);
  RoundOptions rounds = options_.rounds;
  if (!m.gradient) {  // evaluations in the place of gradients
    const auto variables = static_cast<int>(energy.problem().manifold->dimensions().tangent * path.free_count());
    rounds.restart *= variables + 1;
  }
  return solve_by_rounds(energy, path, rounds, minimiser, monitor);
}

std::string nlopt_version() {
  int major = 0, minor = 0, fix = 0;
  nlopt::version(major, minor, fix);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(fix);
}

}  // namespace leastcost
