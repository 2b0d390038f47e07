// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Plans of RRTConnect among discs, polished, against OMPL's own simplifier with the same time and with as much as it
// likes. Paths are judged by the exact distance of their moves from the discs.
#include <time.h>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <leastcost/ompl/ompl.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>
#include "tests/support/moving_discs.hpp"

namespace {

using namespace leastcost;
namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kLeastRadius = 0.3, kMostRadius = 1;
constexpr double kResolution = 0.001;  ///< of the planner, of the extent of its space
constexpr double kSame = 1e-9;         ///< relative: lengths that differ by less are equal
constexpr double kContact = -1e-9;     ///< a clearance that is contact

test::Discs discs_of(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> along(0, 10), radius(kLeastRadius, kMostRadius);
  test::Discs discs;
  while (discs.size() < 25) {
    const test::Disc disc{along(random), along(random), radius(random)};
    const double from = std::hypot(disc.x - 0.5, disc.y - 0.5), to = std::hypot(disc.x - 9.5, disc.y - 9.5);
    if (std::min(from, to) > disc.r + 0.1) discs.push_back(disc);
  }
  return discs;
}

double distance_of(const test::Discs& discs, const double* x) {
  double least = std::numeric_limits<double>::infinity();
  for (const test::Disc& disc : discs) least = std::min(least, std::hypot(x[0] - disc.x, x[1] - disc.y) - disc.r);
  return least;
}

class DiscChecker final : public ob::StateValidityChecker {
 public:
  DiscChecker(const ob::SpaceInformationPtr& space, const test::Discs& discs)
      : ob::StateValidityChecker(space), discs_(discs) {}
  bool isValid(const ob::State* state) const override { return clearance(state) >= 0; }
  double clearance(const ob::State* state) const override {
    return distance_of(discs_, state->as<ob::RealVectorStateSpace::StateType>()->values);
  }

 private:
  const test::Discs& discs_;
};

/// What is said about the obstacles.
enum class Known { discs, distance, answer };

PolishOptions options_of(Known known, const test::Discs& discs, bool certify) {
  PolishOptions options;
  options.find.certificate.enabled = certify;
  if (known == Known::distance) {
    // Not bent more than by the inverse of the distance from the centre, 0.1 within the smallest disc as well.
    constexpr double kWithin = 0.1;
    options.distance =
        DistanceChecker{.curvature = 1 / (kLeastRadius - kWithin), .curvature_from = -kWithin, .size = 10};
  }
  if (known == Known::discs) {
    ObstacleWalls::Obstacles obstacles;
    for (const test::Disc& disc : discs)
      obstacles.push_back(make_ball({.center = Eigen::Vector2d(disc.x, disc.y), .radius = disc.r}));
    options.walls = std::make_shared<ObstacleWalls>(2, std::move(obstacles), 0);
  }
  return options;
}

/// Of processor time of this thread.
double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// "median 12.3, worst 45.6 ms"
std::string milliseconds(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "median %.1f, worst %.1f ms", 1e3 * seconds[seconds.size() / 2],
                1e3 * seconds.back());
  return text.data();
}

/// Against one of OMPL's ways to simplify.
struct Against {
  int shorter = 0, longer = 0, longer_than_valid = 0, invalid = 0;
  std::vector<double> seconds;
  double ratio = 0, worst = 0;

  void add(double length, const og::PathGeometric& theirs, double took, const test::Discs& discs) {
    const Points x = StateColumns(theirs.getSpaceInformation()->getStateSpace()).columns(theirs);
    const bool enters = test::clearance_of(x, discs)<kContact, beaten = length>(1 + kSame) * theirs.length();
    shorter += length < (1 - kSame) * theirs.length() ? 1 : 0;
    longer += beaten ? 1 : 0;
    longer_than_valid += beaten && !enters ? 1 : 0;
    invalid += enters ? 1 : 0;
    seconds.push_back(took);
    ratio += length / theirs.length();
    worst = std::max(worst, length / theirs.length());
  }
  void print(const char* name, int scenes) const {
    std::printf(
        "    %-24s shorter than it %3d, longer %3d (than a valid path %d); length / its %.4f, at most %.4f; it took "
        "%s, "
        "enters a disc %d\n",
        name, shorter, longer, longer_than_valid, ratio / scenes, worst, milliseconds(seconds).c_str(), invalid);
  }
};

struct Row {
  int scenes = 0, longer_than_given = 0, invalid = 0, certified = 0, polished = 0;
  std::vector<double> seconds;
  double ratio = 0, deepest = 0;
  Against once, again, most;
};

void scene(unsigned seed, Known known, bool certify, bool verbose, Row& row) {
  const test::Discs discs = discs_of(seed);
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(0, 10);
  og::SimpleSetup setup(space);
  const ob::SpaceInformationPtr& information = setup.getSpaceInformation();
  setup.setStateValidityChecker(std::make_shared<DiscChecker>(information, discs));
  information->setStateValidityCheckingResolution(kResolution);
  ob::ScopedState<> start(space), goal(space);
  start[0] = start[1] = 0.5;
  goal[0] = goal[1] = 9.5;
  setup.setStartAndGoalStates(start, goal);
  setup.setPlanner(std::make_shared<og::RRTConnect>(information));
  if (setup.solve(1.0) != ob::PlannerStatus::EXACT_SOLUTION) return;
  const og::PathGeometric plan = setup.getSolutionPath();
  if (test::clearance_of(StateColumns(space).columns(plan), discs) < kContact) return;  // it is no plan

  const PolishOptions options = options_of(known, discs, certify);
  double begin = now();
  const Polished ours = polish(plan, options);
  const double seconds = now() - begin;

  const double length = ours.path->length();
  const double clearance = test::clearance_of(StateColumns(space).columns(*ours.path), discs);
  og::PathSimplifier simplifier(information);
  og::PathGeometric once = plan, again = plan, most = plan;
  begin = now();
  simplifier.simplify(once, seconds);
  row.once.add(length, once, now() - begin, discs);
  begin = now();
  while (now() - begin < seconds) simplifier.simplify(again, seconds - (now() - begin));
  row.again.add(length, again, now() - begin, discs);
  begin = now();
  simplifier.simplifyMax(most);
  row.most.add(length, most, now() - begin, discs);

  ++row.scenes;
  row.seconds.push_back(seconds);
  row.ratio += length / plan.length();
  row.longer_than_given += length > (1 + kSame) * plan.length() ? 1 : 0;
  row.invalid += clearance < kContact || !ours.path->check() ? 1 : 0;
  row.deepest = std::min(row.deepest, clearance);
  row.certified += ours.certified() ? 1 : 0;
  row.polished += ours.outcome == PolishOutcome::polished ? 1 : 0;
  if (!verbose) return;
  std::printf("  scene %u: plan %.4f, simplified %.4f, %.4f, %.4f, ours %.4f (%s, %s) clear by %.1e in %.1f ms %s\n",
              seed, plan.length(), once.length(), again.length(), most.length(), length, word_of(ours.outcome).data(),
              word_of(ours.result.status).data(), clearance, 1e3 * seconds, ours.why.c_str());
  for (const CertificateFailure& failure : ours.result.certificate.failures)
    std::printf("    %s: %s\n", failure.name().c_str(), failure.message.c_str());
}

}  // namespace

/// Arguments: the first seed (every second one is taken; default 2), how many (default 100), any third: each scene.
int main(int count, char** arguments) {
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  ompl::RNG::setSeed(7);
  const int first = count > 1 ? std::atoi(arguments[1]) : 2, scenes = count > 2 ? std::atoi(arguments[2]) : 100;
  for (const bool certify : {false, true}) {
    for (const Known known : {Known::discs, Known::distance, Known::answer}) {
      Row row;
      for (int i = 0; i < scenes; ++i) scene(static_cast<unsigned>(first + 2 * i), known, certify, count > 3, row);
      const char* what = known == Known::discs ? "the discs" : known == Known::distance ? "a distance" : "yes or no";
      std::printf(
          "%s, %s: %d plans; polished %d, certified %d; longer than given %d, not valid %d (deepest %.1e); length / "
          "given "
          "%.4f; %s\n",
          what, certify ? "certificate" : "no certificate", row.scenes, row.polished, row.certified,
          row.longer_than_given, row.invalid, row.deepest, row.ratio / row.scenes, milliseconds(row.seconds).c_str());
      row.once.print("simplify, as long", row.scenes);
      row.again.print("simplify until time is up", row.scenes);
      row.most.print("simplifyMax", row.scenes);
      std::fflush(stdout);
    }
  }
}
