// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/registry/built_in.hpp"

#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/rigid_body.hpp>
#include "catalogue/back_ends/back_ends.hpp"
#include "catalogue/plugins/attached_options.hpp"
#include "catalogue/plugins/registration.hpp"

namespace leastcost {

const std::vector<RobotPlugin>& built_in::robots() {
  static const std::vector<RobotPlugin> all = built_in::with_those_of_libraries<RobotPlugin>(
      {
          plugin<RobotPlugin, WithAttached<DhArmOptions>>(
              "dh_arm",
              "An arm with revolute joints, from a Denavit-Hartenberg table; a configuration is its joint angles.",
              [](const WithAttached<DhArmOptions>& o, const BuildContext& c) {
                return attach(make_dh_arm(o.robot), o.attached, c.folder);
              })
              .waiting<WithAttached<DhArmOptions>>([](const WithAttached<DhArmOptions>& o) {
                return has_files(o.attached) ? WaitsFor::files : WaitsFor::nothing;
              }),
          plugin<RobotPlugin, RigidBodyOptions>(
              "rigid_body",
              "A body of balls and capsules, in the plane (x, y, angle) or in space (x, y, z, quaternion).",
              [](const RigidBodyOptions& o, const BuildContext&) { return make_rigid_body(o); }),
      },
      robots_of_libraries());
  return all;
}

}  // namespace leastcost
