// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/config/run_config.hpp"

#include <algorithm>
#include <array>

#include "catalogue/yaml/yaml_writer.hpp"

namespace leastcost {

void FamilyOptions::fields(RunVisitor& visit) {
  visit.field(
      "windings", windings,
      {.help = "Chart with seams: also images of the target up to so many turns on.", .minimum = 0, .maximum = 8});
  visit.field("bows", bows,
              {.help = "Also first paths bowed to so many sides of the straight line.", .minimum = 0, .maximum = 64});
  visit.field("bow_height", bow_height, {.help = "Height of the bows over the distance of the ends.", .minimum = 0});
  visit.field("routes", routes,
              {.help = "Mesh or cloud: so many graph routes, each keeping away from those before it, as first paths.",
               .minimum = 1,
               .maximum = 32});
  visit.field("mirrored", mirrored, {.help = "Also the mirror image of the first path, at the line between the ends."});
  visit.plugins("initializers", initializers, "initializer", {.help = "Also these first paths."});
}

Words<TargetImageChoice> words(TargetImageChoice) {
  static constexpr std::array<Word<TargetImageChoice>, 2> kWords = {
      {{TargetImageChoice::cheapest, "cheapest"}, {TargetImageChoice::given, "given"}}};
  return kWords;
}

void RunConfig::fields(RunVisitor& visit) {
  visit.field("name", name, {.help = "Name of the run and of its output folder; default: that of the file."});
  visit.field("seed", seed, {.help = "Master seed of everything random.", .minimum = 0});
  visit.plugin("manifold", manifold, "manifold", {.help = "Where points may be.", .required = true});
  visit.plugins("obstacles", obstacles, "obstacle",
                {.help = "What no path may enter, in a flat domain; contact is allowed."});
  visit.plugin("robot", robot, "robot",
               {.help = "What moves: points are its configurations, and the obstacles stand in its workspace."});
  visit.field("clearance", clearance,
              {.help = "Distance that a path keeps from the obstacles.", .unit = "length", .minimum = 0});
  visit.plugin("cost", cost, "cost", {.help = "What a move from a to b costs.", .required = true});
  visit.plugin("kernel", kernel, "kernel", {.help = "The convex H of the energy; default: expm1_square."});
  visit.block("ends", {.help = "Where the path begins and ends; none in a ring, or the source alone: its fixed point."},
              [&](RunVisitor& ends) {
                ends.end("source", source, {.help = "Where the path begins; of a ring: its fixed point."});
                ends.end("target", target, {.help = "Where the path ends; none in a ring."});
                ends.file("pairs", pairs,
                          {.help = "Instead of the two: a CSV file of many pairs, a path for each of them; its header "
                                   "is source,target for vertices, or source_x,source_y,..,target_x,.. for points."});
                ends.field("tolerance", pair_tolerance,
                           {.help = "With pairs: how far their points may be moved; default: as of an end.",
                            .unit = "length",
                            .minimum = 0});
              });
  visit.block("path", {.help = "The discrete path."}, [&](RunVisitor& path) {
    path.points(
        "points", points,
        {.help = "Free points n; auto: as many as the first edge path has, at least 8.", .minimum = 1, .maximum = 1e7});
    path.field("ring", ring, {.help = "A closed path without ends."});
    path.field_or_zero("reference_cost", reference_cost,
                       {.help = "s0 of the energy sum H(c / s0); 0: the mean segment cost of the first path.",
                        .unit = "cost",
                        .minimum = 0});
    path.field("cascade", cascade, {.help = "Solve coarse first, then with twice the segments until all are there."});
    path.choice(
        "target_image", target_image,
        {.help = "Where several coordinates name the target (seams and poles of a chart, quaternions, angles), a "
                 "straight start goes to those to which a path is cheapest, unless they state a winding, a period or "
                 "more from the source. given: to those in 'ends'."});
    path.field("escape_saddle", escape_saddle, {.help = "Leave a saddle to its lower side and solve again."});
  });
  visit.plugin("initializer", initializer, "initializer",
               {.help = "The first path; default: dijkstra on a mesh or cloud, else straight."});
  visit.block("family",
              {.help = "More first paths: lists the distinct locally least-cost paths, the least one is delivered."},
              [&](RunVisitor& v) { family.fields(v); });
  visit.plugin(
      "solver", solver, "solver",
      {.help = "How the path is improved; default: none where the shortest path is proved (certificate.global), lbfgs "
               "on a mesh otherwise, else newton."});
  visit.field_or_zero("max_seconds", max_seconds,
                      {.help = "Time budget of the search, from the first path to the certificate; 0: none.",
                       .unit = "s",
                       .minimum = 0,
                       .maximum = 1e9});
  visit.block("certificate", {.help = "What a path must fulfil to be certified."},
              [&](RunVisitor& v) { certificate.fields(v); });
  visit.plugins(
      "post_process", post_process, "post_processor",
      {.help =
           "After the solve, in this order; default: trace, and straighten where the metric is constant, on a mesh."});
  visit.block("output", {.help = "Where results go."}, [&](RunVisitor& v) {
    v.field("folder", output_folder, {.help = "Output folder, relative to the current one; default: results/<name>."});
    v.field("files", output_files,
            {.help = "Which files a run of one path writes beside manifest.json; default: all. Of result, path, curve, "
                     "vtp, obj, geojson (on the earth, with its points apart), gpkg (GeoPackage, of rasters on the "
                     "earth, where GDAL is), residuals, waypoints, history, first_path, scene, config, report; a "
                     "report needs result, path, history, scene and config."});
    v.field("pair_points", pair_points, {.help = "With ends.pairs: the lines of paths.jsonl have the points too."});
    v.block("waypoints",
            {.help = "Also waypoints.csv: points of the path, equally spaced in cost; a count or a spacing."},
            [&](RunVisitor& w) { waypoints.fields(w); });
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
