// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/clicks.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "problems/clicks/click_data.hpp"

namespace leastcost {
namespace {

using Json = nlohmann::ordered_json;

/// As Json writes them; tens of thousands of values of Json would take longer than the search.
template <class Number>
std::string list_text(const std::vector<Number>& numbers) {
  std::string text = "[";
  text.reserve(numbers.size() * 10 + 2);
  for (const Number number : numbers) {
    if (text.size() > 1) text += ',';
    if constexpr (std::is_integral_v<Number>)
      fmt::format_to(std::back_inserter(text), "{}", number);
    else if (std::isfinite(number)) {
      std::array<char, 64> digits{};
      text.append(digits.data(), nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(), number));
    } else
      text += "null";
  }
  return text + "]";
}

std::string content_of(const ClickedMesh& mesh) {
  if (mesh.too_large > 0) return fmt::format("{{\"too_large\":{}}}", mesh.too_large);
  std::string text = "{\"vertices\":" + list_text(mesh.vertices) + ",\"triangles\":" + list_text(mesh.triangles);
  if (!mesh.numbers.empty()) text += ",\"numbers\":" + list_text(mesh.numbers);
  return text + "}";
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
  if (!data.mesh && !data.plan) return "";
  std::string text = "{\"schema_version\":1";
  if (data.mesh) text += ",\"mesh\":" + content_of(*data.mesh);
  if (data.plan) text += ",\"plan\":" + content_of(*data.plan).dump();
  return text + "}\n";
}

}  // namespace leastcost
