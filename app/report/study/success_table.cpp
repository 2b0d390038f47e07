// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What every solver made of every problem.
#include <fmt/format.h>

#include <cmath>

#include "app/plot/text.hpp"
#include "app/report/page/page.hpp"
#include "app/report/study/study_parts.hpp"

namespace leastcost::app {
namespace {

struct Look {
  const char *sign, *style, *words;
};

Look look_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::certified: return {"✓", "good", "certified"};
    case Verdict::other_minimum: return {"○", "other", "other minimum"};
    case Verdict::uncertified: return {"~", "mild", "uncertified"};
    case Verdict::refused: return {"×", "mild", "refused"};
    case Verdict::failed: return {"×", "bad", "failed"};
    case Verdict::absent: break;
  }
  return {"", "", "not tried"};
}

std::string hover_of(const Task& task) {
  std::string text = task.reason;
  if (task.evaluations.count > 0) text += fmt::format("; {} evaluations", count_text(task.evaluations.median));
  if (task.seconds.count > 0) text += "; " + duration_text(task.seconds.median);
  if (task.seconds.count > 1)
    text += fmt::format(" ({} to {}, {} repetitions)", duration_text(task.seconds.least),
                        duration_text(task.seconds.greatest), task.seconds.count);
  if (std::isfinite(task.excess)) text += "; above the best chain by " + number_text(task.excess, 2);
  if (task.same_cost && task.excess > kSolved) text += ", at the same certified cost";
  if (std::isfinite(task.optimum_error)) text += "; off the optimum by " + number_text(task.optimum_error, 2);
  return text;
}

/// Of the certified solves; null without one.
const Task* quickest(const Group& group) {
  const Task* best = nullptr;
  for (const Task& task : group.tasks)
    if (task.verdict == Verdict::certified && task.seconds.count > 0 &&
        (best == nullptr || task.seconds.median < best->seconds.median))
      best = &task;
  return best;
}

/// `best`: the quickest certified solve of the problem.
Cell cell_of(const Task& task, bool best) {
  const Look look = look_of(task.verdict);
  if (task.verdict == Verdict::absent) return {""};
  if (task.verdict == Verdict::refused || task.verdict == Verdict::failed)
    return {fmt::format("{} {}", look.sign, look.words), look.style, hover_of(task)};
  return {fmt::format("{} {}\n{}", look.sign, duration_text(task.seconds.median), count_text(task.evaluations.median)),
          look.style + std::string(best ? " best" : ""), hover_of(task)};
}

}  // namespace

std::string success_table(const StudyAnalysis& study) {
  Table table{{{"problem"}}, {}, "matrix"};
  for (const std::string& solver : study.solvers) table.columns.push_back({solver});
  for (const Group& group : study.groups) {
    const Task* best = quickest(group);
    std::vector<Cell> row = {{group.label}};
    for (const Task& task : group.tasks) row.push_back(cell_of(task, &task == best));
    table.rows.push_back(std::move(row));
  }
  return html(table);
}

}  // namespace leastcost::app
