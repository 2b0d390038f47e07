// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/readers/tensor_reader.hpp"

#include <fstream>

#include <leastcost/framework/base/errors.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

std::vector<Eigen::Matrix3d> read(const std::string& text) {
  const ScratchDir folder;
  std::ofstream(folder / "t.txt") << text;
  return read_tensors(folder / "t.txt");
}

/// The message, or nothing when the text was accepted.
std::string tensor_refusal(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("tensor files: rows of the upper triangle, comments, blank lines") {
  const auto tensors = read("# xx xy xz yy yz zz\n2 0.1 0.2 3 0.3 4  # the first\n\n\t1 0 0 1e0 0 +1\r\n");
  REQUIRE(tensors.size() == 2);
  CHECK(tensors[0] == (Eigen::Matrix3d() << 2, 0.1, 0.2, 0.1, 3, 0.3, 0.2, 0.3, 4).finished());
  CHECK(tensors[1] == Eigen::Matrix3d::Identity());
}

TEST_CASE("tensor files: what is wrong, and in which row") {
  using Catch::Contains;
  CHECK_THAT(tensor_refusal(""), Contains("has no tensors"));
  CHECK_THAT(tensor_refusal("# nothing\n\n"), Contains("has no tensors"));
  CHECK_THAT(tensor_refusal("1 0 0 1 0 1\n1 0 0 1 0\n"), Contains("t.txt:2: expected one of the six entries"));
  CHECK_THAT(tensor_refusal("1 0 0 1 0 1 7\n"), Contains("t.txt:1: unexpected '7'"));
  CHECK_THAT(tensor_refusal("1 0 0 1 0 nan\n"), Contains("t.txt:1"));
  CHECK_THAT(tensor_refusal("1,0,0,1,0,1\n"), Contains("t.txt:1"));
  CHECK_THAT(tensor_refusal("\n1 2 0 1 0 1\n"),
             Contains("t.txt:2: a tensor must be positive definite, but the eigenvalues of this one are -1, 1, 3"));
  CHECK_THAT(tensor_refusal("1 0 0 1 0 0\n"), Contains("n n'"));  // of the plane z = 0
}

}  // namespace leastcost::test
