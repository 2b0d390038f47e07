// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "tests/adversarial/planning/measure_scenes.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <sstream>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include <leastcost/problems/post_processors/shortest_plan.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include "tests/adversarial/planning/judge/exact.hpp"
#include "tests/adversarial/planning/judge/grid_passage.hpp"
#include "tests/adversarial/planning/judge/tangent_graph.hpp"

namespace leastcost::test {
namespace {

using judge::Thing;
using Vector = Eigen::VectorXd;

constexpr double kProvedExcess = 2e-6;  ///< of what is proved to be the shortest: a polyline around discs
constexpr unsigned kMostSeconds = 60;   ///< beyond the budget
constexpr double kTolerance = 1e-9;     ///< of the diameter: what the certificate promises
constexpr int kNodesInPlane = 400, kNodesInSpace = 60;

Vector vector(const judge::Place& x) { return Eigen::Map<const Vector>(x.data(), static_cast<Index>(x.size())); }

std::shared_ptr<const Obstacle> obstacle(const Thing& thing) {
  if (thing.kind == Thing::Kind::ball) return make_ball({vector(thing.corners[0]), thing.radius});
  if (thing.kind == Thing::Kind::box) return make_box_obstacle({vector(thing.corners[0]), vector(thing.corners[1])});
  Eigen::MatrixXd corners(static_cast<Index>(thing.corners.size()), 2);
  for (Index i = 0; i < corners.rows(); ++i) corners.row(i) = vector(thing.corners[static_cast<std::size_t>(i)]);
  return make_polygon({corners});
}

Problem problem_of(const judge::Scene& scene) {
  FreeSpace::Obstacles all;
  for (const Thing& thing : scene.things) all.push_back(obstacle(thing));
  Problem problem;
  const auto space = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = scene.dimension});
  problem.manifold = std::make_shared<const FreeSpace>(space, std::move(all), scene.clearance);
  problem.cost = make_euclidean_cost(scene.dimension);
  problem.kernel = make_kernel(Expm1Square{});
  problem.source = {vector(scene.source)};
  problem.target = {vector(scene.target)};
  return problem;
}

std::string word_of(const Result& result) {
  std::string word(word_of(result.status));
  for (const auto& failure : result.certificate.failures) word += " " + failure.name();
  return word;
}

struct Plan {
  std::string word;
  Points curve = {};
  std::optional<double> least = {};  ///< no path at all is shorter, where that is proved
};

Plan plan(const PlannedScene& planned, double budget) {
  try {
    FindOptions options;
    options.points = planned.points;
    options.post_processors = {std::make_shared<const TautPostProcessor>()};
    if (planned.scene.dimension == 2)
      options.post_processors.push_back(std::make_shared<const ShortestPlanPostProcessor>());
    Monitor monitor;
    monitor.deadline = Monitor::Clock::now() +
                       std::chrono::duration_cast<Monitor::Clock::duration>(std::chrono::duration<double>(budget));
    const Problem problem = problem_of(planned.scene);
    const Result result = planned.scene.dimension == 2
                              ? find_path(problem, GridInitializer(), NoSolver(), options, monitor)
                              : find_path(problem, RrtInitializer(), NoSolver(), options, monitor);
    Plan delivered{word_of(result), result.curve.x};
    if (const auto& global = result.certificate.global; global && global->proved) delivered.least = global->lower_bound;
    return delivered;
  } catch (const InitializationError&) {
    return {"no first path", {}};
  } catch (const InputError& error) {
    const std::string text = error.what();
    return {text.find("end_in_clearance") != std::string::npos ? "end_in_clearance" : "refused: " + text, {}};
  } catch (const std::exception& error) {
    return {std::string("untyped: ") + error.what(), {}};
  }
}

bool all_discs(const judge::Scene& scene) {
  return scene.dimension == 2 && std::all_of(scene.things.begin(), scene.things.end(),
                                             [](const Thing& t) { return t.kind == Thing::Kind::ball; });
}

SceneOutcome judged(const PlannedScene& planned, double budget) {
  const judge::Scene& scene = planned.scene;
  const double tolerance = kTolerance * scene.diameter();
  SceneOutcome outcome;
  outcome.excess = std::numeric_limits<double>::quiet_NaN();
  const auto start = std::chrono::steady_clock::now();
  const auto [word, curve, least] = plan(planned, budget);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.word = word;
  for (const judge::Place& end : {scene.source, scene.target})
    outcome.end_inside = outcome.end_inside || judge::first_touch(scene, {end, end}, tolerance).has_value();
  std::optional<double> shortest;
  if (!outcome.end_inside) {
    if (all_discs(scene))
      outcome.confirmed = (shortest = judge::shortest_among_discs(scene)).has_value();
    else
      outcome.confirmed = judge::grid_confirms(scene, scene.dimension == 2 ? kNodesInPlane : kNodesInSpace);
  }
  if (!outcome.certified()) return outcome;
  std::vector<judge::Place> path;
  double length = 0;
  for (Index i = 0; i < curve.cols(); ++i) {
    path.emplace_back(curve.col(i).begin(), curve.col(i).end());
    if (i > 0) length += (curve.col(i) - curve.col(i - 1)).norm();
  }
  const bool joins = path.size() > 1 && path.front() == scene.source && path.back() == scene.target;
  outcome.wrong = !joins || judge::first_touch(scene, path, tolerance).has_value();
  if (shortest) outcome.excess = length / *shortest - 1;
  // A curve that keeps the clearance but for the tolerance may be shorter than the shortest by a root of it.
  if (outcome.excess < -1e-4) outcome.wrong = true;
  if (shortest && least && (outcome.excess > kProvedExcess || *least > (1 + kProvedExcess) * *shortest))
    outcome.wrong = true;
  return outcome;
}

/// The line that a child sends to its parent.
std::string line_of(const SceneOutcome& o) {
  std::ostringstream out;
  out.precision(17);
  out << o.confirmed << ' ' << o.end_inside << ' ' << o.wrong << ' ' << o.seconds << ' '
      << (std::isnan(o.excess) ? "unknown" : std::to_string(o.excess)) << ' ' << o.word;
  return out.str();
}

SceneOutcome outcome_of(const std::string& line) {
  SceneOutcome o;
  std::istringstream in(line);
  std::string excess;
  in >> o.confirmed >> o.end_inside >> o.wrong >> o.seconds >> excess >> std::ws;
  o.excess = excess == "unknown" ? std::numeric_limits<double>::quiet_NaN() : std::strtod(excess.c_str(), nullptr);
  std::getline(in, o.word);
  return o;
}

}  // namespace

SceneOutcome measure_scene(const PlannedScene& planned, double budget) {
  int ends[2];
  if (pipe(ends) != 0) return {"no pipe"};
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGILL}) std::signal(signal, SIG_DFL);  // not the test runner's
    alarm(kMostSeconds + static_cast<unsigned>(budget));
    const std::string line = line_of(judged(planned, budget));
    const bool sent = write(ends[1], line.data(), line.size()) == static_cast<ssize_t>(line.size());
    _exit(sent ? 0 : 1);
  }
  close(ends[1]);
  std::string line;
  char part[512];
  for (ssize_t got = 0; (got = read(ends[0], part, sizeof part)) > 0;) line.append(part, static_cast<std::size_t>(got));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return outcome_of(line);
  return {WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM ? "timeout" : "crash"};
}

void SceneTally::add(std::uint64_t seed, const SceneOutcome& outcome) {
  ++scenes;
  seconds += outcome.seconds;
  confirmed += outcome.confirmed;
  certified += outcome.certified();
  certified_of_confirmed += outcome.certified() && outcome.confirmed;
  if (outcome.wrong) ++wrong, wrong_seeds.push_back(seed);
  if (outcome.word == "crash" || outcome.word == "timeout") ++crashes, crash_seeds.push_back(seed);
  untyped += outcome.word.rfind("untyped", 0) == 0;
  if (!outcome.certified()) ++others[outcome.word];
  if (outcome.certified() && !std::isnan(outcome.excess)) excess.push_back(outcome.excess);
}

std::string SceneTally::row(const std::string& family) const {
  std::vector<double> sorted = excess;
  std::sort(sorted.begin(), sorted.end());
  const auto at = [&](double share) {
    return sorted.empty() ? std::numeric_limits<double>::quiet_NaN()
                          : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  };
  char text[256];
  std::snprintf(text, sizeof text, "  %-14s %6d %9d %9d %8.1f%% %6d %7d %9.1e %9.1e %6.2f ", family.c_str(), scenes,
                confirmed, certified, confirmed > 0 ? 100.0 * certified_of_confirmed / confirmed : 100.0, wrong,
                crashes, at(0.5), at(1), seconds / std::max(1, scenes));
  std::string out = text;
  for (const auto& [word, count] : others) out += " [" + std::to_string(count) + " " + word + "]";
  for (const std::uint64_t seed : wrong_seeds) out += " wrong:" + std::to_string(seed);
  for (const std::uint64_t seed : crash_seeds) out += " crash:" + std::to_string(seed);
  return out;
}

SceneTally measure_scenes(const SceneFamily& family, std::uint64_t first, int count, double budget) {
  const char* csv = std::getenv("LEASTCOST_SCENES_CSV");  // NOLINT(concurrency-mt-unsafe)
  std::FILE* file = csv != nullptr ? std::fopen(csv, "a") : nullptr;
  SceneTally tally;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t seed = first + 2 * static_cast<std::uint64_t>(i);
    const SceneOutcome outcome = measure_scene(family.make(seed), budget);
    tally.add(seed, outcome);
    if (file == nullptr) continue;
    std::fprintf(file, "%s,%llu,%s\n", family.name.c_str(), static_cast<unsigned long long>(seed),
                 line_of(outcome).c_str());
    std::fflush(file);
  }
  if (file != nullptr) std::fclose(file);
  return tally;
}

}  // namespace leastcost::test
