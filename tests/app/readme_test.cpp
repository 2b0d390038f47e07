// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Every code block of the README is true: configurations run, commands work, C++ is that of an example; and so is that
// of the other pages.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace {

using namespace leastcost;

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Bodies of the blocks fenced with ```language, of the README or another page.
std::vector<std::string> blocks(const std::string& language, const std::string& page = "README.md") {
  const std::string text = read(test::project_dir() / page), open = "```" + language + "\n";
  std::vector<std::string> found;
  for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
    at += open.size();
    found.push_back(text.substr(at, text.find("```", at) - at));
  }
  return found;
}

int run(const std::string& arguments, const std::filesystem::path& folder) {
  const std::string command =
      "cd '" + folder.string() + "' && '" + test::program().string() + "' " + arguments + " >/dev/null 2>&1";
  const int status = std::system(command.c_str());
  return status < 0 ? status : (status >> 8) & 0xff;
}

}  // namespace

TEST_CASE("every configuration in the README runs and is certified", "[readme]") {
  const std::vector<std::string> found = blocks("yaml");
  REQUIRE(!found.empty());
  const test::ScratchDir scratch;
  std::filesystem::create_directory_symlink(test::project_dir() / "configs", scratch / "configs");
  for (const std::string& yaml : found) {
    std::ofstream(scratch / "block.yaml") << yaml;
    INFO(yaml);
    const bool study = yaml.find("\nproblems:") != std::string::npos;
    CHECK(run(study ? "study block.yaml --force" : "run block.yaml --force", scratch.path()) == 0);
  }
}

TEST_CASE("every command in the README works", "[readme]") {
  const test::ScratchDir scratch;
  std::filesystem::create_directory_symlink(test::project_dir() / "configs", scratch / "configs");
  int commands = 0;
  for (const std::string& block : blocks("sh")) {
    std::istringstream lines(block);
    for (std::string line; std::getline(lines, line);) {
      const std::string prefix = "./leastcost ";
      if (line.compare(0, prefix.size(), prefix) != 0) continue;
      ++commands;
      const std::string arguments = line.substr(prefix.size(), line.find('#') - prefix.size());
      if (arguments.compare(0, 4, "test") == 0) continue;  // this is it
      if (arguments.find("bunny") != std::string::npos && !test::installed_model("glmark2/models/bunny.obj")) continue;
      INFO(line);
      CHECK(run(arguments, scratch.path()) == 0);
    }
  }
  CHECK(commands >= 2);
}

TEST_CASE("C++ in the README is that of an example", "[readme]") {
  const std::string example = read(test::project_dir() / "examples/hello/main.cpp");
  for (const std::string& block : blocks("cpp")) CHECK(example.find(block) != std::string::npos);
}

TEST_CASE("C++ in the pages of docs is a piece of an example that is compiled and run", "[readme]") {
  std::vector<std::string> examples;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::project_dir() / "examples"))
    if (entry.path().extension() == ".cpp") examples.push_back(read(entry.path()));
  int found = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::project_dir() / "docs")) {
    if (entry.path().extension() != ".md") continue;
    for (const std::string& block : blocks("cpp", "docs/" + entry.path().filename().string())) {
      INFO(entry.path().filename() << '\n' << block);
      ++found;
      CHECK(std::any_of(examples.begin(), examples.end(),
                        [&](const std::string& example) { return example.find(block) != std::string::npos; }));
    }
  }
  CHECK(found >= 8);
}
