// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/scene/scene.hpp"
#include "catalogue/scene/workspace_json.hpp"

namespace leastcost {
namespace {

using Json = nlohmann::json;

/// Writes numbers rounded to a fixed number of decimals, the shortest text that says them.
class Rounded {
 public:
  /// Seven digits of `extent`.
  explicit Rounded(double extent) {
    const double power = extent > 0 && std::isfinite(extent) ? 6 - std::floor(std::log10(extent)) : 6;
    scale_ = std::pow(10.0, std::clamp(power, -200.0, 200.0));
  }
  void add(std::string& text, double value) const {
    const double rounded = std::round(value * scale_) / scale_;
    if (std::isfinite(rounded))
      fmt::format_to(std::back_inserter(text), "{}", rounded == 0 ? 0.0 : rounded);
    else
      text += "null";
  }

 private:
  double scale_;
};

template <class Range>
std::string vectors(const Range& range, const Rounded& rounded) {
  std::string text = "[";
  for (const auto& x : range)
    for (const double value : x) {
      if (text.size() > 1) text += ',';
      rounded.add(text, value);
    }
  return text + "]";
}

std::string triangles(const std::vector<std::array<int, 3>>& all) {
  std::string text = "[";
  for (const auto& [a, b, c] : all)
    fmt::format_to(std::back_inserter(text), "{}{},{},{}", text.size() > 1 ? "," : "", a, b, c);
  return text + "]";
}

double extent_of(const Scene& scene) {
  double extent = 0;
  const auto grow = [&](const std::vector<Eigen::Vector3d>& points) {
    for (const Eigen::Vector3d& x : points) extent = std::max(extent, (x - points.front()).norm());
  };
  grow(scene.surface.vertices);
  grow(scene.surfels.positions);
  std::vector<Points> lines = scene.curves;
  lines.insert(lines.end(), scene.obstacles.begin(), scene.obstacles.end());
  lines.push_back(scene.lines.path);
  for (const Points& c : lines)
    if (c.size() > 0) extent = std::max(extent, (c.rowwise().maxCoeff() - c.rowwise().minCoeff()).norm());
  return extent;
}

std::string list_of(const std::vector<Points>& lines, const Rounded& rounded) {
  std::string text = "[";
  for (const Points& line : lines) text += (text.size() > 1 ? ",\n" : "") + vectors(line.colwise(), rounded);
  return text + "]";
}

std::string lines_text(const SceneLines& lines, const Rounded& rounded) {
  return fmt::format(",\n\"lines\":{{\"path\":{},\n\"first\":{},\n\"others\":{}}}",
                     vectors(lines.path.colwise(), rounded), vectors(lines.first.colwise(), rounded),
                     list_of(lines.others, rounded));
}

std::string raster_text(const Raster& raster) {
  std::string values = "[";
  for (const double value : raster.values) {
    if (values.size() > 1) values += ',';
    if (std::isfinite(value))
      fmt::format_to(std::back_inserter(values), "{:.4g}", value);
    else
      values += "null";
  }
  return fmt::format(R"({{"columns":{},"rows":{},"lower":[{},{}],"upper":[{},{}],"values":{}]}})", raster.columns,
                     raster.rows, raster.lower[0], raster.lower[1], raster.upper[0], raster.upper[1], values);
}

/// One side of a box; null: infinite.
std::string side(const Eigen::VectorXd& x) {
  std::string text = "[";
  for (const double value : x)
    text += fmt::format("{}{}", text.size() > 1 ? "," : "", std::isfinite(value) ? fmt::format("{}", value) : "null");
  return text + "]";
}

// --- reading -----------------------------------------------------------------------------------------------------

std::vector<Eigen::Vector3d> read_vectors(const Json& flat) {
  const auto numbers = flat.get<std::vector<double>>();
  if (numbers.size() % 3 != 0) throw InputError("a list of points whose length is not a multiple of 3");
  std::vector<Eigen::Vector3d> out;
  for (std::size_t i = 0; i < numbers.size(); i += 3) out.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return out;
}

TriangleSoup read_surface(const Json& json) {
  TriangleSoup out;
  out.vertices = read_vectors(json.at("vertices"));
  const auto corners = json.at("triangles").get<std::vector<int>>();
  if (corners.size() % 3 != 0) throw InputError("a list of triangles whose length is not a multiple of 3");
  for (const int corner : corners)
    if (corner < 0 || static_cast<std::size_t>(corner) >= out.vertices.size())
      throw InputError(fmt::format("a triangle refers to vertex {} of {}", corner, out.vertices.size()));
  for (std::size_t i = 0; i < corners.size(); i += 3)
    out.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  return out;
}

Surfels read_surfels(const Json& json) {
  Surfels out{read_vectors(json.at("positions")), read_vectors(json.at("normals")), json.at("spacing").get<double>()};
  if (out.normals.size() != out.positions.size()) throw InputError("not one normal per point");
  return out;
}

Eigen::VectorXd read_side(const Json& json, double none) {
  Eigen::VectorXd out(static_cast<Index>(json.size()));
  for (std::size_t i = 0; i < json.size(); ++i)
    out[static_cast<Index>(i)] = json[i].is_null() ? none : json[i].get<double>();
  return out;
}

Points read_line(const Json& json, int dimension) {
  std::vector<double> numbers;
  for (const Json& value : json) numbers.push_back(value.is_null() ? std::nan("") : value.get<double>());
  if (numbers.size() % static_cast<std::size_t>(dimension) != 0)
    throw InputError("a line whose length is not a multiple of the dimension");
  return Eigen::Map<const Points>(numbers.data(), dimension, static_cast<Index>(numbers.size()) / dimension);
}

/// Polylines; none where there is no such key.
std::vector<Points> read_list(const Json& json, const char* key, int dimension) {
  std::vector<Points> lines;
  if (json.contains(key))
    for (const Json& line : json.at(key)) lines.push_back(read_line(line, dimension));
  return lines;
}

SceneLines read_lines(const Json& json, int dimension) {
  SceneLines lines{read_line(json.at("path"), dimension), read_line(json.at("first"), dimension), {}};
  for (const Json& other : json.at("others")) lines.others.push_back(read_line(other, dimension));
  return lines;
}

Raster read_raster(const Json& json) {
  Raster out;
  out.columns = json.at("columns").get<int>();
  out.rows = json.at("rows").get<int>();
  for (Index i = 0; i < 2; ++i) {
    out.lower[i] = json.at("lower").at(static_cast<std::size_t>(i)).get<double>();
    out.upper[i] = json.at("upper").at(static_cast<std::size_t>(i)).get<double>();
  }
  for (const Json& value : json.at("values"))
    out.values.push_back(value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>());
  const bool fits = out.columns > 1 && out.rows > 1 && (out.upper.array() > out.lower.array()).all() &&
                    out.values.size() == static_cast<std::size_t>(out.columns) * static_cast<std::size_t>(out.rows);
  if (!fits) throw InputError("a raster with the wrong number of values");
  return out;
}

Scene read(const Json& json) {
  Scene scene;
  scene.dimension = json.at("dimension").get<int>();
  if (scene.dimension < 1) throw InputError("a dimension below 1");
  if (json.contains("lines")) scene.lines = read_lines(json.at("lines"), scene.dimension);
  for (std::size_t i = 0; i < 3; ++i) scene.up[static_cast<Index>(i)] = json.at("up").at(i).get<double>();
  if (json.contains("surface")) scene.surface = read_surface(json.at("surface"));
  if (json.contains("points")) scene.surfels = read_surfels(json.at("points"));
  scene.curves = read_list(json, "curves", scene.dimension);
  scene.obstacles = read_list(json, "obstacles", scene.dimension);
  scene.margins = read_list(json, "margins", scene.dimension);
  scene.free = read_list(json, "free", scene.dimension);
  if (json.contains("box")) {
    const double infinity = std::numeric_limits<double>::infinity();
    scene.lower = read_side(json.at("box").at("lower"), -infinity);
    scene.upper = read_side(json.at("box").at("upper"), infinity);
    if (scene.lower.size() != scene.dimension || scene.upper.size() != scene.dimension)
      throw InputError("a box that does not fit the dimension");
  }
  if (json.contains("strip")) {
    scene.strip.obstacles = read_list(json.at("strip"), "obstacles", 2);
    if (json.at("strip").contains("hand")) scene.strip.hand = read_line(json.at("strip").at("hand"), 2);
    if (json.at("strip").contains("hand_in_space"))
      scene.strip.hand_in_space = read_line(json.at("strip").at("hand_in_space"), 3);
    if (json.at("strip").contains("workspace"))
      scene.strip.workspace = read_workspace(json.at("strip").at("workspace"));
    for (const Json& pose : json.at("strip").at("poses")) {
      std::vector<Points>& parts = scene.strip.poses.emplace_back();
      for (const Json& part : pose) parts.push_back(read_line(part, 2));
    }
  }
  if (json.contains("cost")) scene.cost = read_raster(json.at("cost"));
  if (json.contains("relief")) scene.relief = read_raster(json.at("relief"));
  if (json.contains("potential")) scene.potential = read_raster(json.at("potential"));
  for (const Json& note : json.at("notes")) scene.notes.push_back(note.get<std::string>());
  return scene;
}

/// To seven digits of its own extent.
std::string strip_text(const PoseStrip& strip) {
  double extent = 0;
  for (const auto& pose : strip.poses)
    for (const Points& part : pose) extent = std::max(extent, part.cwiseAbs().maxCoeff());
  const Rounded rounded(extent);
  std::string poses;
  for (const auto& pose : strip.poses) poses += (poses.empty() ? "" : ",\n") + list_of(pose, rounded);
  const std::string workspace = strip.workspace.empty() ? "" : ",\n\"workspace\":" + workspace_json(strip.workspace);
  return fmt::format("{{\"obstacles\":{},\n\"hand\":{},\n\"hand_in_space\":{},\n\"poses\":[{}]{}}}",
                     list_of(strip.obstacles, rounded), vectors(strip.hand.colwise(), rounded),
                     vectors(strip.hand_in_space.colwise(), rounded), poses, workspace);
}

}  // namespace

std::string scene_json(const Scene& scene) {
  const Rounded rounded(extent_of(scene));
  std::string text = fmt::format("{{\"schema_version\":{},\"dimension\":{},\"up\":[{},{},{}]", kSceneVersion,
                                 scene.dimension, scene.up[0], scene.up[1], scene.up[2]);
  if (scene.lines.path.size() > 0) text += lines_text(scene.lines, rounded);
  if (!scene.surface.triangles.empty())
    text += fmt::format(",\n\"surface\":{{\"vertices\":{},\n\"triangles\":{}}}",
                        vectors(scene.surface.vertices, rounded), triangles(scene.surface.triangles));
  if (!scene.surfels.positions.empty())
    text += fmt::format(",\n\"points\":{{\"spacing\":{:.6g},\"positions\":{},\n\"normals\":{}}}", scene.surfels.spacing,
                        vectors(scene.surfels.positions, rounded), vectors(scene.surfels.normals, Rounded(1e4)));
  const std::pair<const char*, const std::vector<Points>&> outlines[] = {
      {"curves", scene.curves}, {"obstacles", scene.obstacles}, {"margins", scene.margins}, {"free", scene.free}};
  for (const auto& [name, lines] : outlines)
    if (!lines.empty()) text += fmt::format(",\n\"{}\":", name) + list_of(lines, rounded);
  if (scene.lower.size() > 0)
    text += fmt::format(",\n\"box\":{{\"lower\":{},\"upper\":{}}}", side(scene.lower), side(scene.upper));
  if (!scene.strip.poses.empty()) text += ",\n\"strip\":" + strip_text(scene.strip);
  if (scene.cost) text += ",\n\"cost\":" + raster_text(*scene.cost);
  if (scene.relief) text += ",\n\"relief\":" + raster_text(*scene.relief);
  if (scene.potential) text += ",\n\"potential\":" + raster_text(*scene.potential);
  return text + ",\n\"notes\":" + Json(scene.notes).dump(-1, ' ', false, Json::error_handler_t::replace) + "}\n";
}

Scene read_scene(std::string_view text, const std::string& name) {
  try {
    return read(Json::parse(text));
  } catch (const Json::exception& e) {
    throw InputError(name + ": not a scene of leastcost: " + e.what());
  } catch (const InputError& e) {
    throw InputError(name + ": not a scene of leastcost: " + e.what());
  }
}

}  // namespace leastcost
