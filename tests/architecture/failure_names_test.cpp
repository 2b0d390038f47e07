// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// What keeps a path from being certified has a name, and docs/failures.md says of each what to do.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::set<std::string> names_in(const std::string& text, const std::regex& pattern) {
  std::set<std::string> names;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    names.insert((*match)[1].str());
  return names;
}

}  // namespace

TEST_CASE("failures: docs/failures.md has every name of a failure") {
  const std::set<std::string> names = names_in(text_of(project_dir() / "framework/certificate/certificate_failure.cpp"),
                                               std::regex(R"re(\{Failure::[a-z_]+, "([a-z_]+)")re"));
  CHECK(names.size() > 25);
  const std::set<std::string> told =
      names_in(text_of(project_dir() / "docs/failures.md"), std::regex(R"(\n\| `([a-z_]+)` \|)"));
  for (const std::string& name : names) {
    CAPTURE(name);
    CHECK(told.count(name) == 1);
  }
  for (const std::string& name : told) {
    CAPTURE(name);
    CHECK(names.count(name) == 1);
  }
}

}  // namespace leastcost::test
