// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "tests/app/config_text.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

/// The built program as a process of its own.
struct Child {
  pid_t pid = -1;
  std::filesystem::path out, err;

  /// Exit code, or 1000 + the signal that ended it. One that does not end is killed: 1000 + SIGKILL.
  int wait() const {
    int status = 0;
    constexpr std::chrono::milliseconds kPause{10};
    constexpr int kMostPauses = 12000;
    pid_t ended = 0;
    for (int i = 0; i < kMostPauses && (ended = ::waitpid(pid, &status, WNOHANG)) == 0; ++i)
      std::this_thread::sleep_for(kPause);
    if (ended == 0) {
      ::kill(pid, SIGKILL);
      ::waitpid(pid, &status, 0);
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }
};

/// Starts the program with its streams in files of `dir`. `prepare` runs in the child before the program does.
/// `which`: another program file.
inline Child start(const ScratchDir& dir, std::vector<std::string> arguments, const std::function<void()>& prepare = {},
                   const std::filesystem::path& which = program()) {
  Child child{-1, dir / "stdout", dir / "stderr"};
  arguments.insert(arguments.begin(), which.string());
  std::vector<char*> argv;
  for (std::string& a : arguments) argv.push_back(a.data());
  argv.push_back(nullptr);
  child.pid = ::fork();
  if (child.pid != 0) return child;
  ::dup2(::open(child.out.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDOUT_FILENO);
  ::dup2(::open(child.err.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDERR_FILENO);
  if (prepare) prepare();
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

/// A run of minutes: plain L-BFGS on many points.
inline std::string endless(const ScratchDir& dir) {
  const std::filesystem::path file = dir / "endless.yaml";
  std::ofstream(file)
      << "manifold: euclidean\ncost: {type: travel_time, gravity: 1, start_speed: 1}\n"
         "ends: {source: {point: [0, 0]}, target: {point: [3, -1]}}\npath: {points: 20000}\n"
         "solver: {type: lbfgs, precondition: none, max_iterations: 1000000, max_evaluations: 100000000}\n";
  return file.string();
}

inline std::string plane(const ScratchDir& dir) {
  const std::filesystem::path file = dir / "plane.yaml";
  std::ofstream(file) << kPlane;
  return file.string();
}

inline bool built() {
  if (!program().empty()) return true;
  record_skip("the program from outside", "the program was not built");
  return false;
}

}  // namespace leastcost::test
