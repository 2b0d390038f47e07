// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/study/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <leastcost/framework/base/errors.hpp>
#include "app/plot/legend.hpp"
#include "app/plot/text.hpp"
#include "app/report/page/json_file.hpp"
#include "app/report/page/page.hpp"
#include "app/report/page/provenance.hpp"
#include "app/report/study/study_parts.hpp"

namespace leastcost::app {
namespace {

namespace fs = std::filesystem;

struct Counts {
  std::size_t problems = 0, tasks = 0;
  int of[kVerdicts] = {};
  int operator[](Verdict v) const { return of[static_cast<int>(v)]; }
};

Counts count(const StudyAnalysis& study) {
  Counts counts;
  std::set<std::string> problems;
  for (const Group& g : study.groups) {
    problems.insert(g.problem);
    for (const Task& t : g.tasks) {
      ++counts.of[static_cast<int>(t.verdict)];
      counts.tasks += t.verdict != Verdict::absent ? 1 : 0;
    }
  }
  counts.problems = problems.size();
  return counts;
}

std::string most_often(const StudyAnalysis& study, Work kind, std::size_t& times) {
  const std::vector<std::size_t> first = problems_won(work_table(study, kind, kSolved), kind, study.solvers.size());
  const auto winner = std::max_element(first.begin(), first.end());
  times = winner == first.end() ? 0 : *winner;
  return winner == first.end() ? "" : study.solvers[static_cast<std::size_t>(winner - first.begin())];
}

/// "1 solver", "2 solvers".
std::string counted(std::size_t number, const char* what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

std::vector<KeyFigure> key_figures_of(const StudyAnalysis& study, const Counts& counts) {
  std::size_t fastest_times = 0, fewest_times = 0;
  const std::string fastest = most_often(study, Work::seconds, fastest_times),
                    fewest = most_often(study, Work::evaluations, fewest_times);
  const std::size_t groups = study.groups.size();
  return {{"problems", std::to_string(counts.problems),
           groups == counts.problems ? "" : fmt::format("{} with all variations", groups)},
          {"solvers", std::to_string(study.solvers.size()), counted(counts.tasks, "solve")},
          {"certified", std::to_string(counts[Verdict::certified]),
           fmt::format("{} other minima, {} uncertified, {} refused, {} failed", counts[Verdict::other_minimum],
                       counts[Verdict::uncertified], counts[Verdict::refused], counts[Verdict::failed])},
          {"fastest", fastest, fmt::format("in {} of {}, within 10 %", fastest_times, groups)},
          {"fewest evaluations", fewest, fmt::format("in {} of {}, ties count", fewest_times, groups)}};
}

/// `missing`: runs of the study that have no result (yet), as in a merge of some of its parts.
Headline headline_of(const std::string& name, const StudyAnalysis& study, const Counts& counts, std::size_t missing) {
  Headline headline{"study", name, counted(counts.problems, "problem") + ", " + counted(study.solvers.size(), "solver"),
                    "", "good"};
  headline.verdict = fmt::format("{} of {} certified", counts[Verdict::certified], counted(counts.tasks, "solve"));
  if (missing > 0) headline.verdict = "incomplete, " + counted(missing, "run") + " missing: " + headline.verdict;
  if (counts[Verdict::failed] > 0)
    headline.style = "bad";
  else if (counts[Verdict::uncertified] > 0 || missing > 0)
    headline.style = "mild";
  return headline;
}

std::string sample_of(const Series& s) {
  std::string out;
  if (s.style.line) out = fmt::format("<path {} d=\"M1 6h28\"/>", stroke_of(s.style));
  if (s.style.markers || s.marks > 0) out += marker(s.style, 15, 6);
  return out;
}

/// On a page one legend stands above all panels; in the file of the figure the last panel has it.
std::string drawn(const StudyFigure& figure, const std::string& caption) {
  std::vector<LegendEntry> legend;
  for (const Series& s : figure.panels.back().series)
    if (!s.name.empty()) legend.push_back({sample_of(s), s.name});
  std::vector<std::string> svgs;
  for (Chart chart : figure.panels) {
    chart.legend = false;
    if (figure.panels.size() > 1) chart.width = figure.panels.front().width;
    svgs.push_back(svg(chart));
  }
  return (legend.empty() ? "" : legend_html(legend, false)) + figures(svgs, caption);
}

/// A section with a figure, and the figure as a file; nothing when the study has nothing to show there.
void add_figure(const std::string& title, const StudyFigure& figure, const std::string& caption,
                const std::string& more, std::string& body, std::vector<ReportFile>& files) {
  if (figure.panels.empty()) return;
  body += section(title, drawn(figure, caption) + more);
  files.push_back({figure.file, panels_svg(figure.title, figure.description, figure.panels)});
}

std::string legend_of_success() {
  return "<p class=\"soft\"><b class=\"good\">✓</b> certified, at the least certified cost of the problem; <b "
         "class=\"other\">○</b> certified, another minimum, which costs more; <b class=\"mild\">~</b> uncertified, "
         "collapsed or interrupted; <b class=\"mild\">×</b> refused: the solver does not support the problem; <b "
         "class=\"bad\">×</b> failed: no path. Time and evaluations are for the whole solve; bold: the fastest "
         "certified solve. A wide table scrolls sideways. Hover for reasons.</p>\n";
}

/// Some methods do not stop where the discrete problem is solved; whoever compares them should know.
std::string rules_of_their_own(const StudyAnalysis& study) {
  const auto has = [&](const char* name) {
    return std::any_of(study.solvers.begin(), study.solvers.end(),
                       [&](const std::string& solver) { return solver.starts_with(name); });
  };
  if (!has("georce") && !has("string") && !has("vfcs")) return "";
  return paragraph(
      "vfcs stops by the rule of its paper. georce and string end at a fixed point of their own, which is not the "
      "least energy of the chain. They can stop, and be certified, without coming within 1e-10 of the others.",
      "soft");
}

/// Where times are ranked that one run more may rank otherwise.
std::string trust_in_times(const StudyAnalysis& study) {
  constexpr double kApart = 1.5;  // greatest over least
  std::size_t tasks = 0, apart = 0, most = 0;
  for (const Group& g : study.groups)
    for (const Task& t : g.tasks) {
      if (t.seconds.count == 0) continue;
      ++tasks;
      most = std::max(most, t.seconds.count);
      apart += t.seconds.greatest > kApart * t.seconds.least ? 1 : 0;
    }
  if (tasks == 0) return "";
  if (most == 1)
    return paragraph(
        "Each time is that of one repetition: ranks by time may be chance. With “repetitions: 5” in the study, times "
        "are medians.",
        "warning");
  if (4 * apart <= tasks) return "";
  return paragraph(fmt::format("The machine was busy: in {} of {} solves the slowest repetition took more than {:g} "
                               "times as long as the fastest. Ranks by time may be chance; evaluations are exact.",
                               apart, tasks, kApart),
                   "warning");
}

std::string meaning_of_solved() {
  return paragraph(
      "Solved: at some time in its run, the solver came within a relative cost excess of 1e-10 over the best chain of "
      "all solvers, or it was certified at the least certified cost. Certified: the delivered path passed the tests of "
      "the framework. Times within 10 % are ties; ties count for each solver.",
      "soft");
}

constexpr std::size_t kMostShown = 500;  ///< groups of which a page has a line or a figure each

/// What does not have room on a page.
std::string only_the_first(const StudyAnalysis& study) {
  if (study.groups.size() <= kMostShown) return "";
  return paragraph(
      fmt::format("Here and below, only the first {} of {} problems are shown one by one; runs.csv has all.",
                  kMostShown, study.groups.size()),
      "soft");
}

std::string fold(const std::string& title, const std::string& body) { return body.empty() ? "" : section(title, body); }

}  // namespace

std::vector<ReportFile> study_report(const fs::path& folder) {
  const auto read = [&](const char* name) { return text_of_file(folder / name); };
  const auto shown = [&](const char* name) { return (folder / name).string(); };
  const JsonFile manifest(folder / "manifest.json"), summary(folder / "summary.json");
  const RunTable runs = read_runs_csv(read("runs.csv"), shown("runs.csv"));
  if (runs.rows.empty()) throw InputError(shown("runs.csv") + ": has no rows: nothing has been run yet");
  const StudyAnalysis study = analyse(runs, read_traces_csv(read("traces.csv"), shown("traces.csv")));
  const StudyAnalysis shown_part = first_groups(study, kMostShown);
  const Counts counts = count(study);
  std::vector<ReportFile> files(1);
  std::string body = key_figures(key_figures_of(study, counts));
  body +=
      section("Solvers", trust_in_times(study) + solver_table(study) + meaning_of_solved() + rules_of_their_own(study));
  body += section("The best of each problem", only_the_first(study) + winners_table(shown_part) +
                                                  paragraph("Time and evaluations to a relative cost excess of 1e-10; "
                                                            "the solve continues until its own stopping test.",
                                                            "soft"));
  body += section("Which solver for which problem", legend_of_success() + success_table(shown_part));
  add_figure(
      "Work against the number of points", evaluations_figure(shown_part),
      "Evaluations to a relative cost excess of 1e-10 over the best chain of all solvers. An evaluation is an energy "
      "or a gradient of the whole path. Hessians and factorisations are counted separately (in runs.csv), so time is "
      "the fairer measure between first-order and second-order methods. A solver whose work does not depend on the "
      "number of points is flat. It has no marker where it never reaches the excess.",
      growth_table(shown_part), body, files);
  add_figure("Time against the number of points", seconds_figure(shown_part), "Seconds to the same excess.",
             ratio_table(shown_part), body, files);
  add_figure(
      "Performance profiles", performance_figure(study),
      "Dolan and Moré (2002): the share of problems that a solver solves to 1e-10 within a multiple of the work of the "
      "best one. The left edge shows how often it is the best. A problem is solved when the solver comes within that "
      "relative cost excess of the best chain of all solvers. It is also solved, at the latest at the end of the run, "
      "when it is certified at the least certified cost. Refusals, failures and other minima are not solved.",
      "", body, files);
  add_figure("Data profiles", data_figure(study),
             "Moré and Wild (2009), with evaluations instead of simplex gradients: the share of problems on which a "
             "solver reaches E ≤ E* + τ (E₀ − E*) within a budget, for τ = 10⁻⁵ and 10⁻¹⁰. E₀ is the energy of its "
             "first path and E* the least energy of all solvers. Runs certified at the least certified cost reach it "
             "at the latest at their end.",
             "", body, files);
  if (const std::string accuracy = accuracy_svg(shown_part, false); !accuracy.empty()) {
    body += section(
        "Accuracy",
        figures({accuracy},
                "Blue: the first solver of the study with a certified path; grey: the others; stroke: its error bar. "
                "An error to the left of its stroke is within the bar. Errors of zero are drawn at 10⁻¹⁷."));
    files.push_back({"accuracy.svg", accuracy_svg(shown_part, true)});
  }
  add_figure("Order", order_figure(shown_part), "For the first solver with a certified path.", order_table(shown_part),
             body, files);
  body += fold("Convergence", convergence_charts(shown_part));
  body += section("Configuration", "<pre>" + escaped(read("study.resolved.yaml")) + "</pre>\n", false);
  body += section("Provenance", provenance_part(manifest), false);
  files[0] = {"report.html", page(headline_of(summary.text("name"), study, counts, summary.size("missing")), body, "")};
  return files;
}

}  // namespace leastcost::app
