// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/certificate/certificate_failure.hpp>

#include <array>
#include <cstddef>

namespace leastcost {
namespace {

constexpr std::array<Consequences, 30> kTable = {{
    {Failure::stationarity, "stationarity", true, PointsHelp::beside_others},
    {Failure::exception, "exception", false, PointsHelp::never},
    {Failure::inconsistent, "inconsistent", false, PointsHelp::never},
    {Failure::interrupted, "interrupted", true, PointsHelp::never},
    {Failure::post_process, "post_process", false, PointsHelp::no},
    {Failure::saddle, "saddle", false, PointsHelp::beside_others},
    {Failure::degenerate, "degenerate", false, PointsHelp::never},
    {Failure::undecidable, "undecidable", false, PointsHelp::no},
    {Failure::index_not_applicable, "index_not_applicable", false, PointsHelp::never},
    {Failure::residual, "residual", true, PointsHelp::no},
    {Failure::touches, "touches", true, PointsHelp::no},
    {Failure::class_lost, "class_lost", false, PointsHelp::no},
    {Failure::active_set_cycling, "active_set_cycling", false, PointsHelp::no},
    {Failure::dearer_than_first, "dearer_than_first", false, PointsHelp::maybe},
    {Failure::straightness, "straightness", false, PointsHelp::no},
    {Failure::infinite_cost, "infinite_cost", true, PointsHelp::no},
    {Failure::costs_nothing, "costs_nothing", false, PointsHelp::never},
    {Failure::collapsed, "collapsed", true, PointsHelp::no},
    {Failure::interfaces, "interfaces", false, PointsHelp::no},
    {Failure::spacing, "spacing", false, PointsHelp::maybe},
    {Failure::longest_segment, "longest_segment", true, PointsHelp::maybe},
    {Failure::doubling, "doubling", false, PointsHelp::maybe},
    {Failure::refinement, "refinement", true, PointsHelp::maybe},
    {Failure::not_asymptotic, "not_asymptotic", false, PointsHelp::maybe},
    {Failure::bracket, "bracket", false, PointsHelp::maybe},
    {Failure::error_bar, "error_bar", false, PointsHelp::maybe},
    {Failure::unresolved, "unresolved", true, PointsHelp::maybe},
    {Failure::geometry_error, "geometry_error", false, PointsHelp::no},
    {Failure::not_global, "global", false, PointsHelp::no},
    {Failure::below_bound, "below_bound", false, PointsHelp::no},
}};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < kTable.size(); ++i)
    if (kTable[i].failure != static_cast<Failure>(i)) return false;
  return true;
}
static_assert(is_in_order() && kTable.back().failure == Failure::below_bound, "one row for each failure, in order");

}  // namespace

const Consequences& consequences(Failure failure) { return kTable[static_cast<std::size_t>(failure)]; }

}  // namespace leastcost
