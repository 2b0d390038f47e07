// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/base/monitor.hpp>

namespace leastcost {

std::string_view name(Stage stage) {
  switch (stage) {
    case Stage::initialize: return "initialize";
    case Stage::solve: return "solve";
    case Stage::post_process: return "post_process";
    case Stage::certify: return "certify";
  }
  return "unknown";
}

}  // namespace leastcost
