// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/config/run_config.hpp"

#include <algorithm>
#include <array>

#include "catalogue/yaml/yaml_writer.hpp"

namespace leastcost {

void FamilyOptions::fields(RunVisitor& visit) {
  visit.field("windings", windings,
              {.help = "On a chart with seams: also try images of the target up to this many turns away.",
               .minimum = 0,
               .maximum = 8});
  visit.field("bows", bows,
              {.help = "Also start from first paths bowed to this many sides of the straight line.",
               .minimum = 0,
               .maximum = 64});
  visit.field("bow_height", bow_height,
              {.help = "Height of the bows, relative to the distance between the ends.", .minimum = 0});
  visit.field("routes", routes,
              {.help = "On a mesh or cloud: number of graph routes used as first paths; each avoids those before it.",
               .minimum = 1,
               .maximum = 32});
  visit.field("mirrored", mirrored, {.help = "Also start from the first path mirrored in the line between the ends."});
  visit.plugins("initializers", initializers, "initializer", {.help = "Also start from these first paths."});
}

Words<TargetImageChoice> words(TargetImageChoice) {
  static constexpr std::array<Word<TargetImageChoice>, 2> kWords = {
      {{TargetImageChoice::cheapest, "cheapest"}, {TargetImageChoice::given, "given"}}};
  return kWords;
}

void RunConfig::fields(RunVisitor& visit) {
  visit.field("name", name, {.help = "Name of the run and of its output folder; default: that of the file."});
  visit.field("seed", seed, {.help = "Master seed of all random numbers.", .minimum = 0});
  visit.plugin("manifold", manifold, "manifold", {.help = "The domain: where points lie.", .required = true});
  visit.plugins("obstacles", obstacles, "obstacle",
                {.help = "Regions that paths avoid, in a flat domain; contact is allowed."});
  visit.plugin("robot", robot, "robot",
               {.help = "The moving body: points are its configurations, and the obstacles are in its workspace."});
  visit.field("clearance", clearance,
              {.help = "Least distance of a path from the obstacles.", .unit = "length", .minimum = 0});
  visit.plugin("cost", cost, "cost", {.help = "Cost of a move from a to b; default: euclidean, its length."});
  visit.plugin("kernel", kernel, "kernel", {.help = "The convex H of the energy; default: expm1_square."});
  visit.block(
      "ends", {.help = "Source and target of the path. A ring has none, or only a source: its fixed point."},
      [&](RunVisitor& ends) {
        ends.end("source", source, {.help = "Start of the path; in a ring, its fixed point."});
        ends.end("target", target, {.help = "End of the path; a ring has none."});
        ends.file("pairs", pairs,
                  {.help = "Instead of source and target: a CSV file of many pairs, with one path for each. Its header "
                           "is source,target for vertices, or source_x,source_y,..,target_x,.. for points."});
        ends.field("tolerance", pair_tolerance,
                   {.help = "With pairs: largest distance by which their points are moved; default: as for an end.",
                    .unit = "length",
                    .minimum = 0});
      });
  visit.block("path", {.help = "The discrete path."}, [&](RunVisitor& path) {
    path.points(
        "points", points,
        {.help = "Number n of free points; auto: as many as the first edge path has, at least 8, and for a robot as "
                 "many as its thin parts need, 64 to 200. Default: auto for a robot.",
         .minimum = 1,
         .maximum = 1e7});
    path.field("ring", ring, {.help = "A closed path without ends."});
    path.field_or_zero("reference_cost", reference_cost,
                       {.help = "s0 of the energy sum H(c / s0); 0: the mean segment cost of the first path.",
                        .unit = "cost",
                        .minimum = 0});
    path.field("cascade", cascade,
               {.help = "Solve with few segments first, then double their number until all points are used."});
    path.choice("target_image", target_image,
                {.help = "For a target with several coordinates (seams and poles of a chart, quaternions, angles). "
                         "cheapest: a straight start goes to the cheapest of them, unless the given ones are a period "
                         "or more from the source and so state a winding. given: it goes to those in 'ends'."});
    path.field("escape_saddle", escape_saddle, {.help = "At a saddle, step towards lower energy and solve again."});
  });
  visit.plugin("initializer", initializer, "initializer",
               {.help = "How the first path is found; default: cell_graph on a cost map read as cells; eikonal in two "
                        "coordinates if the cost varies with position, and among obstacles in a chart; grid among "
                        "obstacles in the plane; rrt for robots and among other obstacles; dijkstra on a mesh or "
                        "cloud; otherwise straight. A ring has no default. run -n names the one chosen, and why."});
  visit.block("family",
              {.help = "Start from more first paths: the distinct locally least-cost paths are listed, and the "
                       "cheapest is delivered."},
              [&](RunVisitor& v) { family.fields(v); });
  visit.plugin("solver", solver, "solver",
               {.help = "How the path is improved; default: none if post-processors make the curve from the first path "
                        "(taut, refract, refract_cells, or a proof that it is the shortest of all), else lbfgs on a "
                        "mesh and newton elsewhere. run -n names the one chosen, and why."});
  visit.field_or_zero("max_seconds", max_seconds,
                      {.help = "Time budget of the search, from the first path to the certificate; 0: no limit.",
                       .unit = "s",
                       .minimum = 0,
                       .maximum = 1e9});
  visit.block("certificate", {.help = "Conditions that a path must meet to be certified."},
              [&](RunVisitor& v) { certificate.fields(v); });
  visit.plugins("post_process", post_process, "post_processor",
                {.help = "Steps after the solve, in this order; default: on_surface on a level set; on a mesh, trace, "
                         "and straighten if the metric is constant; taut among obstacles if the cost is length; "
                         "refract in layers; refract_cells on a cost map read as cells; otherwise none. run -n names "
                         "those chosen, and why."});
  visit.block("output", {.help = "Where results are written."}, [&](RunVisitor& v) {
    v.field("folder", output_folder, {.help = "Output folder, relative to the current one; default: results/<name>."});
    v.field(
        "files", output_files,
        {.help =
             "Files that a run of one path writes in addition to manifest.json; default: all. Choices: result, "
             "path, curve, vtp, obj, geojson (on the Earth, with the points in a second file), gpkg "
             "(GeoPackage, for rasters on the Earth, in builds with GDAL), residuals, waypoints, trajectory, history, "
             "first_path, scene, clicks (for the shortest paths between clicked points in the report), "
             "config, report. A report needs result, path, history, scene and config."});
    v.field("pair_points", pair_points,
            {.help = "With ends.pairs: also write the points to the lines of paths.jsonl."});
    v.block("waypoints",
            {.help = "Also write waypoints.csv: points of the path, equally spaced in cost, by count or by spacing."},
            [&](RunVisitor& w) { waypoints.fields(w); });
    v.block(
        "trajectory",
        {.help = "Also write trajectory.csv and trajectory.json: the quickest motion along the path under limits of "
                 "velocity and acceleration, from rest to rest."},
        [&](RunVisitor& t) {
          trajectory.fields(t);
          t.file("limits", joint_limits,
                 {.help = "MoveIt's joint_limits.yaml: limits by joint name for whatever is not set here; it takes "
                          "precedence over the limits in the robot's file."});
        });
  });
}

bool RunConfig::writes(std::string_view file) const {
  return output_files.empty() || std::count(output_files.begin(), output_files.end(), file) > 0;
}

std::string resolved_yaml(const RunConfig& config, const RenameFile& rename) {
  RunConfig copy = config;
  OptionsWriter writer(rename);
  copy.fields(writer);
  return to_yaml(writer.take());
}

std::vector<std::string> files_of(const RunConfig& config) {
  std::vector<std::string> files;
  resolved_yaml(config, [&](const std::string& file) { return files.push_back(file), file; });
  return files;
}

}  // namespace leastcost
