// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/figure/figure.hpp"

#include <fmt/format.h>

#include <leastcost/framework/base/errors.hpp>
#include "app/plot/legend.hpp"
#include "app/report/page/results_folder.hpp"
#include "app/report/run/run_parts.hpp"
#include "app/report/space/space_view.hpp"
#include "app/report/space/workspace_view.hpp"

namespace leastcost::app {
namespace {

namespace fs = std::filesystem;

/// What a run can be drawn as, the first of them the best.
std::vector<FigurePicture> pictures_of(const RunFiles& files) {
  std::vector<FigurePicture> all;
  const Scene& scene = files.scene;
  if (!scene.strip.poses.empty()) all.push_back(FigurePicture::poses);
  if (scene.dimension == 3 && scene.lines.path.cols() > 0) all.push_back(FigurePicture::space);
  if (scene.lines.path.cols() > 0 && (scene.dimension == 2 || (scene.dimension == 3 && scene.relief)))
    all.push_back(FigurePicture::map);
  all.push_back(FigurePicture::coordinates);
  if (files.history.rows() >= 2) all.push_back(FigurePicture::convergence);
  return all;
}

const char* name_of(FigurePicture picture) {
  switch (picture) {
    case FigurePicture::best: return "best";
    case FigurePicture::space: return "space";
    case FigurePicture::map: return "map";
    case FigurePicture::poses: return "poses";
    case FigurePicture::coordinates: return "coordinates";
    case FigurePicture::convergence: return "convergence";
  }
  return "";
}

FigurePicture chosen(const FigureRequest& request, const RunFiles& files) {
  const std::vector<FigurePicture> all = pictures_of(files);
  if (request.picture == FigurePicture::best) return all.front();
  std::string names;
  for (const FigurePicture picture : all) {
    if (picture == request.picture) return picture;
    names += (names.empty() ? "" : ", ") + std::string(name_of(picture));
  }
  throw InputError(fmt::format("{}: this run has no picture '{}'; it has {}", request.folder.string(),
                               name_of(request.picture), names));
}

/// Sketch and legend of one picture.
struct Drawn {
  Sketch sketch;
  std::vector<LegendEntry> legend = {};
};

Drawn draw(FigurePicture picture, const RunFiles& files, const Look& look, const SpaceView& view) {
  switch (picture) {
    case FigurePicture::poses:
      if (files.scene.strip.workspace.empty())
        return {strip_sketch(files.scene.strip, look), legend_of(files.scene.strip, look)};
      return {workspace_sketch(files.scene.strip, view, look), legend_of_workspace(files.scene.strip, look)};
    case FigurePicture::space: return {space_sketch(files, view, look), legend_of(files, look)};
    case FigurePicture::map: return {plane_sketch(files, look), legend_of(files, look, true)};
    case FigurePicture::convergence: return {convergence_sketch(files, look)};
    default: return {coordinates_sketch(files, look)};
  }
}

}  // namespace

Figure make_figure(const FigureRequest& request) {
  constexpr Index kMostPoints = 60;  // more of them hide the path
  constexpr double kTallest = 1.15;  // in widths
  const std::string kind = kind_of_results(request.folder);
  if (kind == "study")
    throw InputError(request.folder.string() + ": a study has its figures as .svg files in that folder");
  if (kind == "pairs") throw InputError(request.folder.string() + ": a run of many pairs has no picture");
  const RunFiles files = read_run_files(request.folder);
  const FigurePicture picture = chosen(request, files);
  const PoseStrip& strip = files.scene.strip;
  const bool robot = picture == FigurePicture::poses && !strip.workspace.empty();
  const bool space = robot || picture == FigurePicture::space;
  if (request.from && !space)
    throw InputError(fmt::format("--view is for pictures of space, and this one is '{}'", name_of(picture)));
  Look look = request.parts.look;
  look.printed = true;
  look.width = request.size.sketch_width();
  look.height = kTallest * look.width;
  look.image_width = request.size.pixels(look.width);
  look.unit = request.unit.empty() && files.result.text("cost.unit") == "m" ? "m" : request.unit;
  if (robot && look.unit.empty()) look.unit = strip.workspace.unit;
  look.points = look.points && (request.points_asked || files.points.cols() <= kMostPoints);
  SpaceView view;
  const Eigen::Vector3d up = robot ? Eigen::Vector3d::UnitZ().eval() : files.scene.up;
  if (space) view = request.from ? view_from(*request.from, up) : robot ? choose_view(strip) : choose_view(files.scene);
  const Drawn drawn = draw(picture, files, look, view);
  const Sketch whole =
      request.parts.legend ? below(drawn.sketch, legend_sketch(drawn.legend, look.width)) : drawn.sketch;
  Figure figure{printed_svg(whole, request.size), request.size.width, request.size.width * whole.height / look.width,
                std::nullopt};
  if (space) figure.from = angles_of(view, up);
  return figure;
}

}  // namespace leastcost::app
