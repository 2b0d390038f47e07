// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <ostream>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/mesh/mesh_report.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include "app/cli/command_options.hpp"
#include "app/cli/commands.hpp"
#include "catalogue/output/json_numbers.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::ordered_json;
constexpr double kDegrees = 180 / std::numbers::pi;

std::string named(const std::vector<std::int32_t>& numbers) { return fmt::format("{}", fmt::join(numbers, ", ")); }

std::string named(const std::vector<std::array<std::int32_t, 2>>& edges) {
  std::string out;
  for (const auto& edge : edges) out += fmt::format("{}{}-{}", out.empty() ? "" : ", ", edge[0], edge[1]);
  return out;
}

/// "fault: 24 (12-40, 13-7, ...)", nothing for none.
template <class List>
void append_fault(std::string& out, const char* what, std::int32_t count, const List& list) {
  if (count == 0) return;
  const std::string which =
      list.empty() ? ""
                   : fmt::format(" ({}{})", named(list), static_cast<std::size_t>(count) > list.size() ? ", ..." : "");
  out += fmt::format("  {}: {}{}\n", what, count, which);
}

std::string faults(const MeshReport& r) {
  std::string out;
  append_fault(out, "edges with three or more faces", r.non_manifold_edges, r.named_non_manifold_edges);
  append_fault(out, "vertices whose faces are not connected by edges", r.non_manifold_vertices,
               r.named_non_manifold_vertices);
  append_fault(out, "edges between faces of opposite orientation", r.flipped_edges, r.named_flipped_edges);
  append_fault(out, "degenerate faces", r.degenerate_faces, r.named_degenerate_faces);
  append_fault(out, "duplicate faces", r.duplicate_faces, r.named_duplicate_faces);
  append_fault(out, "vertices at the position of an earlier one", r.duplicate_positions, r.named_duplicate_positions);
  append_fault(out, "border vertices close to an earlier one", r.near_positions, r.named_near_positions);
  append_fault(out, "vertices not used by any face", r.unreferenced_vertices, std::vector<std::int32_t>{});
  return out;
}

/// What makes paths go wrong; borders, parts and vertices that no face uses are no faults.
bool has_faults(const MeshReport& r) {
  return r.non_manifold_edges > 0 || r.non_manifold_vertices > 0 || r.flipped_edges > 0 || r.degenerate_faces > 0 ||
         r.duplicate_faces > 0 || r.near_positions > 0 ||
         (r.duplicate_positions > 0 && (r.border_edges > 0 || r.components.size() > 1));
}

/// A power of ten, length units, that joins all vertices that are close to another.
double joining_distance(const MeshReport& r) {
  constexpr double kRoom = 1.01;
  return std::pow(10.0, std::ceil(std::log10(kRoom * r.near_within)));
}

/// What a solve would need, in order of importance.
std::vector<std::string> advice(const MeshReport& r) {
  std::vector<std::string> out;
  if (r.duplicate_positions > 0 && (r.border_edges > 0 || r.components.size() > 1))
    out.emplace_back("try weld: true; vertices at equal positions can be seams that paths cannot cross");
  if (r.near_positions > 0)
    out.push_back(
        fmt::format("try weld: {:g} (length units); {} border vertices lie up to {:.3g} from another one and can be "
                    "seams that paths cannot cross",
                    joining_distance(r), r.near_positions, r.near_within));
  if (r.components.size() > 1) out.emplace_back("both ends must lie in the same component");
  if (r.non_manifold_edges > 0)
    out.emplace_back("a path that must cross an edge with three or more faces ends in an error");
  if (r.border_edges > 0) out.emplace_back("boundaries are obstacles: paths go around holes");
  return out;
}

std::string component_line(std::size_t i, const MeshReport::Component& c) {
  std::string genus = "genus undefined (not manifold)";
  if (c.genus)
    genus = c.orientable ? fmt::format("genus {}", *c.genus) : fmt::format("not orientable, {} cross-caps", *c.genus);
  return fmt::format("  {}: {} vertices, {} edges, {} faces, {} boundary loops, {}\n", i, c.vertices, c.edges, c.faces,
                     c.boundary_loops, genus);
}

std::string report_text(const TriangleMesh& mesh, const MeshReport& r) {
  constexpr std::size_t kShown = 10;
  std::string out = fmt::format("{}: {} vertices, {} edges, {} faces\n", mesh.source(), r.vertices, r.edges, r.faces);
  out += fmt::format("diameter {:.6g}, area {:.6g}, edges {:.3g} to {:.3g}, smallest angle {:.3g} degrees\n",
                     mesh.diameter(), r.area, r.min_edge, r.max_edge, r.min_angle * kDegrees);
  out += fmt::format("{} component{}, {} boundary loops\n", r.components.size(), r.components.size() == 1 ? "" : "s",
                     r.boundary_loops);
  for (std::size_t i = 0; i < std::min(kShown, r.components.size()); ++i) out += component_line(i, r.components[i]);
  if (r.components.size() > kShown) out += fmt::format("  ... and {} more\n", r.components.size() - kShown);
  for (const std::string& note : mesh.notes()) out += "note: " + note + "\n";
  const std::string found = faults(r);
  out += found.empty() ? "no faults\n" : "faults, by the numbers of the file:\n" + found;
  for (const std::string& line : advice(r)) out += "advice: " + line + "\n";
  return out;
}

std::string report_json(const TriangleMesh& mesh, const MeshReport& r) {
  Json components = Json::array();
  for (const MeshReport::Component& c : r.components)
    components.push_back({{"vertices", c.vertices},
                          {"edges", c.edges},
                          {"faces", c.faces},
                          {"boundary_loops", c.boundary_loops},
                          {"border_edges", c.border_edges},
                          {"euler_characteristic", c.euler_characteristic},
                          {"manifold", c.manifold},
                          {"orientable", c.orientable},
                          {"genus", c.genus ? Json(*c.genus) : Json(nullptr)}});
  Json out = {{"schema_version", kSchemaVersion},
              {"file", mesh.source()},
              {"vertices", r.vertices},
              {"edges", r.edges},
              {"faces", r.faces}};
  out["diameter"] = number(mesh.diameter());
  out["area"] = number(r.area);
  out["shortest_edge"] = number(r.min_edge);
  out["longest_edge"] = number(r.max_edge);
  out["smallest_angle_degrees"] = number(r.min_angle * kDegrees);
  out["orientable"] = r.orientable;
  out["boundary_loops"] = r.boundary_loops;
  out["border_edges"] = r.border_edges;
  out["components"] = components;
  out["faults"] = {
      {"non_manifold_edges", {{"count", r.non_manifold_edges}, {"first", r.named_non_manifold_edges}}},
      {"non_manifold_vertices", {{"count", r.non_manifold_vertices}, {"first", r.named_non_manifold_vertices}}},
      {"flipped_edges", {{"count", r.flipped_edges}, {"first", r.named_flipped_edges}}},
      {"degenerate_faces", {{"count", r.degenerate_faces}, {"first", r.named_degenerate_faces}}},
      {"duplicate_faces", {{"count", r.duplicate_faces}, {"first", r.named_duplicate_faces}}},
      {"duplicate_positions", {{"count", r.duplicate_positions}, {"first", r.named_duplicate_positions}}},
      {"near_positions", {{"count", r.near_positions}, {"first", r.named_near_positions}}},
      {"unreferenced_vertices", {{"count", r.unreferenced_vertices}}}};
  out["notes"] = mesh.notes();
  out["advice"] = advice(r);
  return to_text(out);
}

}  // namespace

MeshOptions weld_of(const std::string& text) {
  MeshOptions options;
  options.weld = !text.empty() && text != "false";
  if (!options.weld || text == "true") return options;
  double& within = options.weld_within;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, within);
  if (error != std::errc() || rest != end || !(within > 0) || !std::isfinite(within))
    throw InputError(fmt::format("--weld={}: expected a distance above 0, in length units, or no value", text));
  return options;
}

Exit doctor_command(const std::string& file, const std::string& weld, bool json, const Streams& streams) {
  const TriangleMesh mesh(read_mesh(file), weld_of(weld));
  const MeshReport report = inspect(mesh);
  streams.out << (json ? report_json(mesh, report) : report_text(mesh, report));
  return has_faults(report) ? Exit::input : Exit::certified;
}

void add_doctor(const CommandLine& line) {
  OptionValues& v = line.values;
  CLI::App& doctor = *line.app.add_subcommand("doctor", "Report the faults of a mesh, and what it needs for a solve");
  doctor.add_option("mesh", v.mesh, "OBJ, OFF, PLY or STL file")->required()->type_name("MESH");
  doctor.add_flag(
      "--weld", v.weld,
      "First merge vertices at equal positions; --weld=1e-6: also those no farther apart than this, in length units");
  add_format(doctor, v);
  doctor.callback([&] { line.chosen = [&] { return doctor_command(v.mesh, v.weld, v.json(), line.streams); }; });
}

}  // namespace leastcost::app
