// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/field/field_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/raster/has_raster.hpp>
#include "app/field/field_files.hpp"
#include "app/plot/legend.hpp"
#include "app/report/run/cost_bands.hpp"
#include "app/report/run/plane_frame.hpp"
#include "app/report/run/plane_surroundings.hpp"
#include "catalogue/output/unit_of_cost.hpp"
#include "catalogue/scene/scene.hpp"

namespace leastcost::app {
namespace {

/// A value between nodes: bilinear, or where one of the four is missing that of the nearest which is not.
double value_between(const CostField& field, double column, double row) {
  const auto i = std::min(static_cast<std::int32_t>(column), field.count[0] - 2),
             j = std::min(static_cast<std::int32_t>(row), field.count[1] - 2);
  const double s = column - i, t = row - j;
  double sum = 0, nearest = 2, at_nearest = std::numeric_limits<double>::infinity();
  for (const int b : {0, 1})
    for (const int a : {0, 1}) {
      const double value = field.value(i + a, j + b);
      sum += (a == 1 ? s : 1 - s) * (b == 1 ? t : 1 - t) * value;
      const double apart = std::hypot(s - a, t - b);
      if (std::isfinite(value) && apart < nearest) nearest = apart, at_nearest = value;
    }
  return std::isfinite(sum) ? sum : at_nearest;
}

/// The values at no more nodes than a picture shows; infinite where no path leads.
Raster thinned(const CostField& field) {
  constexpr double kLongest = 300;
  const double fewer = std::min(1.0, kLongest / (std::max(field.count[0], field.count[1]) - 1));
  const auto count = [&](std::size_t d) {
    return std::max(2, static_cast<int>(std::lround(fewer * (field.count[d] - 1))) + 1);
  };
  Raster raster{count(0), count(1), field.lower, field.node(field.count[0] - 1, field.count[1] - 1), {}};
  raster.values.reserve(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
  for (int j = 0; j < raster.rows; ++j)
    for (int i = 0; i < raster.columns; ++i)
      raster.values.push_back(value_between(field, double(i) * (field.count[0] - 1) / (raster.columns - 1),
                                            double(j) * (field.count[1] - 1) / (raster.rows - 1)));
  return raster;
}

/// Values for nodes without one beside nodes with one, the mean of those. Obstacles are drawn over them, and have a
/// border that does not follow the cells.
Raster continued(const Raster& raster) {
  Raster out = raster;
  const auto index = [&](int i, int j) { return static_cast<std::size_t>(j * raster.columns + i); };
  for (int j = 0; j < raster.rows; ++j)
    for (int i = 0; i < raster.columns; ++i) {
      if (std::isfinite(raster.values[index(i, j)])) continue;
      double sum = 0;
      int count = 0;
      for (int b = std::max(j - 1, 0); b <= std::min(j + 1, raster.rows - 1); ++b)
        for (int a = std::max(i - 1, 0); a <= std::min(i + 1, raster.columns - 1); ++a)
          if (std::isfinite(raster.values[index(a, b)])) sum += raster.values[index(a, b)], ++count;
      if (count > 0) out.values[index(i, j)] = sum / count;
    }
  return out;
}

/// Round values between bands: evenly for costs; of a corridor the small ones count.
std::vector<Tick> levels_of(const Raster& raster, bool corridor) {
  constexpr int kBands = 10;
  constexpr double kSmall = 200;  // the largest level over the smallest one of a corridor
  std::vector<double> values;
  values.reserve(raster.values.size());
  for (const double value : raster.values)
    if (std::isfinite(value)) values.push_back(value);
  const double most = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
  std::vector<Tick> levels;
  if (!(most > 0)) return levels;
  if (corridor) {
    for (int e = static_cast<int>(std::floor(std::log10(most / kSmall))); std::pow(10.0, e) < most; ++e)
      for (const double factor : {1.0, 2.0, 5.0})
        if (const double level = factor * std::pow(10.0, e); level > most / kSmall && level < most)
          levels.push_back({level, fmt::format("{:.6g}", level)});
  } else {
    constexpr std::size_t kMostLevels = 12;  // more are hard to tell apart
    for (int bands = kBands; bands > 1 && (levels.empty() || levels.size() > kMostLevels); --bands) {
      levels.clear();
      for (const Tick& tick : ticks(ScaleKind::linear, {0, most}, bands))
        if (tick.at > 0 && tick.at < most) levels.push_back(tick);
    }
  }
  return levels;
}

/// Whether places of the lattice are places of the ambient plane, or of the map of the ground.
bool is_a_map(const ConstraintManifold& domain) {
  return (domain.dimensions().ambient == 2 && find_ability<HasChart>(domain) == nullptr) ||
         find_ability<HasRaster>(domain) != nullptr;
}

/// Obstacles and the box, as far as they can be drawn in the coordinates of the lattice.
Scene scene_of(const RunField& field) {
  const ConstraintManifold& domain = *field.problem().manifold;
  const CostField& lattice = field.lattice();
  Scene scene;
  scene.dimension = 2;
  const auto* drawn = find_ability<DrawsItself>(domain);
  if (drawn == nullptr || !is_a_map(domain)) return scene;
  const Eigen::Vector2d last = lattice.node(lattice.count[0] - 1, lattice.count[1] - 1);
  CoordinatePath corners{Points(2, 4), {}, true};
  corners.u << lattice.lower[0], last[0], last[0], lattice.lower[0],  //
      lattice.lower[1], lattice.lower[1], last[1], last[1];
  drawn->draw({positions(domain, corners), corners.u}, scene);
  scene.curves.clear();
  if (domain.dimensions().ambient != 2) scene.lower.resize(0), scene.upper.resize(0);
  return scene;
}

/// Whether places without value are seen. `covered`: those within obstacles are not.
bool has_gaps(const Raster& raster, bool covered, const Problem& problem) {
  const Eigen::Vector2d cell =
      (raster.upper - raster.lower).cwiseQuotient(Eigen::Vector2d(raster.columns - 1, raster.rows - 1));
  for (int j = 0; j < raster.rows; ++j)
    for (int i = 0; i < raster.columns; ++i) {
      const double value = raster.values[static_cast<std::size_t>(j * raster.columns + i)];
      if (std::isfinite(value)) continue;
      const Eigen::Vector2d x = raster.lower + cell.cwiseProduct(Eigen::Vector2d(i, j));
      if (!covered || why_in_clearance(problem, PathEnd{x}).empty()) return true;
    }
  return false;
}

/// `turned`: the latitude is first, and upward in a picture.
Eigen::Vector2d drawn_at(const Eigen::VectorXd& u, bool turned) { return {u[turned ? 1 : 0], u[turned ? 0 : 1]}; }

Points line_of(const FieldWay& way, bool turned) {
  Points line(2, static_cast<Index>(way.points.size()));
  for (std::size_t k = 0; k < way.points.size(); ++k) line.col(static_cast<Index>(k)) = drawn_at(way.points[k], turned);
  return line;
}

std::string places_of(const RunField& field) {
  return std::string(field.to_places() ? "target" : "source") + (field.places().size() > 1 ? "s" : "");
}

std::string title_of(const RunField& field, const std::string& length_unit) {
  const std::string unit = unit_of_cost(field.problem());
  const std::string shown = unit == "length" ? length_unit : unit == "cost" ? "" : unit;
  const std::string what =
      field.is_corridor() ? "cost of a detour above the least"
                          : fmt::format("least cost {} the {}", field.to_places() ? "to" : "from", places_of(field));
  return what + (shown.empty() ? "" : " (" + shown + ")");
}

std::vector<LegendEntry> legend_of_field(const RunField& field, bool ways, const Scene& scene, bool walls, bool gaps,
                                         const Look& look) {
  std::vector<LegendEntry> out;
  if (look.ends) out.push_back(mark_entry("end", look.mark(4.5), field.is_corridor() ? "ends" : places_of(field)));
  if (look.path && ways) out.push_back(line_entry("path", "path"));
  if (look.shading) out.push_back(line_entry("level", "equal cost"));
  add_surroundings(scene, walls, look, out);
  if (look.shading && gaps) out.push_back(area_entry("out", "no path"));
  return out;
}

}  // namespace

void check_drawable(FieldNodes nodes) {
  if (nodes == FieldNodes::mesh)
    throw InputError(
        "a picture shows a field over a lattice; write one on a mesh as .ply or .vtp, for MeshLab and ParaView");
  if (nodes == FieldNodes::space)
    throw InputError("a picture shows a field in two coordinates; write one in space as .vti, for ParaView");
}

Figure field_figure(const RunField& field, const std::vector<FieldWay>& ways, const FigureRequest& request) {
  constexpr double kTallest = 1.15;  // in widths
  check_drawable(field.nodes());
  Look look = request.parts.look;
  look.printed = true;
  look.width = request.size.sketch_width();
  look.height = kTallest * look.width - cost_bar_height();
  const std::string unit = unit_of_cost(field.problem());
  look.unit = request.unit.empty() && unit == "m" ? "m" : request.unit;
  const Scene scene = scene_of(field);
  const bool turned = latitude_first(field.problem());
  const Raster values = thinned(as_map(field));
  const bool covered = look.obstacles && (!scene.obstacles.empty() || !scene.margins.empty() || !scene.free.empty());
  const Raster shown = covered ? continued(values) : values;
  const std::vector<Tick> levels = levels_of(values, field.is_corridor());
  const PlaneFrame frame(values.lower, values.upper, look);
  std::string inside;
  if (look.shading) inside += cost_bands(shown, levels, frame, BandColour::warm) + level_lines(shown, levels, frame);
  if (look.obstacles) inside += obstacles_in(scene, frame) + box_sides(scene, frame);
  std::vector<Points> lines;
  lines.reserve(ways.size());
  for (const FieldWay& way : ways) lines.push_back(line_of(way, turned));
  if (look.path) inside += polylines(lines, frame, "path");
  std::string out = clip_and_hatch(frame) + fmt::format("<g clip-path=\"url(#inside)\">\n{}</g>\n", inside);
  const auto* chart = find_ability<HasChart>(*field.problem().manifold);
  const std::vector<std::string> names =
      chart != nullptr ? chart->coordinate_names() : std::vector<std::string>{"x", "y"};
  out += frame.axes(look.axis(names[turned ? 1 : 0]), look.axis(names[turned ? 0 : 1]));
  const auto mark = [&](const Eigen::VectorXd& u, const char* name, double radius) {
    const Eigen::Vector2d at = drawn_at(u, turned);
    out += fmt::format("<circle class=\"{}\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2g}\"/>\n", name, frame.x(at[0]),
                       frame.y(at[1]), look.mark(radius));
  };
  if (look.ends) {
    for (const FieldWay& way : ways) mark(field.to_places() ? way.points.front() : way.points.back(), "point", 3.5);
    for (const PathEnd& place : field.places()) mark(place.u, "end", 5.5);
    if (field.is_corridor()) mark(field.target().u, "end", 5.5);
  }
  double height = frame.total_height();
  if (look.shading) {
    out += cost_bar(levels, frame, BandColour::warm, height + 4, title_of(field, look.unit));
    height += cost_bar_height();
  }
  const bool gaps = has_gaps(shown, covered && !turned, field.problem());
  const Sketch picture{"Least costs", "Lines of equal cost, the sources, and paths", frame.total_width(), height, out};
  const Sketch whole =
      request.parts.legend
          ? below(picture,
                  legend_sketch(legend_of_field(field, !ways.empty(), scene, shows_walls(scene, frame), gaps, look),
                                look.width))
          : picture;
  return {printed_svg(whole, request.size), request.size.width, request.size.width * whole.height / look.width,
          std::nullopt};
}

}  // namespace leastcost::app
