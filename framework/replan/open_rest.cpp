// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/replan/open_rest.hpp>

#include <typeinfo>

#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/framework/energy/chain_model.hpp>
#include <leastcost/framework/energy/path_energy.hpp>

namespace leastcost {
namespace {

bool has_places_for_coordinates(const ConstraintManifold& open) {
  return open.shape() == Shape::flat && find_ability<HasChart>(open) == nullptr;
}

}  // namespace

bool OpenRest::holds(const Problem& problem, const CoordinatePath& path, double cost, const Deadline& deadline) {
  constexpr double kAtRest = 1e-12;  // of the cost
  const ConstraintManifold* open = problem.manifold->decorated(typeid(void));
  if (open == nullptr || !(cost > 0)) return false;
  if (remembers(problem, *open, path.u)) return true;
  Problem without = problem;
  without.manifold = std::shared_ptr<const ConstraintManifold>(problem.manifold, open);
  try {
    PathEnergy energy(without, cost / static_cast<double>(path.segment_count()), deadline);
    ChainModel model;
    if (!model.evaluate(energy, path)) return false;
    model.solve(energy, path, HessianKind::exact);
    if (!model.exact || !(model.cost_error <= kAtRest)) return false;
  } catch (const Interrupted&) {
    return false;
  }
  remember(problem, *open, path.u);
  return true;
}

bool OpenRest::remembers(const Problem& problem, const ConstraintManifold& open, const Points& u) const {
  if (cost_ == nullptr || problem.cost != cost_ || problem.ring || !has_places_for_coordinates(open)) return false;
  const auto* box = find_ability<HasBox>(open);
  const auto same = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return a.size() == b.size() && a == b; };
  if (box == nullptr ? lower_.size() > 0 : !(same(box->box_lower(), lower_) && same(box->box_upper(), upper_)))
    return false;
  return u.rows() == u_.rows() && u.cols() == u_.cols() && u == u_;
}

void OpenRest::remember(const Problem& problem, const ConstraintManifold& open, const Points& u) {
  cost_ = nullptr;
  if (problem.ring || !has_places_for_coordinates(open)) return;
  const auto* box = find_ability<HasBox>(open);
  lower_ = box != nullptr ? box->box_lower() : Eigen::VectorXd();
  upper_ = box != nullptr ? box->box_upper() : Eigen::VectorXd();
  cost_ = problem.cost;
  u_ = u;
}

}  // namespace leastcost
