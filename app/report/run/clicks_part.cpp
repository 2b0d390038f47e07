// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/run/clicks_part.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "app/plot/text.hpp"
#include "app/report/page/clicks_module.hpp"
#include "app/report/page/page.hpp"
#include "app/report/page/viewer_script.hpp"
#include "app/report/run/run_parts.hpp"
#include "problems/clicks/click_data.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::json;

constexpr double kMostWhole = 1e15;  // doubles hold these, doubled as well

std::vector<std::int64_t> whole(const std::vector<double>& numbers, double scale) {
  std::vector<std::int64_t> out;
  out.reserve(numbers.size());
  for (const double x : numbers) out.push_back(static_cast<std::int64_t>(std::llround(x * scale)));
  return out;
}

Json packed_mesh(const JsonFile& clicks) {
  const std::vector<double> vertices = clicks.numbers("mesh.vertices"), triangles = clicks.numbers("mesh.triangles");
  const int decimals = common_decimals(vertices);
  Json out = {{"vertex_count", vertices.size() / 3},
              {"triangle_count", triangles.size() / 3},
              {"triangles", packed(whole(triangles, 1), 1)}};
  out["decimals"] = decimals < 0 ? Json() : Json(decimals);
  out["vertices"] = decimals < 0 ? base64({reinterpret_cast<const char*>(vertices.data()), 8 * vertices.size()})
                                 : packed(whole(vertices, std::pow(10.0, decimals)), 3);
  if (clicks.has("mesh.numbers")) out["numbers"] = packed(whole(clicks.numbers("mesh.numbers"), 1), 1);
  return out;
}

Json plan_of(const JsonFile& clicks) {
  Json out = {{"corners", clicks.numbers("plan.corners")},
              {"counts", clicks.numbers("plan.counts")},
              {"required", clicks.numbers("plan.required")}};
  if (!clicks.has("plan.box")) return out;
  for (const char* side : {"lower", "upper"}) {
    Json& sides = out["box"][side] = Json::array();
    for (const double x : clicks.numbers(std::string("plan.box.") + side))
      sides.push_back(std::isfinite(x) ? Json(x) : Json());
  }
  return out;
}

/// The file of the mesh, without its folder.
std::string file_of_mesh(const RunFiles& files) {
  for (const JsonFile& input : files.manifest.objects("inputs"))
    if (input.text("role") == "data") return std::filesystem::path(input.text("file")).filename().string();
  return "mesh.obj";
}

/// Within a script element.
std::string within_script(const std::string& text) {
  std::string out;
  for (const char c : text) c == '<' ? out += "\\u003c" : out += c;
  return out;
}

}  // namespace

std::string packed(std::span<const std::int64_t> numbers, std::size_t stride) {
  std::string bytes;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::int64_t step = numbers[i] - (i >= stride ? numbers[i - stride] : 0);
    std::uint64_t rest = step >= 0 ? 2 * static_cast<std::uint64_t>(step) : 2 * static_cast<std::uint64_t>(-step) - 1;
    for (; rest >= 128; rest /= 128) bytes += static_cast<char>(rest % 128 + 128);
    bytes += static_cast<char>(rest);
  }
  return base64(bytes);
}

int common_decimals(const std::vector<double>& numbers) {
  for (int decimals = 0; decimals <= 12; ++decimals) {
    const double power = std::pow(10.0, decimals);
    bool all = true;
    for (const double x : numbers) {
      const double rounded = std::round(x * power);
      all = std::abs(rounded) < kMostWhole && rounded / power == x;
      if (!all) break;
    }
    if (all) return decimals;
  }
  return -1;
}

bool answers_clicks(const RunFiles& files) {
  return !clicks_module().empty() && files.clicks && !files.clicks->has("mesh.too_large") &&
         !files.clicks->has("plan.too_large") && (files.clicks->has("mesh") || files.scene.lines.path.cols() > 0);
}

bool has_clicked_mesh(const RunFiles& files) { return answers_clicks(files) && files.clicks->has("mesh"); }

std::string clicks_panel(const RunFiles& files) {
  if (!files.clicks || clicks_module().empty()) return "";
  if (files.clicks->has("mesh.too_large"))
    return paragraph(fmt::format("The page finds no other paths on this mesh: it has {} triangles, and the limit of "
                                 "the page is {}. “leastcost run” has no such limit.",
                                 files.clicks->text("mesh.too_large"), kMostClickedTriangles),
                     "soft");
  if (files.clicks->has("plan.too_large"))
    return paragraph(fmt::format("The page finds no other paths among these obstacles: there are {}, and the limit of "
                                 "the page is {}. “leastcost run” has no such limit.",
                                 files.clicks->text("plan.too_large"), kMostClickedObstacles),
                     "soft");
  if (!answers_clicks(files)) return "";
  const bool mesh = has_clicked_mesh(files);
  const char* how = "Click two points of the plane, or type their coordinates";
  if (mesh)
    how = viewer_script().empty() ? "Type the numbers of two vertices"
                                  : "Click two points of the surface, or type the numbers of two vertices";
  return fmt::format(
      "<section class=\"ask\" id=\"ask\">\n<h2>Other ends</h2> <svg class=\"plot\" width=\"30\" height=\"12\" "
      "aria-hidden=\"true\"><path class=\"asked\" d=\"M1 6h28\"/></svg>\n<p class=\"soft\">{0}: this page finds the "
      "shortest path between them and proves it, without a network.</p>\n"
      "<form id=\"ask-form\"><label>from <input id=\"ask-from\" autocomplete=\"off\" {1}></label> <label>to <input "
      "id=\"ask-to\" autocomplete=\"off\" {1}></label> <button>Find the path</button></form>\n"
      "<p id=\"ask-answer\" role=\"status\"></p>\n"
      "<div id=\"ask-lines\" hidden>\n"
      "<div class=\"copied\"><pre id=\"ask-yaml\"></pre><button data-copy=\"ask-yaml\">copy</button></div>\n"
      "<div class=\"copied\"><pre id=\"ask-python\"></pre><button data-copy=\"ask-python\">copy</button></div>\n"
      "</div>\n<noscript><p class=\"soft\">This needs JavaScript.</p></noscript>\n</section>\n",
      how, mesh ? "size=\"9\" inputmode=\"numeric\"" : "size=\"14\"");
}

std::string clicks_scripts(const RunFiles& files) {
  if (!answers_clicks(files)) return "";
  const bool mesh = has_clicked_mesh(files);
  const std::string unit = files.result.text("cost.unit");
  Json data = {{"unit", unit == "length" ? unit : "length (" + unit + ")"}, {"file", file_of_mesh(files)}};
  if (mesh)
    data["mesh"] = packed_mesh(*files.clicks);
  else {
    data["plan"] = plan_of(*files.clicks);
    const PlaneMap map = plane_map(files, {});
    data["frame"] = {{"left", map.left},   {"top", map.top},     {"width", map.width}, {"height", map.height},
                     {"scale", map.scale}, {"lower", map.lower}, {"upper", map.upper}};
  }
  return "<script type=\"application/json\" id=\"clicks\">" +
         within_script(data.dump(-1, ' ', false, Json::error_handler_t::replace)) +
         "</script>\n<script type=\"text/plain\" id=\"solver\">" + base64(clicks_module()) + "</script>\n<script>" +
         std::string(clicks_script()) + "</script>\n";
}

}  // namespace leastcost::app
