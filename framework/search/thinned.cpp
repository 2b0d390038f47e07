// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/thinned.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/certificate/shared_failures.hpp"
#include "framework/energy/spacing.hpp"
#include "framework/search/dearer_than_first.hpp"

namespace leastcost {
namespace {

/// Every `factor`-th point of a chain.
CoordinatePath every(const CoordinatePath& fine, Index factor) {
  CoordinatePath path{Points(fine.u.rows(), (fine.u.cols() - 1) / factor + 1), {}, fine.ring, fine.closing};
  for (Index i = 0; i < path.u.cols(); ++i) {
    path.u.col(i) = fine.u.col(factor * i);
    if (!fine.sites.empty()) path.sites.push_back(fine.site(factor * i));
  }
  return path;
}

}  // namespace

Result thinned(const Problem& problem, Result finer, Index factor, const Search& search) {
  if (factor == 1) return finer;
  CoordinatePath path = every(finer.path, factor);
  const std::string note = (finer.status == Status::certified ? "found and certified with " : "found with ") +
                           std::to_string(finer.path.free_count()) + " points; ";
  if (!are_clear(problem, path, search.options.certificate.clearance, search.monitor.deadline)) {
    finer.notes.push_back(note + "all of them are delivered: moves between fewer points might touch an obstacle");
    return finer;
  }
  finer.notes.push_back(note + "every " + (factor == 2 ? "2nd" : std::to_string(factor) + "th") +
                        " of them is delivered");
  finer.path = std::move(path);
  const Index segments = finer.path.segment_count();
  const Eigen::VectorXd fine = finer.curve_costs;
  finer.curve_costs.resize(segments);
  for (Index i = 0; i < segments; ++i) finer.curve_costs[i] = fine.segment(factor * i, factor).sum();
  finer.costs = PathEnergy(problem, 1).costs(finer.path);
  return finer;
}

void judge_delivered_spacing(const Problem& problem, Index factor, Result& finer) {
  Certificate& c = finer.certificate;
  const bool thinned =
      factor > 1 && finer.costs.size() >= 2 * factor && find_ability<ChecksMoves>(*problem.manifold) == nullptr;
  if (!thinned || problem.manifold->shape() != Shape::polyhedral || finer.curve.straightness || !c.measured) return;
  const Index segments = finer.costs.size() / factor;
  Eigen::VectorXd costs(segments);
  for (Index i = 0; i < segments; ++i) costs[i] = finer.costs.segment(factor * i, factor).sum();
  c.spacing = spread(costs);
  const auto is_spacing = [](const CertificateFailure& failure) { return failure.kind == Failure::spacing; };
  if (!(c.spacing <= kPolyhedronSpacing)) return;
  c.failures.erase(std::remove_if(c.failures.begin(), c.failures.end(), is_spacing), c.failures.end());
  if (finer.status == Status::uncertified && c.certified()) finer.status = Status::certified;
}

}  // namespace leastcost
