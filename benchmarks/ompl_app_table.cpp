// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Plans of RRTConnect in OMPL.app's maze (a car in the plane) and cubicles (a body in space), polished, against OMPL's
// own simplifier with the same time and with as much as it likes. Paths are judged by our bounds on motion and, where
// it is installed, by FCL on the meshes as they are.
#include <time.h>

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <leastcost/ompl/ompl.hpp>
#include "tests/support/app_scene.hpp"
#ifdef LEASTCOST_HAS_FCL
#include "benchmarks/fcl_judge.hpp"
#endif

namespace {

using namespace leastcost;
namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kResolution = 0.001;    ///< of the planner, of the extent of its space
constexpr double kFclResolution = 0.05;  ///< length units
constexpr double kSame = 1e-9;           ///< relative: costs that differ by less are equal
constexpr double kContact = -1e-9;       ///< of the extent of the space: a clearance that is contact
constexpr double kPlanSeconds = 20;

/// The poses of columns: quaternions are x, y, z, w there, and turns are scaled.
Points poses_of(const Points& columns, double turn) {
  Points out = columns;
  if (columns.rows() == 7) {
    out.row(3) = columns.row(6);
    out.bottomRows(3) = columns.middleRows(3, 3);
  }
  out.bottomRows(columns.rows() == 7 ? 4 : 1) /= turn;
  return out;
}

class PoseChecker final : public ob::StateValidityChecker {
 public:
  PoseChecker(const ob::SpaceInformationPtr& space, const StateColumns& columns, std::shared_ptr<const Walls> walls)
      : ob::StateValidityChecker(space), columns_(columns), walls_(std::move(walls)) {}
  bool isValid(const ob::State* state) const override {
    std::vector<Wall> found;
    walls_->near(columns_.column(*state), 0, found);
    return found.empty();
  }

 private:
  StateColumns columns_;
  std::shared_ptr<const Walls> walls_;
};

/// Of processor time of this thread.
double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// "median 12.3, worst 45.6 ms"
std::string milliseconds(std::vector<double> seconds) {
  if (seconds.empty()) return "";
  std::sort(seconds.begin(), seconds.end());
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "median %.0f, worst %.0f ms", 1e3 * seconds[seconds.size() / 2],
                1e3 * seconds.back());
  return text.data();
}

class Bench {
 public:
  explicit Bench(const test::AppScene& scene)
      : scene_(scene),
        space_(make_space(scene)),
        turn_(turn_of(scene)),
        columns_(space_, turn_),
        walls_(make_pose_walls(columns_, test::walls_of(scene, turn_))),
        length_(columns_.length())
#ifdef LEASTCOST_HAS_FCL
        ,
        judge_(scene)
#endif
  {
  }

  const std::shared_ptr<const Walls>& walls() const { return walls_; }
  const ob::StateSpacePtr& space() const { return space_; }
  double turn() const { return turn_; }
  double cost(const Points& x) const {
    double sum = 0;
    for (Index i = 0; i + 1 < x.cols(); ++i) sum += move_cost(*length_, x.col(i), x.col(i + 1));
    return sum;
  }
  /// In pieces so small that chords of quaternions are their arcs.
  double cost(og::PathGeometric path) const {
    path.interpolate(kPieces);
    return cost(columns_.columns(path));
  }
  /// The least clearance of its moves, a lower bound, length units; minus infinity where it is not known.
  double clearance(const og::PathGeometric& path) const {
    const Points x = columns_.columns(path);
    double least = std::numeric_limits<double>::infinity();
    for (Index i = 0; i + 1 < x.cols(); ++i) least = std::min(least, walls_->clearance(x.col(i), x.col(i + 1)).lower);
    return least;
  }
  bool clear(const og::PathGeometric& path) const { return clearance(path) >= kContact * space_->getMaximumExtent(); }
  int meetings(const og::PathGeometric& path) const {
#ifdef LEASTCOST_HAS_FCL
    return judge_.meetings(poses_of(columns_.columns(path), turn_), kFclResolution);
#else
    static_cast<void>(path);
    return 0;
#endif
  }
#ifdef LEASTCOST_HAS_FCL
  bool fcl_meets(const Eigen::VectorXd& pose) const { return judge_.meets(pose); }
#endif

  void set_up(og::SimpleSetup& setup) const {
    const ob::SpaceInformationPtr& information = setup.getSpaceInformation();
    setup.setStateValidityChecker(std::make_shared<PoseChecker>(information, columns_, walls_));
    information->setStateValidityCheckingResolution(kResolution);
    ob::ScopedState<> start(space_), goal(space_);
    columns_.write(state_column(scene_.start), *start);
    columns_.write(state_column(scene_.goal), *goal);
    setup.setStartAndGoalStates(start, goal);
    setup.setPlanner(std::make_shared<og::RRTConnect>(information));
  }

 private:
  static constexpr unsigned kPieces = 2000;

  Eigen::VectorXd state_column(const Eigen::VectorXd& pose) const {
    Eigen::VectorXd out = pose;
    if (pose.size() == 7) {
      out.segment(3, 3) = pose.tail(3);
      out[6] = pose[3];
    }
    out.tail(pose.size() == 7 ? 4 : 1) *= turn_;
    return out;
  }

  /// How far a turn moves the body at most, per angle or change of the quaternion.
  static double turn_of(const test::AppScene& scene) {
    double farthest = 0;
    for (const auto& corners : scene.body)
      for (const Eigen::Vector3d& p : corners)
        farthest = std::max(farthest, scene.planar ? p.head<2>().norm() : 2 * p.norm());
    return farthest;
  }

  static ob::StateSpacePtr make_space(const test::AppScene& scene) {
    ob::RealVectorBounds bounds(static_cast<unsigned>(scene.lower.size()));
    for (Eigen::Index i = 0; i < scene.lower.size(); ++i) {
      bounds.low[static_cast<std::size_t>(i)] = scene.lower[i];
      bounds.high[static_cast<std::size_t>(i)] = scene.upper[i];
    }
    if (scene.planar) {
      auto space = std::make_shared<ob::SE2StateSpace>();
      space->setBounds(bounds);
      return space;
    }
    auto space = std::make_shared<ob::SE3StateSpace>();
    space->setBounds(bounds);
    return space;
  }

  const test::AppScene& scene_;
  ob::StateSpacePtr space_;
  double turn_;
  StateColumns columns_;
  std::shared_ptr<const Walls> walls_;
  std::shared_ptr<const SegmentCost> length_;
#ifdef LEASTCOST_HAS_FCL
  FclJudge judge_;
#endif
};

/// Against one of OMPL's ways to simplify.
struct Against {
  int cheaper = 0, dearer = 0, dearer_than_clear = 0, not_clear = 0, meets = 0, shorter_in_theirs = 0;
  std::vector<double> seconds;
  double ratio = 0, worst = 0;

  void add(const Bench& bench, const og::PathGeometric& ours, double cost, const og::PathGeometric& theirs,
           double took) {
    const double other = bench.cost(theirs);
    const bool clear = bench.clear(theirs), beaten = cost > (1 + kSame) * other;
    cheaper += cost < (1 - kSame) * other ? 1 : 0;
    dearer += beaten ? 1 : 0;
    dearer_than_clear += beaten && clear ? 1 : 0;
    not_clear += clear ? 0 : 1;
    meets += bench.meetings(theirs) > 0 ? 1 : 0;
    shorter_in_theirs += ours.length() < (1 - kSame) * theirs.length() ? 1 : 0;
    seconds.push_back(took);
    ratio += cost / other;
    worst = std::max(worst, cost / other);
  }
  void print(const char* name, int plans) const {
    std::printf(
        "    %-24s ours costs less %3d, more %3d (than a clear path %d), shorter by OMPL's length %d; cost / its %.4f, "
        "at most %.4f; it took %s; not clear %d, meets by FCL %d\n",
        name, cheaper, dearer, dearer_than_clear, shorter_in_theirs, ratio / plans, worst,
        milliseconds(seconds).c_str(), not_clear, meets);
  }
};

struct Row {
  int plans = 0, unsolved = 0, plan_not_clear = 0, dearer_than_given = 0, not_clear = 0, meets = 0, refused = 0;
  int certified = 0, polished = 0, tightened = 0;
  std::vector<double> seconds;
  double ratio = 0, deepest = 0;
  Against once, again, most;
};

void plan(const Bench& bench, unsigned seed, bool search, bool verbose, Row& row) {
  ompl::RNG::setSeed(seed);  // so that a plan does not depend on the time that was taken by those before
  og::SimpleSetup setup(bench.space());
  bench.set_up(setup);
  if (setup.solve(kPlanSeconds) != ob::PlannerStatus::EXACT_SOLUTION) {
    ++row.unsolved;
    return;
  }
  const og::PathGeometric given = setup.getSolutionPath();
  row.plan_not_clear += bench.clear(given) ? 0 : 1;

  PolishOptions options;
  options.walls = bench.walls();
  options.turn = bench.turn();
  options.search = search;
  double begin = now();
  const Polished ours = polish(given, options);
  const double seconds = now() - begin;

  const double cost = bench.cost(*ours.path);
  og::PathSimplifier simplifier(setup.getSpaceInformation());
  og::PathGeometric once = given, again = given, most = given;
  begin = now();
  simplifier.simplify(once, seconds);
  row.once.add(bench, *ours.path, cost, once, now() - begin);
  begin = now();
  while (now() - begin < seconds) simplifier.simplify(again, seconds - (now() - begin));
  row.again.add(bench, *ours.path, cost, again, now() - begin);
  begin = now();
  simplifier.simplifyMax(most);
  row.most.add(bench, *ours.path, cost, most, now() - begin);

  const double clearance = bench.clearance(*ours.path);
  ++row.plans;
  row.seconds.push_back(seconds);
  row.ratio += cost / bench.cost(given);
  row.dearer_than_given += cost > (1 + kSame) * bench.cost(given) ? 1 : 0;
  row.not_clear += bench.clear(*ours.path) ? 0 : 1;
  row.deepest = std::min(row.deepest, clearance);
  row.refused += ours.path->check() ? 0 : 1;
  row.meets += bench.meetings(*ours.path) > 0 ? 1 : 0;
  row.certified += ours.certified() ? 1 : 0;
  row.polished += ours.outcome == PolishOutcome::polished ? 1 : 0;
  row.tightened += ours.outcome == PolishOutcome::tightened ? 1 : 0;
  if (!verbose) return;
  std::printf(
      "  plan %d: given %.4f (clear by %.2g), simplified %.4f, %.4f, %.4f, ours %.4f (%s, %s) clear by %.1e in "
      "%.0f ms %s\n",
      row.plans, bench.cost(given), bench.clearance(given), bench.cost(once), bench.cost(again), bench.cost(most), cost,
      word_of(ours.outcome).data(), word_of(ours.result.status).data(), clearance, 1e3 * seconds, ours.why.c_str());
  for (const CertificateFailure& failure : ours.result.certificate.failures)
    std::printf("    %s: %s\n", failure.name().c_str(), failure.message.c_str());
  std::fflush(stdout);
}

void table(const test::AppScene& scene, unsigned seed, int plans, bool search, bool verbose) {
  const Bench bench(scene);
  for (const auto& [end, name] : {std::pair{&scene.start, "start"}, std::pair{&scene.goal, "goal"}}) {
    Points pose = *end;
    std::printf("%s, %s: clear by %.3g", scene.name.c_str(), name, test::walls_of(scene)->clearance(pose, pose).lower);
#ifdef LEASTCOST_HAS_FCL
    std::printf(", by FCL %s", bench.fcl_meets(pose) ? "in collision" : "free");
#endif
    std::printf("\n");
  }
  Row row;
  for (int i = 0; i < plans; ++i) plan(bench, seed + static_cast<unsigned>(i), search, verbose, row);
  std::printf(
      "%s, %s: %d plans (none found %d, not clear between states %d); polished %d, tightened %d, certified %d; dearer "
      "than given %d, not clear %d (deepest %.1e), refused by the planner %d, meets by FCL %d; cost / given %.4f; %s\n",
      scene.name.c_str(), search ? "with a search" : "without a search", row.plans, row.unsolved, row.plan_not_clear,
      row.polished, row.tightened, row.certified, row.dearer_than_given, row.not_clear, row.deepest, row.refused,
      row.meets, row.ratio / row.plans, milliseconds(row.seconds).c_str());
  row.once.print("simplify, as long", row.plans);
  row.again.print("simplify until time is up", row.plans);
  row.most.print("simplifyMax", row.plans);
  std::fflush(stdout);
}

}  // namespace

/// Arguments: the seed of OMPL for the first plan (default 2; the next plan has the next one), how many plans (default
/// 50), maze, cubicles or both, "search" or anything else, any fifth: each plan.
int main(int count, char** arguments) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);  // it would complain of every seed but the first
  const unsigned seed = count > 1 ? static_cast<unsigned>(std::atoi(arguments[1])) : 2;
  const int plans = count > 2 ? std::atoi(arguments[2]) : 50;
  const std::string which = count > 3 ? arguments[3] : "both";
  const bool search = count > 4 && std::string(arguments[4]) == "search";
  const char* data = std::getenv("LEASTCOST_DATA");
  const std::filesystem::path folder = std::filesystem::path(data != nullptr ? data : "../shared/data") / "planning";
  if (which != "cubicles") table(test::read_maze(folder), seed, plans, search, count > 5);
  if (which != "maze") table(test::read_cubicles(folder), seed, plans, search, count > 5);
}
