// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Starting configurations: each runs where `init` writes it, and nothing is overwritten.
#include <fstream>
#include <iterator>
#include <string>

#include "app/init/templates.hpp"
#include "catalogue/registry/registry.hpp"
#include "tests/app/called.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace {

using namespace leastcost;
using Catch::Matchers::Contains;
using test::call;
using test::Called;
using test::ScratchDir;

std::string text_in(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("init: what it writes runs, by the command that it names") {
  const ScratchDir dir;
  for (const app::Template& t : app::templates()) {
    CAPTURE(t.name);
    const std::string folder = (dir / t.name).string(), config = folder + "/" + t.name + ".yaml";
    const Called made = call({"init", t.name, "-o", folder});
    REQUIRE(made.exit == 0);
    CHECK_THAT(made.out, Contains(config + "\n") && Contains("Next: leastcost " + t.command + " " + config + "\n"));
    CHECK(text_in(config) == t.text);
    CHECK(t.text.rfind("# yaml-language-server: $schema=leastcost.schema.json\n", 0) == 0);
    CHECK(std::filesystem::exists(folder + "/leastcost.schema.json"));
    CHECK(call({"validate", config}).exit == 0);
    const Called ran = call({t.command, config, "-q", "-o", folder + "/out"});
    INFO(ran.out << ran.err);
    CHECK(ran.exit == 0);
  }
}

TEST_CASE("init: there is a template for every domain") {
  for (const PluginEntry* domain : kind("manifold").entries) {
    CAPTURE(domain->type);
    bool found = false;
    for (const app::Template& t : app::templates())
      found = found || t.text.find("type: " + domain->type) != std::string::npos ||
              t.text.find("manifold: " + domain->type) != std::string::npos;
    CHECK(found);
  }
}

TEST_CASE("init: files that exist are kept, and then nothing is written") {
  const ScratchDir dir;
  const std::string folder = (dir / "first").string();
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/hill.obj") << "mine\n";
  const Called refused = call({"init", "mesh", "-o", folder});
  CHECK(refused.exit == 2);
  CHECK_THAT(refused.err, Contains("hill.obj exists and nothing was written") && Contains("--force"));
  CHECK(!std::filesystem::exists(folder + "/mesh.yaml"));
  CHECK(text_in(folder + "/hill.obj") == "mine\n");
  // Both remedies that the message names.
  CHECK(call({"init", "mesh", "-o", (dir / "second/my.yaml").string()}).exit == 0);
  CHECK(std::filesystem::exists(dir / "second/my.yaml"));
  CHECK(call({"init", "mesh", "-o", folder, "--force"}).exit == 0);
  CHECK(text_in(folder + "/hill.obj") != "mine\n");
  // Two configurations share the schema of a folder.
  CHECK(call({"init", "plane", "-o", folder}).exit == 0);
}

TEST_CASE("init: the list, the help and a wrong name") {
  CHECK(call({"init", "plane", "-o", "-"}).out == app::templates().front().text);
  CHECK_THAT(call({"init"}).out, Contains("brachistochrone"));
  CHECK_THAT(call({"init", "brachistochron"}).err, Contains("did you mean 'brachistochrone'?"));
}
