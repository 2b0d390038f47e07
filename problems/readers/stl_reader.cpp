// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// STL, text and binary. Normals and attributes are left out; corners with equal positions become one vertex, numbered
// by first appearance, because the format cannot say that triangles share vertices.
#include <algorithm>
#include <bit>
#include <cctype>
#include <initializer_list>
#include <string>
#include <vector>

#include "problems/mesh/weld.hpp"
#include "problems/readers/byte_reader.hpp"
#include "problems/readers/format_readers.hpp"
#include "problems/readers/text_scanner.hpp"

namespace leastcost {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kTriangleBytes = 50;

/// Three corners per triangle -> shared vertices.
PolygonSoup share_vertices(const std::vector<Eigen::Vector3d>& corners) {
  const std::vector<std::int32_t> same_as = lowest_equal(corners);
  PolygonSoup soup;
  soup.corners.resize(corners.size());
  soup.polygon_begin.push_back(0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t lowest = static_cast<std::size_t>(same_as[i]);
    if (lowest == i) {
      soup.corners[i] = static_cast<std::int32_t>(soup.positions.size());
      soup.positions.push_back(corners[i]);
    } else {
      soup.corners[i] = soup.corners[lowest];
    }
    if (i % 3 == 2) soup.polygon_begin.push_back(static_cast<std::int32_t>(i + 1));
  }
  return soup;
}

PolygonSoup read_binary(std::string_view content, const std::string& file) {
  ByteReader reader(content, kHeaderBytes, file, std::endian::little);
  const std::size_t count = reader.read<std::uint32_t>("the number of triangles");
  if (count > kMaxElements / 3) reader.fail("more triangles than 32-bit numbers can count");
  std::vector<Eigen::Vector3d> corners;
  corners.reserve(3 * count);
  for (std::size_t f = 0; f < count; ++f) {
    reader.skip(3 * sizeof(float), "a normal");
    for (int corner = 0; corner < 3; ++corner) {
      Eigen::Vector3d position;
      for (int k = 0; k < 3; ++k) position[k] = static_cast<double>(reader.read<float>("a vertex"));
      if (!position.allFinite()) reader.fail("triangle " + std::to_string(f) + " has a coordinate that is not finite");
      corners.push_back(position);
    }
    reader.skip(sizeof(std::uint16_t), "an attribute");
  }
  return share_vertices(corners);
}

bool same_word(std::string_view token, std::string_view word) {
  return std::equal(token.begin(), token.end(), word.begin(), word.end(),
                    [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
}

void expect_words(TextScanner& scanner, std::initializer_list<const char*> words, const char* line) {
  for (const char* word : words) {
    const std::string_view token = scanner.token();
    if (!same_word(token, word)) {
      scanner.fail(std::string("expected '") + line + "', found " +
                   (token.empty() ? "the end of the line" : printable(token)));
    }
  }
}

void next_stl_line(TextScanner& scanner, const char* line) {
  if (!scanner.next_line()) scanner.fail(std::string("the file ends where '") + line + "' is expected");
}

/// From the rest of a line 'facet normal x y z' to 'endfacet'. The normal is not read: some programs write nan there.
void read_facet(TextScanner& scanner, std::vector<Eigen::Vector3d>& corners) {
  expect_words(scanner, {"normal"}, "facet normal x y z");
  next_stl_line(scanner, "outer loop");
  expect_words(scanner, {"outer", "loop"}, "outer loop");
  scanner.expect_line_end("'outer loop'");
  for (int corner = 0; corner < 3; ++corner) {
    next_stl_line(scanner, "vertex x y z");
    expect_words(scanner, {"vertex"}, "vertex x y z");
    Eigen::Vector3d position;
    for (int k = 0; k < 3; ++k) position[k] = scanner.number("a coordinate of a vertex (3 numbers)");
    scanner.expect_line_end("the 3 coordinates of a vertex");
    corners.push_back(position);
  }
  next_stl_line(scanner, "endloop");
  expect_words(scanner, {"endloop"}, "endloop");
  next_stl_line(scanner, "endfacet");
  expect_words(scanner, {"endfacet"}, "endfacet");
}

PolygonSoup read_text(std::string_view content, const std::string& file, const Deadline& deadline) {
  TextScanner scanner(content, file, {0, false}, deadline);
  std::vector<Eigen::Vector3d> corners;
  while (scanner.next_line()) {
    expect_words(scanner, {"solid"}, "solid name");
    while (true) {
      next_stl_line(scanner, "endsolid");
      const std::string_view token = scanner.token();
      if (same_word(token, "endsolid")) break;
      if (!same_word(token, "facet"))
        scanner.fail("expected 'facet normal x y z' or 'endsolid', found " + printable(token));
      read_facet(scanner, corners);
      if (corners.size() > kMaxElements - 3) scanner.fail("more triangles than 32-bit numbers can count");
    }
  }
  return share_vertices(corners);
}

}  // namespace

bool is_binary_stl(std::string_view content) {
  if (content.size() < kHeaderBytes + sizeof(std::uint32_t)) return false;
  ByteReader reader(content, kHeaderBytes, "", std::endian::little);
  const std::size_t count = reader.read<std::uint32_t>("the number of triangles");
  return reader.bytes_left() == count * kTriangleBytes;
}

PolygonSoup read_stl(std::string_view content, const std::string& file, const Deadline& deadline) {
  if (is_binary_stl(content)) return read_binary(content, file);
  TextScanner scanner(content, file, {0, false});
  if (scanner.next_line() && same_word(scanner.token(), "solid")) return read_text(content, file, deadline);
  throw InputError(file + ": " + std::to_string(content.size()) +
                   " bytes are neither a text STL file (which begins with 'solid') nor a binary one (84 bytes plus 50 "
                   "per triangle, counted in bytes 80 to 83)");
}

}  // namespace leastcost
