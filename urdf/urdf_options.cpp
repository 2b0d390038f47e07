// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/urdf/urdf_options.hpp>

namespace leastcost {

void UrdfRobotOptions::fields(FieldVisitor& visit) {
  visit.file("file", file, {.help = "URDF file.", .required = true});
  visit.file("srdf", srdf, {.help = "SRDF file: groups of joints, named states, pairs of links that may touch."});
  visit.field("group", group, {.help = "Group of the SRDF whose joints move; default: all joints."});
  visit.field("hold", hold,
              {.help = "Values at which joints are held, {finger: 0.02}; default: 0, or the limit nearest to it.",
               .unit = "rad or length"});
  visit.field("hold_state", hold_state,
              {.help = "SRDF state that sets the joints that are neither moved nor listed in hold."});
  visit.field("soft_limits", soft_limits,
              {.help = "Keep to the soft limits of a safety_controller where they are narrower."});
  visit.group("base", {.help = "Where the root link stands."}, [this](FieldVisitor& base) {
    base.field("position", position, {.help = "Position of its origin.", .unit = "length"});
    base.field("rpy", rpy,
               {.help = "Roll, pitch and yaw of the root link: turns about the fixed x, y and z.", .unit = "rad"});
  });
  visit.file("packages", packages,
             {.help = "Folder with the packages of package:// names; meshes are also searched for beside the URDF."});
}

}  // namespace leastcost
