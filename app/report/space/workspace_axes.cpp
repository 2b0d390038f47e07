// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/plot/scale.hpp"
#include "app/plot/text.hpp"
#include "app/report/space/workspace_view.hpp"

namespace leastcost::app {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// One edge of a box with what stands beside it.
struct AxisEdge {
  Vector3d from, to;
  Vector3d outwards;  ///< where its numbers stand
  Eigen::Index coordinate = 0;
};

Vector2d in_picture(const Projector& projector, const Vector3d& x) { return projector.place(x).head<2>(); }

/// Takes text in, and what room it needs.
void add_text(const Vector2d& at, const char* anchor, const std::string& text, AxesInSpace& out) {
  constexpr double kHalfHeight = 3.9;  // of a digit
  const double width = kDrawnFont * text_width(text);
  const double left = at[0] - (*anchor == 'e' ? width : *anchor == 'm' ? width / 2 : 0);
  out.room.extend(Vector2d(left, at[1] - kDrawnFont / 2));
  out.room.extend(Vector2d(left + width, at[1] + kDrawnFont / 2));
  out.svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", at[0], at[1] + kHalfHeight,
                         anchor, escaped(text));
}

void draw(const AxisEdge& edge, const Projector& projector, const std::string& title, AxesInSpace& axes) {
  constexpr double kShortest = 24, kPerTick = 44, kTick = 3.5, kNumber = 7, kBeside = 5, kAbove = 10;
  const bool upright = edge.coordinate == 2;
  const Vector2d from = in_picture(projector, edge.from), to = in_picture(projector, edge.to);
  const double length = (to - from).norm();
  if (!(length > kShortest)) return;
  Vector2d out = in_picture(projector, edge.from + edge.outwards) - from;
  out = upright ? Vector2d(-1, 0) : out.norm() > 0 ? Vector2d(out.normalized()) : Vector2d(0, 1);
  const char* anchor = out[0] < -0.5 ? "end" : out[0] > 0.5 ? "start" : "middle";
  axes.svg +=
      fmt::format("<path class=\"axis\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n", from[0], from[1], to[0], to[1]);
  const double low = edge.from[edge.coordinate], high = edge.to[edge.coordinate];
  double widest = 0;
  for (const Tick& tick : ticks(ScaleKind::linear, {low, high}, std::max(2, static_cast<int>(length / kPerTick)))) {
    if (tick.at < low || tick.at > high) continue;
    const Vector2d at = from + (to - from) * (tick.at - low) / (high - low);
    const double size = tick.label.empty() ? kTick / 2 : kTick;
    axes.svg += fmt::format("<path class=\"axis\" d=\"M{:.1f} {:.1f}l{:.1f} {:.1f}\"/>\n", at[0], at[1], size * out[0],
                            size * out[1]);
    if (tick.label.empty()) continue;
    widest = std::max(widest, kDrawnFont * text_width(tick.label));
    add_text(at + (kNumber + kBeside * std::abs(out[1])) * out, anchor, tick.label, axes);
  }
  if (upright) return add_text(to + Vector2d(0, -kAbove), "middle", title, axes);
  const double aside = kNumber + (std::abs(out[0]) > 0.5 ? widest : 0) + (1 + 1.3 * std::abs(out[1])) * kDrawnFont;
  add_text((from + to) / 2 + aside * out, anchor, title, axes);
}

std::array<AxisEdge, 3> edges_of(const Eigen::AlignedBox3d& box, const SpaceView& view) {
  const Vector3d eye = view.direction();
  const Vector3d &low = box.min(), &high = box.max();
  // The sides of the box that are seen.
  const double x = eye[0] > 0 ? high[0] : low[0], y = eye[1] > 0 ? high[1] : low[1];
  const double other_x = low[0] + high[0] - x, other_y = low[1] + high[1] - y;
  const Vector3d out_x = Vector3d(x - other_x, 0, 0).normalized(), out_y = Vector3d(0, y - other_y, 0).normalized();
  std::array<AxisEdge, 3> edges = {{{{low[0], y, low[2]}, {high[0], y, low[2]}, out_y, 0},
                                    {{x, low[1], low[2]}, {x, high[1], low[2]}, out_x, 1},
                                    {{x, other_y, low[2]}, {x, other_y, high[2]}, -out_y, 2}}};
  // Of the two upright edges at the sides the one on the left.
  const Vector3d right = view.axes.row(0);
  if (right.dot(Vector3d(other_x, y, 0) - Vector3d(x, other_y, 0)) < 0)
    edges[2] = {{other_x, y, low[2]}, {other_x, y, high[2]}, -out_x, 2};
  return edges;
}

}  // namespace

std::vector<Vector3d> ends_of_axes(const Eigen::AlignedBox3d& box, const SpaceView& view) {
  std::vector<Vector3d> out;
  for (const AxisEdge& edge : edges_of(box, view)) {
    out.push_back(edge.from);
    out.push_back(edge.to);
  }
  return out;
}

AxesInSpace axes_in_space(const Eigen::AlignedBox3d& box, const SpaceView& view, const Projector& projector,
                          const Look& look) {
  constexpr std::array<const char*, 3> kNames = {"x", "y", "z"};
  AxesInSpace axes;
  for (const AxisEdge& edge : edges_of(box, view))
    draw(edge, projector, look.axis(kNames[static_cast<std::size_t>(edge.coordinate)]), axes);
  return axes;
}

}  // namespace leastcost::app
