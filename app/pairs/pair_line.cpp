// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/pairs/pair_line.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "catalogue/output/json_numbers.hpp"
#include "catalogue/output/path_table.hpp"
#include "catalogue/run/ends.hpp"
#include "catalogue/run/search.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const Eigen::VectorXd& values) {
  Json out = Json::array();
  for (const double value : values) out.push_back(number(value));
  return out;
}

/// As it stands in the file; null where it could not be read.
Json given(const EndOptions& end) {
  if (end.vertex) return *end.vertex;
  if (end.lonlat) return numbers(*end.lonlat);
  return end.point ? numbers(*end.point) : Json(nullptr);
}

Json points_json(const RunOutcome& run) {
  const PathTable table = delivered_points(run.parts.problem, run.result);
  Json out = Json::array();
  for (Eigen::Index i = 0; i < table.x.cols(); ++i) out.push_back(numbers(table.x.col(i)));
  return out;
}

Json notes_of(const RunOutcome& run) {
  Json out = Json::array();
  for (const std::string& note : run.parts.notes) out.push_back(note);
  for (const std::string& note : run.result.notes) out.push_back(note);
  return out;
}

void add_path(const RunOutcome& run, bool points, Json& out) {
  const Result& result = run.result;
  const Certificate& certificate = result.certificate;
  const CostEstimate& estimate = certificate.estimate;
  out["outcome"] = std::string(word_of(result.status));
  out["certified"] = result.status == Status::certified;
  out["cost"] = number(certificate.measured && !std::isnan(estimate.value) ? estimate.value : result.curve.cost);
  out["error_estimate"] = certificate.measured ? number(estimate.error) : Json(nullptr);
  out["scope"] = certificate.measured ? Json(word_of(certificate.scope)) : Json(nullptr);
  if (certificate.global) {
    out["proof"] = word_of(certificate.global->outcome);
    out["lower_bound"] = number(certificate.global->lower_bound);
  }
  if (!certificate.failures.empty()) {
    Json failures = Json::array();
    for (const CertificateFailure& failure : certificate.failures) failures.push_back(failure.name());
    out["failures"] = std::move(failures);
  }
  if (run.parts.source.given.size() > 0 && (run.parts.source.moved > 0 || run.parts.target.moved > 0))
    out["moved"] = {number(run.parts.source.moved), number(run.parts.target.moved)};
  if (Json notes = notes_of(run); !notes.empty()) out["notes"] = std::move(notes);
  if (points) out["points"] = points_json(run);
}

/// Of a place with itself: nothing is to be searched, and nothing costs less.
void add_one_place(const Problem& problem, bool points, Json& out) {
  out["outcome"] = std::string(word_of(Status::certified));
  out["certified"] = true;
  out["cost"] = 0.0;
  out["error_estimate"] = 0.0;
  out["scope"] = word_of(Scope::global);
  out["proof"] = word_of(ProofOutcome::proved);
  out["lower_bound"] = 0.0;
  if (points) out["points"] = Json::array({numbers(source_position(problem))});
}

void add_fault(const char* outcome, const std::string& message, long line, Json& out) {
  out["outcome"] = outcome;
  out["certified"] = false;
  out["cost"] = nullptr;
  out["line"] = line;  // of the file of pairs
  out["message"] = message;
}

/// Everything of the line but the seconds.
void find(const PairComposer& composer, const PairRow& row, bool points, const Monitor& monitor, Json& out) {
  const auto refuse = [&](const char* outcome, const std::string& message) {
    add_fault(outcome, message, row.line, out);
  };
  if (!row.fault.empty()) return refuse("bad_pair", row.fault);
  try {
    RunOutcome run;
    try {
      run.parts = composer.compose(row.source, row.target);
    } catch (const OptionError& e) {
      return refuse("bad_pair", e.key() + ": " + e.what());
    }
    if (are_one_place(run.parts.problem)) return add_one_place(run.parts.problem, points, out);
    search(run, composer.config().max_seconds, monitor);
    add_path(run, points, out);
  } catch (const StoppedEarly& e) {
    refuse("interrupted", e.what());
  } catch (const InitializationError& e) {
    refuse("no_path", e.what());
  } catch (const std::bad_alloc&) {
    throw;  // the next pair would fare no better
  } catch (const std::exception& e) {
    refuse("error", e.what());
  }
}

double number_in(const Json& json, const char* key) {
  const auto at = json.find(key);
  return at != json.end() && at->is_number() ? at->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string text_in(const Json& json, const char* key) {
  const auto at = json.find(key);
  return at != json.end() && at->is_string() ? at->get<std::string>() : std::string();
}

PairFacts facts_in(const Json& json) {
  PairFacts facts;
  facts.number = json.at("pair").get<long>();
  facts.outcome = json.at("outcome").get<std::string>();
  facts.proof = text_in(json, "proof");
  facts.error = number_in(json, "error_estimate") / std::abs(number_in(json, "cost"));
  facts.seconds = number_in(json, "seconds");
  return facts;
}

}  // namespace

PairLine solve_pair(const PairComposer& composer, const PairRow& row, bool points, const Monitor& monitor) {
  const auto start = std::chrono::steady_clock::now();
  Json out = {{"pair", row.number}, {"source", given(row.source)}, {"target", given(row.target)}};
  find(composer, row, points, monitor, out);
  out["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {out.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n", facts_in(out)};
}

PairFacts read_pair_line(const std::string& text) {
  try {
    return facts_in(Json::parse(text));
  } catch (const Json::exception& e) {
    throw InputError(fmt::format("not a line of a run of pairs: {}", e.what()));
  }
}

}  // namespace leastcost::app
