// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/progress.hpp"

#include <sstream>
#include <thread>

#include "tests/support/catch.hpp"

namespace leastcost::test {

using Catch::Contains;

namespace {

Progress solving(const Iteration& iteration) { return {Stage::solve, &iteration}; }
Iteration with_error(int number, double error) { return {.iteration = number, .cost_error = error}; }
void wait(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

}  // namespace

TEST_CASE("progress: on a terminal a bar that is taken away again") {
  std::ostringstream out, err;
  {
    app::ProgressPrinter printer({out, err, true, false}, false);
    const Iteration first = with_error(0, 1e-2), later = with_error(7, 1e-8);
    printer.show(solving(first));
    wait(120);
    printer.show(solving(later));
  }
  CHECK_THAT(err.str(), Contains("\r\033[K[##########..........] solve") && Contains("iteration 7"));
  CHECK(err.str().substr(err.str().size() - 4) == "\r\033[K");
  CHECK(out.str().empty());
}

TEST_CASE("progress: elsewhere plain lines per 10 %, none in the first second, none when quiet") {
  std::ostringstream out, err;
  app::ProgressPrinter printer({out, err, false, false}, false), silent({out, err, false, false}, true);
  const Iteration first = with_error(0, 1e-2);
  printer.show(solving(first));
  CHECK(err.str().empty());
  wait(1050);
  for (int i = 1; i <= 120; ++i) {
    const Iteration next = with_error(i, 1e-2 * std::pow(10, -i / 10.0));
    printer.show(solving(next));
    silent.show(solving(next));
  }
  const std::string text = err.str();
  CHECK(std::count(text.begin(), text.end(), '\n') == 11);  // where it stands after the silent second, then each 10 %
  CHECK_THAT(text, Contains(" 50 %  solve") && Contains("100 %  solve"));
  CHECK(text.find('\r') == std::string::npos);
}

TEST_CASE("progress: errors that are no numbers are no progress") {
  std::ostringstream out, err;
  app::ProgressPrinter printer({out, err, true, false}, false);
  wait(120);
  for (const double error : {std::nan(""), std::numeric_limits<double>::infinity(), 0.0, -1.0}) {
    const Iteration i = with_error(1, error);
    CHECK_NOTHROW(printer.show(solving(i)));
  }
  printer.show({Stage::certify, nullptr});
}

TEST_CASE("progress: a search with more points says with how many, as a bar and in lines") {
  std::ostringstream out, bar, lines;
  app::ProgressPrinter on_terminal({out, bar, true, false}, false), elsewhere({out, lines, false, false}, false);
  const Iteration iteration = with_error(3, 1e-5);
  const MorePoints once{121, 1, 6}, twice{243, 2, 6};
  elsewhere.show({Stage::initialize, nullptr, &once});
  CHECK(lines.str().empty());
  wait(1050);
  for (const MorePoints* more : {&once, &twice}) {
    on_terminal.show({Stage::solve, &iteration, more});
    for (const Stage stage : {Stage::initialize, Stage::certify}) elsewhere.show({stage, nullptr, more});
    elsewhere.show({Stage::solve, &iteration, more});
  }
  CHECK_THAT(bar.str(), Contains("certificate: trying 121 points (1 of 6)"));
  const std::string text = lines.str();
  CHECK_THAT(text, Contains("certificate: trying 121 points (1 of 6)\n") &&
                       Contains("certificate: trying 243 points (2 of 6)\n"));
  CHECK(std::count(text.begin(), text.end(), '\n') == 2);
}

TEST_CASE("progress: a domain that is being made, as a bar and in lines") {
  std::ostringstream out, bar, lines;
  app::ProgressPrinter on_terminal({out, bar, true, false}, false), elsewhere({out, lines, false, false}, false);
  on_terminal.show_building(0, "distances");
  elsewhere.show_building(0, "distances");
  wait(1050);
  on_terminal.show_building(0.25, "distances");
  elsewhere.show_building(0.25, "distances");
  elsewhere.show_building(0.99, "distances");  // at most a line per second
  CHECK_THAT(bar.str(), Contains("\r\033[K[#####...............] build        distances"));
  CHECK_THAT(lines.str(), Contains(" 25 %  build        distances\n"));
  CHECK(lines.str().find("99 %") == std::string::npos);
}

}  // namespace leastcost::test
