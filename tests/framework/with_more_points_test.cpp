// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// A path that is refused for want of points is solved with more of them, and those that were asked for are delivered.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <leastcost/problems/costs/metric_field.hpp>
#include "framework/search/more_points_may_help.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/hill.hpp"

namespace leastcost::test {
namespace {

constexpr double kHeight = 2, kCenter = 0.123, kWidth = 0.012;

/// Across a wall that is a fourth as wide as a segment, straight ahead: n(x) = 1 + A exp(-((x - c) / w)^2).
Problem across_a_wall() {
  const std::string n = "(1+2*exp(-((x-0.123)/0.012)^2))^2";
  MetricFieldOptions options;
  options.field = metric::Formula{{n, "0", n}};
  return between(space(2), make_metric_field_cost(options, 2), Eigen::Vector2d(-1, 0), Eigen::Vector2d(1, 0));
}
double true_cost() {
  return 2 + kHeight * kWidth * std::sqrt(std::acos(-1.0)) / 2 *
                 (std::erf((1 - kCenter) / kWidth) + std::erf((1 + kCenter) / kWidth));
}

bool has_note(const Result& result, const std::string& part) {
  return std::any_of(result.notes.begin(), result.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

Result find_refined(const Problem& problem, int points, int refine, const Monitor& monitor = {}) {
  FindOptions options{.points = points};
  options.certificate.refine = refine;
  return find_path(problem, StraightInitializer(), Newton(), options, monitor);
}

}  // namespace

TEST_CASE("refine: what few points cannot certify, more do, and the points asked for are delivered", "[framework]") {
  const int points = GENERATE(25, 30);
  const Problem problem = across_a_wall();
  const Result coarse = find_refined(problem, points, 0), fine = find_refined(problem, points, 6);
  CAPTURE(points, failures(coarse.certificate), failures(fine.certificate), fine.certificate.estimate.value);
  REQUIRE(coarse.status == Status::uncertified);
  CHECK(more_points_may_help(problem, coarse));
  REQUIRE(fine.status == Status::certified);
  CHECK(std::abs(fine.certificate.estimate.value - true_cost()) <= fine.certificate.estimate.error);
  CHECK(fine.certificate.estimate.error <= 1e-3 * true_cost());
  CHECK(fine.path.free_count() == points);
  CHECK(fine.path.u.col(0) == coarse.path.u.col(0));
  CHECK(fine.path.u.rightCols(1) == coarse.path.u.rightCols(1));
  CHECK(fine.costs.size() == points + 1);
  CHECK(fine.curve_costs.size() == points + 1);
  CHECK(fine.curve_costs.sum() == Approx(fine.curve.cost));
  CHECK(fine.curve_costs.maxCoeff() / fine.curve_costs.minCoeff() < 1.05);
  CHECK(fine.initial.u == coarse.initial.u);
  CHECK(fine.reference_cost == coarse.reference_cost);
  REQUIRE(fine.certificate.levels.size() == 3);  // they say with how many points it was certified
  CHECK(fine.certificate.levels[1].segments % (points + 1) == 0);
  CHECK(has_note(fine,
                 "found and certified with " + std::to_string(fine.certificate.levels[1].segments - 1) + " points"));
  CHECK(fine.curve.x.cols() == fine.certificate.levels[1].segments + 1);
}

TEST_CASE("refine: where the doublings do not suffice the path stays as it came, and a note says so", "[framework]") {
  const Problem problem = across_a_wall();
  const Result coarse = find_refined(problem, 25, 0), once = find_refined(problem, 25, 1);
  CHECK(once.status == Status::uncertified);
  CHECK(once.path.u == coarse.path.u);
  CHECK(failures(once.certificate) == failures(coarse.certificate));
  CHECK(has_note(once, "with 51 points the path is not certified either"));
  CHECK_FALSE(has_note(coarse, "not certified either"));
}

TEST_CASE("refine: a saddle, or a path that is certified, is not refined", "[framework]") {
  const Problem hill = between(space(2), make_segment_cost(Hill{}), Eigen::Vector2d(-2, 0), Eigen::Vector2d(2, 0));
  const Result saddle = find_refined(hill, 31, 6);
  CHECK(failed(saddle.certificate, "saddle"));
  CHECK_FALSE(more_points_may_help(hill, saddle));
  CHECK_FALSE(has_note(saddle, "points"));
  const Problem line = between(space(2), make_euclidean_cost(2), Eigen::Vector2d(-2, 0), Eigen::Vector2d(2, 0));
  const Result straight = find_refined(line, 8, 6);
  CHECK(straight.status == Status::certified);
  CHECK_FALSE(has_note(straight, "points"));
}

TEST_CASE("refine: stopped on the way it keeps the path that it has, with its certificate", "[framework]") {
  const Problem problem = across_a_wall();
  const Result coarse = find_refined(problem, 25, 0);
  int searches = 0;
  Monitor monitor;
  monitor.observe = [&](const Progress& progress) {
    searches += progress.stage == Stage::initialize && progress.iteration == nullptr;
  };
  monitor.stop_requested = [&] { return searches > 1; };
  const Result stopped = find_refined(problem, 25, 6, monitor);
  CHECK(searches == 2);
  CHECK(stopped.status == Status::uncertified);
  CHECK(stopped.path.u == coarse.path.u);
  CHECK(failures(stopped.certificate) == failures(coarse.certificate));
  CHECK(has_note(stopped, "no time"));
}

/// A field that varies `frequency` times as fast as the ends are apart, by `weight` of itself.
Problem over_ripples(int frequency, const std::string& weight = "0.5") {
  const std::string f = std::to_string(frequency),
                    n = "(1+" + weight + "*sin(" + f + "*(1.7*x+0.3*y))*sin(" + f + "*1.1*y))^2";
  MetricFieldOptions options;
  options.field = metric::Formula{{n, "0", n}};
  return between(space(2), make_metric_field_cost(options, 2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0.31));
}

TEST_CASE("refine: where more points bring the value no closer it ends, and says what helps", "[framework]") {
  int doublings = 0;
  Monitor monitor;
  monitor.observe = [&](const Progress& p) { doublings = p.more_points != nullptr ? p.more_points->doubling : 0; };
  const Result result = find_refined(over_ripples(280), 5, 6, monitor);  // far narrower than any of the segments
  CAPTURE(doublings, failures(result.certificate), result.notes);
  CHECK(result.status == Status::uncertified);
  CHECK(doublings > 1);
  CHECK(doublings < 6);
  CHECK(has_note(result, "more points do not help: the cost is uncertain by "));
  CHECK(has_note(result, "smooth the data or the field, or give the field a smaller weight"));
  CHECK(find_refined(over_ripples(300, "0.001"), 5, 6).status == Status::certified);
  CHECK(find_refined(over_ripples(1), 5, 6).status == Status::certified);
}

TEST_CASE("refine: the doublings take a part of the first search's work, which an option states", "[framework]") {
  const Problem problem = across_a_wall();
  FindOptions options{.points = 25};
  options.certificate.refine_work = 0.2;
  const Result stopped = find_path(problem, StraightInitializer(), Newton(), options);
  CAPTURE(failures(stopped.certificate), stopped.notes);
  CHECK(stopped.status == Status::uncertified);
  CHECK(has_note(stopped, "to continue, increase certificate.refine_work"));
  options.certificate.refine_work = 30;
  CHECK(find_path(problem, StraightInitializer(), Newton(), options).status == Status::certified);
}

TEST_CASE("refine: who watches hears with how many points it is tried", "[framework]") {
  std::vector<std::vector<long>> told;
  bool before = false;
  Monitor monitor;
  monitor.observe = [&](const Progress& progress) {
    if (const MorePoints* more = progress.more_points; more == nullptr)
      before = told.empty();
    else if (told.empty() || told.back()[0] != more->points)
      told.push_back({more->points, more->doubling, more->of});
  };
  find_refined(across_a_wall(), 25, 2, monitor);
  CHECK(before);
  CHECK(told == std::vector<std::vector<long>>{{51, 1, 2}, {103, 2, 2}});
}

}  // namespace leastcost::test
