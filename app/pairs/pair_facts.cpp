// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/pairs/pair_facts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost::app {
namespace {

using Json = nlohmann::ordered_json;

double number_in(const Json& json, const char* key) {
  const auto at = json.find(key);
  return at != json.end() && at->is_number() ? at->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string text_in(const Json& json, const char* key) {
  const auto at = json.find(key);
  return at != json.end() && at->is_string() ? at->get<std::string>() : std::string();
}

}  // namespace

PairFacts facts_of(const PairResult& result) {
  return {result.number, result.outcome, result.proof ? std::string(word_of(*result.proof)) : "",
          result.error / std::abs(result.cost), result.seconds};
}

PairFacts read_pair_line(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    PairFacts facts;
    facts.number = json.at("pair").get<long>();
    facts.outcome = json.at("outcome").get<std::string>();
    facts.proof = text_in(json, "proof");
    facts.error = number_in(json, "error_estimate") / std::abs(number_in(json, "cost"));
    facts.seconds = number_in(json, "seconds");
    return facts;
  } catch (const Json::exception& e) {
    throw InputError(fmt::format("not a line of a run of pairs: {}", e.what()));
  }
}

}  // namespace leastcost::app
