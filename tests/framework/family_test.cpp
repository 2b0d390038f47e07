// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/family/find_family.hpp>
#include <leastcost/framework/family/same_path.hpp>

#include <numbers>
#include <stdexcept>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/hill.hpp"
#include "tests/support/pi.hpp"

namespace leastcost::test {
namespace {

class NoPath final : public Initializer {
 public:
  std::string_view name() const override { return "no_path"; }
  FirstPath first_path(const Problem&, const Monitor&) const override { throw InitializationError("blocked"); }
};

FamilyStart bow(const Problem& problem, double angle, double height) {
  return {"bow", problem, std::make_shared<const BowInitializer>(BowOptions{height, angle})};
}

FindOptions with_certificate() {
  FindOptions options;
  options.points = 31;
  return options;
}

}  // namespace

TEST_CASE("family: distinct paths by cost, the same path once", "[framework]") {
  const Problem problem =
      between(space(2), make_segment_cost(Hill{}), Eigen::Vector2d(-2, 0.05), Eigen::Vector2d(2, 0.05));
  const Newton newton;
  const Family family = find_family({bow(problem, 180, 0.4),
                                     bow(problem, 0, 0.4),
                                     bow(problem, 0, 0.5),
                                     {"blocked", problem, std::make_shared<const NoPath>()}},
                                    newton, with_certificate());
  REQUIRE(family.members.size() == 2);
  const FamilyMember &first = family.members[0], &second = family.members[1];
  CHECK(first.result.status == Status::certified);
  CHECK(second.result.status == Status::certified);
  CHECK(first.origins.size() == 2);  // both bows to the near side
  CHECK(first.result.certificate.estimate.value < second.result.certificate.estimate.value);
  CHECK_FALSE(same_path(problem, first.result.path, second.result.path));
  REQUIRE(family.notes.size() == 1);
  CHECK_THAT(family.notes[0], Catch::Contains("blocked"));
}

TEST_CASE("family: a shorter path that few points cannot certify comes before a longer one that they can",
          "[framework]") {
  // Across the flat face of an oblate ellipsoid or around its sharp rim.
  const auto [from, to] = GENERATE(std::pair(Eigen::Vector2d(0, -0.046293), Eigen::Vector2d(-2.801967, -0.646658)),
                                   std::pair(Eigen::Vector2d(0, 0.459907), Eigen::Vector2d(-2.343115, 0.094936)));
  const int points = GENERATE(12, 24, 50);
  const Problem problem =
      between(make_parametric_manifold({.surface = parametric::Ellipsoid{Eigen::Vector3d(1, 1, 0.2)}}),
              make_euclidean_cost(3), from, to);
  std::vector<FamilyStart> starts = {{"straight", problem, std::make_shared<const StraightInitializer>()}};
  for (const double angle : {0.0, 90.0, 180.0, 270.0}) starts.push_back(bow(problem, angle, 0.5));
  FindOptions options;
  options.points = points;
  const Family family = find_family(starts, Newton(), options);
  const FamilyMember& first = family.members.front();
  CAPTURE(points, failures(first.result.certificate), family.members.size());
  CHECK(first.result.status == Status::certified);
  CHECK(first.result.path.free_count() == points);
  CHECK(first.result.costs.size() == points + 1);
  CHECK(first.result.curve_costs.size() == points + 1);
  CHECK(first.result.curve_costs.sum() == Approx(first.result.curve.cost));
  const double longest = first.result.curve_costs.maxCoeff(), shortest = first.result.curve_costs.minCoeff();
  CHECK(longest / shortest < 1.05);
  for (const FamilyMember& m : family.members) {
    CHECK(first.result.certificate.estimate.value <= m.rank_cost + first.result.certificate.estimate.error);
    CHECK(std::isfinite(m.rank_cost));
  }
}

TEST_CASE("family: a saddle that is the cheapest path found is left downwards", "[framework]") {
  // From the straight start alone: over the hill. The other start is sent far around.
  const Problem problem = between(space(2), make_segment_cost(Hill{}), Eigen::Vector2d(-2, 0), Eigen::Vector2d(2, 0));
  const Family family =
      find_family({{"straight", problem, std::make_shared<const StraightInitializer>()}}, Newton(), with_certificate());
  REQUIRE(family.members.size() == 2);
  CHECK(family.members[0].result.status == Status::certified);
  CHECK_THAT(family.members[0].origins.front(), Catch::Contains("saddle"));
  CHECK(family.members[1].left);
  CHECK(family.members[0].rank_cost < family.members[1].rank_cost);
}

TEST_CASE("family: paths whose bars overlap are tied", "[framework]") {
  const auto ways_around = [](double aside) {
    const Problem problem =
        between(space(2), make_segment_cost(Hill{}), Eigen::Vector2d(-2, aside), Eigen::Vector2d(2, aside));
    return find_family({bow(problem, 180, 0.4), bow(problem, 0, 0.4)}, Newton(), with_certificate());
  };
  const Family even = ways_around(0), odd = ways_around(0.05);
  REQUIRE(even.members.size() == 2);
  CHECK((even.members[0].tied && even.members[1].tied));
  REQUIRE(odd.members.size() == 2);
  CHECK_FALSE((odd.members[0].tied || odd.members[1].tied));
}

TEST_CASE("family: a cheaper path that stays undecided comes first, and is not certified", "[framework]") {
  const Problem problem =
      between(space(2), make_segment_cost(Hill{}), Eigen::Vector2d(-2, 0.05), Eigen::Vector2d(2, 0.05));
  // On the cheaper side of the hill the solver stops short of convergence, and does nothing for finer chains.
  class GivesUp final : public Solver {
   public:
    std::string_view name() const override { return "gives_up"; }

   private:
    SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override {
      if (path.u.row(1).mean() < 0) return Newton().solve(energy, path, monitor);
      if (path.segment_count() <= 32) return Newton({.max_iterations = 2}).solve(energy, path, monitor);
      SolveReport report;
      report.termination = Termination::iteration_limit;
      return report;
    }
  };
  const Family family = find_family({bow(problem, 180, 0.4), bow(problem, 0, 0.4)}, GivesUp(), with_certificate());
  REQUIRE(family.members.size() == 2);
  const FamilyMember& first = family.members.front();
  CAPTURE(first.rank_cost, family.members[1].rank_cost, failures(first.result.certificate));
  CHECK(family.members[1].result.status == Status::certified);
  CHECK(first.result.status == Status::uncertified);
  CHECK(first.result.path.free_count() == 31);
  REQUIRE(family.notes.size() == 1);
  CHECK_THAT(family.notes[0], Catch::Contains("neither certified nor ruled out"));
  REQUIRE(!first.result.notes.empty());
  CHECK_THAT(first.result.notes.back(), Catch::Contains("points the path is not certified either: "));
}

TEST_CASE("family: the least path is proved, the others are not asked", "[framework][slow_sanitized]") {
  const auto around_hill = [](const std::string& more) {
    const std::string index2 = "(1 + 2*exp(-2*(x^2 + y^2))" + more + ")^2";
    MetricFieldOptions cost;
    cost.field = metric::Formula{{index2, "0", index2}, {}};
    const Problem problem =
        between(space(2), make_metric_field_cost(cost, 2), Eigen::Vector2d(-2, 0.05), Eigen::Vector2d(2, 0.05));
    return find_family({bow(problem, 180, 0.4), bow(problem, 0, 0.4)}, Newton(), with_certificate());
  };
  const auto minimum_proved = [](const FamilyMember& m) { return m.result.certificate.resolution->minimum_proved; };
  const Family smooth = around_hill("");
  REQUIRE(smooth.members.size() == 2);
  for (const FamilyMember& m : smooth.members) CHECK(m.result.status == Status::certified);
  CHECK(minimum_proved(smooth.members[0]));
  CHECK_FALSE(minimum_proved(smooth.members[1]));

  // A detail beside the least path that no point sees: the proof refutes it, whatever the other one looks like.
  const Points& u = smooth.members[0].result.path.u;
  const Eigen::Vector2d place = u.col(10) + 0.37 * (u.col(11) - u.col(10));
  const Family rough = around_hill(" + 1e-3*exp(-((x - (" + std::to_string(place.x()) + "))^2 + (y - (" +
                                   std::to_string(place.y()) + "))^2)/2e-4^2)");
  const FamilyMember& first = rough.members.front();
  CHECK(first.rank_cost == Approx(smooth.members[0].rank_cost));
  CHECK(first.result.status == Status::uncertified);
  CHECK_THAT(failures(first.result.certificate), Catch::Contains("unresolved"));
  CHECK_FALSE(rough.notes.empty());
}

TEST_CASE("family: twice around a circle is not once around", "[framework]") {
  const Problem problem = closed(space(2), make_euclidean_cost(2));
  const auto circle = [](int turns) {
    CoordinatePath path{Points(2, 40), {}, true};
    for (Index i = 0; i < 40; ++i) {
      const double t = 2 * std::numbers::pi * turns * static_cast<double>(i) / 40;
      path.u.col(i) = Eigen::Vector2d(std::cos(t), std::sin(t));
    }
    return path;
  };
  CHECK(same_path(problem, circle(1), circle(1)));
  CHECK_FALSE(same_path(problem, circle(1), circle(2)));
}

TEST_CASE("family: a start that throws loses none of the others", "[framework]") {
  class Throws final : public Initializer {
   public:
    std::string_view name() const override { return "throws"; }
    FirstPath first_path(const Problem&, const Monitor&) const override { throw std::runtime_error("of the user"); }
  };
  const Problem problem = between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0));
  Problem misfit = problem;
  misfit.cost = make_euclidean_cost(3);
  const FamilyStart good = {"straight", problem, std::make_shared<const StraightInitializer>()},
                    wrong = {"wrong", misfit, std::make_shared<const StraightInitializer>()},
                    throwing = {"throwing", problem, std::make_shared<const Throws>()};
  const Family family = find_family({throwing, good, wrong}, Newton(), with_certificate());
  REQUIRE(family.members.size() == 1);
  CHECK(family.members[0].result.status == Status::certified);
  REQUIRE(family.notes.size() == 2);
  CHECK_THAT(family.notes[0], Catch::Contains("throwing: of the user"));
  CHECK_THAT(family.notes[1], Catch::Contains("wrong"));
  CHECK_THROWS_AS(find_family({wrong, throwing}, Newton(), with_certificate()), InputError);
  CHECK_THROWS_AS(find_family({good, {"null", problem, nullptr}}, Newton(), with_certificate()), InputError);
}

TEST_CASE("family: without any first path the first reason is the error", "[framework]") {
  const Problem problem = between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0));
  const Newton newton;
  CHECK_THROWS_WITH(find_family({{"blocked", problem, std::make_shared<const NoPath>()}}, newton, with_certificate()),
                    Catch::Contains("blocked"));
}

}  // namespace leastcost::test
