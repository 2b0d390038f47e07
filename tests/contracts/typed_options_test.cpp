// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A misspelt choice does not compile. Those of the back ends are in nlopt_test.cpp and ceres_test.cpp; that the list is
// complete is checked by tests/app/registry_test.cpp.
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/end_effector_length.hpp>
#include <leastcost/problems/costs/kinetic_energy.hpp>
#include <leastcost/problems/problems.hpp>
#include <leastcost/solvers/rounds.hpp>
#include <leastcost/solvers/solvers.hpp>
#include "tests/support/choices.hpp"

namespace leastcost::test {
namespace {

// The only way to a choice in a field list is an enum with words.
template <class T>
concept CanBeChosen = requires(FieldVisitor& visit, T& value) {
  visit.choice("key", value, FieldDoc{});
};
static_assert(CanBeChosen<TravelTimeRule>);
static_assert(!CanBeChosen<std::string>);
static_assert(!CanBeChosen<int>);

template <class Options>
concept TakesMisspeltRule = requires {
  Options{.rule = "averge"};
};
static_assert(!TakesMisspeltRule<TravelTimeOptions>);
static_assert(!TakesMisspeltRule<MetricFieldOptions>);
template <class Options>
concept TakesMisspeltPreconditioner = requires {
  Options{.precondition = "chian"};
};
static_assert(!TakesMisspeltPreconditioner<LbfgsOptions>);
static_assert(!TakesMisspeltPreconditioner<RoundOptions>);
template <class Options>
concept TakesMisspeltSurface = requires {
  Options{.surface = "toros"};
};
static_assert(!TakesMisspeltSurface<ParametricOptions>);
static_assert(!TakesMisspeltSurface<ImplicitManifoldOptions>);

// Choices.
static_assert(!kTakesWords<decltype(TravelTimeOptions::rule)>);
static_assert(!kTakesWords<decltype(MetricFieldOptions::rule)>);
static_assert(!kTakesWords<decltype(MetricFieldOptions::reading)>);
static_assert(!kTakesWords<decltype(TensorFileOptions::on)>);
static_assert(!kTakesWords<decltype(OccupancyOptions::unknown)>);
static_assert(!kTakesWords<decltype(MeshObstacleOptions::inside)>);
static_assert(!kTakesWords<decltype(arm_model::Table::convention)>);
static_assert(!kTakesWords<decltype(PointCloudSettings::normals)>);
static_assert(!kTakesWords<decltype(distance_source::Sides::sign)>);
static_assert(!kTakesWords<decltype(refraction::SmoothLayers::values_are)>);
static_assert(!kTakesWords<decltype(walking::Tobler::unit)>);
static_assert(!kTakesWords<decltype(WalkingOptions::length)>);
static_assert(!kTakesWords<decltype(CostMapOptions::interpolation)>);
static_assert(!kTakesWords<decltype(LbfgsOptions::precondition)>);
static_assert(!kTakesWords<decltype(RoundOptions::precondition)>);

// Forms of a block.
static_assert(!kTakesWords<decltype(ParametricOptions::surface)>);
static_assert(!kTakesWords<decltype(ImplicitManifoldOptions::surface)>);
static_assert(!kTakesWords<decltype(ConstraintManifoldOptions::set)>);
static_assert(!kTakesWords<decltype(MetricFieldOptions::field)>);
static_assert(!kTakesWords<decltype(SignedDistanceOptions::source)>);
static_assert(!kTakesWords<decltype(DhArmOptions::model)>);
static_assert(!kTakesWords<decltype(RefractiveIndexOptions::index)>);
static_assert(!kTakesWords<decltype(WalkingOptions::law)>);
static_assert(!kTakesWords<decltype(ZermeloOptions::flow)>);

}  // namespace

TEST_CASE("typed options: every value of a choice has one word") {
  check_words(TravelTimeRule::midpoint);
  check_words(TensorRule::average);
  check_words(TensorReading::root);
  check_words(TensorPlace::points);
  check_words(UnknownCells::free);
  check_words(MeshInside::surface);
  check_words(DhConvention::modified);
  check_words(NormalSource::estimate);
  check_words(DistanceSign::without_sides);
  check_words(Preconditioner::none);
  check_words(refraction::LayerValues::speed);
  check_words(WalkingTime::seconds);
  check_words(MapLength::kilometres);
  check_words(CostMapInterpolation::cells);
}

TEST_CASE("typed options: a number that is no value of a choice is refused where it matters") {
  CHECK(word_of(static_cast<TravelTimeRule>(7)) == "");
  CHECK_THROWS_AS(make_travel_time_cost({.rule = static_cast<TravelTimeRule>(7), .level = 0}, 2, {}), OptionError);
}

}  // namespace leastcost::test
