// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include <leastcost/catalogue/output/output_folder.hpp>
#include <leastcost/catalogue/output/results.hpp>
#include <leastcost/problems/manifolds/made_from_data.hpp>
#include "catalogue/output/json_numbers.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::ordered_json;

std::string row(std::string_view label, const std::string& text) { return fmt::format("{:<11} {}\n", label, text); }

std::string status_line(const WrittenRun& run) {
  const Certificate& c = run.result.certificate;
  std::string line(name(run.result.status));
  if (run.result.status == Status::certified) return line + fmt::format(" ({})", c.scope);
  if (!c.measured)
    line += run.config.certificate.enabled ? ": the certificate was not measured" : ": the certificate is switched off";
  return line;
}

std::string cost_line(const WrittenRun& run) {
  const Result& result = run.result;
  const std::string& unit = run.parts.problem.cost->traits().unit;
  const CostEstimate& estimate = result.certificate.estimate;
  if (!result.certificate.measured) return fmt::format("{:.15g} {} (error not measured)", result.curve.cost, unit);
  if (!std::isfinite(estimate.error)) return fmt::format("{:.15g} {} (error unknown)", estimate.value, unit);
  std::string line = fmt::format("{:.15g} +- {:.2g} {} ({})", estimate.value, estimate.error, unit, estimate.method);
  if (const std::optional<double>& geometry = result.certificate.geometry_error)
    line += fmt::format(", and +- {:.2g} for the samples of the domain", *geometry);
  return line;
}

std::string solver_line(const WrittenRun& run) {
  const SolveReport& report = run.result.solve;
  std::string line =
      fmt::format("{}: {} after {} iterations", run.parts.solver->name(), name(report.termination), report.iterations);
  if (report.termination != Termination::converged && !report.message.empty()) line += " (" + report.message + ")";
  return line;
}

const char* shape_of(const WrittenRun& run) {
  if (run.config.ring && run.config.source.given) return " (a loop with a fixed point, the source)";
  return run.result.path.ring ? " (ring)" : " and two ends";
}

/// One line per distinct path of the family.
std::string family_rows(const WrittenRun& run) {
  std::string out;
  for (const FamilyMember& m : run.family) {
    const Certificate& c = m.result.certificate;
    out += row(out.empty() ? "family" : "",
               fmt::format("{:.12g}  {}, {}  from {}", c.measured ? c.estimate.value : m.result.curve.cost,
                           name(m.result.status), name(c.index.verdict), fmt::join(m.origins, "; ")));
  }
  return out;
}

std::string time_line(const WrittenRun& run) {
  const StageSeconds& s = run.result.seconds;
  return fmt::format("read {:.3g} s, first path {:.3g} s, solve {:.3g} s, post-process {:.3g} s, certify {:.3g} s",
                     run.parts.read_seconds, s.initialize, s.solve, s.post_process, s.certify);
}

std::string end_line(const PlacedEnd& end) {
  const std::string line = fmt::format("({:.6g})", fmt::join(end.end.u, ", "));
  return line + fmt::format(", moved by {:.3g} onto the manifold", end.moved);
}

std::vector<DataCount> counts_of(const Composition& parts) {
  const auto* data = find_ability<MadeFromData>(*parts.problem.manifold);
  return data == nullptr ? std::vector<DataCount>() : data->counts();
}

std::string steps(const Run& prepared) {
  const Composition& parts = prepared.parts;
  std::string line = fmt::format("{}, {}", prepared.loaded.config.initializer.plugin->type, parts.solver->name());
  for (const auto& processor : parts.post_processors) line += fmt::format(", {}", processor->name());
  return line + (parts.options.certificate.enabled ? ", certificate" : "");
}

std::string points_text(const RunConfig& config) {
  return config.points.automatic ? "as many as the first edge path" : std::to_string(config.points.count);
}

}  // namespace

std::string summary_text(const WrittenRun& run, bool verbose) {
  const Result& result = run.result;
  std::string out = row("status", status_line(run));
  for (const CertificateFailure& f : result.certificate.failures)
    out += row("", fmt::format("{}: {}", f.name, f.message));
  out += row("cost", cost_line(run));
  if (result.certificate.measured)
    out += row("spacing", fmt::format("{:.3g} (largest / smallest segment cost - 1)", result.certificate.spacing));
  out += row("points", fmt::format("{}{}", result.path.free_count(), shape_of(run)));
  out += row("solver", solver_line(run));
  if (!run.config.ring || run.config.source.given) {
    if (verbose || run.config.source.point.size() > 0) out += row("source", end_line(run.parts.source));
    if (!run.config.ring && (verbose || run.config.target.point.size() > 0))
      out += row("target", end_line(run.parts.target));
  }
  out += family_rows(run);
  for (const std::string& note : run.parts.notes) out += row("note", note);
  for (const std::string& note : result.notes) out += row("note", note);
  out += row("time", time_line(run));
  if (run.output_error.empty()) out += row("output", run.output.string());
  return out;
}

std::string summary_json(const WrittenRun& run) {
  Json out = Json::parse(result_json(run));
  out["output"] = run.output_error.empty() ? Json(run.output.string()) : Json(nullptr);
  return to_text(out);
}

std::string dry_run_text(const RunRequest& request, const Run& prepared) {
  const RunConfig& config = prepared.loaded.config;
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
  else if (config.source.given)
    out += row("fixed point", end_line(prepared.parts.source));
  for (const std::string& note : prepared.parts.notes) out += row("note", note);
  for (const FamilyStart& start : prepared.parts.family)
    out += row(&start == &prepared.parts.family.front() ? "family" : "", "from " + start.origin);
  out += row("points", points_text(config));
  out += row("would run", steps(prepared));
  out += row("would write", output_of(request, config).string());
  const std::string refusal = output_refusal(output_of(request, config), request.force);
  if (!refusal.empty()) out += row("but", refusal);
  return out;
}

std::string dry_run_json(const RunRequest& request, const Run& prepared) {
  const RunConfig& config = prepared.loaded.config;
  const Dimensions dims = prepared.parts.problem.manifold->dimensions();
  Json out = {{"schema_version", kSchemaVersion}, {"status", "dry_run"}, {"name", config.name}};
  out["dimensions"] = {{"coordinate", dims.coordinate}, {"ambient", dims.ambient}, {"tangent", dims.tangent}};
  for (const DataCount& c : counts_of(prepared.parts)) out[config.manifold.plugin->type][c.many] = c.count;
  out["points"] = config.points.automatic ? Json("auto") : Json(config.points.count);
  if (!config.ring)
    out["moved"] = {{"source", number(prepared.parts.source.moved)}, {"target", number(prepared.parts.target.moved)}};
  if (!prepared.parts.family.empty()) out["family"] = Json::array();
  for (const FamilyStart& start : prepared.parts.family) out["family"].push_back(start.origin);
  out["read_seconds"] = prepared.parts.read_seconds;
  out["output"] = output_of(request, config).string();
  const std::string refusal = output_refusal(output_of(request, config), request.force);
  out["output_refused"] = refusal.empty() ? Json(nullptr) : Json(refusal);
  return to_text(out);
}

}  // namespace leastcost::app
