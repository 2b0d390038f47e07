// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/report/profiles.hpp"
#include "app/study/run_table.hpp"
#include "app/study/study_summary.hpp"

namespace leastcost::app {

/// What a solver made of a discrete problem.
enum class Verdict {
  certified,      ///< at the best chain that any solver found
  other_minimum,  ///< certified, but a locally least-cost path that costs more
  uncertified,    ///< a path came back that cannot be trusted, or a limit stopped the solver
  failed,         ///< no path
  absent          ///< not tried
};

/// How a solver came down: relative cost excess over the best chain of all solvers.
struct Descent {
  std::vector<double> evaluations, seconds, excess;
};

/// All repetitions of one solver on one discrete problem.
struct Task {
  Verdict verdict = Verdict::absent;
  std::string reason;           ///< outcome, status, termination, failures, message
  Spread seconds, evaluations;  ///< of the solve, over repetitions
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

enum class Work { evaluations, seconds };

/// The work to a relative cost excess of tau, per group and solver: the median over repetitions; infinity where it was never reached, and where the solver ended in
/// another minimum or without a path.
WorkTable work_table(const StudyAnalysis& study, Work work, double tau);

}  // namespace leastcost::app
