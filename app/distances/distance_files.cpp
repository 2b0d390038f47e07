// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/distances/distance_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/output/vtp.hpp"

namespace leastcost::app {
namespace {

constexpr double kNoPath = -1, kNotReached = -2;  // in formats whose readers do not take inf

AtVertex at_vertex(const ExactDistances& distances, std::int32_t v) {
  const std::size_t i = static_cast<std::size_t>(v);
  const double most = distances.at_most[i];
  switch (state_at(distances, v)) {
    case DistanceState::exact: return {distances.distance[i], most - distances.at_least[i]};
    case DistanceState::bound: return {most, most - distances.at_least[i]};
    case DistanceState::not_reached: return {most, most};
    case DistanceState::no_path: return {most, 0};
  }
  return {};
}

/// Of all vertices, the same without inf.
std::vector<AtVertex> finite_at_vertices(const ExactDistances& distances) {
  std::vector<AtVertex> all;
  all.reserve(distances.distance.size());
  for (std::int32_t v = 0; v < static_cast<std::int32_t>(distances.distance.size()); ++v) {
    const DistanceState state = state_at(distances, v);
    all.push_back(state == DistanceState::no_path       ? AtVertex{kNoPath, 0}
                  : state == DistanceState::not_reached ? AtVertex{kNotReached, 0}
                                                        : at_vertex(distances, v));
  }
  return all;
}

std::string distance_csv(const TriangleMesh& mesh, const ExactDistances& distances) {
  std::string out = "vertex,x,y,z,distance,error,state\n";
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.file_vertex(v) < 0) continue;  // made by subdivision
    const Eigen::Vector3d& p = mesh.position(v);
    const AtVertex at = at_vertex(distances, v);
    fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{}\n", mesh.file_vertex(v), p.x(), p.y(), p.z(),
                   at.value, at.error, word_of(state_at(distances, v)));
  }
  return out;
}

/// One row of text for each of so many.
template <class Row>
std::string rows(std::int32_t count, Row row) {
  std::string text;
  for (std::int32_t i = 0; i < count; ++i) fmt::format_to(std::back_inserter(text), "{}\n", row(i));
  return text;
}

}  // namespace

Words<DistanceState> words(DistanceState) {
  using enum DistanceState;
  static constexpr Word<DistanceState> kWords[] = {
      {exact, "exact"}, {bound, "bound"}, {not_reached, "not_reached"}, {no_path, "no_path"}};
  return kWords;
}

DistanceState state_at(const ExactDistances& distances, std::int32_t v) {
  const double least = distances.at_least[static_cast<std::size_t>(v)];
  if (!std::isfinite(distances.at_most[static_cast<std::size_t>(v)]))
    return std::isfinite(least) ? DistanceState::not_reached : DistanceState::no_path;
  return least < distances.seen_to ? DistanceState::exact : DistanceState::bound;
}

DistanceFormat distance_format(std::string_view file) {
  const std::string_view ending = file.substr(std::min(file.size(), file.rfind('.')));
  if (ending == ".csv") return DistanceFormat::csv;
  if (ending == ".vtp") return DistanceFormat::vtp;
  if (ending == ".ply") return DistanceFormat::ply;
  throw InputError(std::string(file) + ": distances can be written as .csv, .vtp or .ply");
}

std::string vertices_ply(const TriangleMesh& mesh, std::string_view name, std::string_view comment,
                         const std::vector<AtVertex>& values) {
  std::string out = fmt::format(
      "ply\nformat ascii 1.0\ncomment {}\nelement vertex {}\n"
      "property double x\nproperty double y\nproperty double z\nproperty double {}\nproperty double error\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      comment, mesh.vertex_count(), name, mesh.face_count());
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Eigen::Vector3d& p = mesh.position(v);
    const AtVertex& at = values[static_cast<std::size_t>(v)];
    fmt::format_to(std::back_inserter(out), "{} {} {} {} {}\n", p.x(), p.y(), p.z(), at.value, at.error);
  }
  for (const auto& face : mesh.faces())
    fmt::format_to(std::back_inserter(out), "3 {} {} {}\n", face[0], face[1], face[2]);
  return out;
}

std::string vertices_vtp(const TriangleMesh& mesh, std::string_view name, const std::vector<AtVertex>& values) {
  const std::int32_t points = mesh.vertex_count(), faces = mesh.face_count();
  const auto of_vertices = [&](std::string_view of, double AtVertex::*value) {
    return vtp_array(of, 1, "Float64",
                     rows(points, [&](std::int32_t v) { return values[static_cast<std::size_t>(v)].*value; }));
  };
  std::string piece = fmt::format("      <PointData Scalars=\"{}\">\n", name) + of_vertices(name, &AtVertex::value) +
                      of_vertices("error", &AtVertex::error) + "      </PointData>\n      <Points>\n";
  piece += vtp_array("Points", 3, "Float64", rows(points, [&](std::int32_t v) {
                       const Eigen::Vector3d& p = mesh.position(v);
                       return fmt::format("{} {} {}", p.x(), p.y(), p.z());
                     }));
  piece += "      </Points>\n      <Polys>\n";
  piece += vtp_array("connectivity", 1, "Int32", rows(faces, [&](std::int32_t f) {
                       const auto& face = mesh.faces()[static_cast<std::size_t>(f)];
                       return fmt::format("{} {} {}", face[0], face[1], face[2]);
                     }));
  piece += vtp_array("offsets", 1, "Int32", rows(faces, [](std::int32_t f) { return 3 * (f + 1); }));
  return vtp_file({.points = points, .polygons = faces}, piece + "      </Polys>\n");
}

std::string distance_text(const TriangleMesh& mesh, const ExactDistances& distances, DistanceFormat format) {
  switch (format) {
    case DistanceFormat::csv: return distance_csv(mesh, distances);
    case DistanceFormat::vtp: return vertices_vtp(mesh, "distance", finite_at_vertices(distances));
    case DistanceFormat::ply:
      return vertices_ply(mesh, "distance", "exact distances on the mesh; -1: no path; -2: not reached",
                          finite_at_vertices(distances));
  }
  return "";
}

}  // namespace leastcost::app
