// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "urdf/urdf_model.hpp"

namespace leastcost {

/// A named state of a group of joints.
struct SrdfState {
  std::string name, group;
  std::map<std::string, double> joints;  ///< by name
};

/// What an SRDF says about the robot of a URDF.
struct SrdfModel {
  std::map<std::string, std::set<int>> groups;  ///< their joints, by their numbers in the URDF
  std::vector<SrdfState> states;
  std::set<std::pair<std::string, std::string>> enabled, disabled;  ///< pairs of links, the lesser name first
  std::set<std::string> off;            ///< links whose pairs are disabled unless they are enabled
  std::vector<std::string> notes = {};  ///< for people: what was passed over

  bool checks(const std::string& link, const std::string& other) const;
};

/// Throws InputError("file:line: ...") for what is none, and for a group with links, joints or groups that are not
/// there. Pairs of links that are not there are passed over with a note, as MoveIt does: they may be those of an object
/// or a tool that the URDF leaves out.
SrdfModel read_srdf(const std::filesystem::path& file, const UrdfModel& robot);

}  // namespace leastcost
