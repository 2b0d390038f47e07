// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Object File Format (Geomview), as text: [ST][C][N]OFF. Normals, colours and texture coordinates are checked and left
// out.
#include <algorithm>
#include <string>

#include "problems/readers/format_readers.hpp"
#include "problems/readers/text_scanner.hpp"

namespace leastcost {
namespace {

/// What a vertex line holds after its three coordinates.
struct Header {
  bool texture = false, colour = false, normal = false;

  bool allows(int extra) const {
    const int least = (texture ? 2 : 0) + (normal ? 3 : 0);
    // Colours are found under the plain header, too, with three or four numbers.
    const bool with_colour = (colour || least == 0) && (extra == least + 3 || extra == least + 4);
    return extra == least || with_colour;
  }
};

Header read_header(TextScanner& scanner) {
  if (!scanner.next_line()) scanner.fail("the file has no content; an OFF file begins with OFF");
  const std::string_view word = scanner.token();
  std::string_view rest = word;
  Header header;
  const auto take = [&rest](std::string_view prefix) {
    if (!rest.starts_with(prefix)) return false;
    rest.remove_prefix(prefix.size());
    return true;
  };
  header.texture = take("ST");
  header.colour = take("C");
  header.normal = take("N");
  if (rest != "OFF") {
    scanner.fail("expected the header OFF (or COFF, NOFF, STOFF), found " + printable(word) +
                 (rest == "4OFF" || rest == "nOFF" || rest == "4nOFF" ? "; only three dimensions are supported" : ""));
  }
  return header;
}

/// `least_bytes`: the shortest line that describes one such thing, with its end.
std::size_t read_count(TextScanner& scanner, const char* what, std::size_t least_bytes) {
  const std::int64_t count = scanner.integer(what);
  if (count < 0) scanner.fail(std::string("expected ") + what + ", found " + std::to_string(count));
  if (static_cast<std::uint64_t>(count) > std::min(kMaxElements, scanner.bytes_left() / least_bytes + 1)) {
    scanner.fail(std::string(what) + " is " + std::to_string(count) + ", but the file has only " +
                 std::to_string(scanner.bytes_left()) + " bytes left");
  }
  return static_cast<std::size_t>(count);
}

void next_record(TextScanner& scanner, const char* what, std::size_t have, std::size_t count) {
  if (scanner.next_line()) return;
  scanner.fail("the file ends after " + std::to_string(have) + " of " + std::to_string(count) + " " + what);
}

Eigen::Vector3d read_vertex(TextScanner& scanner, const Header& header) {
  Eigen::Vector3d position;
  for (int k = 0; k < 3; ++k) position[k] = scanner.number("a coordinate of a vertex (3 numbers)");
  int extra = 0;
  for (; !scanner.at_line_end(); ++extra) scanner.number("a normal, colour or texture coordinate");
  if (!header.allows(extra)) {
    scanner.fail("a vertex with " + std::to_string(3 + extra) + " numbers does not fit the header of the file");
  }
  return position;
}

void read_face(TextScanner& scanner, PolygonSoup& soup) {
  const std::int64_t corners = scanner.integer("the number of corners of a face");
  if (corners < 3) scanner.fail("a face needs at least 3 corners, found " + std::to_string(corners));
  for (std::int64_t k = 0; k < corners; ++k) {
    const std::int64_t vertex = scanner.integer("a vertex number of a face");
    if (vertex < 0 || vertex >= static_cast<std::int64_t>(soup.positions.size())) {
      scanner.fail("there is no vertex " + std::to_string(vertex) + "; the file has " +
                   std::to_string(soup.positions.size()) + " vertices numbered from 0");
    }
    soup.corners.push_back(static_cast<std::int32_t>(vertex));
  }
  int colour = 0;
  for (; !scanner.at_line_end(); ++colour) scanner.number("a colour of a face");
  if (colour > 4) scanner.fail("a face colour has at most 4 numbers, found " + std::to_string(colour));
  if (soup.corners.size() > kMaxElements) scanner.fail("more corners than 32-bit numbers can count");
  soup.polygon_begin.push_back(static_cast<std::int32_t>(soup.corners.size()));
}

}  // namespace

PolygonSoup read_off(std::string_view content, const std::string& file, const Deadline& deadline) {
  TextScanner scanner(content, file, {}, deadline);
  const Header header = read_header(scanner);
  if (scanner.at_line_end() && !scanner.next_line()) scanner.fail("expected the numbers of vertices, faces and edges");
  const std::size_t vertex_count = read_count(scanner, "the number of vertices", 6);  // "0 0 0\n"
  const std::size_t face_count = read_count(scanner, "the number of faces", 8);       // "3 0 0 0\n"
  if (!scanner.at_line_end()) scanner.integer("the number of edges");
  scanner.expect_line_end("the numbers of vertices, faces and edges");
  PolygonSoup soup;
  soup.positions.reserve(vertex_count);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    next_record(scanner, "vertices", v, vertex_count);
    soup.positions.push_back(read_vertex(scanner, header));
  }
  soup.corners.reserve(3 * face_count);
  soup.polygon_begin.reserve(face_count + 1);
  soup.polygon_begin.push_back(0);
  for (std::size_t f = 0; f < face_count; ++f) {
    next_record(scanner, "faces", f, face_count);
    read_face(scanner, soup);
  }
  if (scanner.next_line()) scanner.fail("unexpected " + printable(scanner.token()) + " after the last face");
  return soup;
}

}  // namespace leastcost
