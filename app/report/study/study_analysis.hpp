// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/report/study/profiles.hpp"
#include "app/study/rows/run_table.hpp"
#include "app/study/study_summary.hpp"

namespace leastcost::app {

/// What a solver made of a discrete problem.
enum class Verdict {
  certified,      ///< at the least certified cost of all solvers
  other_minimum,  ///< certified, but a locally least-cost path that costs more
  uncertified,    ///< a path came back that cannot be trusted, or a limit stopped the solver
  refused,        ///< the solver said beforehand that it cannot
  failed,         ///< no path
  absent          ///< not tried
};
inline constexpr std::size_t kVerdicts = 6;

/// The relative cost excess over the best chain of all solvers at which a problem counts as solved.
inline constexpr double kSolved = 1e-10;

/// How a solver came down in one repetition.
struct Descent {
  std::vector<double> evaluations, seconds;
  std::vector<double> excess;  ///< of cost over the best chain of all solvers, relative
  std::vector<double> left;    ///< of the way down, (E - E*) / (E0 - E*)
  /// Certified at the least certified cost. The chains of equal paths on a mesh have different energies: where the
  /// points lie beside the kinks is in the energy and not in the cost; so such a run counts as solved at its end,
  /// wherever its chain lies.
  bool same_cost = false;
  double all_evaluations = 0, all_seconds = 0;  ///< of the whole run
};

/// All repetitions of one solver on one discrete problem.
struct Task {
  Verdict verdict = Verdict::absent;
  std::string reason;           ///< outcome, status, termination, failures, message
  Spread seconds, evaluations;  ///< of the solve, over repetitions
  bool same_cost = false;       ///< of the first repetition, see Descent
  double excess = 0;            ///< of the delivered chain, relative cost; NaN without one
  double solver_error = 0;      ///< as measured by us for every solver alike
  double optimum_error = 0,
         bar = 0;          ///< of the reported value, relative to the true least cost; NaN where that is not known
  double chain_error = 0;  ///< the same of the cost of the chain
  Descent descent;         ///< of the first repetition
  std::vector<Descent> repetitions;  ///< of all
};

/// Rows that differ in the solver and the repetition only.
struct Group {
  std::string problem, label;  ///< label: problem and whatever else varies in the study
  long points = 0;
  std::string rest;         ///< what else varies, without problem and points
  std::vector<Task> tasks;  ///< one per solver of the study
};

struct StudyAnalysis {
  std::vector<std::string> solvers;
  std::vector<Group> groups;
};

/// Groups the rows, finds the best chain of every group and measures all others against it.
StudyAnalysis analyse(const RunTable& runs, const std::vector<TraceRow>& traces);

/// The same study with its first groups only, for what has a line or a figure for each of them.
StudyAnalysis first_groups(const StudyAnalysis& study, std::size_t most);

enum class Work { evaluations, seconds };

/// What has to fall to the tolerance.
enum class Test {
  excess,  ///< of cost, relative
  left     ///< of the way down: E <= E* + tau (E0 - E*), the test of More and Wild
};

/// The work to a tolerance of tau, per group and solver: the median over repetitions; at the latest the whole work of a
/// run with Descent::same_cost. Infinity where it was never reached, and where the solver ended in another minimum or
/// without a path.
WorkTable work_table(const StudyAnalysis& study, Work work, double tau, Test test = Test::excess);

/// How often each solver comes first: ties count for each of them. Times within 10 % of the least are ties, that much
/// is noise.
std::vector<std::size_t> problems_won(const WorkTable& work, Work kind, std::size_t solvers);

}  // namespace leastcost::app
