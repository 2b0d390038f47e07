// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/result/delivery.hpp"

#include <cmath>
#include <limits>
#include <new>
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
  for (const auto& step : options.post_processors) {
    look_at_clock(monitor.deadline);
    PostProcessed processed = step->apply(problem, first, so_far, monitor);
    check_processed(problem, chain, processed);
    so_far = std::move(processed);
  }
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
