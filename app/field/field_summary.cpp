// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/field/field_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
  for (Eigen::Index i = 0; i < x.size(); ++i) out += fmt::format("{}{:.6g}", i > 0 ? ", " : "", x[i]);
  return out + ")";
}

/// What a user should know about the nodes of a lattice, in two coordinates or in space.
template <class Field>
std::vector<std::string> remarks_on(const Field& field) {
  std::vector<std::string> all;
  if (field.free_nodes > 0)
    all.push_back(
        fmt::format("a unit of length costs 0 at {} of {} nodes, the first is {}: moves between them are free",
                    field.free_nodes, field.values.size(), point_text(field.free_at)));
  if (field.enclosed)
    all.push_back(fmt::format(
        "no path leads farther than 5 steps from the {}: obstacles or places without a cost enclose {}, or gaps are "
        "narrower than a step (then use a smaller --resolution)",
        field.places.size() > 1 ? "places" : "place", field.places.size() > 1 ? "them" : "it"));
  return all;
}

std::vector<std::string> remarks_of(const RunField& field) {
  if (field.in_space()) return remarks_on(field.space());
  if (field.on_mesh()) {
    const auto reached = extent_of(field.values()).reached;
    if (reached > field.places().size() || field.values().size() <= reached) return {};
    return {"no path leads farther than the place itself: its part of the mesh has no other vertex"};
  }
  const CostField& lattice = field.lattice();
  std::vector<std::string> all = remarks_on(lattice);
  constexpr double kRounding = 1e-6;  // of a step
  if ((lattice.uncovered.array() > kRounding * lattice.step.array()).any())
    all.push_back(fmt::format(
        "equal steps do not divide the sides of the box: a strip at its upper edges has no nodes, {:.3g} wide along {} "
        "and {:.3g} along {}",
        lattice.uncovered[0], field.names()[0], lattice.uncovered[1], field.names()[1]));
  return all;
}

/// A path that costs more than the field has at its end by more than the error.
std::vector<std::string> remarks_on_ways(const RunField& field, const std::vector<FieldWay>& ways) {
  constexpr double kRounding = 1e-3;  // of the cost: values are linear between nodes
  std::vector<std::string> all;
  for (const FieldWay& way : ways) {
    if (field.nodes() != FieldNodes::plane || field.is_corridor()) continue;
    if (!(way.cost > way.value + field.lattice().error + kRounding * way.value)) continue;
    all.push_back(fmt::format(
        "the path to {} costs {:.6g}, and the field has {:.6g} there with an error of about {:.2g}: the cost changes "
        "too much within a step; use a smaller --resolution, or leastcost run between these two places",
        point_text(field.to_places() ? way.points.front() : way.points.back()), way.cost, way.value,
        field.lattice().error));
  }
  return all;
}

/// Of a field over a lattice, in two coordinates or in space.
template <class Field>
std::string estimate_notes(const Field& field, double largest) {
  std::string out;
  if (std::isfinite(field.error))
    out += fmt::format(
        "error  about {:.2g} at worst, {:.2g} on average (an estimate, from the field on half as many cells)\n",
        field.error, field.mean_error);
  else
    out += "error  not estimated: half as many cells are too few\n";
  if (field.error > largest)
    out += "note: at some nodes the error may be larger than every value: use a smaller --resolution\n";
  if (!field.without_cost.empty())
    out += fmt::format("note: nodes without a cost are left out: {}\n", field.without_cost);
  if (field.unresolved > 0)
    out += fmt::format("note: {} nodes are reached only by passages of one or two cells; use a smaller --resolution\n",
                       field.unresolved);
  return out;
}

std::string direction_note(const RunField& of) {
  if (!is_directed(of) || of.is_corridor()) return {};
  return fmt::format("note: the two directions of a way differ in cost; these are costs of {} the {}\n",
                     of.to_places() ? "reaching" : "leaving", of.places().size() > 1 ? "places" : "place");
}

std::string lattice_notes(const RunField& of, double largest) {
  const CostField& field = of.lattice();
  std::string out = estimate_notes(field, largest) + direction_note(of);
  if (field.asymmetry > CostField::kFaithfulAsymmetry)
    out += fmt::format(
        "note: {}; under such a cost values can be wrong by more than the estimate (leastcost run gives certified "
        "costs between two places)\n",
        std::isfinite(field.asymmetry)
            ? fmt::format("a move costs up to {:.3g} times the same move back", field.asymmetry)
            : "some moves have no move back");
  return out;
}

std::string mesh_notes(const MeshField& field) {
  std::string out = fmt::format("error  at most {:.2g} (proved: shortest paths by windows)\n", largest_error(field));
  if (field.cut)
    out +=
        "note: memory ran out, or paths run over faces without height: some values are lengths of paths that may not "
        "be the shortest (leastcost doctor lists such faces)\n";
  return out;
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
  for (const auto& more : {remarks_of(field), remarks_on_ways(field, ways)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

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
  out += field.on_mesh()    ? mesh_notes(field.on_vertices())
         : field.in_space() ? estimate_notes(field.space(), extent.largest) + direction_note(field)
                            : lattice_notes(field, extent.largest);
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
