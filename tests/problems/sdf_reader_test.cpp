// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/readers/sdf_reader.hpp"

#include <leastcost/framework/base/errors.hpp>
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

std::string values(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += std::to_string(i) + (i % 7 == 0 ? "\n" : " ");
  return text;
}

std::string refusal(const std::string& text, double memory = 1e9) {
  try {
    read_sdf(text, "a.sdf", memory);
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("sdf reader: header and values, x fastest") {
  const GridSamples samples = read_sdf("4 5 6\n-1 2.5 3e-1 # first node\n0.25\n" + values(120), "a.sdf", 1e9);
  CHECK(samples.shape.count == std::array<int, 3>{4, 5, 6});
  CHECK(samples.shape.origin == Eigen::Vector3d(-1, 2.5, 0.3));
  CHECK(samples.shape.cell == 0.25);
  REQUIRE(samples.values.size() == 120);
  CHECK(samples.values[samples.shape.index(3, 0, 0)] == 3);
  CHECK(samples.values[samples.shape.index(1, 2, 3)] == 1 + 4 * (2 + 5 * 3));
}

TEST_CASE("sdf reader: what is wrong, with its line") {
  const std::string header = "4 4 4\n0 0 0\n0.5\n";
  CHECK(refusal(header + values(64)) == "accepted");
  CHECK_THAT(refusal(""), Catch::Contains("a.sdf:") && Catch::Contains("the number of nodes"));
  CHECK_THAT(refusal("4 4 4\n"), Catch::Contains("position of the first node"));
  CHECK_THAT(refusal("4 4 4\n0 0 0\n"), Catch::Contains("cell size"));
  CHECK_THAT(refusal(header + values(63)), Catch::Contains("ends after 63 of 64 values"));
  CHECK_THAT(refusal(header + values(65)), Catch::Contains("more values than the 64 nodes"));
  CHECK_THAT(refusal(header + "nan " + values(63)), Catch::Contains("a.sdf:4: expected a distance that is finite"));
  CHECK_THAT(refusal(header + "inf " + values(63)), Catch::Contains("finite"));
  CHECK_THAT(refusal(header + "1 2 x"), Catch::Contains("a.sdf:4: expected a distance, found 'x'"));
  CHECK_THAT(refusal("4 4.5 4\n"), Catch::Contains("a.sdf:1: expected a number of nodes"));
  CHECK_THAT(refusal("4 4\n0 0 0\n"), Catch::Contains("a.sdf:1:"));
  CHECK_THAT(refusal("4 4 4 4\n"), Catch::Contains("unexpected '4'"));
  CHECK_THAT(refusal("4 3 4\n"), Catch::Contains("at least 4"));
  CHECK_THAT(refusal("4 -4 4\n"), Catch::Contains("at least 4"));
  CHECK_THAT(refusal("4 4 4\n0 0\n"), Catch::Contains("a.sdf:2:"));
  CHECK_THAT(refusal("4 4 4\n0 0 0\n0\n"), Catch::Contains("a.sdf:3: the cell size must be positive"));
  CHECK_THAT(refusal("1000 1000 1000\n"), Catch::Contains("memory limit of 954 MiB"));
}

}  // namespace leastcost::test
