// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/base/monitor.hpp>

namespace leastcost {

Words<Stage> words(Stage) {
  using enum Stage;
  static constexpr Word<Stage> kWords[] = {
      {initialize, "initialize"}, {solve, "solve"}, {post_process, "post_process"}, {certify, "certify"}};
  return kWords;
}

}  // namespace leastcost
