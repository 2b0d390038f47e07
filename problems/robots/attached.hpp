// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <leastcost/problems/robots/covering.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// What a robot carries: it is fixed to a frame of the robot, and moves with it.
struct AttachedObject {
  std::string name = "object";            ///< for messages
  std::string link = {};                  ///< the frame, by its name; empty: that of the last link
  Frame pose = {};                        ///< of the object in that frame
  Covering shape = {};                    ///< in the frame of the object
  std::vector<std::string> touches = {};  ///< links and other objects that may touch it, besides its link
};

/// The robot with these objects. They keep away from obstacles, and from what does not move with them: the robot's
/// other parts and other objects, except for what they may touch and what they touch in each of 200 random
/// configurations, which `whose` names. Throws OptionError("<number>.link"), ("<number>.touches") for names that are
/// not there, ("<number>.shape") for an object without parts, and ("0") for a robot in the plane.
std::shared_ptr<const Robot> with_attached(const Robot& robot, const std::vector<AttachedObject>& objects);

}  // namespace leastcost
