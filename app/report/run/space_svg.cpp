// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

#include "app/report/run/run_parts.hpp"
#include "app/report/space/space_image.hpp"
#include "app/report/space/space_marks.hpp"
#include "app/report/space/space_view.hpp"
#include "problems/drawing/thinned.hpp"

namespace leastcost::app {
namespace {

constexpr int kShades = 20;
constexpr std::size_t kDrawnTriangles = 3600;  ///< where they are drawn as such

int shade(const Eigen::Vector3d& normal, const SpaceView& view) {
  const Eigen::Vector3d seen = view.axes * normal;
  return std::clamp(static_cast<int>(lightness(seen[2] < 0 ? -seen : seen) * kShades), 0, kShades - 1);
}

std::string colour(int shade) {
  const auto [red, green, blue] = colour_of_light((shade + 0.5) / kShades);
  return fmt::format("#{:02x}{:02x}{:02x}", red, green, blue);
}

/// Without the vertices of no triangle, which stand anywhere.
TriangleSoup only_used(const TriangleSoup& surface) {
  TriangleSoup out;
  std::vector<int> number(surface.vertices.size(), -1);
  for (std::array<int, 3> triangle : surface.triangles) {
    for (int& v : triangle) {
      int& mine = number[static_cast<std::size_t>(v)];
      if (mine < 0) {
        mine = static_cast<int>(out.vertices.size());
        out.vertices.push_back(surface.vertices[static_cast<std::size_t>(v)]);
      }
      v = mine;
    }
    out.triangles.push_back(triangle);
  }
  return out;
}

/// Something opaque with a depth; drawn from far to near, neighbours of one shade in one element.
struct Piece {
  double depth = 0;
  int shade = 0;
  std::string d;
};

std::string painted(std::vector<Piece> pieces) {
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.depth < b.depth; });
  std::string out, d;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    d += pieces[i].d;
    if (i + 1 < pieces.size() && pieces[i + 1].shade == pieces[i].shade) continue;
    fmt::format_to(std::back_inserter(out), "<path fill=\"{0}\" stroke=\"{0}\" d=\"{1}\"/>\n", colour(pieces[i].shade),
                   d);
    d.clear();
  }
  return out;
}

std::vector<Piece> triangles(const TriangleSoup& surface, const Projector& projector, const SpaceView& view) {
  std::vector<Piece> pieces;
  for (const auto& [i, j, k] : surface.triangles) {
    const Eigen::Vector3d &a = surface.vertices[static_cast<std::size_t>(i)],
                          &b = surface.vertices[static_cast<std::size_t>(j)],
                          &c = surface.vertices[static_cast<std::size_t>(k)];
    const Eigen::Vector3d p = projector.place(a), q = projector.place(b), r = projector.place(c);
    pieces.push_back({p[2] + q[2] + r[2], shade((b - a).cross(c - a).normalized(), view),
                      fmt::format("M{:.0f} {:.0f}L{:.0f} {:.0f} {:.0f} {:.0f}Z", p[0], p[1], q[0], q[1], r[0], r[1])});
  }
  return pieces;
}

std::vector<Piece> discs(const Surfels& surfels, const Projector& projector, const SpaceView& view) {
  constexpr std::size_t kMost = 4000;
  const std::size_t step = surfels.positions.size() / kMost + 1;
  const double radius =
      std::clamp(0.62 * projector.scale() * surfels.spacing * std::sqrt(static_cast<double>(step)), 0.8, 6.0);
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < surfels.positions.size(); i += step) {
    const Eigen::Vector3d p = projector.place(surfels.positions[i]);
    pieces.push_back({p[2], shade(surfels.normals[i], view),
                      fmt::format("M{0:.1f} {1:.1f}a{2:.1f} {2:.1f} 0 1 0 .1 0Z", p[0], p[1], radius)});
  }
  return pieces;
}

/// What the picture has to show, in the view.
Eigen::AlignedBox2d area_of(const Scene& scene, const TriangleSoup& surface, const SpaceView& view) {
  Eigen::AlignedBox2d box;
  const auto grow = [&](const Eigen::Vector3d& x) {
    if (x.allFinite()) box.extend(Eigen::Vector2d((view.axes * x).head<2>()));
  };
  for (const auto& x : surface.vertices) grow(x);
  for (const auto& x : scene.surfels.positions) grow(x);
  for (const auto x : scene.lines.path.colwise()) grow(x);
  for (const auto x : scene.lines.first.colwise()) grow(x);
  return box;
}

/// The surface as an image that lies under everything else.
std::string image_of(const TriangleSoup& surface, const Projector& projector, const SpaceView& view, const Look& look) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& x : surface.vertices) box.extend(Eigen::Vector2d((view.axes * x).head<2>()));
  const double share = projector.scale() * box.sizes().maxCoeff() / look.width;
  const double pixels = std::clamp(look.image_width * share + 1, 2.0, kMostPixels);
  return image_element(shaded_image(surface, view, static_cast<int>(pixels)), projector);
}

}  // namespace

Sketch space_sketch(const RunFiles& files, const SpaceView& view, const Look& look) {
  constexpr int kDepthPixels = 320;
  constexpr double kBar = 14;
  constexpr Index kMostPoints = 150;
  const Scene& scene = files.scene;
  constexpr double kNoGaps = 1.1;  // between the squares of a cloud, of its spacing
  const bool image = look.image_width > 0;
  TriangleSoup surface = only_used(image ? scene.surface : thinned(scene.surface, Points(3, 0), kDrawnTriangles));
  if (image && surface.triangles.empty()) surface = squares(scene.surfels, kNoGaps);
  const Projector projector(area_of(scene, surface, view), view, look.width, look.height);
  const DepthMap depths(surface.triangles.empty() ? squares(scene.surfels) : surface, view, kDepthPixels);
  std::string out;
  if (look.shading && image && !surface.triangles.empty())
    out += image_of(surface, projector, view, look);
  else if (look.shading)
    out += "<g class=\"solid\">\n" + painted(triangles(surface, projector, view)) +
           painted(discs(scene.surfels, projector, view)) + "</g>\n";
  if (look.first) out += line_in_space(scene.lines.first, "first", projector, depths);
  if (look.others)
    for (const Points& other : scene.lines.others) out += line_in_space(other, "other", projector, depths);
  if (look.path) out += line_in_space(scene.lines.path, "path", projector, depths);
  if (look.points && (look.printed || files.points.cols() <= kMostPoints))
    out += circles_in_space(files.points, "point", look.mark(2.2), false, projector, depths);
  if (look.ends) out += circles_in_space(ends_of(files), "end", look.mark(5.5), true, projector, depths);
  if (look.printed) out += length_bar(projector, projector.height(), look.unit);
  return {"The path on its domain",
          "The domain seen from one side, with the path, its points, its ends and the first path", projector.width(),
          projector.height() + (look.printed ? kBar : 0), out};
}

}  // namespace leastcost::app
