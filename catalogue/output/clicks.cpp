// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/clicks.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "problems/clicks/click_data.hpp"

namespace leastcost {
namespace {

using Json = nlohmann::ordered_json;

Json content_of(const ClickedMesh& mesh) {
  if (mesh.too_large > 0) return {{"too_large", mesh.too_large}};
  Json out = {{"vertices", mesh.vertices}, {"triangles", mesh.triangles}};
  if (!mesh.numbers.empty()) out["numbers"] = mesh.numbers;
  return out;
}

/// null: infinite.
Json side_of_box(const Eigen::VectorXd& x) {
  Json out = Json::array();
  for (const double value : x) out.push_back(std::isfinite(value) ? Json(value) : Json());
  return out;
}

Json content_of(const ClickedPlan& plan) {
  if (plan.too_large > 0) return {{"too_large", plan.too_large}};
  Json out = {{"corners", plan.corners}, {"counts", plan.counts}, {"required", plan.required}};
  if (plan.lower.size() > 0) out["box"] = {{"lower", side_of_box(plan.lower)}, {"upper", side_of_box(plan.upper)}};
  return out;
}

}  // namespace

std::string clicks_json(const Problem& problem) {
  const ClickData data = click_data(problem);
  Json out = {{"schema_version", 1}};
  if (data.mesh) out["mesh"] = content_of(*data.mesh);
  if (data.plan) out["plan"] = content_of(*data.plan);
  return out.size() > 1 ? out.dump() + "\n" : "";
}

}  // namespace leastcost
