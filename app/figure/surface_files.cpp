// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/figure/surface_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "app/report/page/results_folder.hpp"
#include "app/report/run/run_files.hpp"
#include "app/report/space/workspace_view.hpp"
#include "catalogue/output/vtp.hpp"

namespace leastcost::app {
namespace {

namespace fs = std::filesystem;

constexpr double kNone = -1;  ///< of a value that a point does not have
enum class Part : int { path = 1, other = 2, surface = 3, start = 4, target = 5 };

/// A polyline: so many points from one on.
struct Line {
  std::size_t first = 0, count = 0;
  Part part = Part::path;
};

struct Model {
  std::vector<Eigen::Vector3d> points;
  std::vector<double> cumulative_cost, cost_per_length;
  std::vector<std::array<int, 3>> triangles;
  std::vector<Part> parts;  ///< of the triangles
  std::vector<Line> lines;
  bool has_field = false;
};

void add_point(Model& model, const Eigen::Vector3d& x, double cost, double field) {
  model.points.push_back(x);
  model.cumulative_cost.push_back(cost);
  model.cost_per_length.push_back(field);
}

Eigen::Vector3d in_space(const Eigen::VectorXd& x) {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  p.head(std::min<Index>(3, x.size())) = x.head(std::min<Index>(3, x.size()));
  return p;
}

/// The bilinear value; kNone outside and where there is none.
double value_at(const Raster& raster, const Eigen::Vector3d& x) {
  const Eigen::Vector2d cells(raster.columns - 1, raster.rows - 1);
  const Eigen::Vector2d at =
      (x.head<2>() - raster.lower).cwiseQuotient(raster.upper - raster.lower).cwiseProduct(cells);
  if ((at.array() < 0).any() || (at.array() > cells.array()).any()) return kNone;
  const Eigen::Vector2d low = at.array().floor().min(cells.array() - 1), part = at - low;
  const auto node = [&](double i, double j) {
    return raster
        .values[static_cast<std::size_t>(j) * static_cast<std::size_t>(raster.columns) + static_cast<std::size_t>(i)];
  };
  const double value = (1 - part[1]) * ((1 - part[0]) * node(low[0], low[1]) + part[0] * node(low[0] + 1, low[1])) +
                       part[1] * ((1 - part[0]) * node(low[0], low[1] + 1) + part[0] * node(low[0] + 1, low[1] + 1));
  return std::isfinite(value) ? value : kNone;
}

/// The plane where it has a cost, as a surface.
void add_plane(Model& model, const Raster& raster) {
  model.has_field = true;
  const auto first = static_cast<int>(model.points.size());
  const Eigen::Vector2d cell =
      (raster.upper - raster.lower).cwiseQuotient(Eigen::Vector2d(raster.columns - 1, raster.rows - 1));
  for (int j = 0; j < raster.rows; ++j)
    for (int i = 0; i < raster.columns; ++i) {
      const Eigen::Vector2d x = raster.lower + cell.cwiseProduct(Eigen::Vector2d(i, j));
      const double value = raster.values[static_cast<std::size_t>(j * raster.columns + i)];
      add_point(model, {x[0], x[1], 0}, kNone, std::isfinite(value) ? value : kNone);
    }
  for (int j = 0; j + 1 < raster.rows; ++j)
    for (int i = 0; i + 1 < raster.columns; ++i) {
      const int a = first + j * raster.columns + i, b = a + 1, c = b + raster.columns, d = a + raster.columns;
      const auto finite = [&](int v) { return model.cost_per_length[static_cast<std::size_t>(v)] != kNone; };
      if (!finite(a) || !finite(b) || !finite(c) || !finite(d)) continue;
      model.triangles.push_back({a, b, c});
      model.triangles.push_back({a, c, d});
    }
}

void add_line(Model& model, const Points& x, const std::vector<double>& costs, Part part, bool ring,
              const Scene& scene) {
  Line line{model.points.size(), 0, part};
  const bool known = costs.size() == static_cast<std::size_t>(x.cols());
  for (Index i = 0; i <= x.cols(); ++i) {
    if (i == x.cols() && !ring) break;
    const Eigen::Vector3d p = in_space(x.col(i % x.cols()));
    if (!p.allFinite()) continue;
    add_point(model, p, known && i < x.cols() ? costs[static_cast<std::size_t>(i)] : kNone,
              scene.cost ? value_at(*scene.cost, p) : kNone);
    ++line.count;
  }
  if (line.count > 1) model.lines.push_back(line);
}

Points columns_of(const NumberTable& table, const std::vector<std::string>& names) {
  Points x(static_cast<Index>(names.size()), static_cast<Index>(table.rows()));
  for (std::size_t i = 0; i < names.size(); ++i)
    x.row(static_cast<Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXd>(table[names[i]].data(), static_cast<Index>(table.rows()));
  return x;
}

void add_surface(Model& model, const TriangleSoup& surface, Part part) {
  const auto first = static_cast<int>(model.points.size());
  for (const Eigen::Vector3d& x : surface.vertices) add_point(model, x, kNone, kNone);
  for (const auto& [a, b, c] : surface.triangles) model.triangles.push_back({first + a, first + b, first + c});
  model.parts.resize(model.triangles.size(), part);
}

/// The robot at both ends of its path, and what it moves among.
void add_workspace(Model& model, const Workspace& workspace) {
  constexpr int kAround = 32;
  const auto all = [](std::size_t) { return true; };
  add_surface(model, workspace.obstacles, Part::surface);
  add_surface(model, workspace.ground, Part::surface);
  add_surface(model, robot_surface(workspace, 0, all, kAround), Part::start);
  add_surface(model, robot_surface(workspace, workspace.poses.size() - 1, all, kAround), Part::target);
}

Model model_of(const fs::path& folder) {
  const RunFiles files = read_run_files(folder);
  const Scene& scene = files.scene;
  Model model;
  if (!scene.strip.workspace.empty())
    add_workspace(model, scene.strip.workspace);
  else
    add_surface(model, scene.surface, Part::surface);
  if (scene.cost) add_plane(model, *scene.cost);
  model.parts.resize(model.triangles.size(), Part::surface);
  const bool ring = files.result.flag("ring");
  const NumberTable curve(fs::exists(folder / "curve.csv") ? folder / "curve.csv" : folder / "path.csv");
  if (scene.strip.hand_in_space.cols() > 0)
    add_line(model, scene.strip.hand_in_space, curve["cumulative_cost"], Part::path, false, scene);
  else if (scene.dimension > 3)
    throw InputError(fmt::format("{}: a path in {} dimensions has no place in space; path.csv has its coordinates",
                                 folder.string(), scene.dimension));
  else
    add_line(model, columns_of(curve, files.coordinates), curve["cumulative_cost"], Part::path, ring, scene);
  for (const Points& other : scene.lines.others) add_line(model, other, {}, Part::other, false, scene);
  return model;
}

/// One row of text for each of so many.
template <class Row>
std::string rows(std::size_t count, Row row) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) fmt::format_to(std::back_inserter(text), "{}\n", row(i));
  return text;
}

std::string xyz(const Eigen::Vector3d& x) { return fmt::format("{} {} {}", x[0], x[1], x[2]); }

std::string vtp(const Model& model) {
  const std::size_t points = model.points.size(), lines = model.lines.size(), faces = model.triangles.size();
  std::string text = "      <PointData Scalars=\"cumulative_cost\">\n";
  const auto of_points = [&](const char* name, const std::vector<double>& values) {
    text += vtp_array(name, 1, "Float64", rows(points, [&](std::size_t i) { return values[i]; }));
  };
  of_points("cumulative_cost", model.cumulative_cost);
  if (model.has_field) of_points("cost_per_length", model.cost_per_length);
  text += "      </PointData>\n      <CellData>\n" +
          vtp_array("part", 1, "Int32", rows(lines + faces, [&](std::size_t i) {
                      return static_cast<int>(i < lines ? model.lines[i].part : model.parts[i - lines]);
                    }));
  text += "      </CellData>\n      <Points>\n" +
          vtp_array("Points", 3, "Float64", rows(points, [&](std::size_t i) { return xyz(model.points[i]); }));
  std::size_t end = 0;
  text += "      </Points>\n      <Lines>\n" + vtp_array("connectivity", 1, "Int64", rows(lines, [&](std::size_t i) {
                                                           std::string numbers;
                                                           for (std::size_t k = 0; k < model.lines[i].count; ++k)
                                                             numbers += fmt::format("{} ", model.lines[i].first + k);
                                                           return numbers;
                                                         }));
  text += vtp_array("offsets", 1, "Int64", rows(lines, [&](std::size_t i) { return end += model.lines[i].count; }));
  text += "      </Lines>\n      <Polys>\n" + vtp_array("connectivity", 1, "Int64", rows(faces, [&](std::size_t i) {
                                                          const auto& t = model.triangles[i];
                                                          return fmt::format("{} {} {}", t[0], t[1], t[2]);
                                                        }));
  text += vtp_array("offsets", 1, "Int64", rows(faces, [](std::size_t i) { return 3 * (i + 1); }));
  return vtp_file({.points = static_cast<std::int64_t>(points),
                   .lines = static_cast<std::int64_t>(lines),
                   .polygons = static_cast<std::int64_t>(faces)},
                  text + "      </Polys>\n");
}

std::string ply(const Model& model) {
  std::size_t edges = 0;
  for (const Line& line : model.lines) edges += line.count - 1;
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\ncomment surface and path by leastcost; cumulative_cost -1: not on the path\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\nproperty double cumulative_cost\n{}"
      "element face {}\nproperty list uchar int vertex_indices\nelement edge {}\nproperty int vertex1\nproperty int "
      "vertex2\nend_header\n",
      model.points.size(), model.has_field ? "property double cost_per_length\n" : "", model.triangles.size(), edges);
  for (std::size_t i = 0; i < model.points.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{} {}", xyz(model.points[i]), model.cumulative_cost[i]);
    text += model.has_field ? fmt::format(" {}\n", model.cost_per_length[i]) : "\n";
  }
  for (const auto& [a, b, c] : model.triangles) fmt::format_to(std::back_inserter(text), "3 {} {} {}\n", a, b, c);
  for (const Line& line : model.lines)
    for (std::size_t k = line.first; k + 1 < line.first + line.count; ++k)
      fmt::format_to(std::back_inserter(text), "{} {}\n", k, k + 1);
  return text;
}

}  // namespace

std::string surface_file(const fs::path& folder, FigureFormat format) {
  if (kind_of_results(folder) != "run")
    throw InputError(folder.string() + ": has no path to write; give the output folder of `leastcost run`");
  const Model model = model_of(folder);
  return format == FigureFormat::vtp ? vtp(model) : ply(model);
}

}  // namespace leastcost::app
