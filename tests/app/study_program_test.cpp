// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The built program from outside: signals for a study and its children.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/app/study_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;

namespace {

/// Starts `leastcost study` in a process group of its own, its streams in files of `dir`.
pid_t start_study(const ScratchDir& dir, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {program().string(), "study", (dir / "study.yaml").string(), "-o",
                                        (dir / "out").string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  std::vector<char*> argv;
  for (std::string& a : arguments) argv.push_back(a.data());
  argv.push_back(nullptr);
  const std::string out = (dir / "stdout").string(), err = (dir / "stderr").string();
  const pid_t pid = ::fork();
  if (pid != 0) return pid;
  ::setpgid(0, 0);
  ::dup2(::open(out.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDOUT_FILENO);
  ::dup2(::open(err.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDERR_FILENO);
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

/// Exit code, or 1000 + the signal that ended it.
int wait_for(pid_t pid) {
  int status = 0;
  ::waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

/// Waits up to ten seconds for something to be so.
template <class Condition>
bool eventually(Condition holds) {
  for (int i = 0; i < 1000; ++i) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

/// A study whose first cell is done at once and whose second takes minutes.
void write_endless(const ScratchDir& dir) {
  std::ofstream(dir / "study.yaml")
      << "problems:\n  - name: bead\n    config: {manifold: euclidean, cost: {type: travel_time, gravity: 1, "
         "start_speed: "
         "1},\n             ends: {source: {point: [0, 0]}, target: {point: [3, -1]}}}\n"
         "points: [8, 20000]\n"
         "solvers: [{type: lbfgs, precondition: none, max_iterations: 1000000, max_evaluations: 100000000}]\n";
}

bool first_cell_done(const ScratchDir& dir) {
  const std::string journal = content(dir / "out/journal.jsonl");
  return std::count(journal.begin(), journal.end(), '\n') == 2;
}

std::string children_of(pid_t pid) {
  const std::string text = std::to_string(pid);
  return content("/proc/" + text + "/task/" + text + "/children");
}

}  // namespace

TEST_CASE("study program: Ctrl-C for the whole group ends it with the journal kept, what is left is run on resume") {
  if (program().empty()) return record_skip("studies from outside", "the program was not built");
  const ScratchDir dir;
  write_endless(dir);
  const pid_t pid = start_study(dir, {});
  REQUIRE(eventually([&] { return first_cell_done(dir); }));
  ::kill(-pid, SIGINT);
  CHECK(wait_for(pid) == 130);
  CHECK(first_cell_done(dir));
  CHECK_THAT(content(dir / "stderr"), Contains("interrupted: 1 results are in") && Contains("add --resume"));
  CHECK(wait_for(start_study(dir, {"--resume", "--timeout", "0.1"})) == 2);  // another study
  CHECK_THAT(content(dir / "stderr"), Contains("belongs to another study"));
}

TEST_CASE("study program: killed, it takes its children with it") {
  if (program().empty()) return record_skip("studies from outside", "the program was not built");
  const ScratchDir dir;
  write_endless(dir);
  const pid_t pid = start_study(dir, {});
  REQUIRE(eventually([&] { return first_cell_done(dir) && !children_of(pid).empty(); }));
  const pid_t child = std::stoi(children_of(pid));
  ::kill(pid, SIGKILL);
  CHECK(wait_for(pid) == 1000 + SIGKILL);
  CHECK(eventually([&] {
    return ::kill(child, 0) != 0 ||
           content("/proc/" + std::to_string(child) + "/stat").find(") Z") != std::string::npos;
  }));
}

}  // namespace leastcost::test
