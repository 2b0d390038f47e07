// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The built program from outside: signals, a full disk, the streams of a shell.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;

namespace {

struct Child {
  pid_t pid = -1;
  fs::path out, err;

  /// Exit code, or 1000 + the signal that ended it.
  int wait() const {
    int status = 0;
    ::waitpid(pid, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }
};

/// Starts the program with its streams in files of `dir`. `file_limit`: bytes that one of its files may have; 0: no
/// limit.
Child start(const ScratchDir& dir, std::vector<std::string> arguments, rlim_t file_limit = 0) {
  Child child{-1, dir / "stdout", dir / "stderr"};
  arguments.insert(arguments.begin(), program().string());
  std::vector<char*> argv;
  for (std::string& a : arguments) argv.push_back(a.data());
  argv.push_back(nullptr);
  child.pid = ::fork();
  if (child.pid != 0) return child;
  ::dup2(::open(child.out.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDOUT_FILENO);
  ::dup2(::open(child.err.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDERR_FILENO);
  if (file_limit > 0) {
    const rlimit limit{file_limit, file_limit};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit then fails, as on a full disk
  }
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

/// A run of minutes: plain L-BFGS on many points.
std::string endless(const ScratchDir& dir) {
  const fs::path file = dir / "endless.yaml";
  std::ofstream(file)
      << "manifold: euclidean\ncost: {type: travel_time, gravity: 1, start_speed: 1}\n"
         "ends: {source: {point: [0, 0]}, target: {point: [3, -1]}}\npath: {points: 20000}\n"
         "solver: {type: lbfgs, precondition: none, max_iterations: 1000000, max_evaluations: 100000000}\n";
  return file.string();
}

std::string plane(const ScratchDir& dir) {
  const fs::path file = dir / "plane.yaml";
  std::ofstream(file) << kPlane;
  return file.string();
}

bool built() {
  if (!program().empty()) return true;
  record_skip("the program from outside", "the program was not built");
  return false;
}

}  // namespace

TEST_CASE("program: the first Ctrl-C ends a run with its best path") {
  if (!built()) return;
  const ScratchDir dir;
  const int signal = GENERATE(SIGINT, SIGTERM);
  const Child child = start(dir, {"run", endless(dir), "-o", (dir / "out").string(), "--format", "json"});
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  ::kill(child.pid, signal);
  CHECK(child.wait() == 130);
  CHECK_THAT(content(child.out), Contains("\"status\": \"interrupted\""));
  CHECK(fs::exists(dir / "out/path.csv"));
}

TEST_CASE("program: killed, it leaves no half-written output folder") {
  if (!built()) return;
  const ScratchDir dir;
  const Child child = start(dir, {"run", endless(dir), "-o", (dir / "out").string()});
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  ::kill(child.pid, SIGKILL);
  CHECK(child.wait() == 1000 + SIGKILL);
  CHECK_FALSE(fs::exists(dir / "out"));
}

TEST_CASE("program: a full disk loses neither the result on stdout nor the folder that was there") {
  if (!built()) return;
  const ScratchDir dir;
  REQUIRE(start(dir, {"run", plane(dir), "-o", (dir / "out").string()}).wait() == 0);
  const std::string before = content(dir / "out/result.json");
  const Child child =
      start(dir, {"run", plane(dir), "-o", (dir / "out").string(), "--force", "--set", "path.points=200"}, 4000);
  CHECK(child.wait() == 1);
  CHECK_THAT(content(child.out), Contains("certified"));
  CHECK_THAT(content(child.err), Contains("the results are not in their place: ") && Contains("File too large"));
  CHECK(content(dir / "out/result.json") == before);
  for (const auto& entry : fs::directory_iterator(dir.path()))
    CHECK(entry.path().filename().string().rfind(".out.", 0) != 0);
}

TEST_CASE("program: progress of a longer run goes to stderr as plain lines") {
  if (!built()) return;
  const ScratchDir dir;
  const Child child = start(dir, {"run", endless(dir), "-o", (dir / "out").string(), "--set", "max_seconds=2"});
  CHECK(child.wait() == 130);
  CHECK(content(child.err).find('\r') == std::string::npos);
  CHECK(content(child.err).find('\x1b') == std::string::npos);
  CHECK_THAT(content(child.err), Contains(" s  "));
  const Child quiet =
      start(dir, {"run", endless(dir), "-q", "-o", (dir / "out2").string(), "--set", "max_seconds=1.5"});
  CHECK(quiet.wait() == 130);
  CHECK(content(quiet.err) == "");
}

TEST_CASE("program: without -o the results go to results/<name> of the current folder") {
  if (!built()) return;
  const ScratchDir dir;
  const std::string config = plane(dir);
  const fs::path before = fs::current_path();
  fs::current_path(dir.path());
  const int exit = start(dir, {"run", config}).wait();
  fs::current_path(before);
  CHECK(exit == 0);
  CHECK(fs::exists(dir / "results/plane/result.json"));
}

}  // namespace leastcost::test
