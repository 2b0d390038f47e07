// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/result/delivery.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <optional>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/domain/in_parts.hpp"
#include "framework/result/find_path_checks.hpp"

namespace leastcost {

PostProcessed chain_as_curve(PathEnergy& energy, const CoordinatePath& path) {
  PostProcessed out;
  out.chain = path;
  out.curve_costs = energy.costs(path);
  out.curve.cost = out.curve_costs.sum();
  out.curve.x = energy.ambient(path).x;
  return out;
}

void post_process(const Problem& problem, const FirstPath& first, const FindOptions& options, const Monitor& monitor,
                  PostProcessed& so_far) {
  const CoordinatePath chain = so_far.chain;
  const auto& steps = options.post_processors;
  std::optional<InputError> fault;
  for (auto step = steps.begin(); step != steps.end(); ++step) {
    look_at_clock(monitor.deadline);
    try {
      PostProcessed processed = (*step)->apply(problem, first, so_far, monitor);
      check_processed(problem, chain, processed);
      so_far = std::move(processed);
    } catch (const InputError& error) {
      // A later search over all paths may find a curve where this step could make none of the one that it was given.
      if (!fault) fault = error;
      if (!std::any_of(step + 1, steps.end(), [](const auto& later) { return later->bounds_all_paths(); })) break;
    }
  }
  if (fault && !so_far.curve.global) throw *fault;
}

std::optional<std::string> post_process_or_say_why(const Problem& problem, const FirstPath& first,
                                                   const FindOptions& options, const Monitor& monitor,
                                                   PostProcessed& so_far) {
  try {
    post_process(problem, first, options, monitor, so_far);
    return std::nullopt;
  } catch (const Interrupted&) {
    throw;
  } catch (const std::bad_alloc&) {
    return "not enough memory";
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception not derived from std::exception";
  }
}

void deliver(const PostProcessed& processed, Eigen::VectorXd costs, Result& result) {
  result.costs = std::move(costs);
  result.path = processed.chain;
  result.curve = processed.curve;
  result.curve_costs = processed.curve_costs;
  result.notes.insert(result.notes.end(), processed.notes.begin(), processed.notes.end());
}

void deliver_unmeasured(Result& result) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  result.costs.setConstant(result.path.segment_count(), kUnknown);
  result.curve_costs = result.costs;
  result.curve = {};
  result.curve.cost = kUnknown;
}

bool has_collapsed(const Result& result, const PostProcessed& processed) {
  return processed.collapsed || (result.solve.termination == Termination::collapsed && !processed.curve.straightness);
}

}  // namespace leastcost
