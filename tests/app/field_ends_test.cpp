// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// `leastcost field` of configurations that have no ends, or one of them.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include <leastcost/catalogue/run/load_run.hpp>
#include <leastcost/catalogue/run/solve.hpp>
#include <leastcost/framework/base/errors.hpp>
#include "tests/app/called.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;

/// A configuration of the repository without the block of its ends; its files by their full names.
std::string without_ends(const std::string& name) {
  const fs::path folder = project_dir() / "configs";
  std::string text = content(folder / name);
  const std::size_t begin = text.find("\nends:") + 1;
  std::size_t end = text.find('\n', begin) + 1;
  while (end < text.size() && text[end] == ' ') end = text.find('\n', end) + 1;
  text.erase(begin, end - begin);
  if (const std::size_t at = text.find("file: data/"); at != std::string::npos)
    text.insert(at + 6, folder.string() + "/");
  return text;
}

const char* const kOpenPlane = "manifold: {type: euclidean}\ncost: euclidean\n";

}  // namespace

TEST_CASE("field without ends: the same values as with them on rasters and terrain and maps and meshes") {
  const ScratchDir dir;
  const std::string with = (dir / "with.npy").string(), without = (dir / "without.npy").string();
  struct Case {
    const char *name, *from, *to;
  };
  // The last two lie around the ends, as their domain has no box; the sum depends on where paths begin.
  for (const Case& one :
       {Case{"cost_map.yaml", "4,15", ""}, Case{"terrain.yaml", "200,700", ""}, Case{"cost_map_cells.yaml", "9,15", ""},
        Case{"map_rooms.yaml", "2.5,2.5", ""}, Case{"walking_over_hill.yaml", "-2000,100", "2000,100"},
        Case{"sum_of_costs.yaml", "0,-0.5", "2,-1.5"}}) {
    CAPTURE(one.name);
    const std::string bare = text_file(dir / "bare.yaml", without_ends(one.name));
    REQUIRE(call({"field", (project_dir() / "configs" / one.name).string(), "-o", with}).exit == 0);
    std::vector<std::string> arguments = {"field", bare, "-o", without, std::string("--from=") + one.from};
    if (*one.to != '\0') arguments.push_back(std::string("--to=") + one.to);
    const Called called = call(arguments);
    CHECK(called.err == "");
    REQUIRE(called.exit == 0);
    CHECK(content(with) == content(without));
  }
  text_file(dir / "fold.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  const std::string mesh = text_file(dir / "mesh.yaml", "manifold: {type: mesh, file: fold.obj}\ncost: euclidean\n");
  CHECK(call({"field", mesh, "-o", (dir / "m.csv").string(), "--from", "0", "--to", "3"}).exit == 0);
  CHECK_THAT(content(dir / "m.csv"), Contains("\n3,1,1,0,1.41421356"));
}

TEST_CASE("field without ends: one end alone is enough where it is the one that is needed") {
  const ScratchDir dir;
  const std::string out = (dir / "f.csv").string();
  const std::string box = "manifold: {type: euclidean, lower: [0, 0], upper: [4, 2]}\ncost: euclidean\n";
  const std::string source = text_file(dir / "source.yaml", box + "ends: {source: {point: [1, 1]}}\n");
  CHECK(call({"field", source, "-o", out, "--resolution", "0.5"}).exit == 0);
  CHECK_THAT(content(out), Contains("\n1,1,0\n"));
  const std::string target = text_file(dir / "target.yaml", box + "ends: {target: {point: [3, 1]}}\n");
  CHECK(call({"field", target, "-o", out, "--resolution", "0.5", "--from", "1,1", "--corridor"}).exit == 0);
  CHECK_THAT(content(out), Contains("\n1,1,0\n") && Contains("\n3,1,0\n"));
  const std::string none = text_file(dir / "none.yaml", box);
  CHECK(call({"field", none, "-o", out, "--resolution", "0.5", "--from", "1,1", "--to", "3,1", "--corridor"}).exit ==
        0);
  CHECK_THAT(content(out), Contains("\n3,1,0\n"));
  const std::string goals =
      text_file(dir / "goals.yaml", box + "ends: {source: {point: [1, 1]}, target: {points: [[3, 1], [2, 2]]}}\n");
  CHECK(call({"field", goals, "-o", out, "--resolution", "0.5", "--corridor"}).exit == 0);
  CHECK_THAT(content(out), Contains("\n2,2,0\n"));  // the nearer of the two
  CHECK(call({"field", goals, "-o", out, "--resolution", "0.5", "--from", "0,0"}).exit == 0);
  CHECK_THAT(content(out), Contains("\n0,0,0\n"));
  CHECK_THAT(call({"field", goals, "-o", out, "--from", "0,0", "--corridor"}).err,
             Contains("nothing says where it leads"));
  const std::string pairs = text_file(dir / "pairs.yaml", box + "ends: {pairs: pairs.csv}\n");
  text_file(dir / "pairs.csv", "1,1,2,2\n");
  CHECK(call({"field", pairs, "-o", out, "--resolution", "0.5", "--from", "0,0"}).exit == 0);
  CHECK_THAT(call({"field", pairs, "-o", out}).err, Contains("many pairs of ends: say where the field is from"));
  const std::string open = text_file(dir / "open.yaml", kOpenPlane);
  CHECK(call({"field", open, "-o", out, "--from", "1,1", "--from", "3,2", "--resolution", "0.5"}).exit == 0);
}

TEST_CASE("field without ends: what is missing is said") {
  const ScratchDir dir;
  const std::string out = (dir / "f.csv").string(), open = text_file(dir / "open.yaml", kOpenPlane);
  const auto refused = [&](const std::vector<std::string>& more, const std::string& words) {
    std::vector<std::string> all = {"field", open, "-o", out};
    all.insert(all.end(), more.begin(), more.end());
    const Called called = call(all);
    CHECK(called.exit == 4);
    CHECK_THAT(called.err, Contains(words));
  };
  refused({}, "nothing says where it is from: give a source (--from X,Y), or the configuration ends");
  refused({"--from", "1,1"}, "the domain has no box, and one place alone gives none");
  refused({"--set", "manifold.lower=[0,0]", "--set", "manifold.upper=[4,2]", "--from", "1,1", "--corridor"},
          "nothing says where it leads: give a target (--to X,Y)");
  CHECK_THAT(call({"run", open, "-o", (dir / "run").string()}).err, Contains("missing key 'ends'"));
  CHECK_THROWS_WITH(solve(load_run(open, {}, {}, {}, EndsFrom::caller), {}), Contains("needs both ends"));
}

}  // namespace leastcost::test
