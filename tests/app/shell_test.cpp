// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Completions, man pages and pages of Markdown, made of the tables of --help and describe.
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "app/reference/markdown.hpp"
#include "catalogue/registry/registry.hpp"
#include "tests/app/called.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace {

using namespace leastcost;
using Catch::Matchers::Contains;
using test::call;
using test::ScratchDir;

std::string written(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool shell_runs(const std::string& command) { return std::system((command + " >/dev/null 2>&1").c_str()) == 0; }

/// Whether a check by this program is possible; if not, that is recorded.
bool checked_by(const std::string& program) {
  const bool found = shell_runs("command -v " + program);
  if (!found) test::record_skip("shell: a check by " + program, "not installed");
  return found;
}

/// What bash offers at the end of a command line, whose words are as bash splits them: `=` is one.
class Bash {
 public:
  Bash() {
    std::ofstream(dir_ / "leastcost") << call({"completion", "bash"}).out;
    std::ofstream(dir_ / "first.yaml");
    std::ofstream(dir_ / "notes.txt");
    std::filesystem::create_directories(dir_ / "folder");
  }

  std::string offers(const std::vector<std::string>& words) const {
    std::string list;
    for (const std::string& word : words) list += " '" + word + "'";
    std::ofstream(dir_ / "try.sh") << "cd '" << dir_.path().string() << "' && . ./leastcost\nCOMP_WORDS=(leastcost"
                                   << list << ")\nCOMP_CWORD=" << words.size()
                                   << "\n_leastcost\necho \"${COMPREPLY[*]}\" >out\n";
    if (!shell_runs("bash '" + (dir_ / "try.sh").string() + "'")) return "bash failed";
    std::string out = written(dir_ / "out");
    out.pop_back();
    return out;
  }

 private:
  ScratchDir dir_;
};

}  // namespace

TEST_CASE("completion: bash offers commands, options, values, types and files") {
  const Bash bash;
  CHECK(bash.offers({"ru"}) == "run");
  CHECK_THAT(bash.offers({""}), Contains("study") && Contains("--version"));
  CHECK(bash.offers({"run", "--dry"}) == "--dry-run");
  CHECK(bash.offers({"run", "--format", "js"}) == "json jsonl");
  CHECK(bash.offers({"run", "--format", "=", "te"}) == "text");
  CHECK(bash.offers({"run", "f"}) == "folder first.yaml");
  CHECK(bash.offers({"run", "-o", "f"}) == "folder");
  CHECK(bash.offers({"run", "n"}).empty());  // not a configuration
  CHECK(bash.offers({"run", "--pairs", "n"}) == "notes.txt");
  CHECK(bash.offers({"describe", "so"}) == "solver");
  CHECK(bash.offers({"describe", "solver", "new"}) == "newton");
  CHECK(bash.offers({"list", "--format", "text", "ker"}) == "kernels");
  CHECK(bash.offers({"run", "first.yaml", "--set", "path.po"}) == "path.points=");
  CHECK(bash.offers({"run", "first.yaml", "--set", "solver", "=", "lb"}) == "lbfgs");
  CHECK(bash.offers({"run", "first.yaml", "--set", "cost", "="}).find("zermelo") != std::string::npos);
  CHECK_THAT(bash.offers({"init", ""}), Contains("mesh") && Contains("study"));
}

TEST_CASE("completion: zsh and fish read their scripts, and fish offers types") {
  const ScratchDir dir;
  std::ofstream(dir / "_leastcost") << call({"completion", "zsh"}).out;
  std::ofstream(dir / "leastcost.fish") << call({"completion", "fish"}).out;
  if (checked_by("zsh")) CHECK(shell_runs("zsh -n '" + (dir / "_leastcost").string() + "'"));
  if (checked_by("fish")) {
    const std::string script = "'" + (dir / "leastcost.fish").string() + "'";
    CHECK(shell_runs("fish -n " + script));
    const auto offers = [&](const std::string& line, const std::string& word) {
      return shell_runs("fish -N -c \"source " + script + "; complete -C '" + line + "'\" | grep -q '^" + word + "'");
    };
    CHECK(offers("leastcost ru", "run"));
    CHECK(offers("leastcost describe solver new", "newton"));
    CHECK(offers("leastcost run --format js", "jsonl"));
  }
  CHECK_THAT(call({"completion", "zsh"}).out, Contains("#compdef leastcost"));
  CHECK(call({"completion", "tcsh"}).exit == 2);
}

TEST_CASE("man pages: one for each command, and the formatter warns of nothing") {
  const ScratchDir dir;
  REQUIRE(call({"man", dir.path().string()}).exit == 0);
  CHECK_THAT(written(dir / "leastcost.1"), Contains(".SH EXIT STATUS") && Contains("leastcost\\-figure"));
  CHECK_THAT(written(dir / "leastcost-run.1"), Contains("\\-\\-dry\\-run") && Contains("jsonl"));
  for (const auto& page : std::filesystem::directory_iterator(dir.path())) {
    CAPTURE(page.path().filename());
    CHECK_THAT(written(page.path()), Contains(".SH EXIT STATUS") && !Contains("text or json. One of"));
    const std::string file = "'" + page.path().string() + "'";
    if (checked_by("mandoc")) CHECK(shell_runs("mandoc -T lint -W warning " + file));
    if (checked_by("groff")) CHECK(shell_runs("! groff -man -ww -z -Tutf8 " + file + " 2>&1 | grep ."));
  }
}

TEST_CASE("describe --markdown: a page for each plug-in with every option") {
  const ScratchDir dir;
  REQUIRE(call({"describe", "--markdown", dir.path().string()}).exit == 0);
  for (const PluginKind& k : plugin_kinds()) {
    CHECK_THAT(written(dir / (k.plural + ".md")), Contains("(" + k.name + "/"));
    for (const PluginEntry* plugin : k.entries)
      CHECK(std::filesystem::file_size(dir / k.name / (plugin->type + ".md")) > 80);
  }
  CHECK_THAT(written(dir / "cost/travel_time.md"), Contains("| `gravity` | number, greater than 0") &&
                                                       Contains("| `9.80665` |") && Contains("unit length/s^2"));
  CHECK_THAT(written(dir / "cost/zermelo.md"), Contains("### `flow`: `grid`") && Contains("| `flow.file` | file |"));
  CHECK_THAT(written(dir / "run.md"), Contains("`path.points`") && Contains("](solvers.md)"));
  CHECK(call({"describe"}).exit == 2);
  CHECK(call({"describe", "run", "--markdown", "x"}).exit == 2);
}
