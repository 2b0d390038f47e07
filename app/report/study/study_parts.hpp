// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

// The parts of the report on a study. All return HTML, the figures SVG.
#include <string>
#include <vector>

#include "app/plot/chart.hpp"
#include "app/report/study/study_analysis.hpp"

namespace leastcost::app {

/// "1.20 ms".
std::string duration_text(double seconds);
/// Of evaluations, which may be a median: "20004".
std::string count_text(double count);

/// One row per solver: how often it succeeded, what it needed.
std::string solver_table(const StudyAnalysis& study);
/// One row per group, one column per solver: verdict, time, evaluations.
std::string success_table(const StudyAnalysis& study);
/// Per group the solvers that needed the least.
std::string winners_table(const StudyAnalysis& study);

/// A figure that also becomes a file of its own; no charts: the study has nothing to show there.
struct StudyFigure {
  std::string file;  ///< "performance.svg"
  std::string title, description;
  std::vector<Chart> panels;
};
/// Performance profiles by time and evaluations.
StudyFigure performance_figure(const StudyAnalysis& study);
/// Data profiles by evaluations, strict and loose.
StudyFigure data_figure(const StudyAnalysis& study);
/// Evaluations to kSolved against the number of points, a panel per problem; empty unless the points vary.
StudyFigure evaluations_figure(const StudyAnalysis& study);
StudyFigure seconds_figure(const StudyAnalysis& study);
/// Error of chain and reported value against the number of segments, n + 1 as for open paths.
StudyFigure order_figure(const StudyAnalysis& study);
/// The slopes of its lines.
std::string order_table(const StudyAnalysis& study);

/// How much the evaluations grow from the fewest points to the most.
std::string growth_table(const StudyAnalysis& study);
/// Times to kSolved as multiples of those of the first solver of the study, for every number of points.
std::string ratio_table(const StudyAnalysis& study);
/// A dot per solver and problem: distance from the true least cost. SVG; empty where no optimum is known.
std::string accuracy_svg(const StudyAnalysis& study, bool standalone);
/// Per group, all solvers: relative excess against evaluations and time.
std::string convergence_charts(const StudyAnalysis& study);

}  // namespace leastcost::app
