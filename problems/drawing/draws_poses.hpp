// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// A robot on its way, seen from one side: closed polylines in the plane of the picture, 2 x m each.
struct PoseStrip {
  std::vector<std::vector<Points>> poses;  ///< from the first to the last, each the outlines of its parts
  std::vector<Points> obstacles;           ///< of the workspace
  Points hand;                             ///< the way of its last link, or of a body, 2 x points of the path
  Points hand_in_space;                    ///< the same in the workspace, 3 x points of the path; z is 0 in the plane
};

/// Ability of a domain whose points are configurations of something that can be drawn in its workspace.
class DrawsPoses {
 public:
  virtual ~DrawsPoses() = default;
  bool present() const { return has_poses(); }
  /// Of a path through the configurations, dimension x m, m at least 1.
  virtual PoseStrip pose_strip(const Points& configurations) const = 0;

 private:
  virtual bool has_poses() const = 0;
};

}  // namespace leastcost
