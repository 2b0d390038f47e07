// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include <leastcost/problems/manifolds/made_from_data.hpp>
#include "catalogue/output/json_numbers.hpp"
#include "catalogue/output/output_folder.hpp"
#include "catalogue/output/unit_of_cost.hpp"
#include "catalogue/run/family_ways.hpp"
#include "catalogue/run/memory.hpp"
#include "catalogue/run/run_origin.hpp"
#include "framework/result/never_worse.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::ordered_json;

std::string row(std::string_view label, const std::string& text) { return fmt::format("{:<11} {}\n", label, text); }

const RunConfig& config_of(const WrittenRun& run) { return run.origin->config; }

std::vector<FamilyStart> family_of(const RunParts& parts) {
  return parts.wants_family() ? family_starts(parts) : std::vector<FamilyStart>{};
}

std::string status_line(const WrittenRun& run) {
  const Certificate& c = run.result.certificate;
  std::string line(word_of(run.result.status));
  if (run.result.status == Status::certified)
    return line +
           fmt::format(" ({}{})", word_of(c.scope), c.resolution && c.resolution->minimum_proved ? ", proved" : "");
  if (run.result.status == Status::interrupted) return line;
  if (!c.measured)
    line += run.parts.options.certificate.enabled ? ": the certificate was not measured"
                                                  : ": the certificate is switched off";
  return line;
}

/// The cost of the delivered path, where that is exact and lies beyond the bar of the value, which is that of ever more
/// points. Nothing on a curved domain, where a curve through the points has the value.
std::optional<double> cost_as_delivered(const WrittenRun& run) {
  const CostEstimate& estimate = run.result.certificate.estimate;
  if (!moves_are_exact(run.parts.problem)) return std::nullopt;
  const double own = run.result.curve.cost;
  if (!(std::abs(own - estimate.value) > std::max(estimate.error, 1e-6 * own))) return std::nullopt;
  return own;
}

std::string cost_line(const WrittenRun& run) {
  const Result& result = run.result;
  const std::string unit = unit_of_cost(run.parts.problem);
  const CostEstimate& estimate = result.certificate.estimate;
  if (std::isinf(result.curve.cost)) return "infinite: the cost is not defined along the whole path";
  if (result.status == Status::interrupted && !std::isfinite(estimate.error))
    return fmt::format("{:.15g} {} (interrupted: error not measured)", result.curve.cost, unit);
  if (!result.certificate.measured) return fmt::format("{:.15g} {} (error not measured)", result.curve.cost, unit);
  if (!std::isfinite(estimate.error)) return fmt::format("{:.15g} {} (error unknown)", estimate.value, unit);
  if (const std::optional<double> own = cost_as_delivered(run))
    return fmt::format("{:.9g} {} (the delivered points; {:.9g} +- {:.2g} in the limit of more points: {})", *own, unit,
                       estimate.value, estimate.error, word_of(estimate.method));
  std::string line =
      fmt::format("{:.15g} +- {:.2g} {} ({})", estimate.value, estimate.error, unit, word_of(estimate.method));
  if (const std::optional<double>& geometry = result.certificate.geometry_error)
    line += fmt::format(", and +- {:.2g} from the samples of the domain", *geometry);
  return line;
}

/// What is proved of all paths in a box, or looks so.
std::string bracket_line(const GlobalBound& global) {
  if (global.outcome == ProofOutcome::blocked) return "nothing proved: " + global.reason;
  if (global.counts == "places")
    return fmt::format(
        "no path over the cells is cheaper by more than {:.2g} % ({}, {} points on their sides, {:.2g} s)",
        100 * global.gap, word_of(global.category), global.steps, global.seconds);
  return fmt::format("no path in this box is cheaper by more than {:.2g} % ({}, {} cells, {:.2g} s)", 100 * global.gap,
                     word_of(global.category), fmt::join(global.grid->cells, " x "), global.seconds);
}

constexpr double kFarBelow = 0.01;  // of the cost: a bound that deserves a line

/// What a search over all paths left open, where that is much.
std::string bound_line(const GlobalBound& global) {
  return fmt::format("no path costs less than {:.9g}; a path cheaper than this one was not ruled out: {}",
                     global.lower_bound, global.reason.empty() ? "the search budget is used up" : global.reason);
}

std::string solver_line(const WrittenRun& run) {
  const SolveReport& report = run.result.solve;
  if (!run.parts.solver->moves_points()) return fmt::format("{}: {}", run.parts.solver->name(), report.message);
  std::string line = fmt::format("{}: {} after {} iterations", run.parts.solver->name(), word_of(report.termination),
                                 report.iterations);
  if (report.termination != Termination::converged && !report.message.empty()) line += " (" + report.message + ")";
  return line;
}

const char* shape_of(const WrittenRun& run) {
  if (config_of(run).ring && config_of(run).source) return " (a loop with a fixed point, the source)";
  return run.result.path.ring ? " (ring)" : " and two ends";
}

/// One line per distinct path of the family.
std::string family_rows(const WrittenRun& run) {
  std::string out;
  for (const FamilyMember& m : run.family) {
    const Certificate& c = m.result.certificate;
    out += row(out.empty() ? "family" : "",
               fmt::format("{:.12g}  {}, {}{}  from {}", c.measured ? c.estimate.value : m.result.curve.cost,
                           word_of(m.result.status), word_of(c.index.verdict), m.tied ? ", tied" : "",
                           fmt::join(m.origins, "; ")));
  }
  return out;
}

std::string time_line(const WrittenRun& run) {
  const StageSeconds& s = run.result.seconds;
  const RunSeconds& all = run.seconds;
  constexpr double kWorthSaying = 1e-3;
  const std::string coarser = s.prepare > kWorthSaying ? fmt::format("coarser domains {:.3g} s, ", s.prepare) : "";
  std::string line = fmt::format(
      "read {:.3g} s, compose {:.3g} s, first path {:.3g} s, solve {:.3g} s, post-process {:.3g} s, "
      "{}certify {:.3g} s, write {:.3g} s, report {:.3g} s",
      all.read, all.compose, s.initialize, s.solve, s.post_process, coarser, s.certify, all.write, all.report);
  if (!run.family.empty()) line += fmt::format("; the whole family {:.3g} s", all.search);
  return line;
}

std::string end_line(const PlacedEnd& end) {
  const std::string line = fmt::format("({:.9g})", fmt::join(end.end.u, ", "));
  return end.moved > 0 ? line + fmt::format(", moved by {:.3g} onto the manifold", end.moved) : line;
}

std::vector<DataCount> counts_of(const RunParts& parts) {
  const auto* data = find_ability<MadeFromData>(*parts.problem.manifold);
  return data == nullptr ? std::vector<DataCount>() : data->counts();
}

std::string steps(const Run& prepared) {
  const RunParts& parts = prepared.parts;
  std::string line = fmt::format("{}, {}", prepared.origin->config.initializer.plugin->type, parts.solver->name());
  for (const auto& processor : parts.options.post_processors) line += fmt::format(", {}", processor->name());
  return line + (parts.options.certificate.enabled ? ", certificate" : "");
}

std::string memory_text(int points, const Dimensions& dims) {
  return fmt::format("the path needs about {}; the host has {}", size_in_words(bytes_of_path(points, dims)),
                     size_in_words(memory_of_host()));
}

std::string points_text(const RunConfig& config) {
  return config.points ? std::to_string(*config.points) : "as many as the first edge path has";
}

}  // namespace

std::string summary_text(const WrittenRun& run, bool verbose) {
  const Result& result = run.result;
  std::string out = row("status", status_line(run));
  for (const CertificateFailure& f : result.certificate.failures)
    out += row("", fmt::format("{}: {}", f.name(), f.message));
  out += row("cost", cost_line(run));
  if (const auto& global = result.certificate.global;
      global && (global->counts == "cells" || global->counts == "places"))
    out += row("bracket", bracket_line(*global));
  else if (global && global->outcome == ProofOutcome::bounded && global->gap > kFarBelow)
    out += row("bound", bound_line(*global));
  if (result.certificate.measured && std::isfinite(result.curve.cost))
    out += row("spacing", fmt::format("{:.3g} (largest / smallest segment cost - 1)", result.certificate.spacing));
  out += row("points", fmt::format("{}{}", result.path.free_count(), shape_of(run)));
  out += row("solver", solver_line(run));
  const RunConfig& config = config_of(run);
  if (!config.ring || config.source) {
    if (verbose || config.source->point) out += row("source", end_line(run.parts.source));
    if (!config.ring && (verbose || config.target->point)) out += row("target", end_line(run.parts.target));
  }
  out += family_rows(run);
  for (const std::string& note : run.parts.notes) out += row("note", note);
  for (const std::string& note : result.notes) out += row("note", note);
  out += row("time", time_line(run));
  if (run.in_place) out += row("output", run.output.string());
  return out;
}

std::string summary_json(const WrittenRun& run) {
  Json out = Json::parse(result_json(run));
  out["output"] = run.in_place ? Json(run.output.string()) : Json(nullptr);
  return to_text(out);
}

std::string dry_run_text(const RunRequest& request, const Run& prepared) {
  const RunConfig& config = prepared.origin->config;
  const Dimensions dims = prepared.parts.problem.manifold->dimensions();
  std::string domain =
      fmt::format("{}, dimension {} in R^{}", config.manifold.plugin->type, dims.tangent, dims.ambient);
  const char* before = ": ";
  for (const DataCount& c : counts_of(prepared.parts)) {
    domain += fmt::format("{}{} {}", before, c.count, c.count == 1 ? c.one : c.many);
    before = ", ";
  }
  std::string out = row("valid", request.config_file.string());
  out += row("manifold", domain);
  out += row("cost", fmt::format("{} [{}]", config.cost.plugin->type, prepared.parts.problem.cost->traits().unit));
  out += row("kernel", config.kernel.plugin->type);
  if (!config.ring)
    out += row("source", end_line(prepared.parts.source)) + row("target", end_line(prepared.parts.target));
  else if (config.source)
    out += row("fixed point", end_line(prepared.parts.source));
  for (const std::string& note : prepared.parts.notes) out += row("note", note);
  const std::vector<FamilyStart> family = family_of(prepared.parts);
  for (const FamilyStart& start : family) out += row(&start == &family.front() ? "family" : "", "from " + start.origin);
  out += row("points", points_text(config));
  if (config.points) out += row("memory", memory_text(*config.points, dims));
  out += row("would run", steps(prepared));
  for (const std::string& line : prepared.origin->why) out += row("", line);
  out += row("would write", output_of(request, prepared).string());
  const OutputRefusal refusal = output_refusal(output_of(request, prepared), request.force);
  if (!refusal.empty()) out += row("but", with_advice(refusal.reason, refusal.replaceable));
  return out;
}

std::string dry_run_json(const RunRequest& request, const Run& prepared) {
  const RunConfig& config = prepared.origin->config;
  const Dimensions dims = prepared.parts.problem.manifold->dimensions();
  Json out = {{"schema_version", kSchemaVersion}, {"status", "dry_run"}, {"name", config.name}};
  out["dimensions"] = {{"coordinate", dims.coordinate}, {"ambient", dims.ambient}, {"tangent", dims.tangent}};
  for (const DataCount& c : counts_of(prepared.parts)) out[config.manifold.plugin->type][c.many] = c.count;
  out["points"] = config.points ? Json(*config.points) : Json("auto");
  out["path_bytes"] = config.points ? Json(bytes_of_path(*config.points, dims)) : Json(nullptr);
  if (!config.ring)
    out["moved"] = {{"source", number(prepared.parts.source.moved)}, {"target", number(prepared.parts.target.moved)}};
  for (const FamilyStart& start : family_of(prepared.parts)) out["family"].push_back(start.origin);
  if (!prepared.origin->why.empty()) out["why"] = prepared.origin->why;
  out["read_seconds"] = prepared.seconds.read;
  out["output"] = output_of(request, prepared).string();
  const OutputRefusal refusal = output_refusal(output_of(request, prepared), request.force);
  out["output_refused"] = refusal.empty() ? Json(nullptr) : Json(with_advice(refusal.reason, refusal.replaceable));
  return to_text(out);
}

}  // namespace leastcost::app
