// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/field/field_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "catalogue/output/json_numbers.hpp"
#include "catalogue/output/unit_of_cost.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::ordered_json;

struct Extent {
  std::size_t reached = 0;
  double largest = 0;
};

Extent extent_of(const std::vector<double>& values) {
  Extent extent;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    ++extent.reached;
    extent.largest = std::max(extent.largest, value);
  }
  return extent;
}

double largest_error(const MeshField& field) {
  return field.errors.empty() ? 0 : *std::max_element(field.errors.begin(), field.errors.end());
}

Json places_json(const std::vector<PathEnd>& places) {
  Json all = Json::array();
  for (const PathEnd& place : places) all.push_back(numbers(place.u));
  return all;
}

void say_nodes(const RunField& field, Json& out) {
  const Extent extent = extent_of(field.values());
  if (field.on_mesh()) {
    out["vertices"] = field.values().size();
  } else if (field.in_space()) {
    out["nodes"] = field.space().count;
    out["lower"] = numbers(field.space().lower);
    out["step"] = numbers(field.space().step);
  } else {
    out["columns"] = field.lattice().count[0];
    out["rows"] = field.lattice().count[1];
    out["lower"] = numbers(field.lattice().lower);
    out["step"] = numbers(field.lattice().step);
  }
  out["reached"] = extent.reached;
  out["largest"] = number(extent.largest);
}

Json error_json(const RunField& field) {
  if (field.on_mesh())
    return {{"largest", number(largest_error(field.on_vertices()))}, {"kind", "bound"}, {"by", "windows on the mesh"}};
  const bool space = field.in_space();
  return {{"largest", number(space ? field.space().error : field.lattice().error)},
          {"mean", number(space ? field.space().mean_error : field.lattice().mean_error)},
          {"unresolved", space ? field.space().unresolved : field.lattice().unresolved},
          {"kind", "estimate"},
          {"by", "difference from the field on half as many cells"}};
}

std::string point_text(const Eigen::VectorXd& x) {
  std::string out = "(";
  for (Eigen::Index i = 0; i < x.size(); ++i) out += fmt::format("{}{:.10g}", i > 0 ? ", " : "", x[i]);
  return out + ")";
}

/// Why no value of a field over a lattice, in two coordinates or in space, can be relied on.
template <class Field>
std::vector<std::string> warnings_on(const Field& field, double largest) {
  std::vector<std::string> all;
  if (field.error > largest)
    all.emplace_back("at some nodes the error may be larger than every value: use a smaller --resolution");
  if (field.enclosed)
    all.push_back(fmt::format(
        "no path leads farther than 5 steps from the {}: obstacles or places without a cost enclose {}, or gaps are "
        "narrower than a step (then use a smaller --resolution)",
        field.places.size() > 1 ? "places" : "place", field.places.size() > 1 ? "them" : "it"));
  return all;
}

std::vector<std::string> warnings_on_mesh(const RunField& of) {
  const MeshField& field = of.on_vertices();
  const Extent extent = extent_of(field.values);
  std::vector<std::string> all;
  if (field.cut)
    all.emplace_back(
        "memory ran out, or paths run over faces without height: some values are lengths of paths that may not be the "
        "shortest (leastcost doctor lists such faces)");
  if (largest_error(field) > extent.largest && extent.largest > 0)
    all.emplace_back("at some vertices the error may be larger than every value");
  if (!of.is_corridor() && extent.reached <= field.places.size() && extent.reached < field.values.size())
    all.emplace_back("no path leads farther than the place itself: its part of the mesh has no other vertex");
  return all;
}

/// What a user should know about the nodes of a lattice, in two coordinates or in space.
template <class Field>
std::vector<std::string> remarks_on(const Field& field) {
  std::vector<std::string> all;
  if (!field.without_cost.empty())
    all.push_back(fmt::format("nodes without a cost are left out: {}", field.without_cost));
  if (field.unresolved > 0)
    all.push_back(fmt::format("{} nodes are reached only by passages of one or two cells; use a smaller --resolution",
                              field.unresolved));
  if (field.free_nodes > 0)
    all.push_back(
        fmt::format("a unit of length costs 0 at {} of {} nodes, the first is {}: moves between them are free",
                    field.free_nodes, field.values.size(), point_text(field.free_at)));
  return all;
}

std::vector<std::string> remarks_of(const RunField& of) {
  if (of.on_mesh()) return {};
  std::vector<std::string> all = of.in_space() ? remarks_on(of.space()) : remarks_on(of.lattice());
  if (is_directed(of) && !of.is_corridor())
    all.push_back(fmt::format("the two directions of a way differ in cost; these are costs of {} the {}",
                              of.to_places() ? "reaching" : "leaving", of.places().size() > 1 ? "places" : "place"));
  if (of.in_space()) return all;
  const CostField& lattice = of.lattice();
  if (lattice.asymmetry > CostField::kFaithfulAsymmetry)
    all.push_back(fmt::format(
        "{}; under such a cost values can be wrong by more than the estimate (leastcost run gives certified costs "
        "between two places)",
        std::isfinite(lattice.asymmetry)
            ? fmt::format("a move costs up to {:.3g} times the same move back", lattice.asymmetry)
            : "some moves have no move back"));
  constexpr double kRounding = 1e-6;  // of a step
  if ((lattice.uncovered.array() > kRounding * lattice.step.array()).any())
    all.push_back(fmt::format(
        "equal steps do not divide the sides of the box: a strip at its upper edges has no nodes, {:.3g} wide along {} "
        "and {:.3g} along {}",
        lattice.uncovered[0], of.names()[0], lattice.uncovered[1], of.names()[1]));
  return all;
}

/// By how much the value of a field at a place may exceed what it has there because it is linear between nodes: the
/// range of the values around. Infinite near a place of the field, around which it is a cone.
double linear_allowance(const CostField& field, const Eigen::VectorXd& place) {
  constexpr double kNear = 3, kNone = std::numeric_limits<double>::infinity();  // steps
  for (const Eigen::VectorXd& source : field.places)
    if (((place - source).array().abs() <= kNear * field.step.array()).all()) return kNone;
  const Eigen::Vector2d at = (place - field.lower).cwiseQuotient(field.step);
  double least = kNone, most = -kNone;
  for (const double i : {std::floor(at[0]), std::ceil(at[0])})
    for (const double j : {std::floor(at[1]), std::ceil(at[1])}) {
      if (i < 0 || j < 0 || i >= field.count[0] || j >= field.count[1]) return kNone;
      const double value = field.value(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j));
      least = std::min(least, value), most = std::max(most, value);
    }
  return most - least;
}

/// A path whose cost and the value of the field at its end differ by more than the error.
std::vector<std::string> remarks_on_ways(const RunField& field, const std::vector<FieldWay>& ways) {
  constexpr double kRounding = 1e-3;  // of the cost: values are linear between nodes
  std::vector<std::string> all;
  for (const FieldWay& way : ways) {
    if (field.nodes() != FieldNodes::plane || field.is_corridor()) continue;
    const Eigen::VectorXd& end = field.to_places() ? way.points.front() : way.points.back();
    const std::string place = point_text(end);
    const double more = field.lattice().error + kRounding * way.cost;
    if (way.value > way.cost + more && way.value > way.cost + more + linear_allowance(field.lattice(), end))
      all.push_back(fmt::format(
          "the path to {} costs {:.6g}, less than the {:.6g} of the field there, whose error is larger than "
          "the estimate {:.2g}: the cost changes too much within a step; use a smaller --resolution",
          place, way.cost, way.value, field.lattice().error));
    if (!(way.cost > way.value + field.lattice().error + kRounding * way.value)) continue;
    all.push_back(fmt::format(
        "the path to {} costs {:.6g}, and the field has {:.6g} there with an error of about {:.2g}: the cost changes "
        "too much within a step; use a smaller --resolution, or leastcost run between these two places",
        place, way.cost, way.value, field.lattice().error));
  }
  return all;
}

/// Of a field over a lattice, in two coordinates or in space.
template <class Field>
std::string error_line(const Field& field) {
  return std::isfinite(field.error)
             ? fmt::format(
                   "error  about {:.2g} at worst, {:.2g} on average (an estimate, from the field on half as many "
                   "cells)\n",
                   field.error, field.mean_error)
             : "error  not estimated: half as many cells are too few\n";
}

std::string error_line(const RunField& field) {
  switch (field.nodes()) {
    case FieldNodes::mesh:
      return fmt::format("error  at most {:.2g} (proved: shortest paths by windows)\n",
                         largest_error(field.on_vertices()));
    case FieldNodes::space: return error_line(field.space());
    case FieldNodes::plane: return error_line(field.lattice());
  }
  return "";
}

std::string nodes_in_words(const RunField& field) {
  switch (field.nodes()) {
    case FieldNodes::mesh: return fmt::format("{} vertices", field.values().size());
    case FieldNodes::space: return fmt::format("{} nodes", fmt::join(field.space().count, " x "));
    case FieldNodes::plane: return fmt::format("{} nodes", fmt::join(field.lattice().count, " x "));
  }
  return "";
}

/// Of the configuration, of the nodes and of the paths.
std::vector<std::string> all_notes(const RunField& field, const std::vector<FieldWay>& ways) {
  std::vector<std::string> all = field.notes();
  for (const auto& more : {warnings_of(field), remarks_of(field), remarks_on_ways(field, ways)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

std::vector<std::string> warnings_of(const RunField& field) {
  if (field.on_mesh()) return warnings_on_mesh(field);
  const double largest = extent_of(field.values()).largest;
  return field.in_space() ? warnings_on(field.space(), largest) : warnings_on(field.lattice(), largest);
}

bool is_directed(const RunField& field) {
  return field.in_space() ? field.space().directed : !field.on_mesh() && field.lattice().directed;
}

std::string method_of(const RunField& field) {
  return field.on_mesh() ? "exact windows" : field.in_space() ? field.space().method : field.lattice().method;
}

std::string field_summary_text(const RunField& field, const std::string& output, const std::vector<FieldWay>& ways) {
  const Extent extent = extent_of(field.values());
  const std::string unit = unit_of_cost(field.problem());
  const std::string nodes = nodes_in_words(field);
  std::string out = fmt::format("{}: {}, {} reached, the largest value {:.6g} {}\n", output, nodes, extent.reached,
                                extent.largest, unit);
  out += error_line(field);
  for (const std::string& note : all_notes(field, ways)) out += fmt::format("note: {}\n", note);
  for (const FieldWay& way : ways)
    out += fmt::format("path   from {} to {}: {:.10g} {}\n", point_text(way.points.front()),
                       point_text(way.points.back()), way.cost, unit);
  return out;
}

std::string field_summary_json(const RunField& field, const std::string& output, const std::vector<FieldWay>& ways) {
  Json out = {{"schema_version", kSchemaVersion},
              {"what", field.is_corridor() ? "corridor" : "field"},
              {"output", output},
              {"method", method_of(field)},
              {"directed", is_directed(field)},
              {"asymmetry", number(field.nodes() == FieldNodes::plane ? field.lattice().asymmetry : 1)},
              {"unit", unit_of_cost(field.problem())}};
  out[field.to_places() ? "to" : "from"] = places_json(field.places());
  if (field.is_corridor()) out["to"] = places_json({field.target()});
  say_nodes(field, out);
  out["error"] = error_json(field);
  out["notes"] = all_notes(field, ways);
  out["ways"] = Json::array();
  for (const FieldWay& way : ways)
    out["ways"].push_back({{"begin", numbers(way.points.front())},
                           {"end", numbers(way.points.back())},
                           {"cost", number(way.cost)},
                           {"value", number(way.value)},
                           {"points", way.points.size()}});
  return to_text(out);
}

}  // namespace leastcost::app
