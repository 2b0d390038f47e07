// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/family.hpp>

#include <numbers>

#include <leastcost/framework/errors.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/hill.hpp"

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

TEST_CASE("family: without any first path the first reason is the error", "[framework]") {
  const Problem problem = between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0));
  const Newton newton;
  CHECK_THROWS_WITH(find_family({{"blocked", problem, std::make_shared<const NoPath>()}}, newton, with_certificate()),
                    Catch::Contains("blocked"));
}

}  // namespace leastcost::test
