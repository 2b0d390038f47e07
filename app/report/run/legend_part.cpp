// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/report/run/plane_surroundings.hpp"
#include "app/report/run/run_parts.hpp"

namespace leastcost::app {
namespace {

bool holds_infinity(const std::optional<Raster>& raster) {
  return raster && std::any_of(raster->values.begin(), raster->values.end(), [](double v) { return std::isinf(v); });
}

void add_ground(const RunFiles& files, const Look& look, std::vector<LegendEntry>& out) {
  const Scene& scene = files.scene;
  add_surroundings(scene, look.obstacles && shows_walls(files), look, out);
  if (look.shading && holds_infinity(scene.cost)) out.push_back(area_entry("out", "cannot be reached"));
  if (look.shading && holds_infinity(scene.relief)) out.push_back(area_entry("out", "no data"));
  if (look.shading && scene.potential) out.push_back(line_entry("level", "levels of the lower bound"));
  if (!scene.curves.empty()) out.push_back(line_entry("domain", "domain"));
}

}  // namespace

std::vector<LegendEntry> legend_of(const RunFiles& files, const Look& look, bool map) {
  std::vector<LegendEntry> out;
  if (look.path) out.push_back(line_entry("path", "path"));
  if (look.points) {
    out.push_back(mark_entry("point", look.mark(3), look.printed ? "points" : "its points, equally spaced in cost"));
    out.back().layer = "points";
  }
  if (look.first) {
    out.push_back(line_entry("first", "first path"));
    out.back().layer = "first";
  }
  if (look.others && !files.scene.lines.others.empty()) {
    out.push_back(line_entry("other", "other paths of the family"));
    out.back().layer = "others";
  }
  if (look.ends && !files.result.flag("ring")) out.push_back(mark_entry("end", look.mark(4.5), "ends"));
  if (map || files.scene.dimension == 2) add_ground(files, look, out);
  return out;
}

}  // namespace leastcost::app
