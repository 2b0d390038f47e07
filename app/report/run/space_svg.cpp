// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

#include "app/plot/text.hpp"
#include "app/report/run/space_view.hpp"
#include "problems/drawing/thinned.hpp"

namespace leastcost::app {
namespace {

constexpr double kMargin = 8;
constexpr int kShades = 20;
constexpr std::size_t kDrawnTriangles = 3600;  ///< where they are drawn as such

/// Where points of the scene lie in the drawing.
class Projector {
 public:
  Projector(const Scene& scene, const TriangleSoup& surface, const SpaceView& view, const Look& look) : view_(view) {
    Eigen::AlignedBox2d box;
    const auto grow = [&](const Eigen::Vector3d& x) {
      if (x.allFinite()) box.extend(Eigen::Vector2d((view.axes * x).head<2>()));
    };
    for (const auto& x : surface.vertices) grow(x);
    for (const auto& x : scene.surfels.positions) grow(x);
    for (const auto x : scene.lines.path.colwise()) grow(x);
    for (const auto x : scene.lines.first.colwise()) grow(x);
    const Eigen::Vector2d extent = box.diagonal().cwiseMax(1e-300);
    scale_ = std::min((look.width - 2 * kMargin) / extent[0], (look.height - 2 * kMargin) / extent[1]);
    middle_ = box.center();
    half_ = scale_ * extent / 2;
  }
  double width() const { return 2 * (half_[0] + kMargin); }
  double height() const { return 2 * (half_[1] + kMargin); }
  double scale() const { return scale_; }
  Eigen::Vector3d place(const Eigen::Vector3d& x) const { return place_seen(view_.axes * x); }
  /// Of a place of the view.
  Eigen::Vector3d place_seen(const Eigen::Vector3d& p) const {
    return {kMargin + half_[0] + scale_ * (p[0] - middle_[0]), kMargin + half_[1] - scale_ * (p[1] - middle_[1]), p[2]};
  }

 private:
  SpaceView view_;
  Eigen::Vector2d middle_, half_;
  double scale_ = 1;
};

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

/// A line in two parts: what is seen, and what is hidden.
std::string line(const Points& x, const char* name, const Projector& projector, const DepthMap& depths) {
  std::string seen, hidden;
  bool was_seen = false;
  for (Index i = 0; i < x.cols(); ++i) {
    if (!x.col(i).allFinite()) continue;
    const bool sees = depths.sees(x.col(i));
    std::string& d = sees ? seen : hidden;
    const Eigen::Vector3d p = projector.place(x.col(i));
    if (i > 0 && (sees != was_seen || d.empty())) {
      const Eigen::Vector3d before = projector.place(x.col(i - 1));
      fmt::format_to(std::back_inserter(d), "M{:.1f} {:.1f}", before[0], before[1]);
    }
    fmt::format_to(std::back_inserter(d), "{}{:.1f} {:.1f}", d.empty() ? "M" : "L", p[0], p[1]);
    was_seen = sees;
  }
  std::string out;
  if (!hidden.empty()) out += fmt::format("<path class=\"{} hidden\" d=\"{}\"/>\n", name, hidden);
  if (!seen.empty()) out += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", name, seen);
  return out;
}

std::string circles(const Points& x, const char* name, double radius, bool hidden_too, const Projector& projector,
                    const DepthMap& depths) {
  std::string out;
  for (const auto column : x.colwise()) {
    const bool seen = depths.sees(column);
    if (!seen && !hidden_too) continue;
    const Eigen::Vector3d p = projector.place(column);
    fmt::format_to(std::back_inserter(out), "<circle class=\"{}{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2g}\"/>\n", name,
                   seen ? "" : " hidden", p[0], p[1], radius);
  }
  return out;
}

/// The surface as an image that lies under everything else.
std::string image_of(const TriangleSoup& surface, const Projector& projector, const SpaceView& view, const Look& look) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& x : surface.vertices) box.extend(Eigen::Vector2d((view.axes * x).head<2>()));
  const double share = projector.scale() * box.sizes().maxCoeff() / look.width;
  constexpr double kMostPixels = 3000;  // some 400 MB while it is made
  const double pixels = std::clamp(look.image_width * share + 1, 2.0, kMostPixels);
  const ShadedImage image = shaded_image(surface, view, static_cast<int>(pixels));
  const Eigen::Vector3d corner = projector.place_seen({image.area.min()[0], image.area.max()[1], 0});
  const Eigen::Vector2d size = projector.scale() * image.area.sizes();
  return fmt::format(
      "<image x=\"{:.3f}\" y=\"{:.3f}\" width=\"{:.3f}\" height=\"{:.3f}\" preserveAspectRatio=\"none\" "
      "xlink:href=\"data:image/png;base64,{}\"/>\n",
      corner[0], corner[1], size[0], size[1], base64(image.png));
}

/// A round length about a quarter as wide as the drawing, with what it is.
std::string length_bar(const Projector& projector, double top, const std::string& unit) {
  const double wanted = projector.width() / projector.scale() / 4,
               power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double factor = wanted / power, length = power * (factor < 2 ? 1 : factor < 5 ? 2 : 5);
  constexpr double kLong = 1e4, kKilo = 1e3;
  const bool kilometres = unit == "m" && length >= kLong;
  const std::string label =
      number_text(kilometres ? length / kKilo : length, 1) + (unit.empty() ? "" : " ") + (kilometres ? "km" : unit);
  return fmt::format(
      "<path class=\"axis\" d=\"M{0:.2f} {1:.1f}v6m0 -3h{2:.3f}m0 -3v6\"/><text x=\"{3:.1f}\" "
      "y=\"{4:.1f}\">{5}</text>\n",
      kMargin, top, projector.scale() * length, kMargin + projector.scale() * length + 6, top + 6.8, escaped(label));
}

}  // namespace

double lightness(const Eigen::Vector3d& normal) {
  constexpr double kAmbient = 0.4;  // what is turned away from the lamp still has some light
  const Eigen::Vector3d lamp(-0.35, 0.55, 0.76);
  return std::clamp((normal.dot(lamp) + kAmbient) / (1 + kAmbient), 0.0, 1.0);
}

std::array<int, 3> colour_of_light(double lightness) {
  return {static_cast<int>(118 + 112 * lightness), static_cast<int>(114 + 110 * lightness),
          static_cast<int>(106 + 104 * lightness)};
}

Sketch space_sketch(const RunFiles& files, const SpaceView& view, const Look& look) {
  constexpr int kDepthPixels = 320;
  constexpr double kBar = 14;
  constexpr Index kMostPoints = 150;
  const Scene& scene = files.scene;
  constexpr double kNoGaps = 1.1;  // between the squares of a cloud, of its spacing
  const bool image = look.image_width > 0;
  TriangleSoup surface = only_used(image ? scene.surface : thinned(scene.surface, Points(3, 0), kDrawnTriangles));
  if (image && surface.triangles.empty()) surface = squares(scene.surfels, kNoGaps);
  const Projector projector(scene, surface, view, look);
  const DepthMap depths(surface.triangles.empty() ? squares(scene.surfels) : surface, view, kDepthPixels);
  std::string out;
  if (look.shading && image && !surface.triangles.empty())
    out += image_of(surface, projector, view, look);
  else if (look.shading)
    out += "<g class=\"solid\">\n" + painted(triangles(surface, projector, view)) +
           painted(discs(scene.surfels, projector, view)) + "</g>\n";
  if (look.first) out += line(scene.lines.first, "first", projector, depths);
  if (look.others)
    for (const Points& other : scene.lines.others) out += line(other, "other", projector, depths);
  if (look.path) out += line(scene.lines.path, "path", projector, depths);
  if (look.points && (look.printed || files.points.cols() <= kMostPoints))
    out += circles(files.points, "point", look.mark(2.2), false, projector, depths);
  if (look.ends) out += circles(ends_of(files), "end", look.mark(5.5), true, projector, depths);
  if (look.printed) out += length_bar(projector, projector.height(), look.unit);
  return {"The path on its domain",
          "The domain seen from one side, with the path, its points, its ends and the first path", projector.width(),
          projector.height() + (look.printed ? kBar : 0), out};
}

}  // namespace leastcost::app
