// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost::test {

TEST_CASE("option errors: the message is a sentence about the option and both halves are kept") {
  const OptionError error("memory", "must be at least 1, not 0");
  CHECK(error.what() == std::string("memory must be at least 1, not 0"));
  CHECK(error.key() == "memory");
  CHECK(error.reason() == "must be at least 1, not 0");
  CHECK(OptionError("axes", "2 numbers").what() == std::string("axes: 2 numbers"));
  CHECK(OptionError("", "no joint moves").what() == std::string("no joint moves"));
}

TEST_CASE("option errors: a block that an option stands in comes before its name") {
  const OptionError error = OptionError("box.lower", "is above the upper one").under("manifold");
  CHECK(error.key() == "manifold.box.lower");
  CHECK(error.what() == std::string("manifold.box.lower is above the upper one"));
  CHECK(OptionError("", "has no type").under("model").what() == std::string("model has no type"));
}

}  // namespace leastcost::test
