// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Arms among balls and boxes: how many plans are found, certified and proved, what an independent look at dense places
// of the delivered curve finds, and what a solve costs, in solves of the same chain without obstacles.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/solvers/newton.hpp>
#include "benchmarks/arm_scene.hpp"
#include "benchmarks/thread_time.hpp"

namespace {

using namespace leastcost;
using namespace leastcost::bench;

constexpr int kPoints = 50, kPlaces = 20;
constexpr double kMoved = 0.005;     ///< m: how far each obstacle moves before a warm solve
constexpr double kNothing = 1e-8;    ///< m
constexpr double kStraight = 1e-9;   ///< relative: longer than a straight line is a way round something
constexpr double kMostSeconds = 20;  ///< for a plan with its certificate

struct Figures {
  std::vector<double> cold, warm, certificate, fits;
};

void print(const char* what, const Figures& f) {
  std::printf(
      "  %-9s %3zu: cold median %.1f, p90 %.1f, worst %.1f; warm %.1f, %.1f, %.1f solves; certificate %.0f ms\n", what,
      f.cold.size(), quantile_of(f.cold, 0.5), quantile_of(f.cold, 0.9), quantile_of(f.cold, 1),
      quantile_of(f.warm, 0.5), quantile_of(f.warm, 0.9), quantile_of(f.warm, 1),
      1e3 * quantile_of(f.certificate, 0.5));
}

Monitor within(double seconds) {
  Monitor monitor;
  monitor.deadline = Monitor::Clock::now() +
                     std::chrono::duration_cast<Monitor::Clock::duration>(std::chrono::duration<double>(seconds));
  return monitor;
}

/// Seconds of improve_path from a chain, without certificate; the median of some.
double seconds_of(const Problem& problem, const CoordinatePath& chain, int times, Result& result) {
  std::vector<double> all;
  for (int k = 0; k < times; ++k) {
    const double begin = thread_seconds();
    result = improve_path(problem, chain, Newton(), {.certificate = {.enabled = false}}, within(kMostSeconds));
    all.push_back(thread_seconds() - begin);
    if (all.back() > 0.1) break;  // long enough to be measured once
  }
  return quantile_of(all, 0.5);
}

}  // namespace

/// Arguments: how many queries for each arm, the first seed (the next ones are two apart), 1 to certify, the arm; 100,
/// 1, 1 and both unless given.
int main(int count, char** arguments) {
  const int queries = count > 1 ? std::atoi(arguments[1]) : 100;
  const auto first = static_cast<unsigned>(count > 2 ? std::atoi(arguments[2]) : 1);
  const bool certify = count <= 3 || std::atoi(arguments[3]) != 0;
  const std::string only = count > 4 ? arguments[4] : "";
  for (const Arm& arm : arms()) {
    if (!only.empty() && only != arm.name) continue;
    int no_ends = 0, found = 0, certified = 0, proved = 0, violations = 0;
    Figures straight, round;
    for (int k = 0; k < queries; ++k) {
      const unsigned seed = first + 2 * static_cast<unsigned>(k);
      const Query query = query_of(arm, seed, kMoved);
      if (query.source.size() == 0 || query.target.size() == 0) {
        ++no_ends;
        continue;
      }
      const Problem problem = problem_of(arm, query, &query.things), free = problem_of(arm, query, nullptr);
      try {
        FindOptions options;
        options.points = kPoints;
        options.certificate.enabled = certify;
        const Result result = find_path(problem, RrtInitializer(), Newton(), options, within(kMostSeconds));
        found += result.first.path.u.cols() > 0 ? 1 : 0;
        const bool is_certified = result.status == Status::certified;
        certified += is_certified ? 1 : 0;
        const auto& clearance = result.certificate.clearance;
        proved += is_certified && clearance && clearance->proved ? 1 : 0;
        double least = 1e9;
        for (Index i = 0; i + 1 < result.curve.x.cols(); ++i)
          for (int place = 0; place <= kPlaces; ++place)
            least = std::min(least, own_gap(arm, query.things,
                                            result.curve.x.col(i) +
                                                (result.curve.x.col(i + 1) - result.curve.x.col(i)) * place / kPlaces));
        violations += is_certified && least < -kNothing ? 1 : 0;
        if (result.path.u.cols() == 0) continue;
        Result solved, freed, warmed;
        const double cold = seconds_of(problem, result.initial, 3, solved);
        const double unit = seconds_of(free, result.initial, 7, freed);
        const double warm = seconds_of(problem_of(arm, query, &query.moved), result.path, 3, warmed);
        const bool goes_round = solved.curve.cost > (query.target - query.source).norm() * (1 + kStraight);
        Figures& figures = goes_round ? round : straight;
        figures.cold.push_back(cold / unit);
        figures.warm.push_back(warm / unit);
        figures.certificate.push_back(result.seconds.certify);
        std::printf(
            "seed %u: %s%s, gap %.1e, first %.2f s, cold %.2f ms (%d iterations), warm %.2f ms (%d), free %.3f ms "
            "(%d), %s: %.1f, %.1f\n",
            seed, is_certified ? "certified" : "not certified", least < -kNothing ? ", TOUCHES" : "", least,
            result.seconds.initialize, 1e3 * cold, solved.solve.iterations, 1e3 * warm, warmed.solve.iterations,
            1e3 * unit, freed.solve.iterations, goes_round ? "round" : "straight", cold / unit, warm / unit);
        for (const auto& failure : result.certificate.failures)
          std::printf("    %s: %s\n", failure.name().c_str(), failure.message.c_str());
      } catch (const std::exception& error) {
        std::printf("seed %u: %s\n", seed, error.what());
      }
      std::fflush(stdout);
    }
    std::printf(
        "%s: %d queries, %d without free ends, %d first paths, %d certified, %d of them proved, %d of them violated\n",
        arm.name, queries, no_ends, found, certified, proved, violations);
    print("straight", straight);
    print("round", round);
  }
}
