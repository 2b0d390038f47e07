// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A configuration read by a program, changed in memory, solved, and its files written: load_run slide.yaml FOLDER
#include <cstdio>
#include <exception>

#include <leastcost/catalogue/catalogue.hpp>
#include <leastcost/problems/costs/travel_time.hpp>

int main(int count, char** arguments) try {
  if (count != 3) return std::fprintf(stderr, "usage: load_run CONFIG FOLDER\n"), 2;
  leastcost::Run run = leastcost::load_run(arguments[1], {{"path.points=80"}});
  run.parts.problem.cost = leastcost::make_travel_time_cost({.gravity = 4}, 2, run.parts.problem.source.u);
  const leastcost::RunOutcome outcome = leastcost::solve(run);
  leastcost::write_run(outcome, arguments[2], {.replace = true});
  const leastcost::Certificate& certificate = outcome.result.certificate;
  std::printf("%s: %.4f s\n", certificate.certified() ? "certified" : "uncertified", certificate.estimate.value);
  return certificate.certified() ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 3;
}
