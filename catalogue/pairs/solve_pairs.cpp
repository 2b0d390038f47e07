// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/catalogue/pairs/solve_pairs.hpp>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <exception>
#include <new>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/chart/is_geographic.hpp>
#include <leastcost/problems/manifolds/file_places.hpp>
#include "catalogue/output/path_table.hpp"
#include "catalogue/pairs/ordered_pairs.hpp"
#include "catalogue/pairs/pair_line.hpp"
#include "catalogue/pairs/rows.hpp"
#include "catalogue/run/ends.hpp"
#include "catalogue/run/run_clock.hpp"
#include "catalogue/run/run_origin.hpp"
#include "catalogue/run/search.hpp"

namespace leastcost {
namespace {

/// Why an end from memory is none; empty: it is one. Those of files are checked where they are read.
std::string end_fault(const EndOptions& end) {
  const bool on_face = end.face || end.barycentric;
  if (end.ways() != 1) return EndOptions::kWays;
  if (end.is_several()) return "must be one point: several goals and poses of a tool are for runs of one path";
  if (on_face && !(end.face && end.barycentric && end.barycentric->size() == 3))
    return "must have a face and three barycentric numbers";
  if (end.lonlat && end.lonlat->size() != 2) return "lonlat must have two numbers, longitude and latitude";
  if (end.point && !end.point->allFinite()) return "the point is not finite";
  return "";
}

void add_path(const RunOutcome& run, bool points, PairResult& out) {
  const Result& result = run.result;
  const Certificate& certificate = result.certificate;
  const CostEstimate& estimate = certificate.estimate;
  out.outcome = word_of(result.status);
  out.cost = certificate.measured && !std::isnan(estimate.value) ? estimate.value : result.curve.cost;
  if (certificate.measured) {
    out.error = estimate.error;
    out.scope = certificate.scope;
  }
  if (certificate.global) {
    out.proof = certificate.global->outcome;
    out.lower_bound = certificate.global->lower_bound;
  }
  for (const CertificateFailure& failure : certificate.failures) out.failures.push_back(failure.name());
  if (run.parts.source.given.size() > 0) {
    out.source_moved = run.parts.source.moved;
    out.target_moved = run.parts.target.moved;
  }
  out.notes = run.parts.notes;
  out.notes.insert(out.notes.end(), result.notes.begin(), result.notes.end());
  if (points) out.points = delivered_points(run.parts.problem, result).x;
}

/// Of a place with itself: nothing is to be searched, and nothing costs less.
void add_one_place(const Problem& problem, bool points, PairResult& out) {
  out.outcome = word_of(Status::certified);
  out.cost = out.error = out.lower_bound = 0;
  out.scope = Scope::global;
  out.proof = ProofOutcome::proved;
  if (points) out.points = source_position(problem);
}

/// Everything of the result but the seconds.
void find(const Run& run, const PairRow& row, const PairsOptions& options, PairResult& out) {
  const auto refuse = [&](const char* outcome, std::string message) {
    out.outcome = outcome;
    out.message = std::move(message);
  };
  if (!row.fault.empty()) return refuse("bad_pair", row.fault);
  Monitor monitor;
  if (options.stop_requested) monitor.stop_requested = options.stop_requested;
  try {
    RunOutcome found;
    try {
      found.parts = run.origin->pairs->compose(row.source, row.target, run.parts);
    } catch (const OptionError& e) {
      return refuse("bad_pair", e.what());
    }
    if (are_one_place(found.parts.problem)) return add_one_place(found.parts.problem, options.points, out);
    if (are_one_place_but_for_rounding(found.parts.problem))
      return refuse("bad_pair", "the target is the same point as the source up to rounding; move it");
    search(found, run.max_seconds, monitor);
    add_path(found, options.points, out);
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

PairResult solve_row(const Run& run, const PairRow& row, const PairsOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  PairResult out;
  out.number = row.number;
  out.file_line = row.line;
  out.ends = {row.source, row.target};
  find(run, row, options, out);
  out.seconds = seconds_since(start);
  if (options.lines) out.line = pair_line(out, options.points);
  return out;
}

}  // namespace

PairReader reader_of_pairs(const Run& run) {
  const RunOrigin& origin = *run.origin;
  const Problem& problem = origin.pairs->parts().problem;
  const bool vertices = find_ability<HasVertices>(*problem.manifold) != nullptr;
  const bool on_earth = find_ability<IsGeographic>(*problem.manifold) != nullptr ||
                        find_ability<IsGeographic>(problem.cost.get()) != nullptr;
  return {origin.folder / origin.config.pairs, origin.pairs->coordinates(), vertices, on_earth};
}

bool solve_rows(const Run& run, const std::function<std::optional<PairRow>()>& next, const PairDone& done,
                const PairsOptions& options) {
  if (!run.origin) throw InputError("a run must be made by load_run() or parse_run()");
  if (!run.origin->pairs) throw InputError("solve_pairs() joins pairs of ends, but the run is a ring, which has none");
  if (!run.parts.solver || !run.parts.initializer) throw InputError("the run has no solver or no initializer");
  if (run.parts.problem.manifold != run.origin->parts.problem.manifold)
    throw InputError("solve_pairs() needs the manifold that the configuration was composed with; it was replaced");
  OrderedPairs work;
  work.next = next;
  work.solve = [&](const PairRow& row) { return solve_row(run, row, options); };
  work.done = done;
  work.stop_requested = options.stop_requested;
  work.threads = options.threads;
  return solve_in_order(work);
}

bool solve_pairs(const Run& run, std::span<const EndPair> pairs, const PairDone& done, const PairsOptions& options) {
  std::size_t i = 0;
  const auto next = [&]() -> std::optional<PairRow> {
    if (i == pairs.size()) return std::nullopt;
    const EndPair& pair = pairs[i];
    PairRow row;
    row.number = static_cast<long>(i++);
    row.source = pair.source;
    row.target = pair.target;
    for (const auto& [end, name] : {std::pair(&pair.source, "source"), std::pair(&pair.target, "target")})
      if (const std::string fault = end_fault(*end); !fault.empty() && row.fault.empty())
        row.fault = std::string(name) + ": " + fault;
    return row;
  };
  return solve_rows(run, next, done, options);
}

bool solve_pairs(const Run& run, const PairDone& done, const PairsOptions& options) {
  if (!run.origin || !run.origin->config.has_pairs())
    throw InputError("the configuration names no file of pairs (ends: {pairs: FILE}): hand over the pairs");
  PairReader reader = reader_of_pairs(run);
  return solve_rows(
      run, [&] { return reader.next(); }, done, options);
}

}  // namespace leastcost
