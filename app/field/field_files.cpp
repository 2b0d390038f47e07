// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/field/field_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/chart/is_geographic.hpp>
#include <leastcost/problems/chart/seams.hpp>
#include <leastcost/problems/raster/has_raster.hpp>
#include "app/distances/distance_files.hpp"
#include "catalogue/back_ends/back_ends.hpp"
#include "catalogue/output/unit_of_cost.hpp"

namespace leastcost::app {
namespace {

std::string header(const std::vector<std::string>& names, const char* cost) {
  return fmt::format("{},{}\n", fmt::join(names, ","), cost);
}

std::string lattice_csv(const CostField& field, const std::vector<std::string>& names) {
  std::string out = header(names, "cost");
  for (std::int32_t j = 0; j < field.count[1]; ++j)
    for (std::int32_t i = 0; i < field.count[0]; ++i) {
      const Eigen::Vector2d x = field.node(i, j);
      fmt::format_to(std::back_inserter(out), "{},{},{}\n", x.x(), x.y(), field.value(i, j));
    }
  return out;
}

/// The start of a file of doubles. `shape`: as in Python, "(5, 9)".
std::string npy_header(const std::string& shape) {
  constexpr std::size_t kLengthAt = 8, kBefore = 10, kAlignment = 64;
  std::string header = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': {}, }}", shape);
  header.append(kAlignment - 1 - (kBefore + header.size()) % kAlignment, ' ') += '\n';
  std::string out = std::string("\x93NUMPY\x01\x00", kLengthAt);
  out += static_cast<char>(header.size() & 0xFF);
  out += static_cast<char>(header.size() >> 8);
  return out + header;
}

/// Little-endian, whatever the host is.
void append(std::string& out, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  for (int byte = 0; byte < 8; ++byte) out += static_cast<char>(bits >> (8 * byte) & 0xFF);
}

std::string lattice_npy(const CostField& field) {
  std::string out = npy_header(fmt::format("({}, {})", field.count[1], field.count[0]));
  out.reserve(out.size() + 8 * field.values.size());
  for (std::int32_t j = field.count[1] - 1; j >= 0; --j)
    for (std::int32_t i = 0; i < field.count[0]; ++i) append(out, field.value(i, j));
  return out;
}

std::string lattice_asc(const CostField& field) {
  constexpr double kRounding = 1e-9, kNoPath = -9999;
  if (std::abs(field.step.x() - field.step.y()) > kRounding * field.step.x())
    throw InputError(
        fmt::format("an .asc file needs cells with equal sides (found {} and {}): write .csv or .npy, or set "
                    "a --resolution that divides both sides of the box",
                    field.step.x(), field.step.y()));
  std::string out = fmt::format("ncols {}\nnrows {}\nxllcorner {}\nyllcorner {}\ncellsize {}\nNODATA_value {}\n",
                                field.count[0], field.count[1], field.lower.x() - field.step.x() / 2,
                                field.lower.y() - field.step.y() / 2, field.step.x(), kNoPath);
  for (std::int32_t j = field.count[1] - 1; j >= 0; --j)
    for (std::int32_t i = 0; i < field.count[0]; ++i) {
      const double value = field.value(i, j);
      fmt::format_to(std::back_inserter(out), "{}{}", std::isnan(value) ? kNoPath : value,
                     i + 1 < field.count[0] ? ' ' : '\n');
    }
  return out;
}

std::string space_csv(const SpaceField& field, const std::vector<std::string>& names) {
  std::string out = header(names, "cost");
  for (std::int32_t k = 0; k < field.count[2]; ++k)
    for (std::int32_t j = 0; j < field.count[1]; ++j)
      for (std::int32_t i = 0; i < field.count[0]; ++i) {
        const Eigen::Vector3d x = field.node(i, j, k);
        fmt::format_to(std::back_inserter(out), "{},{},{},{}\n", x.x(), x.y(), x.z(), field.value(i, j, k));
      }
  return out;
}

std::string space_npy(const SpaceField& field) {
  std::string out = npy_header(fmt::format("({}, {}, {})", field.count[0], field.count[1], field.count[2]));
  out.reserve(out.size() + 8 * field.values.size());
  for (std::int32_t i = 0; i < field.count[0]; ++i)
    for (std::int32_t j = 0; j < field.count[1]; ++j)
      for (std::int32_t k = 0; k < field.count[2]; ++k) append(out, field.value(i, j, k));
  return out;
}

/// The image data of VTK, as text.
std::string space_vti(const SpaceField& field, const char* name) {
  constexpr double kNone = -1;
  const std::string extent = fmt::format("0 {} 0 {} 0 {}", field.count[0] - 1, field.count[1] - 1, field.count[2] - 1);
  std::string out = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\">\n<ImageData WholeExtent=\"{}\" "
      "Origin=\"{} {} {}\" Spacing=\"{} {} {}\">\n<Piece Extent=\"{}\">\n<PointData Scalars=\"{}\">\n<DataArray "
      "type=\"Float64\" Name=\"{}\" format=\"ascii\">\n",
      extent, field.lower.x(), field.lower.y(), field.lower.z(), field.step.x(), field.step.y(), field.step.z(), extent,
      name, name);
  for (const double value : field.values)
    fmt::format_to(std::back_inserter(out), "{}\n", std::isnan(value) ? kNone : value);
  return out + "</DataArray>\n</PointData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
}

std::string mesh_csv(const TriangleMesh& mesh, const MeshField& field) {
  std::string out = "vertex,x,y,z,cost\n";
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.file_vertex(v) < 0) continue;  // made by subdivision
    const Eigen::Vector3d& p = mesh.position(v);
    fmt::format_to(std::back_inserter(out), "{},{},{},{},{}\n", mesh.file_vertex(v), p.x(), p.y(), p.z(),
                   field.values[static_cast<std::size_t>(v)]);
  }
  return out;
}

std::string mesh_npy(const TriangleMesh& mesh, const MeshField& field) {
  std::string out = npy_header(fmt::format("({},)", mesh.file_vertex_count()));
  for (const double value : in_order_of_file(mesh, field)) append(out, value);
  return out;
}

/// Without NaN, which many readers do not take.
std::vector<AtVertex> finite_values(const MeshField& field) {
  std::vector<AtVertex> all;
  all.reserve(field.values.size());
  for (std::size_t v = 0; v < field.values.size(); ++v)
    all.push_back(std::isnan(field.values[v]) ? AtVertex{-1, 0} : AtVertex{field.values[v], field.errors[v]});
  return all;
}

/// The raster that a problem was made from; null where there is none.
const RasterGrid* raster_of(const Problem& problem) {
  for (const HasRaster* of : {find_ability<HasRaster>(*problem.manifold), find_ability<HasRaster>(*problem.cost)})
    if (of != nullptr) return &of->raster();
  return nullptr;
}

/// Cells with the nodes in their middles.
RasterGrid cells_around(const CostField& field) {
  RasterGrid cells;
  cells.columns = field.count[0];
  cells.rows = field.count[1];
  cells.cell = field.step;
  cells.corner = field.lower - field.step / 2;
  cells.values = field.values;
  return cells;
}

/// Of longitudes and latitudes on the usual ellipsoid; null for others.
std::shared_ptr<const RasterCrs> crs_of_earth(const Problem& problem) {
  constexpr double kEquator = 6378137, kPole = 6356752.314245, kRounding = 1e-5;  // WGS 84, m
  if (!latitude_first(problem)) return nullptr;
  CoordinatePath places{Points(2, 2), {}, true};
  places.u << 0, 90, 0, 0;
  const Points x = positions(*problem.manifold, places);
  if (std::abs(x.col(0).norm() - kEquator) > kRounding || std::abs(x.col(1).norm() - kPole) > kRounding) return nullptr;
  auto crs = std::make_shared<RasterCrs>();
  crs->name = "WGS 84";
  crs->wkt =
      "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],UNIT["
      "\"degree\",0.0174532925199433],AUTHORITY[\"EPSG\",\"4326\"]]";
  crs->geographic = true;
  return crs;
}

std::string lattice_tif(const RunField& field) {
  RasterGrid cells = cells_around(as_map(field));
  cells.crs = crs_of_earth(field.problem());
  if (const RasterGrid* raster = raster_of(field.problem())) {
    cells.degrees = raster->degrees;
    cells.crs = raster->crs;
  }
  return geotiff_writer_of_libraries()(cells, field.is_corridor() ? "detour" : "cost", unit_of_cost(field.problem()));
}

constexpr std::array<std::pair<std::string_view, FieldFormat>, 8> kFormats = {{{".csv", FieldFormat::csv},
                                                                               {".npy", FieldFormat::npy},
                                                                               {".asc", FieldFormat::asc},
                                                                               {".tif", FieldFormat::tif},
                                                                               {".tiff", FieldFormat::tif},
                                                                               {".vti", FieldFormat::vti},
                                                                               {".vtp", FieldFormat::vtp},
                                                                               {".ply", FieldFormat::ply}}};
constexpr std::string_view kOfLattice = ".csv, .npy, .asc or .tif", kOfSpace = ".csv, .npy or .vti",
                           kOfMesh = ".csv, .npy, .vtp or .ply";

}  // namespace

bool latitude_first(const Problem& problem) {
  const auto* earth = find_ability<IsGeographic>(*problem.manifold);
  return earth != nullptr && find_ability<HasSeams>(*problem.manifold) != nullptr &&
         earth->longitude_latitude(Eigen::Vector2d(1, 2)) == Eigen::Vector2d(2, 1);
}

CostField as_map(const RunField& field) {
  const CostField& given = field.lattice();
  if (!latitude_first(field.problem())) return given;
  CostField map = given;
  map.count = {given.count[1], given.count[0]};
  map.lower = given.lower.reverse(), map.step = given.step.reverse();
  for (std::int32_t j = 0; j < map.count[1]; ++j)
    for (std::int32_t i = 0; i < map.count[0]; ++i)
      map.values[static_cast<std::size_t>(j) * static_cast<std::size_t>(map.count[0]) + static_cast<std::size_t>(i)] =
          given.value(j, i);
  return map;
}

FieldFormat field_format(std::string_view file) {
  std::string ending(file.substr(std::min(file.size(), file.rfind('.'))));
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const auto& [word, format] : kFormats)
    if (ending == word) return format;
  throw InputError(fmt::format("{}: a field can be written as {}, in space as {}, on a mesh as {}", file, kOfLattice,
                               kOfSpace, kOfMesh));
}

void check_format(FieldFormat format, FieldNodes nodes) {
  if (format == FieldFormat::csv || format == FieldFormat::npy) return;
  if (format == FieldFormat::tif && nodes == FieldNodes::plane && geotiff_writer_of_libraries() == nullptr)
    throw InputError(
        "a GeoTIFF needs GDAL, which this build is without: install libgdal-dev and rebuild, or write .asc or .npy");
  switch (nodes) {
    case FieldNodes::plane:
      if (format == FieldFormat::asc || format == FieldFormat::tif) return;
      throw InputError(fmt::format("a field over a lattice can be written as {}", kOfLattice));
    case FieldNodes::space:
      if (format == FieldFormat::vti) return;
      throw InputError(fmt::format("a field in space can be written as {}", kOfSpace));
    case FieldNodes::mesh:
      if (format == FieldFormat::vtp || format == FieldFormat::ply) return;
      throw InputError(fmt::format("a field on a mesh can be written as {}", kOfMesh));
  }
}

std::string field_text(const RunField& field, FieldFormat format) {
  check_format(format, field.nodes());
  const bool mesh = field.on_mesh(), space = field.in_space();
  switch (format) {
    case FieldFormat::csv:
      return mesh    ? mesh_csv(field.mesh(), field.on_vertices())
             : space ? space_csv(field.space(), field.names())
                     : lattice_csv(field.lattice(), field.names());
    case FieldFormat::npy:
      return mesh    ? mesh_npy(field.mesh(), field.on_vertices())
             : space ? space_npy(field.space())
                     : lattice_npy(as_map(field));
    case FieldFormat::asc: return lattice_asc(as_map(field));
    case FieldFormat::tif: return lattice_tif(field);
    case FieldFormat::vti: return space_vti(field.space(), field.is_corridor() ? "detour" : "cost");
    case FieldFormat::vtp: return vertices_vtp(field.mesh(), "cost", finite_values(field.on_vertices()));
    case FieldFormat::ply: return vertices_ply(field.mesh(), "cost", "-1: no path", finite_values(field.on_vertices()));
  }
  return "";
}

std::string ways_csv(const RunField& field, const std::vector<FieldWay>& ways) {
  std::string out = fmt::format("way,{}\n", fmt::join(field.names(), ","));
  for (std::size_t k = 0; k < ways.size(); ++k)
    for (const Eigen::VectorXd& x : ways[k].points) {
      fmt::format_to(std::back_inserter(out), "{}", k);
      for (const double coordinate : x) fmt::format_to(std::back_inserter(out), ",{}", coordinate);
      out += '\n';
    }
  return out;
}

}  // namespace leastcost::app
