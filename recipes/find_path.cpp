// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/recipes/find_path.hpp>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/recipes/look_elsewhere.hpp>
#include <leastcost/recipes/recommended.hpp>

namespace leastcost {
namespace {

std::string note_on(const OtherWay& way) {
  std::ostringstream out;
  out.precision(4);
  out << "another path costs about " << way.cost << ", ";
  out.precision(2);
  out << 100 * way.less << " % less; to start from it, use ";
  out.precision(6);
  out << "find_path(problem, BowInitializer({.height = " << way.bow.height << ", .angle = " << way.bow.angle
      << "}), solver)";
  return out.str();
}

}  // namespace

Result find_path(const Problem& problem, const FindOptions& options, const Monitor& monitor) {
  const Recipe recipe = recommended(problem, options);
  if (!recipe.initializer)
    throw InputError("a ring has no default first path: call find_path(problem, initializer, solver) with one");
  FindOptions chosen = options;
  for (const auto& step : recipe.post_processors) {
    const bool given = std::any_of(options.post_processors.begin(), options.post_processors.end(),
                                   [&](const auto& other) { return other && other->name() == step->name(); });
    if (!given) chosen.post_processors.push_back(step);
  }
  const Problem complete = with_kernel(problem);
  Result result = find_path(complete, *recipe.initializer, *recipe.solver, chosen, monitor);
  if (!recipe.one_way || monitor.deadline || result.status == Status::interrupted) return result;
  const std::optional<OtherWay> other = look_elsewhere(complete, *recipe.solver, result, options.points, monitor);
  if (other) result.notes.push_back(note_on(*other));
  return result;
}

}  // namespace leastcost
