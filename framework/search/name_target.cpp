// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/name_target.hpp"

#include <optional>
#include <vector>

#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/result/other_images.hpp>

namespace leastcost {

void name_target_over_pole(const Search& search, Outcome& out) {
  constexpr double kAtMost = 1.5;  // of the line to the target itself: no promise beyond
  const Problem& problem = out.problem;
  const auto* chart = find_ability<HasChart>(*problem.manifold);
  if (search.options.target_as_given || problem.ring || problem.based || chart == nullptr || chart->poles().size() != 2)
    return;
  Monitor quiet = search.monitor;
  quiet.observe = nullptr;
  const std::vector<TriedImage> tried = other_images(problem, quiet.limit());
  if (tried.empty() || !(tried.front().cost < kAtMost * straight_start_cost(problem, quiet.limit()))) return;
  if (const std::optional<CheaperImage> best = find_cheaper_image(problem, quiet))
    out.asked.target.u = out.problem.target.u = best->image.u;
}

void name_target_of_first_path(const Search& search, Outcome& out) {
  const Points& u = out.result.first.path.u;
  if (search.options.target_as_given || out.problem.ring || u.cols() < 2) return;
  out.asked.target.u = out.problem.target.u = nearest_name(out.problem, out.problem.target.u, u.col(u.cols() - 2));
}

}  // namespace leastcost
