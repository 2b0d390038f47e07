// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/pairs/pair_line.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "catalogue/output/json_numbers.hpp"

namespace leastcost {
namespace {

using Json = nlohmann::ordered_json;

/// As it was given; null where it could not be read.
Json end_json(const EndOptions& end) {
  if (end.vertex) return *end.vertex;
  if (end.face && end.barycentric) return {{"face", *end.face}, {"barycentric", numbers(*end.barycentric)}};
  if (end.lonlat) return numbers(*end.lonlat);
  if (end.state) return *end.state;
  return end.point ? numbers(*end.point) : Json(nullptr);
}

Json points_json(const Points& points) {
  Json out = Json::array();
  for (Eigen::Index i = 0; i < points.cols(); ++i) out.push_back(numbers(points.col(i)));
  return out;
}

void add_path(const PairResult& result, bool points, Json& out) {
  out["cost"] = number(result.cost);
  out["error_estimate"] = number(result.error);
  out["scope"] = result.scope ? Json(word_of(*result.scope)) : Json(nullptr);
  if (result.proof) {
    out["proof"] = word_of(*result.proof);
    out["lower_bound"] = number(result.lower_bound);
  }
  if (!result.failures.empty()) out["failures"] = result.failures;
  if (result.source_moved > 0 || result.target_moved > 0)
    out["moved"] = {number(result.source_moved), number(result.target_moved)};
  if (!result.notes.empty()) out["notes"] = result.notes;
  if (points) out["points"] = points_json(result.points);
}

}  // namespace

std::string pair_line(const PairResult& result, bool points) {
  Json out = {{"pair", result.number},
              {"source", end_json(result.ends.source)},
              {"target", end_json(result.ends.target)},
              {"outcome", result.outcome},
              {"certified", result.certified()}};
  if (result.found()) {
    add_path(result, points, out);
  } else {
    out["cost"] = nullptr;
    if (result.file_line > 0) out["line"] = result.file_line;
    out["message"] = result.message;
  }
  out["seconds"] = result.seconds;
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace leastcost
