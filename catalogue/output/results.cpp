// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <span>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/drawing/draws_poses.hpp>
#include <leastcost/problems/raster/has_voids.hpp>
#include "catalogue/back_ends/back_ends.hpp"
#include "catalogue/output/clicks.hpp"
#include "catalogue/output/geojson.hpp"
#include "catalogue/output/manifest.hpp"
#include "catalogue/output/path_table.hpp"
#include "catalogue/output/trajectory_files.hpp"
#include "catalogue/run/run_origin.hpp"
#include "catalogue/scene/scene.hpp"
#include "problems/formula/coordinate_names.hpp"
#include "problems/raster/raster_cells.hpp"

namespace leastcost {
namespace {

namespace fs = std::filesystem;

/// The configuration with every default.
std::string resolved_config(const RunOutcome& outcome, const fs::path& output) {
  const RunOrigin& origin = *outcome.origin;
  std::string head =
      "# Every option of this run, including defaults. To repeat the run: `leastcost run` on this file.\n";
  if (!outcome.replaced.empty())
    head = fmt::format(
        "# The configuration as read, including defaults. A program then replaced parts of it, which differ from this "
        "file: {}.\n",
        fmt::join(outcome.replaced, ", "));
  return head + resolved_yaml(origin.config, from_output(origin.folder, output));
}

ManifestFacts facts_of(const RunOutcome& outcome, const std::vector<std::string>& arguments) {
  ManifestFacts facts;
  facts.arguments = arguments;
  facts.inputs = outcome.origin->inputs;
  facts.seed = outcome.origin->config.seed;
  facts.started = outcome.origin->started;
  facts.finished = outcome.finished;
  return facts;
}

bool is_on_raster(const Problem& problem) {
  return find_ability<HasVoids>(*problem.manifold) != nullptr || find_ability<HasVoids>(*problem.cost) != nullptr ||
         find_ability<HasRasterCells>(*problem.cost) != nullptr;
}

/// For viewers, which show places: of a robot the way of its hand takes the place of its configurations.
PathTable in_workspace(const Problem& problem, PathTable table) {
  const auto* robot = find_ability<DrawsPoses>(*problem.manifold);
  if (robot != nullptr && table.x.cols() > 0) {
    table.configurations = table.x;
    table.x = robot->pose_strip(table.x).hand_in_space;
  }
  return table;
}

/// Polylines: the delivered points and curve, and the curves of the family.
void write_paths(const RunOutcome& outcome, OutputFolder& folder) {
  const RunConfig& config = outcome.origin->config;
  const PathTable points = delivered_points(outcome.parts.problem, outcome.result);
  const PathTable curve = delivered_curve(outcome.parts.problem, outcome.result);
  if (config.writes("curve")) folder.write("curve.csv", csv_text(curve));
  if (config.writes("vtp")) {
    const bool chords = curve.x.cols() != points.x.cols() || curve.x != points.x;  // else both are the curve
    std::vector<PathTable> lines;
    std::vector<VtpPart> parts;
    const auto add = [&](VtpPart part, PathTable line) {
      lines.push_back(in_workspace(outcome.parts.problem, std::move(line)));
      parts.push_back(part);
    };
    if (chords) add(VtpPart::chords, points);
    add(VtpPart::curve, curve);
    for (std::size_t k = 1; k < outcome.family.size(); ++k)
      add(VtpPart::other_way, delivered_curve(outcome.family[k].problem, outcome.family[k].result));
    folder.write("path.vtp", vtp_text(lines, parts));
  }
  if (config.writes("obj")) folder.write("path.obj", obj_text(in_workspace(outcome.parts.problem, curve)));
  const std::string geojson = config.writes("geojson") ? geojson_text(outcome) : "";
  if (!geojson.empty()) {
    folder.write("path.geojson", geojson);
    folder.write("path_points.geojson", geojson_points_text(outcome));
  }
  const GeoPackageWriter geopackage = geopackage_writer_of_libraries();
  if (geopackage != nullptr && config.writes("gpkg") && is_on_raster(outcome.parts.problem)) {
    const std::string line = geojson_text(outcome);
    const std::string bytes =
        line.empty() ? "" : geopackage({{"path", line}, {"points", geojson_points_text(outcome)}});
    if (!bytes.empty()) folder.write("path.gpkg", bytes);
  }
  const std::string residuals = config.writes("residuals") ? residuals_csv(outcome.parts.problem, curve) : "";
  if (!residuals.empty()) folder.write("residuals.csv", residuals);
}

}  // namespace

RenameFile from_output(const fs::path& folder_of_config, const fs::path& output) {
  return [folder_of_config, output](const std::string& file) {
    if (fs::path(file).is_absolute()) return file;
    const fs::path absolute = fs::weakly_canonical(fs::absolute(folder_of_config / file));
    return absolute.lexically_relative(output).string();
  };
}

void write_results(RunOutcome& outcome, const std::vector<std::string>& arguments, OutputFolder& folder) {
  const auto start = std::chrono::steady_clock::now();
  const RunConfig& config = outcome.origin->config;
  // What was solved comes first: a disk may be full after it.
  if (config.writes("result")) folder.write("result.json", result_json(outcome));
  if (config.writes("path"))
    folder.write("path.csv", csv_text(delivered_points(outcome.parts.problem, outcome.result)));
  if (config.writes("config")) folder.write("config.resolved.yaml", resolved_config(outcome, folder.target()));
  folder.write("manifest.json", manifest_json(facts_of(outcome, arguments)));
  write_paths(outcome, folder);
  if (outcome.waypoints && config.writes("waypoints"))
    folder.write("waypoints.csv", csv_text(waypoint_table(outcome.parts.problem, *outcome.waypoints)));
  if (outcome.trajectory && config.writes("trajectory")) {
    const Robot* robot = outcome.parts.robot.get();
    const std::vector<std::string> names =
        robot != nullptr && !robot->joints.empty() ? robot->joints : space_coordinates(*outcome.parts.problem.manifold);
    folder.write("trajectory.csv", trajectory_csv(*outcome.trajectory, names));
    folder.write("trajectory.json", trajectory_json(*outcome.trajectory, names));
  }
  if (config.writes("history")) folder.write("history.csv", history_csv(outcome.result.solve.history));
  if (config.writes("first_path"))
    folder.write("first_path.csv", first_path_csv(outcome.parts.problem, outcome.result.first));
  const std::span<const FamilyMember> family = outcome.family;
  if (config.writes("scene"))
    folder.write("scene.json",
                 scene_json(make_scene(outcome.parts.problem, outcome.result, family.subspan(family.empty() ? 0 : 1))));
  const std::string clicks = config.writes("clicks") ? clicks_json(outcome.parts.problem) : "";
  if (!clicks.empty()) folder.write("clicks.json", clicks);
  outcome.seconds.write = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (config.writes("result")) folder.write("result.json", result_json(outcome));
}

std::filesystem::path write_run(const RunOutcome& outcome, const fs::path& folder, const WriteOptions& options) {
  if (folder.empty()) throw OutputError("the output folder must have a name");
  if (!outcome.origin) throw InputError("only a result of solve() can be written");
  OutputFolder out(folder, options.replace);
  RunOutcome timed = outcome;
  try {
    write_results(timed, options.arguments, out);
  } catch (const OutputError& e) {
    throw OutputError(e.what() + out.leave());
  }
  out.commit();
  return out.target();
}

}  // namespace leastcost
