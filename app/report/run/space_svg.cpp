// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "app/plot/chart.hpp"
#include "app/report/run/space_view.hpp"

namespace leastcost::app {
namespace {

constexpr double kWidth = 860, kHeight = 560, kMargin = 14;
constexpr int kShades = 20;

/// Where points of the scene lie in the drawing.
class Projector {
 public:
  Projector(const Scene& scene, const SpaceView& view) : view_(view) {
    Eigen::AlignedBox2d box;
    const auto grow = [&](const Eigen::Vector3d& x) {
      if (x.allFinite()) box.extend(Eigen::Vector2d((view.axes * x).head<2>()));
    };
    for (const auto& x : scene.surface.vertices) grow(x);
    for (const auto& x : scene.surfels.positions) grow(x);
    for (const auto x : scene.lines.path.colwise()) grow(x);
    for (const auto x : scene.lines.first.colwise()) grow(x);
    const Eigen::Vector2d extent = box.diagonal().cwiseMax(1e-300);
    scale_ = std::min((kWidth - 2 * kMargin) / extent[0], (kHeight - 2 * kMargin) / extent[1]);
    middle_ = box.center();
    half_ = scale_ * extent / 2;
  }
  double width() const { return 2 * (half_[0] + kMargin); }
  double height() const { return 2 * (half_[1] + kMargin); }
  double scale() const { return scale_; }
  Eigen::Vector3d place(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d p = view_.axes * x;
    return {kMargin + half_[0] + scale_ * (p[0] - middle_[0]), kMargin + half_[1] - scale_ * (p[1] - middle_[1]), p[2]};
  }

 private:
  SpaceView view_;
  Eigen::Vector2d middle_, half_;
  double scale_ = 1;
};

/// Lit from above the left shoulder, the same from both sides.
int shade(const Eigen::Vector3d& normal, const SpaceView& view) {
  const Eigen::Vector3d light = Eigen::Vector3d(-0.35, 0.55, 0.76);
  const double brightness = std::abs((view.axes * normal).dot(light));
  return std::clamp(static_cast<int>(brightness * kShades), 0, kShades - 1);
}

std::string colour(int shade) {
  const double part = (shade + 0.5) / kShades;
  return fmt::format("#{:02x}{:02x}{:02x}", static_cast<int>(118 + 112 * part), static_cast<int>(114 + 110 * part),
                     static_cast<int>(106 + 104 * part));
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

std::string circles(const Points& x, const char* name, double radius, const Projector& projector,
                    const DepthMap& depths) {
  std::string out;
  for (const auto column : x.colwise()) {
    if (!depths.sees(column)) continue;
    const Eigen::Vector3d p = projector.place(column);
    fmt::format_to(std::back_inserter(out), "<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>", name, p[0],
                   p[1], radius);
  }
  return out + "\n";
}

}  // namespace

std::string space_svg(const Scene& scene, const TriangleSoup& surface, const Points& markers, const Points& ends,
                      const SpaceView& view) {
  const Projector projector(scene, view);
  const DepthMap depths(surface.triangles.empty() ? squares(scene.surfels) : surface, view, 320);
  std::string out = "<g class=\"solid\">\n" + painted(triangles(surface, projector, view)) +
                    painted(discs(scene.surfels, projector, view)) + "</g>\n";
  out += line(scene.lines.first, "first", projector, depths);
  for (const Points& other : scene.lines.others) out += line(other, "other", projector, depths);
  out += line(scene.lines.path, "path", projector, depths);
  if (markers.cols() <= 150) out += circles(markers, "point", 2.2, projector, depths);
  out += circles(ends, "end", 5.5, projector, depths);
  return svg_element("The path on its domain",
                     "The domain seen from one side, with the path, its points, its ends and the first path",
                     projector.width(), projector.height(), out, false);
}

}  // namespace leastcost::app
