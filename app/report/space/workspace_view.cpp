// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/space/workspace_view.hpp"

#include <algorithm>
#include <cmath>

#include "problems/drawing/solids.hpp"

namespace leastcost::app {
namespace {

using Eigen::Vector3d;

Vector3d placed(const DrawnFrame& frame, const Vector3d& x) { return frame.turn * x + frame.origin; }

bool always(std::size_t) { return true; }

/// How much of the points is seen, 0 to 1.
double part_seen(const DepthMap& depths, const std::vector<Vector3d>& points) {
  if (points.empty()) return 1;
  const auto seen = std::count_if(points.begin(), points.end(), [&](const Vector3d& x) { return depths.sees(x); });
  return static_cast<double>(seen) / static_cast<double>(points.size());
}

/// On the axes of capsules and the corners of plates; later links count more often, for they are what moves.
std::vector<Vector3d> points_of(const Workspace& workspace, std::size_t pose) {
  std::vector<Vector3d> out;
  const std::vector<DrawnFrame>& frames = workspace.poses[pose];
  for (const DrawnCapsule& capsule : workspace.capsules)
    for (const double at : {0.0, 0.5, 1.0})
      out.push_back(placed(frames[capsule.link], capsule.from + at * (capsule.to - capsule.from)));
  const std::size_t step = workspace.plates.size() / 100 + 1;
  for (std::size_t i = 0; i < workspace.plates.size(); i += step)
    out.push_back(placed(frames[workspace.plates[i].link], workspace.plates[i].corners[0]));
  return out;
}

/// The area that a surface fills in the view.
double covered(const TriangleSoup& surface, const SpaceView& view, int pixels) {
  const DepthMap map(surface, view, pixels);
  double count = 0;
  for (int j = 0; j < map.grid().rows; ++j)
    for (int i = 0; i < map.grid().columns; ++i)
      if (map.triangle(i, j) >= 0) ++count;
  return count * map.grid().pixel * map.grid().pixel;
}

}  // namespace

std::vector<std::size_t> poses_drawn(const Workspace& workspace) {
  constexpr std::size_t kBetween = 4;  // moves from one to the next
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k <= kBetween && !workspace.poses.empty(); ++k)
    out.push_back(k * (workspace.poses.size() - 1) / kBetween);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::vector<bool> still_links(const Workspace& workspace) {
  if (workspace.empty()) return {};
  const double small = 1e-4 * (workspace.upper - workspace.lower).norm();
  const std::vector<DrawnFrame>& first = workspace.poses.front();
  std::vector<bool> still(first.size(), true);
  for (const std::vector<DrawnFrame>& pose : workspace.poses)
    for (std::size_t link = 0; link < first.size(); ++link)
      if ((pose[link].origin - first[link].origin).norm() > small ||
          pose[link].turn.angularDistance(first[link].turn) > 1e-3)
        still[link] = false;
  return still;
}

TriangleSoup robot_surface(const Workspace& workspace, std::size_t pose, const std::function<bool(std::size_t)>& wanted,
                           int around) {
  TriangleSoup out;
  const std::vector<DrawnFrame>& frames = workspace.poses[pose];
  for (const DrawnCapsule& capsule : workspace.capsules)
    if (wanted(capsule.link)) {
      const DrawnFrame& frame = frames[capsule.link];
      append(out, capsule_surface(placed(frame, capsule.from), placed(frame, capsule.to), capsule.radius, around));
    }
  for (const DrawnPlate& plate : workspace.plates)
    if (wanted(plate.link)) {
      const DrawnFrame& frame = frames[plate.link];
      const auto& [a, b, c] = plate.corners;
      append(out, {{placed(frame, a), placed(frame, b), placed(frame, c)}, {{0, 1, 2}}});
    }
  return out;
}

SpaceView choose_view(const PoseStrip& strip) {
  constexpr int kQuarters = 4, kSides = 6, kPixels = 60, kCoarse = 8;
  constexpr double kQuarter = 90, kFirst = 20, kStep = 10;  // degrees: not along an axis
  constexpr double kLow = 22, kHigh = 36, kLikingLow = 0.05, kApart = 2, kOfHand = 0.4, kSpread = 0.5;
  const Workspace& workspace = strip.workspace;
  const std::vector<std::size_t> drawn = poses_drawn(workspace);
  std::vector<std::vector<Vector3d>> points;
  points.reserve(drawn.size() + 2);
  for (const std::size_t pose : drawn) points.push_back(points_of(workspace, pose));
  points.push_back(points.front());  // the ends count twice
  points.push_back(points[drawn.size() - 1]);
  std::vector<Vector3d> hand;
  for (const auto x : strip.hand_in_space.colwise()) hand.emplace_back(x);
  TriangleSoup both = robot_surface(workspace, drawn.front(), always, kCoarse);
  append(both, robot_surface(workspace, drawn.back(), always, kCoarse));
  const double size = std::max((workspace.upper - workspace.lower).norm(), 1e-300);
  const auto score = [&](const SpaceView& view) {
    const DepthMap obstacles(workspace.obstacles, view, kPixels);
    double seen = 0;
    for (const std::vector<Vector3d>& pose : points) seen += part_seen(obstacles, pose);
    // Poses that stand beside each other fill more of the picture than poses behind each other.
    const double filled = covered(both, view, kPixels) / (size * size);
    Eigen::AlignedBox2d spread;
    for (const Vector3d& x : hand) spread.extend(Eigen::Vector2d((view.axes * x).head<2>()));
    return seen / static_cast<double>(points.size()) + kOfHand * part_seen(obstacles, hand) + kApart * filled +
           kSpread * (spread.isEmpty() ? 0 : spread.diagonal().norm() / size);
  };
  double azimuth = 0, best = -1;
  for (int k = 0; k < kQuarters * kSides; ++k) {
    const int quarter = k / kSides;
    const double turn = kQuarter * quarter + kFirst + kStep * (k % kSides);
    const double liked = score(view_from({turn, kLow}, Vector3d::UnitZ()));
    if (liked > best) azimuth = turn;
    best = std::max(best, liked);
  }
  const SpaceView high = view_from({azimuth, kHigh}, Vector3d::UnitZ());
  return score(high) > best + kLikingLow ? high : view_from({azimuth, kLow}, Vector3d::UnitZ());
}

}  // namespace leastcost::app
