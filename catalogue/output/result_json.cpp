// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include <leastcost/catalogue/output/write_run.hpp>
#include <leastcost/framework/cost/has_interfaces.hpp>
#include "catalogue/output/json_numbers.hpp"
#include "catalogue/output/unit_of_cost.hpp"
#include "catalogue/run/run_origin.hpp"
#include "problems/raster/raster_cells.hpp"

namespace leastcost {
namespace {

using Json = nlohmann::ordered_json;

Json failures(const Certificate& certificate) {
  Json out = Json::array();
  for (const CertificateFailure& f : certificate.failures) out.push_back({{"name", f.name()}, {"message", f.message}});
  return out;
}

Json cost(const RunOutcome& run) {
  const Result& result = run.result;
  const CostEstimate& estimate = result.certificate.estimate;
  const bool measured = result.certificate.measured;
  Json out;
  out["value"] = number(measured && !std::isnan(estimate.value) ? estimate.value : result.curve.cost);
  out["unit"] = unit_of_cost(run.parts.problem);
  out["error_estimate"] = measured ? number(estimate.error) : Json(nullptr);
  out["initial"] = number(result.initial_cost);
  out["method"] =
      measured && estimate.method != ValueMethod::unmeasured ? Json(word_of(estimate.method)) : Json(nullptr);
  out["lower"] = number(estimate.lower);
  out["upper"] = number(estimate.upper);
  out["order"] = number(estimate.order);
  out["chain"] = number(result.costs.sum());
  out["curve"] = number(result.curve.cost);
  if (const auto* map = find_ability<HasRasterCells>(*run.parts.problem.cost))
    out["cells"] = number(map->cost_over_cells(result.curve.x));
  out["reference"] = number(result.reference_cost);
  return out;
}

Json levels(const Certificate& certificate) {
  Json out = Json::array();
  for (const RefinementLevel& l : certificate.levels)
    out.push_back({{"segments", l.segments},
                   {"cost", number(l.cost)},
                   {"energy", number(l.energy)},
                   {"spacing", number(l.spacing)},
                   {"iterations", l.iterations}});
  return out;
}

/// The thresholds of the configuration; docs/numerics.md says where others take their place.
Json thresholds(const CertificateOptions& o) {
  return {{"stationarity", o.stationarity},
          {"residual", o.residual},
          {"spacing", o.spacing},
          {"doubling", o.doubling},
          {"longest_segment", o.longest_segment},
          {"clearance", o.clearance}};
}

Json problem_json(const RunOutcome& run) {
  const Dimensions d = run.parts.problem.manifold->dimensions();
  const RunConfig& config = run.origin->config;
  const auto type = [&](const char* part, const PluginChoice& choice) {
    const bool replaced = std::count(run.replaced.begin(), run.replaced.end(), part) > 0;
    return replaced ? Json(nullptr) : Json(choice.plugin->type);  // made by a program, without a name
  };
  return {{"manifold", type("manifold", config.manifold)},
          {"cost", type("cost", config.cost)},
          {"kernel", type("kernel", config.kernel)},
          {"dimensions", {{"coordinate", d.coordinate}, {"ambient", d.ambient}, {"tangent", d.tangent}}}};
}

/// Where a minimum is proved, and between which bounds the least cost lies.
Json tube(const Certificate& c) {
  if (!c.resolution || !c.resolution->half_width) return nullptr;
  return {{"half_width", number(c.resolution->half_width)},
          {"lower", number(c.resolution->lower)},
          {"upper", number(c.resolution->upper)}};
}

/// Of the certificate where it got that far: a path that costs infinitely much has no spacing.
double where_measured(const Certificate& c, double value) {
  return c.measured && c.longest_segment > 0 ? value : std::numeric_limits<double>::quiet_NaN();
}

/// How near a path comes to an obstacle; null where there are none.
Json clearance_json(const std::optional<Clearance>& clearance) {
  if (!clearance) return nullptr;
  return {{"lower", number(clearance->lower)},  {"upper", number(clearance->upper)},
          {"obstacle", clearance->obstacle},    {"segment", clearance->segment},
          {"place", numbers(clearance->place)}, {"collision", clearance->proved ? "proved" : "sampled"}};
}

/// What the straight moves between the waypoints cost more than the path, and how near they come to an obstacle.
Json waypoints_json(const Waypoints& points) {
  Json out = {{"count", points.path.u.cols()},
              {"spacing", number(points.cost[1] - points.cost[0])},
              {"cost_of_moves", points.gap ? number(points.total + *points.gap) : Json(nullptr)},
              {"clearance", clearance_json(points.clearance)}};
  if (points.clearance) out["touches"] = points.touches;
  return out;
}

/// How long the motion along the path takes, and what the rounding of its corners does.
Json trajectory_json(const Trajectory& motion) {
  Json out = {{"duration", number(motion.duration)},
              {"least_duration", number(motion.least_duration)},
              {"samples", motion.time.size()},
              {"deviation", number(motion.deviation)},
              {"clearance", clearance_json(motion.clearance)}};
  if (motion.clearance) {
    out["checked_within"] = number(motion.checked_within);
    out["touches"] = motion.touches;
  }
  return out;
}

/// What a proof over all paths says; null where none was tried.
Json global_json(const std::optional<GlobalBound>& global) {
  if (!global) return nullptr;
  Json out = {{"outcome", word_of(global->outcome)},
              {"category", std::string(word_of(global->category))},
              {"lower_bound", number(global->lower_bound)},
              {"gap", number(global->gap)},
              {global->counts, global->steps},
              {"bound", global->bound},
              {"seconds", number(global->seconds)},
              {"reason", global->reason.empty() ? Json(nullptr) : Json(global->reason)}};
  if (!global->grid) return out;
  out["upper_bound"] = number(global->grid->upper);
  out["box"] = {{"lower", numbers(Eigen::VectorXd(global->grid->box.min()))},
                {"upper", numbers(Eigen::VectorXd(global->grid->box.max()))}};
  out["grid"] = global->grid->cells;
  return out;
}

/// Where the path meets interfaces, with the angles to their normals.
Json crossings_json(const HasInterfaces& cost, const Points& curve, const ConstraintManifold& domain) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  Json out = Json::array();
  for (const Crossing& c : cost.crossings(curve, domain))
    out.push_back({{"place", numbers(c.place)},
                   {"interface", c.interface},
                   {"layers", {c.from, c.to}},
                   {"indices", {number(c.index_before), number(c.index_after)}},
                   {"degrees", {number(kDegrees * c.angle_before), number(kDegrees * c.angle_after)}},
                   {"slowness", number(c.slowness)},
                   {"mismatch", number(c.mismatch)}});
  return out;
}

/// How the cost that is meant lies to the one that was minimised; null where they are the same.
Json regularization_json(const std::optional<Regularization>& r) {
  if (!r) return nullptr;
  return {{"below", number(r->below)},
          {"above", number(r->above)},
          {"free_share", number(r->free_share)},
          {"free_ways", r->free_ways.empty() ? Json(nullptr) : Json(r->free_ways)}};
}

Json certificate_json(const Certificate& c, const CertificateOptions& options) {
  return {{"measured", c.measured},
          {"stationarity", number(c.stationarity)},
          {"residual", number(c.residual)},
          {"spacing", number(where_measured(c, c.spacing))},
          {"doubling", number(c.doubling)},
          {"doubling_expected", number(c.doubling_expected)},
          {"longest_segment", number(where_measured(c, c.longest_segment))},
          {"index",
           {{"verdict", std::string(word_of(c.index.verdict))},
            {"negatives", c.index.negatives},
            {"saddle_order", c.index.saddle_order},
            {"nullity", c.index.nullity}}},
          {"curve_cost", c.resolution ? Json(c.resolution->curve_enclosed ? "enclosed" : "measured") : Json(nullptr)},
          {"resolution", c.resolution ? Json(std::string(word_of(c.resolution->verdict))) : Json(nullptr)},
          {"minimum", c.resolution ? Json(c.resolution->minimum_proved ? "proved" : "measured") : Json(nullptr)},
          {"narrowest", c.resolution ? number(c.resolution->narrowest) : Json(nullptr)},
          {"tube", tube(c)},
          {"clearance", clearance_json(c.clearance)},
          {"straightness", number(c.straightness)},
          {"asymmetry", number(c.asymmetry)},
          {"geometry_error", number(c.geometry_error)},
          {"regularization", regularization_json(c.regularization)},
          {"levels", levels(c)},
          {"thresholds", thresholds(options)}};
}

Json solver_json(const RunOutcome& run) {
  const SolveReport& report = run.result.solve;
  const Counters& n = report.counters;
  return {{"name", std::string(run.parts.solver->name())},
          {"termination", std::string(word_of(report.termination))},
          {"message", report.message},
          {"iterations", report.iterations},
          {"counters",
           {{"energies", n.energies},
            {"gradients", n.gradients},
            {"hessians", n.hessians},
            {"projections", n.projections},
            {"linear_solves", n.linear_solves}}},
          {"initial_energy", number(report.initial_energy)},
          {"final_energy", number(report.final_energy)},
          {"cost_error", number(report.cost_error)}};
}

Json end_json(const PlacedEnd& end) {
  return {{"given", numbers(end.given)}, {"placed", numbers(end.end.u)}, {"moved", number(end.moved)}};
}

Json family(const RunOutcome& run) {
  Json out = Json::array();
  for (const FamilyMember& m : run.family) {
    const Certificate& c = m.result.certificate;
    Json item;
    item["status"] = std::string(word_of(m.result.status));
    item["cost"] = number(c.measured ? c.estimate.value : m.result.curve.cost);
    item["error_estimate"] = c.measured ? number(c.estimate.error) : Json(nullptr);
    item["rank_cost"] = number(m.rank_cost);
    item["tied"] = m.tied;
    item["index"] = std::string(word_of(c.index.verdict));
    item["failures"] = failures(c);
    item["iterations"] = m.result.solve.iterations;
    item["from"] = m.origins;
    out.push_back(std::move(item));
  }
  return out;
}

/// Wall time by stage. The stages are those of the delivered path; of a family, the other members are one more.
Json seconds(const RunOutcome& run) {
  const StageSeconds& s = run.result.seconds;
  Json out = {{"read", run.seconds.read}, {"compose", run.seconds.compose}, {"initialize", s.initialize},
              {"solve", s.solve},         {"post_process", s.post_process}, {"certify", s.certify}};
  if (s.prepare > 0) out["prepare"] = s.prepare;  // a domain that has coarser versions
  if (!run.family.empty())
    out["other_members"] =
        std::max(0.0, run.seconds.search - s.initialize - s.solve - s.post_process - s.prepare - s.certify);
  out["write"] = run.seconds.write;
  out["report"] = run.seconds.report;
  return out;
}

Json ends(const RunOutcome& run) {
  const Problem& problem = run.parts.problem;
  const bool based = run.origin->config.ring && run.origin->config.source.has_value();
  if (based || problem.based) return {{"source", end_json(run.parts.source)}};
  if (problem.ring) return nullptr;
  return {{"source", end_json(run.parts.source)}, {"target", end_json(run.parts.target)}};
}

Json notes(const RunOutcome& run) {
  Json out = Json::array();
  for (const std::string& note : run.parts.notes) out.push_back(note);
  for (const std::string& note : run.result.notes) out.push_back(note);
  return out;
}

}  // namespace

std::string result_json(const RunOutcome& run) {
  const Result& result = run.result;
  Json out;
  out["schema_version"] = kSchemaVersion;
  out["name"] = run.name;
  out["problem"] = problem_json(run);
  out["status"] = std::string(word_of(result.status));
  out["certified"] = result.status == Status::certified;
  out["failures"] = failures(result.certificate);
  out["scope"] = result.certificate.measured ? Json(word_of(result.certificate.scope)) : Json(nullptr);
  out["cost"] = cost(run);
  out["global"] = global_json(result.certificate.global);
  out["spacing"] = number(where_measured(result.certificate, result.certificate.spacing));
  out["points"] = result.path.free_count();
  out["ring"] = run.parts.problem.ring || run.parts.problem.based;
  out["certificate"] = certificate_json(result.certificate, run.parts.options.certificate);
  out["solver"] = solver_json(run);
  out["initializer"] = std::string(run.parts.initializer->name());
  out["seconds"] = seconds(run);
  out["ends"] = ends(run);
  if (!run.family.empty()) out["family"] = family(run);
  if (const auto* cost = find_ability<HasInterfaces>(*run.parts.problem.cost);
      cost != nullptr && result.curve.least_of_class)
    out["crossings"] = crossings_json(*cost, result.curve.x, *run.parts.problem.manifold);
  if (run.waypoints) out["waypoints"] = waypoints_json(*run.waypoints);
  if (run.trajectory) out["trajectory"] = trajectory_json(*run.trajectory);
  out["notes"] = notes(run);
  return to_text(out);
}

}  // namespace leastcost
