// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <map>
#include <new>
#include <thread>

#include "app/study/cell/isolation.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {

using Catch::Contains;
using How = app::IsolatedEnd::How;

namespace {

/// Runs the works, each with the limits given, and returns how they ended.
std::map<std::size_t, app::IsolatedEnd> ends_of(const std::vector<std::function<std::string()>>& works,
                                                int parallel = 1, double max_seconds = 0, int max_memory = 0) {
  std::map<std::size_t, app::IsolatedEnd> ends;
  app::IsolatedJobs jobs;
  jobs.count = works.size();
  jobs.parallel = parallel;
  jobs.job = [&](std::size_t i) { return app::IsolatedJob{works[i], max_seconds, max_memory}; };
  jobs.ended = [&](std::size_t i, app::IsolatedEnd end) {
    CHECK(ends.count(i) == 0);
    ends[i] = std::move(end);
  };
  CHECK(app::run_isolated(jobs));
  return ends;
}

std::string hang() {
  for (;;) ::pause();
}

}  // namespace

TEST_CASE("isolation: what a child returns reaches the parent whole") {
  const std::string large(3'000'000, 'x');  // more than a pipe holds
  const auto ends =
      ends_of({[] { return std::string(); }, [&] { return large; }, [] { return std::string("\n\n"); }}, 2);
  REQUIRE(ends.size() == 3);
  CHECK(ends.at(0).how == How::done);
  CHECK(ends.at(0).text == "");
  CHECK(ends.at(1).text == large);
  CHECK(ends.at(2).text == "\n\n");
}

TEST_CASE("isolation: crash, exception, silent exit and hang are ends like any other") {
  const auto ends =
      ends_of({[]() -> std::string {
                 std::fprintf(stderr, "first line\nlast words\n");
                 std::signal(SIGABRT, SIG_DFL);
                 std::abort();
               },
               []() -> std::string { throw std::runtime_error("what it says"); }, []() -> std::string { throw 7; },
               []() -> std::string { ::_exit(0); }, hang, [] { return std::string("good"); }},
              3, 0.2);
  REQUIRE(ends.size() == 6);
  CHECK(ends.at(0).how == How::crash);
  CHECK_THAT(ends.at(0).text, Contains("signal 6") && Contains("last words") && !Contains("first"));
  CHECK(ends.at(1).how == How::error);
  CHECK(ends.at(1).text == "what it says");
  CHECK(ends.at(2).how == How::error);
  CHECK(ends.at(3).how == How::crash);
  CHECK(ends.at(3).text == "ended without a result");
  CHECK(ends.at(4).how == How::timeout);
  CHECK(ends.at(5).how == How::done);
}

TEST_CASE("isolation: memory has a limit of its own") {
  const auto greedy = [] { return std::string(std::size_t{4'000'000'000}, 'x').substr(0, 1); };
  const auto out_of_memory = ends_of({[]() -> std::string { throw std::bad_alloc(); }});
  CHECK(out_of_memory.at(0).how == How::memory);
  if (app::can_limit_memory()) CHECK(ends_of({greedy}, 1, 0, 1000).at(0).how == How::memory);
}

TEST_CASE("isolation: a stop request ends the children, and a signal for the parent does not") {
  const auto start = std::chrono::steady_clock::now();
  int ended = 0;
  app::IsolatedJobs jobs;
  jobs.count = 4;
  jobs.parallel = 2;
  jobs.job = [](std::size_t) { return app::IsolatedJob{hang}; };
  jobs.ended = [&](std::size_t, const app::IsolatedEnd&) { ++ended; };
  jobs.stop_requested = [&] { return std::chrono::steady_clock::now() - start > std::chrono::milliseconds(50); };
  CHECK_FALSE(app::run_isolated(jobs));
  CHECK(ended == 0);

  const auto ends = ends_of({[] {
    ::raise(SIGINT);
    ::raise(SIGTERM);
    return std::string("alive");
  }});
  CHECK(ends.at(0).text == "alive");
}

TEST_CASE("isolation: at most so many at once, in their order") {
  const auto nap = [] {
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    return std::to_string(std::chrono::steady_clock::now().time_since_epoch().count());
  };
  const auto seconds_of = [&](int at_once) {
    const auto start = std::chrono::steady_clock::now();
    ends_of({nap, nap, nap, nap}, at_once);
    return std::chrono::steady_clock::now() - start;
  };
  auto together = seconds_of(4);  // the least of a few: the machine may be busy
  for (int k = 0; k < 4; ++k) together = std::min(together, seconds_of(4));
  CHECK(together < std::chrono::milliseconds(4 * 60));
  const auto ends = ends_of({nap, nap, nap}, 1);
  CHECK(std::stoll(ends.at(0).text) < std::stoll(ends.at(1).text));
  CHECK(std::stoll(ends.at(1).text) < std::stoll(ends.at(2).text));
}

}  // namespace leastcost::test
