// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Wavefront OBJ: positions and polygons are kept; normals, texture coordinates, groups, materials, points and lines are
// checked as far as their numbers go and left out.
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "problems/readers/format_readers.hpp"
#include "problems/readers/text_scanner.hpp"

namespace leastcost {
namespace {

constexpr std::array kIgnored = {"g",      "o",        "s",        "usemtl",     "mtllib",   "l",
                                 "p",      "vp",       "mg",       "lod",        "bevel",    "usemap",
                                 "maplib", "c_interp", "d_interp", "shadow_obj", "trace_obj"};
constexpr std::array kFreeForm = {"cstype", "deg",  "bmat", "step", "curv", "curv2", "surf",  "parm",
                                  "trim",   "hole", "scrv", "sp",   "end",  "con",   "ctech", "stech"};

template <class List>
bool contains(const List& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// How many elements of one kind there are, and the highest number used: an element may come after the face that uses
/// it.
struct Numbering {
  const char* name;
  std::int64_t count = 0;
  std::int64_t highest = 0;
  std::size_t highest_line = 0;
};

class ObjReader {
 public:
  ObjReader(std::string_view content, const std::string& file, const Deadline& deadline)
      : scanner_(content, file, {'#', true}, deadline) {
    soup_.polygon_begin.push_back(0);
  }

  PolygonSoup read() {
    while (scanner_.next_line()) read_line(scanner_.token());
    for (const Numbering* n : {&vertices_, &textures_, &normals_}) {
      if (n->highest <= n->count) continue;
      scanner_.fail_at(n->highest_line, std::string("there is no ") + n->name + " " + std::to_string(n->highest) +
                                            "; the file has " + std::to_string(n->count));
    }
    return std::move(soup_);
  }

 private:
  void read_line(std::string_view keyword) {
    if (keyword == "v") {
      read_vertex();
    } else if (keyword == "f") {
      read_face();
    } else if (keyword == "vn") {
      for (int k = 0; k < 3; ++k) scanner_.number("a coordinate of a normal (3 numbers)");
      scanner_.expect_line_end("the 3 numbers of a normal");
      ++normals_.count;
    } else if (keyword == "vt") {
      scanner_.number("a texture coordinate (1 to 3 numbers)");
      for (int k = 1; k < 3 && !scanner_.at_line_end(); ++k) scanner_.number("a texture coordinate (1 to 3 numbers)");
      scanner_.expect_line_end("the 3 numbers of a texture coordinate");
      ++textures_.count;
    } else if (contains(kFreeForm, keyword)) {
      scanner_.fail("free-form geometry (" + printable(keyword) + ") is not supported; export polygons instead");
    } else if (!contains(kIgnored, keyword)) {
      scanner_.fail("unknown keyword " + printable(keyword) +
                    "; known are v, vn, vt, vp, f, l, p, g, o, s, usemtl, mtllib");
    }
  }

  void read_vertex() {
    if (soup_.positions.size() >= kMaxElements) scanner_.fail("more vertices than 32-bit numbers can count");
    Eigen::Vector3d position;
    for (int k = 0; k < 3; ++k) position[k] = scanner_.number("a coordinate of a vertex (3 numbers)");
    // Then a weight, which polygons do not use, or a colour.
    int more = 0;
    for (; !scanner_.at_line_end(); ++more) scanner_.number("a weight or colour of a vertex");
    if (more != 0 && more != 1 && more != 3 && more != 4) {
      scanner_.fail("a vertex must have 3 numbers, 4 with a weight, or 6 or 7 with a colour; found " +
                    std::to_string(3 + more));
    }
    soup_.positions.push_back(position);
    ++vertices_.count;
  }

  void read_face() {
    const std::size_t first = soup_.corners.size();
    while (!scanner_.at_line_end()) read_corner(scanner_.token());
    const std::size_t corners = soup_.corners.size() - first;
    if (corners < 3) scanner_.fail("a face needs at least 3 corners, found " + std::to_string(corners));
    if (soup_.corners.size() > kMaxElements) scanner_.fail("more corners than 32-bit numbers can count");
    soup_.polygon_begin.push_back(static_cast<std::int32_t>(soup_.corners.size()));
  }

  /// v, v/vt, v//vn or v/vt/vn.
  void read_corner(std::string_view token) {
    const std::size_t slash = token.find('/');
    soup_.corners.push_back(static_cast<std::int32_t>(reference(token.substr(0, slash), token, vertices_)) - 1);
    if (slash == std::string_view::npos) return;
    const std::string_view rest = token.substr(slash + 1);
    const std::size_t second = rest.find('/');
    const std::string_view texture = rest.substr(0, second);
    if (!texture.empty() || second == std::string_view::npos) reference(texture, token, textures_);
    if (second != std::string_view::npos) reference(rest.substr(second + 1), token, normals_);
  }

  /// The number from 1 that a reference means; negative ones count back from the latest element.
  std::int64_t reference(std::string_view digits, std::string_view corner, Numbering& elements) {
    if (digits.empty()) scanner_.fail("expected a corner like 1, 1/2, 1//3 or 1/2/3, found " + printable(corner));
    std::int64_t value = scanner_.parse_integer(digits, "a corner like 1, 1/2, 1//3 or 1/2/3");
    if (value < 0 && value >= -elements.count) value += elements.count + 1;
    if (value <= 0 || value > static_cast<std::int64_t>(kMaxElements)) {
      scanner_.fail(std::string("there is no ") + elements.name + " " + std::string(digits.substr(0, 24)) +
                    "; numbers start at 1, and " + std::to_string(elements.count) +
                    " come before this line (-1 is the latest)");
    }
    if (value > elements.highest) {
      elements.highest = value;
      elements.highest_line = scanner_.line();
    }
    return value;
  }

  TextScanner scanner_;
  PolygonSoup soup_;
  Numbering vertices_{"vertex"}, textures_{"texture coordinate"}, normals_{"normal"};
};

}  // namespace

PolygonSoup read_obj(std::string_view content, const std::string& file, const Deadline& deadline) {
  return ObjReader(content, file, deadline).read();
}

}  // namespace leastcost
