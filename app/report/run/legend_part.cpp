// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/run/run_parts.hpp"

namespace leastcost::app {
namespace {

std::string sample_line(const char* name) { return fmt::format("<path class=\"{}\" d=\"M1 6h28\"/>", name); }
std::string sample_area(const char* name) { return fmt::format("<path class=\"{}\" d=\"M3 1h24v10h-24Z\"/>", name); }
std::string sample_mark(const char* name, double radius) {
  return fmt::format("<circle class=\"{}\" cx=\"15\" cy=\"6\" r=\"{:.2g}\"/>", name, radius);
}

bool holds_infinity(const std::optional<Raster>& raster) {
  return raster && std::any_of(raster->values.begin(), raster->values.end(), [](double v) { return std::isinf(v); });
}

void add_surroundings(const RunFiles& files, const Look& look, std::vector<LegendEntry>& out) {
  const Scene& scene = files.scene;
  if (look.obstacles && !scene.obstacles.empty()) out.push_back({areas({"M3 1h24v10h-24Z"}, "obstacle"), "obstacles"});
  if (look.obstacles && !scene.free.empty()) out.push_back({areas({"M3 1h24v10h-24Z"}, "obstacle"), "blocked"});
  if (look.obstacles && !scene.margins.empty()) out.push_back({areas({"M3 1h24v10h-24Z"}, "margin"), "clearance"});
  if (look.obstacles && shows_walls(files))
    out.push_back({sample_area("out") + "<path class=\"wall\" d=\"M3 1v10\"/>", "outside the box"});
  if (look.shading && holds_infinity(scene.cost)) out.push_back({sample_area("out"), "cannot be reached"});
  if (look.shading && holds_infinity(scene.relief)) out.push_back({sample_area("out"), "no data"});
  if (look.shading && scene.potential) out.push_back({sample_line("level"), "levels of the lower bound"});
  if (!scene.curves.empty()) out.push_back({sample_line("domain"), "domain"});
}

}  // namespace

std::vector<LegendEntry> legend_of(const RunFiles& files, const Look& look, bool map) {
  std::vector<LegendEntry> out;
  if (look.path) out.push_back({sample_line("path"), "path"});
  if (look.points)
    out.push_back(
        {sample_mark("point", look.mark(3)), look.printed ? "points" : "its points, equally spaced in cost", "points"});
  if (look.first) out.push_back({sample_line("first"), "first path", "first"});
  if (look.others && !files.scene.lines.others.empty())
    out.push_back({sample_line("other"), "other paths of the family", "others"});
  if (look.ends && !files.result.flag("ring")) out.push_back({sample_mark("end", look.mark(4.5)), "ends"});
  if (map || files.scene.dimension == 2) add_surroundings(files, look, out);
  return out;
}

}  // namespace leastcost::app
