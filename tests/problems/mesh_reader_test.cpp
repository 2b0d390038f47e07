// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/readers/mesh_reader.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <random>
#include <set>
#include <sstream>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/mesh/mesh_report.hpp>
#include "problems/readers/format_readers.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost {
namespace {

constexpr unsigned kReaderSeed = 20260103;

using Reader = PolygonSoup (*)(std::string_view, const std::string&, const Deadline&);

/// The message of the InputError that reading ends with, empty when it succeeds.
std::string error_of(Reader read, const std::string& content) {
  try {
    read(content, "m", {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

template <class T>
void append(std::string& bytes, T value, std::endian order) {
  std::array<char, sizeof(T)> raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

std::string as_off(const PolygonSoup& soup) {
  std::ostringstream out;
  out.precision(17);
  out << "OFF\n" << soup.positions.size() << ' ' << soup.polygon_begin.size() - 1 << " 0\n";
  for (const Eigen::Vector3d& p : soup.positions) out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (std::size_t p = 0; p + 1 < soup.polygon_begin.size(); ++p) {
    out << soup.polygon_begin[p + 1] - soup.polygon_begin[p];
    for (std::int32_t i = soup.polygon_begin[p]; i < soup.polygon_begin[p + 1]; ++i)
      out << ' ' << soup.corners[static_cast<std::size_t>(i)];
    out << '\n';
  }
  return out.str();
}

std::string as_obj(const PolygonSoup& soup) {
  std::ostringstream out;
  out.precision(17);
  for (const Eigen::Vector3d& p : soup.positions) out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (std::size_t p = 0; p + 1 < soup.polygon_begin.size(); ++p) {
    out << 'f';
    for (std::int32_t i = soup.polygon_begin[p]; i < soup.polygon_begin[p + 1]; ++i)
      out << ' ' << soup.corners[static_cast<std::size_t>(i)] + 1;
    out << '\n';
  }
  return out.str();
}

/// Binary PLY with doubles, and with other elements and properties around what matters.
std::string as_binary_ply(const PolygonSoup& soup, std::endian order) {
  std::string bytes =
      std::string("ply\r\nformat binary_") + (order == std::endian::little ? "little" : "big") +
      "_endian 1.0\r\ncomment made by a test\r\nelement camera 2\r\nproperty list ushort short zoom\r\n" +
      "element vertex " + std::to_string(soup.positions.size()) +
      "\r\nproperty uchar red\r\nproperty double x\r\nproperty double y\r\nproperty double z\r\nproperty list uchar "
      "float weights\r\nelement face " +
      std::to_string(soup.polygon_begin.size() - 1) +
      "\r\nproperty list int uint vertex_indices\r\nproperty int8 flags\r\nend_header\r\n";
  for (const int zooms : {0, 3}) {
    append(bytes, static_cast<std::uint16_t>(zooms), order);
    for (int i = 0; i < zooms; ++i) append(bytes, std::int16_t{-5}, order);
  }
  for (const Eigen::Vector3d& p : soup.positions) {
    append(bytes, std::uint8_t{200}, order);
    for (int k = 0; k < 3; ++k) append(bytes, p[k], order);
    append(bytes, std::uint8_t{1}, order);
    append(bytes, 0.25F, order);
  }
  for (std::size_t p = 0; p + 1 < soup.polygon_begin.size(); ++p) {
    append(bytes, soup.polygon_begin[p + 1] - soup.polygon_begin[p], order);
    for (std::int32_t i = soup.polygon_begin[p]; i < soup.polygon_begin[p + 1]; ++i) {
      append(bytes, static_cast<std::uint32_t>(soup.corners[static_cast<std::size_t>(i)]), order);
    }
    append(bytes, std::int8_t{-1}, order);
  }
  return bytes;
}

std::string as_text_ply(const PolygonSoup& soup) {
  const std::string off = as_off(soup);
  const std::size_t body = off.find('\n', off.find('\n') + 1) + 1;
  return "ply\nformat ascii 1.0\nobj_info x\nelement vertex " + std::to_string(soup.positions.size()) +
         "\nproperty float x\nproperty float64 y\nproperty float z\nelement face " +
         std::to_string(soup.polygon_begin.size() - 1) + "\nproperty list uchar int vertex_index\nend_header\n" +
         off.substr(body);
}

std::string as_text_stl(const PolygonSoup& triangles) {
  std::ostringstream out;
  out.precision(17);
  out << "solid a name with solid in it\n";
  for (std::size_t i = 0; i < triangles.corners.size(); ++i) {
    const Eigen::Vector3d& p = triangles.positions[static_cast<std::size_t>(triangles.corners[i])];
    if (i % 3 == 0) out << "  facet normal nan nan nan\n    outer loop\n";
    out << "      vertex " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    if (i % 3 == 2) out << "    endloop\n  endfacet\n";
  }
  out << "endsolid\n";
  return out.str();
}

std::string as_binary_stl(const PolygonSoup& triangles) {
  std::string bytes = "solid, as some programs write here";
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(triangles.corners.size() / 3), std::endian::little);
  for (std::size_t i = 0; i < triangles.corners.size(); ++i) {
    if (i % 3 == 0) bytes.append(12, '\0');
    const Eigen::Vector3d& p = triangles.positions[static_cast<std::size_t>(triangles.corners[i])];
    for (int k = 0; k < 3; ++k) append(bytes, static_cast<float>(p[k]), std::endian::little);
    if (i % 3 == 2) bytes.append(2, '\0');
  }
  return bytes;
}

void check_equal(const PolygonSoup& a, const PolygonSoup& b) {
  CHECK(a.positions == b.positions);
  CHECK(a.corners == b.corners);
  CHECK(a.polygon_begin == b.polygon_begin);
}

std::string write(const test::ScratchDir& dir, const std::string& name, const std::string& content) {
  std::ofstream(dir / name, std::ios::binary) << content;
  return (dir / name).string();
}

PolygonSoup triangulated_cube() { return test::soup_of(TriangleMesh(test::cube())); }

}  // namespace

TEST_CASE("mesh reader: every format gives the same mesh, doubles bit for bit", "[reader]") {
  const test::ScratchDir dir;
  PolygonSoup soup = test::cube();
  soup.positions[0] = {0.1, -1.0 / 3, 6.02214076e23};
  soup.positions[1] = {-5e-324, 1.7976931348623157e308, -0.0};
  check_equal(read_mesh(write(dir, "a.off", as_off(soup))), soup);
  check_equal(read_mesh(write(dir, "a.OBJ", as_obj(soup))), soup);
  check_equal(read_mesh(write(dir, "a.ply", as_text_ply(soup))), soup);
  check_equal(read_mesh(write(dir, "b.ply", as_binary_ply(soup, std::endian::little))), soup);
  check_equal(read_mesh(write(dir, "c.ply", as_binary_ply(soup, std::endian::big))), soup);
  CHECK(read_mesh(dir / "a.off").source == (dir / "a.off").string());
  // STL numbers vertices by first appearance.
  const TriangleMesh cube(test::cube());
  for (const std::string& content : {as_text_stl(triangulated_cube()), as_binary_stl(triangulated_cube())}) {
    const PolygonSoup stl = read_mesh(write(dir, "a.stl", content));
    CHECK(stl.positions.size() == 8);
    const TriangleMesh mesh(stl);
    REQUIRE(mesh.face_count() == 12);
    for (std::int32_t f = 0; f < 12; ++f) {
      for (std::size_t k = 0; k < 3; ++k) CHECK(mesh.position(mesh.face(f)[k]) == cube.position(cube.face(f)[k]));
    }
  }
}

TEST_CASE("mesh reader: OBJ as programs write it", "[reader]") {
  const std::string content =
      "\xef\xbb\xbf# comment\r\n"
      "mtllib a b.mtl\r\no thing\r\ng one two\r\ns off\r\nusemtl \\\r\n steel\r\n"
      "\tv  0 0 0 1.0\r\nv 1 0 0 0.5 0.5 0.5\r\nv +1 1e0 .0\r\nv 0 1 \\\r\n0 # four\r\n"
      "vt 0\nvt 0.5 1\nvt 0 0 0\nvn 0 0 1\nvp 1 2\nl 1 2\np 1\n"
      "f 1/1/1 2/2/1 3/3/1 \\\n 4/1/-1\r"
      "f -4 -3 -2\nf 1//1 2//1 3//1\nf 1/3 2/-1 5/1\nv 5 5 5";
  const PolygonSoup soup = read_obj(content, "m");
  CHECK(soup.positions == std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 5, 5}});
  CHECK(soup.corners == std::vector<std::int32_t>{0, 1, 2, 3, 0, 1, 2, 0, 1, 2, 0, 1, 4});
  CHECK(soup.polygon_begin == std::vector<std::int32_t>{0, 4, 7, 10, 13});
}

TEST_CASE("mesh reader: OFF as programs write it", "[reader]") {
  const auto faces = [](const std::string& content) { return read_off(content, "m").polygon_begin.size() - 1; };
  CHECK(faces("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n") == 1);
  CHECK(faces("# first\nOFF # here\n\n3 1 # no edges\n# there\n0 0 0\n1 0 0\n\n0 1 0\n3 0 1 2 255 0 0 # red\n\n") == 1);
  CHECK(faces("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n0 1 0 0 0 0 0\n3 0 1 2") == 1);
  CHECK(faces("NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2 7") == 1);
  CHECK(faces("STOFF\n3 1 0\n0 0 0 0 1\n1 0 0 0 1\n0 1 0 0 1\n3 0 1 2 0.5 0.5 0.5 1") == 1);
}

TEST_CASE("mesh reader: messages name the place, the finding and the remedy", "[reader]") {
  struct Sample {
    Reader read;
    std::string content, message;
  };
  const std::string ply = "ply\nformat ascii 1.0\n",
                    vertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n", points = "0 0 0\n1 0 0\n0 1 0\n";
  const std::vector<Sample> samples = {
      {read_obj, "v 0 0 0\nw 1 2 3\n", "m:2: unknown keyword 'w'"},
      {read_obj, "v 0 0\n", "m:1: expected a coordinate of a vertex (3 numbers), found the end of the line"},
      {read_obj, "v 0 0 1,5\n", "m:1: expected a coordinate of a vertex (3 numbers), found '1,5'"},
      {read_obj, "\nv 0 0 nan\n", "m:2: expected a coordinate of a vertex (3 numbers) that is finite, found 'nan'"},
      {read_obj, "v 0 0 1e999\n", "that is finite, found '1e999'"},
      {read_obj, "v 1 2 3 4 5\n",
       "m:1: a vertex must have 3 numbers, 4 with a weight, or 6 or 7 with a colour; found 5"},
      {read_obj, "v 0 0 0\nf 1 1\n", "m:2: a face needs at least 3 corners, found 2"},
      {read_obj, "v 0 0 0\nf 1 1 2\n", "m:2: there is no vertex 2; the file has 1"},
      {read_obj, "v 0 0 0\nf 1 1 0\n", "m:2: there is no vertex 0; numbers start at 1"},
      {read_obj, "v 0 0 0\nf 1 1 -2\n", "m:2: there is no vertex -2"},
      {read_obj, "v 0 0 0\nf 1/1 1/1 1/1\n", "m:2: there is no texture coordinate 1; the file has 0"},
      {read_obj, "v 0 0 0\nf 1//4 1//4 1//4\n", "m:2: there is no normal 4"},
      {read_obj, "v 0 0 0\nf 1/ 1 1\n", "m:2: expected a corner like 1, 1/2, 1//3 or 1/2/3, found '1/'"},
      {read_obj, "v 0 0 0\nf 1 1 1x\n", "found '1x'"},
      {read_obj, "v 0 0 0\nf 1 1 99999999999999999999\n", "m:2: expected a corner"},
      {read_obj, "v 0 0 0\n\\\n\\\nf 1 1 3000000000\n", "m:4: there is no vertex 3000000000"},
      {read_obj, "cstype bspline\n", "m:1: free-form geometry ('cstype')"},
      {read_obj, std::string("v 0 0 \0\x01", 8), "found '\\x00\\x01'"},
      {read_off, "OF\n", "m:1: expected the header OFF (or COFF, NOFF, STOFF), found 'OF'"},
      {read_off, "4OFF\n", "only three dimensions"},
      {read_off, "", "m:1: the file has no content"},
      {read_off, "OFF\n", "m:2: expected the numbers of vertices"},
      {read_off, "OFF\n3 -1 0\n" + points, "m:2: expected the number of faces, found -1"},
      {read_off, "OFF\n3.5 1 0\n", "m:2: expected the number of vertices (an integer), found '3.5'"},
      {read_off, "OFF\n2000000000 1 0\n0 0 0\n", "m:2: the number of vertices is 2000000000, but the file has only"},
      {read_off, "OFF\n3 1 0\n" + points + "3 0 1 3\n",
       "m:6: there is no vertex 3; the file has 3 vertices numbered from 0"},
      {read_off, "OFF\n3 1 0\n" + points + "2 0 1\n", "m:6: a face needs at least 3 corners, found 2"},
      {read_off, "OFF\n3 1 0\n" + points + "4 0 1 2\n",
       "m:6: expected a vertex number of a face (an integer), found the end of the line"},
      {read_off, "OFF\n3 1 0\n" + points + "3 0 1 2 1 1 1 1 1\n", "m:6: a face colour has at most 4 numbers, found 5"},
      {read_off, "OFF\n3 1 0\n" + points + "3 0 1 2\n3 0 1 2\n", "m:7: unexpected '3' after the last face"},
      {read_off, "OFF\n3 2 0\n" + points + "3 0 1 2   \n         \n", "the file ends after 1 of 2 faces"},
      {read_off, "OFF\n3 1 0\n0 0 0 1\n", "m:3: a vertex with 4 numbers does not fit"},
      {read_ply, "play\n", "m:1: expected 'ply' on the first line"},
      {read_ply, "ply\nformat ascii 2.0\n", "m:2: expected format version 1.0, found '2.0'"},
      {read_ply, "ply\nformat binary 1.0\n",
       "m:2: unknown format 'binary'; known are ascii, binary_little_endian, binary_big_endian"},
      {read_ply, ply + "element vertex three\n", "m:3: expected the number of elements (an integer), found 'three'"},
      {read_ply, ply + "property float x\n", "m:3: a property before the first element"},
      {read_ply, ply + "element vertex 1\nproperty real x\n", "m:4: unknown type 'real'"},
      {read_ply, ply + "element vertex 1\nproperty list float int x\n",
       "m:4: the length of a list must have an integer type"},
      {read_ply, ply + "element a 99999999\nend_header\n", "m:3: element 'a' has no properties"},
      {read_ply, ply + vertex + "property int x\n", "m:7: property 'x' is declared twice"},
      {read_ply, ply + vertex + vertex, "m:7: element 'vertex' is declared twice"},
      {read_ply, ply + vertex + "end_header\n", "declares no element 'face'"},
      {read_ply, ply + "element vertex 3\nproperty float x\nproperty float y\n" + face + "end_header\n",
       "m:3: element 'vertex' has no number 'z'"},
      {read_ply, ply + vertex + "element face 1\nproperty int a\nend_header\n",
       "m:7: element 'face' needs exactly one list vertex_indices"},
      {read_ply, ply + vertex, "the file ends before 'end_header'"},
      {read_ply, ply + vertex + face + "end_header\n" + points + "3 0 1 5\n", "m:13: there is no vertex 5"},
      {read_ply, ply + vertex + face + "end_header\n" + points + "3 0 1 2 9\n",
       "m:13: unexpected '9' after the properties of this element"},
      {read_ply, ply + vertex + face + "end_header\n" + points + "3 0 1 2\n1",
       "m:14: unexpected '1' after the last element"},
      {read_stl, "solid a\nfacet normal 0 0 1\nouter lop\n", "m:3: expected 'outer loop', found 'lop'"},
      {read_stl, "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", "m:4: expected a coordinate of a vertex"},
      {read_stl, "solid a\n", "the file ends where 'endsolid' is expected"},
      {read_stl, "neither of them", "neither a text STL file"}};
  for (const Sample& sample : samples) {
    INFO(sample.content);
    CHECK_THAT(error_of(sample.read, sample.content), Catch::Matchers::Contains(sample.message));
  }
}

TEST_CASE("mesh reader: counts are checked against the file before memory is taken", "[reader]") {
  const auto binary_ply = [](const std::string& vertices, const std::string& faces) {
    return "ply\nformat binary_little_endian 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\n" + "element face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n" + std::string(36, '\0');
  };
  const auto mentions = [](const char* text) { return Catch::Matchers::Contains(text); };
  CHECK_THAT(error_of(read_ply, binary_ply("4", "0")), mentions("only 36 bytes are left"));
  CHECK_THAT(error_of(read_ply, binary_ply("9000000000000000000", "1")), mentions("at least 12 bytes each"));
  CHECK_THAT(error_of(read_ply, binary_ply("1", "1000000000")), mentions("1000000000 of element 'face'"));
  CHECK_THAT(error_of(read_ply, binary_ply("2", "0")), mentions("12 bytes are left after the last element"));
  std::string nan = binary_ply("3", "0");
  nan[nan.size() - 1] = '\x7f';
  nan[nan.size() - 2] = '\xc0';
  CHECK_THAT(error_of(read_ply, nan), mentions("expected a coordinate of a vertex that is finite, found nan"));
  std::string stl = as_binary_stl(triangulated_cube());
  CHECK(error_of(read_stl, stl).empty());
  stl.pop_back();
  CHECK_FALSE(error_of(read_stl, stl).empty());
}

TEST_CASE("mesh reader: files that are not what their name says", "[reader]") {
  const test::ScratchDir dir;
  const auto message_of = [](const std::filesystem::path& file) -> std::string {
    try {
      read_mesh(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const auto mentions = [](const std::string& text) { return Catch::Matchers::Contains(text); };
  CHECK_THAT(message_of(dir / "nothing.obj"), mentions("nothing.obj: no such file"));
  CHECK_THAT(message_of(dir.path()), mentions("unknown mesh format"));
  std::filesystem::create_directory(dir / "folder.obj");
  CHECK_THAT(message_of(dir / "folder.obj"), mentions("not a regular file"));
  CHECK_THAT(message_of(write(dir, "a.vtk", "x")), mentions("must be a .obj, .off, .ply or .stl file"));
  CHECK_THAT(message_of(write(dir, "a.obj", "")), mentions("the file is empty"));
  CHECK_THAT(message_of(write(dir, "b.obj", as_off(test::cube()))), mentions("the content is that of a .off file"));
  CHECK_THAT(message_of(write(dir, "b.off", as_text_ply(test::cube()))),
             mentions("the content is that of a .ply file"));
  CHECK_THAT(message_of(write(dir, "b.ply", as_obj(test::cube()))), mentions("the content is that of a .obj file"));
  CHECK_THAT(message_of(write(dir, "c.off", as_text_stl(triangulated_cube()))),
             mentions("the content is that of a .stl file"));
  CHECK_THAT(message_of(write(dir, "c.obj", "v 1 2 3\nv 1 2 4\n")), mentions("no faces (2 vertices)"));
}

TEST_CASE("mesh reader: damaged files end in an error or a mesh, never otherwise", "[reader][fuzz]") {
  UNSCOPED_INFO("seed " << kReaderSeed);
  std::mt19937_64 engine(kReaderSeed);
  const PolygonSoup cube = test::cube();
  const std::vector<std::pair<Reader, std::string>> files = {
      {read_obj, as_obj(cube) + "vt 0 1\nvn 0 0 1\nf 1/1/1 2/1/1 -1/1/1\n"},
      {read_off, as_off(cube)},
      {read_ply, as_text_ply(cube)},
      {read_ply, as_binary_ply(cube, std::endian::little)},
      {read_ply, as_binary_ply(cube, std::endian::big)},
      {read_stl, as_text_stl(triangulated_cube())},
      {read_stl, as_binary_stl(triangulated_cube())}};
  const auto attempt = [](Reader read, const std::string& content) {
    try {
      const PolygonSoup soup = read(content, "m", {});
      // What was read fits into what was there.
      REQUIRE(soup.positions.size() <= content.size());
      REQUIRE(soup.corners.size() <= content.size());
      inspect(TriangleMesh(soup));
    } catch (const InputError& error) {
      REQUIRE(std::string(error.what()).size() < 1000);
    }
  };
  for (const auto& [read, content] : files) {
    REQUIRE_NOTHROW(read(content, "m", {}));
    for (std::size_t size = 0; size < content.size(); ++size) attempt(read, content.substr(0, size));
    for (int round = 0; round < 3000; ++round) {
      std::string damaged = content;
      for (std::uint64_t flips = 1 + engine() % 4; flips > 0; --flips) {
        char& byte = damaged[engine() % damaged.size()];
        const std::uint64_t kind = engine() % 3;
        byte = kind == 0   ? static_cast<char>(engine() % 256)
               : kind == 1 ? "-9\\/ \n\r#e.0"[engine() % 11]
                           : static_cast<char>(byte ^ (1 << engine() % 8));
      }
      attempt(read, damaged);
      // Once more with a piece repeated or cut out.
      const std::size_t from = engine() % damaged.size(), length = engine() % 64;
      attempt(read, damaged.substr(0, from) + damaged.substr(std::min(damaged.size(), from + length)));
      attempt(read, damaged.substr(0, std::min(damaged.size(), from + length)) + damaged.substr(from));
    }
  }
}

TEST_CASE("mesh reader: an installed model is the closed surface that it is known to be", "[reader]") {
  const auto file = test::installed_model("glmark2/models/bunny.obj");
  if (!file) return;
  const TriangleMesh mesh(read_mesh(*file));
  const MeshReport report = inspect(mesh);
  // A closed surface without handles: 2 (V - 2) triangles.
  CHECK(report.components.size() == 1);
  CHECK(report.components[0].genus == 0);
  CHECK(report.boundary_loops == 0);
  CHECK(report.faces == 2 * (report.vertices - 2));
}

}  // namespace leastcost
