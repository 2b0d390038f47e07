// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The built program from outside: signals, a full disk, the streams of a shell.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "app/study/cell/isolation.hpp"
#include "tests/app/child_program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;

namespace {

/// A write beyond so many bytes of a file then fails, as on a full disk.
std::function<void()> file_limit(rlim_t bytes) {
  return [bytes] {
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  };
}

/// A GiB, where the build can live with that (a sanitizer cannot).
void little_memory() {
  const rlimit limit{rlim_t{1} << 30, rlim_t{1} << 30};
  if (app::can_limit_memory()) ::setrlimit(RLIMIT_AS, &limit);
}

/// The folders that runs have left beside `name`.
std::vector<fs::path> beside(const ScratchDir& dir, const std::string& name) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(dir.path()))
    if (entry.path().filename().string().rfind("." + name + ".", 0) == 0) found.push_back(entry.path());
  return found;
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

TEST_CASE("program: a full disk loses neither the result nor the folder that was there") {
  if (!built()) return;
  const ScratchDir dir;
  REQUIRE(start(dir, {"run", plane(dir), "-o", (dir / "out").string()}).wait() == 0);
  const std::string before = content(dir / "out/result.json");
  const Child child = start(
      dir, {"run", plane(dir), "-o", (dir / "out").string(), "--force", "--set", "path.points=200"}, file_limit(8000));
  CHECK(child.wait() == 8);
  CHECK_THAT(content(child.out), Contains("certified"));
  CHECK_THAT(content(child.err),
             Contains("the results are not in the requested folder: ") && Contains("File too large"));
  CHECK(content(dir / "out/result.json") == before);
  const std::vector<fs::path> kept = beside(dir, "out");
  REQUIRE(kept.size() == 1);
  CHECK_THAT(content(child.err), Contains("the files that could be written are in " + kept[0].string()));
  CHECK_THAT(content(kept[0] / "result.json"), Contains("\"status\": \"certified\""));
  for (const auto& entry : fs::directory_iterator(kept[0])) CHECK(entry.file_size() < 8000);  // nothing half-written
}

TEST_CASE("program: a disk without any room is said, and nothing is left") {
  if (!built()) return;
  const ScratchDir dir;
  const Child child =
      start(dir, {"run", plane(dir), "-o", (dir / "out").string(), "--format", "json"}, file_limit(1500));
  CHECK(child.wait() == 8);
  CHECK_THAT(content(child.err), Contains("File too large"));
  CHECK_FALSE(fs::exists(dir / "out"));
  CHECK(beside(dir, "out").empty());
}

TEST_CASE("program: what a closed stream is told is lost, the results are not") {
  if (!built()) return;
  const ScratchDir dir;
  const std::vector<std::string> run = {"run", plane(dir), "-o", (dir / "out").string(), "--force"};
  const auto stream_to = [](int stream, const char* device) {
    return [=] { ::dup2(::open(device, O_WRONLY), stream); };
  };
  const Child full = start(dir, run, stream_to(STDOUT_FILENO, "/dev/full"));
  CHECK(full.wait() == 8);
  CHECK_THAT(content(full.err), Contains("could not be written to standard output"));
  CHECK(fs::exists(dir / "out/path.csv"));
  const std::string path = content(dir / "out/path.csv"), result = content(dir / "out/config.resolved.yaml");

  // Closed, its number must not go to a file that then gets the summary.
  const Child closed = start(dir, run, [] { ::close(STDOUT_FILENO); });
  CHECK(closed.wait() == 8);
  CHECK(content(dir / "out/path.csv") == path);
  CHECK(content(dir / "out/config.resolved.yaml") == result);
  CHECK(start(dir, run, [] { ::close(STDERR_FILENO); }).wait() == 0);
  CHECK(start(dir, run, [] { ::close(STDIN_FILENO); }).wait() == 0);
  CHECK(content(dir / "out/path.csv") == path);

  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    CAPTURE(stream);
    const auto broken_pipe = [stream] {
      int ends[2];
      if (::pipe(ends) != 0) ::_exit(126);
      ::dup2(ends[1], stream);
      ::close(ends[0]);
      ::close(ends[1]);
    };
    CHECK(start(dir, run, broken_pipe).wait() == (stream == STDOUT_FILENO ? 8 : 0));
    CHECK(content(dir / "out/path.csv") == path);
  }
  // Progress of a longer run to a pipe that nobody reads any more.
  const Child longer =
      start(dir, {"run", endless(dir), "-o", (dir / "longer").string(), "--set", "max_seconds=1.5"}, [] {
        int ends[2];
        if (::pipe(ends) != 0) ::_exit(126);
        ::dup2(ends[1], STDERR_FILENO);
        ::close(ends[0]);
        ::close(ends[1]);
      });
  CHECK(longer.wait() == 130);
  CHECK(fs::exists(dir / "longer/path.csv"));
}

TEST_CASE("program: an output folder that cannot be is said before the run") {
  if (!built()) return;
  const ScratchDir dir;
  std::ofstream(dir / "file") << "x";
  for (const std::string& place : {std::string("/proc/x"), (dir / "file/out").string()}) {
    CAPTURE(place);
    const Child child = start(dir, {"run", plane(dir), "-o", place, "--format", "json"});
    CHECK(child.wait() == 8);
    CHECK_THAT(content(child.out), Contains("\"status\": \"output_error\""));
    CHECK_THAT(content(child.err), !Contains("please report"));
  }
  const Child empty = start(dir, {"run", plane(dir), "-o", ""});
  CHECK(empty.wait() == 2);
  CHECK_THAT(content(empty.err), Contains("must not be empty"));
  CHECK(start(dir, {"init", "plane", "-o", (dir / "file/x.yaml").string()}).wait() == 8);
}

TEST_CASE("program: killed at any time, a folder of results is whole or not there, and what was there stays") {
  if (!built()) return;
  const ScratchDir dir;
  const std::string config = plane(dir), out = (dir / "out").string();
  REQUIRE(start(dir, {"run", config, "-o", out}).wait() == 0);
  constexpr int kTries = 12;
  for (int i = 0; i < kTries; ++i) {
    const Child child = start(dir, {"run", config, "-o", out, "--force", "--set", "path.points=400"});
    std::this_thread::sleep_for(std::chrono::milliseconds(7 * i));
    ::kill(child.pid, i % 3 == 0 ? SIGTERM : SIGKILL);
    child.wait();
    CAPTURE(i);
    for (const char* file : {"result.json", "path.csv", "manifest.json", "report.html"})
      CHECK(fs::exists(fs::path(out) / file));
    CHECK(start(dir, {"report", out}).wait() == 0);
  }
}

TEST_CASE("program: of two runs into one place one is in it, and the other beside it") {
  if (!built()) return;
  const ScratchDir dir, second;
  const std::string out = (dir / "out").string();
  const std::vector<std::string> run = {"run", endless(dir), "-o", out, "--set", "max_seconds=2"};
  const Child one = start(dir, run), two = start(second, run);
  const int first_exit = one.wait(), second_exit = two.wait();
  CHECK(std::min(first_exit, second_exit) == 8);
  CHECK(std::max(first_exit, second_exit) == 130);
  const std::vector<fs::path> kept = beside(dir, "out");
  REQUIRE(kept.size() == 1);
  CHECK_THAT(content(first_exit == 8 ? one.err : two.err), Contains("the results are in " + kept[0].string()));
  for (const fs::path& place : {fs::path(out), kept[0]}) CHECK(fs::exists(place / "report.html"));
}

TEST_CASE("program: a configuration that never comes can be given up") {
  if (!built()) return;
  const ScratchDir dir;
  const std::string pipe = (dir / "pipe").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  for (const std::string command : {"run", "study"}) {
    CAPTURE(command);
    const Child child = start(dir, {command, pipe, "-o", (dir / "out").string(), "--format", "json"});
    std::this_thread::sleep_for(std::chrono::seconds(1));
    ::kill(child.pid, SIGTERM);
    CHECK(child.wait() == 130);
    CHECK_THAT(content(child.out), Contains("\"status\": \"interrupted\""));
    CHECK_THAT(content(child.err), Contains("nothing was written"));
  }
  // Opened, it still says nothing. (That it can be opened for writing shows that the program waits for it.)
  const Child child = start(dir, {"run", pipe, "-o", (dir / "out").string()});
  int writer = -1;
  for (int i = 0; i < 1000 && writer < 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    writer = ::open(pipe.c_str(), O_WRONLY | O_NONBLOCK);
  }
  ::kill(child.pid, SIGTERM);
  CHECK(child.wait() == 130);
  ::close(writer);
}

TEST_CASE("program: a merge that waits for a journal can be given up and leaves nothing") {
  if (!built()) return;
  const ScratchDir dir;
  fs::create_directory(dir / "shard");
  REQUIRE(::mkfifo((dir / "shard/journal.jsonl").c_str(), 0600) == 0);
  const Child child = start(dir, {"merge", (dir / "shard").string(), "-o", (dir / "out").string()});
  std::this_thread::sleep_for(std::chrono::seconds(1));
  ::kill(child.pid, SIGTERM);
  CHECK(child.wait() == 130);
  CHECK_THAT(content(child.err), Contains("nothing was written"));
  CHECK(beside(dir, "out").empty());
}

TEST_CASE("program: a configuration without an end is read to where it is too long") {
  if (!built()) return;
  const ScratchDir dir;
  for (const std::string command : {"run", "validate", "study"}) {
    const Child child = start(dir, {command, "/dev/zero"}, little_memory);
    CHECK(child.wait() == 3);
    CHECK_THAT(content(child.err), Contains("at most 1048576 bytes"));
  }
}

TEST_CASE("program: more points than a limit leaves memory for are refused before it is taken") {
  if (!built() || !app::can_limit_memory()) return;
  const ScratchDir dir;
  for (const std::string command : {"run", "validate"}) {
    const Child child = start(dir, {command, plane(dir), "--set", "path.points=2000000"}, little_memory);
    CHECK(child.wait() == 3);
    CHECK_THAT(content(child.err), Contains("2000000 points take about") && Contains("there are 1.0 GiB"));
  }
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
