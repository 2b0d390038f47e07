// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Back ends that the program loads when they are first asked for.
#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/app/child_program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;

namespace {

/// Beside the program; empty, with a record of the skip, where this build has no modules.
fs::path module_folder(const char* name) {
  const fs::path folder = program().parent_path().parent_path() / "lib/leastcost";
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().filename().string().rfind(std::string("leastcost_") + name + "_", 0) == 0) return folder;
  record_skip(std::string("the module of ") + name, "this build is linked with its back ends");
  return {};
}

}  // namespace

TEST_CASE("back ends: the program starts without the libraries of those that it loads") {
  if (!built() || module_folder("ceres").empty() || module_folder("ompl").empty()) return;
  const ScratchDir dir;
  const Child child = start(dir, {}, [] { ::setenv("LD_TRACE_LOADED_OBJECTS", "1", 1); });
  CHECK(child.wait() == 0);
  CHECK_THAT(content(child.out), Contains("libstdc++") && !Contains("libompl") && !Contains("libglog"));
}

TEST_CASE("back ends: a module solves and plans as the library does") {
  if (!built() || module_folder("ceres").empty() || module_folder("ompl").empty()) return;
  const ScratchDir dir;
  const Child child = start(dir, {"run", plane(dir), "-o", (dir / "out").string(), "--set", "solver.type=ceres",
                                  "--set", "initializer={type: ompl, planner: RRTConnect}"});
  CHECK(child.wait() == 0);
  CHECK_THAT(content(dir / "out/result.json"), Contains("\"status\": \"certified\"") && Contains("RRTConnect"));
  const Child refused = start(dir, {"run", plane(dir), "-o", (dir / "other").string(), "--set",
                                    "initializer={type: ompl, planner: PRM, range: 1}"});
  CHECK(refused.wait() != 0);  // thrown in the module
  CHECK_THAT(content(refused.err), Contains("initializer") && Contains("PRM has none: remove it"));
}

TEST_CASE("back ends: a program without its modules says what it needs, and lists them") {
  if (!built() || module_folder("ceres").empty()) return;
  const ScratchDir dir;
  const fs::path alone = dir / "leastcost";
  fs::copy_file(program(), alone);
  const auto of_the_copy = [&](std::vector<std::string> arguments) {
    return start(dir, std::move(arguments), {}, alone);
  };
  const Child child = of_the_copy({"run", plane(dir), "-o", (dir / "out").string(), "--set", "solver.type=ceres"});
  CHECK(child.wait() != 0);
  CHECK_THAT(content(child.err), Contains("Ceres is needed for this") && Contains("cannot be loaded: install"));
  const Child listed = of_the_copy({"describe", "solver", "ceres"});
  CHECK(listed.wait() == 0);
  CHECK_THAT(content(listed.out), Contains("levenberg_marquardt"));
}

}  // namespace leastcost::test
