// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/nlopt/nlopt_solver.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlopt.hpp>
#include <utility>

namespace leastcost {
namespace {

/// A method of NLopt, by the name it has here.
struct Method {
  const char* name;
  nlopt::algorithm algorithm;
  bool gradient;
  int most_variables;  ///< beyond it a solve would take minutes: dense algebra, or evaluations in proportion to the
                       ///< square of the variables
};

constexpr int kAny = std::numeric_limits<int>::max();
constexpr std::array<Method, 15> kMethods = {{
    {"lbfgs", nlopt::LD_LBFGS, true, kAny},
    {"tnewton", nlopt::LD_TNEWTON, true, kAny},
    {"tnewton_restart", nlopt::LD_TNEWTON_RESTART, true, kAny},
    {"tnewton_precond", nlopt::LD_TNEWTON_PRECOND, true, kAny},
    {"tnewton_precond_restart", nlopt::LD_TNEWTON_PRECOND_RESTART, true, kAny},
    {"var1", nlopt::LD_VAR1, true, kAny},
    {"var2", nlopt::LD_VAR2, true, kAny},
    {"mma", nlopt::LD_MMA, true, kAny},
    {"ccsaq", nlopt::LD_CCSAQ, true, kAny},
    {"slsqp", nlopt::LD_SLSQP, true, 500},
    {"cobyla", nlopt::LN_COBYLA, false, 60},
    {"bobyqa", nlopt::LN_BOBYQA, false, 100},
    {"neldermead", nlopt::LN_NELDERMEAD, false, 40},
    {"sbplx", nlopt::LN_SBPLX, false, 100},
    {"praxis", nlopt::LN_PRAXIS, false, 100},
}};

const Method& method(const std::string& name) {
  return *std::find_if(kMethods.begin(), kMethods.end(), [&](const Method& m) { return name == m.name; });
}

std::string words(nlopt::result result) {
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
  explicit NloptRounds(const Method& method) : method_(method) {}

  std::string minimise(RoundObjective& objective) override {
    nlopt::opt optimiser(method_.algorithm, static_cast<unsigned>(objective.size()));
    Context context{objective, optimiser, Eigen::VectorXd()};
    optimiser.set_min_objective(&evaluate, &context);
    if (objective.evaluations_left() < kAny) optimiser.set_maxeval(objective.evaluations_left());
    optimiser.set_initial_step(objective.typical_step());
    std::vector<double> z(static_cast<std::size_t>(objective.size()), 0.0);
    double value = 0;
    try {
      return words(optimiser.optimize(z, value));
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
    if (!std::isfinite(value)) value = context.objective.rise(at, g);
    if (!gradient.empty()) std::copy(context.gradient.begin(), context.gradient.end(), gradient.begin());
    if (context.objective.must_stop()) context.optimiser.force_stop();
    return value;
  }

  const Method& method_;
};

}  // namespace

void NloptOptions::fields(FieldVisitor& visit) {
  std::vector<std::string> names;
  names.reserve(kMethods.size());
  for (const Method& m : kMethods) names.emplace_back(m.name);
  visit.choice("algorithm", algorithm, names,
               {.help = "Local optimiser of NLopt; those after slsqp need no gradients and are for few points."});
  rounds.fields(visit);
}

Nlopt::Nlopt(NloptOptions options) : options_(std::move(options)) {}

std::optional<std::string> Nlopt::cannot_solve(const PathEnergy& energy, const CoordinatePath& path) const {
  const Method& m = method(options_.algorithm);
  const Index variables = energy.problem().manifold->dimensions().tangent * path.free_count();
  if (variables <= m.most_variables) return std::nullopt;
  return std::string("nlopt ") + m.name + " is for at most " + std::to_string(m.most_variables) +
         " variables, this path has " + std::to_string(variables) +
         (m.gradient ? ": its time grows with the cube of them"
                     : ": it needs no gradients and many evaluations instead");
}

SolveReport Nlopt::do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  const Method& m = method(options_.algorithm);
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
