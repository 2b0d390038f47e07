// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Stanford PLY 1.0, text and binary: x, y, z of 'vertex' and the list vertex_indices (or vertex_index) of 'face'. Other
// properties and elements are passed over.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>

#include "problems/readers/format_readers.hpp"
#include "problems/readers/ply_values.hpp"

namespace leastcost {
namespace {

bool is_index_list(const PlyProperty& p) {
  return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
}

/// Vertices that a face can refer to, from the header: the faces may come first.
const PlyElement& check_header(const PlyHeader& header, const TextScanner& scanner) {
  const auto find = [&](std::string_view name) -> const PlyElement& {
    for (const PlyElement& element : header.elements) {
      if (element.name == name) return element;
    }
    scanner.fail("the header declares no element '" + std::string(name) + "'; a mesh needs vertex and face");
  };
  const PlyElement& vertex = find("vertex");
  for (const char* axis : {"x", "y", "z"}) {
    const auto is_axis = [&](const PlyProperty& p) { return p.name == axis && !p.is_list; };
    if (std::any_of(vertex.properties.begin(), vertex.properties.end(), is_axis)) continue;
    scanner.fail_at(vertex.line, std::string("element 'vertex' has no number '") + axis + "'");
  }
  const PlyElement& face = find("face");
  const auto list_count = std::count_if(face.properties.begin(), face.properties.end(), is_index_list);
  if (list_count != 1)
    scanner.fail_at(face.line, "element 'face' needs exactly one list vertex_indices (or vertex_index)");
  const PlyProperty& list = *std::find_if(face.properties.begin(), face.properties.end(), is_index_list);
  if (!ply_is_integer(list.type)) scanner.fail_at(face.line, "the list of vertex indices must have an integer type");
  return vertex;
}

template <class Values>
class PlyBody {
 public:
  PlyBody(Values& values, std::size_t vertex_count)
      : values_(values), vertex_count_(static_cast<std::int64_t>(vertex_count)) {
    soup_.polygon_begin.push_back(0);
  }

  void read(const PlyElement& element) {
    std::size_t least = least_bytes(values_, element);
    for (const PlyProperty& p : element.properties)
      if (element.name == "face" && is_index_list(p)) least += 3 * values_.least_bytes(p.type);
    check_count(values_, element, least);
    if (element.name == "vertex") soup_.positions.reserve(element.count);
    if (element.name == "face") soup_.polygon_begin.reserve(element.count + 1);
    if (element.name == "face") soup_.corners.reserve(3 * element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.begin_record();
      if (element.name == "vertex") {
        read_vertex(element);
      } else if (element.name == "face") {
        read_face(element);
      } else {
        for (const PlyProperty& p : element.properties) skip_property(values_, p);
      }
      values_.end_record();
    }
  }

  PolygonSoup take() { return std::move(soup_); }

 private:
  void read_vertex(const PlyElement& element) {
    Eigen::Vector3d position;
    for (const PlyProperty& p : element.properties) {
      const bool is_axis = !p.is_list && p.name.size() == 1 && p.name[0] >= 'x' && p.name[0] <= 'z';
      if (is_axis) {
        position[p.name[0] - 'x'] = values_.number(p.type, "a coordinate of a vertex");
      } else {
        skip_property(values_, p);
      }
    }
    soup_.positions.push_back(position);
  }

  void read_face(const PlyElement& element) {
    for (const PlyProperty& p : element.properties) {
      if (!is_index_list(p)) {
        skip_property(values_, p);
        continue;
      }
      const std::int64_t count = values_.integer(p.count_type, "the number of corners of a face");
      if (count < 3) values_.fail("a face needs at least 3 corners, found " + std::to_string(count));
      for (std::int64_t k = 0; k < count; ++k) {
        const std::int64_t vertex = values_.integer(p.type, "a vertex number of a face");
        if (vertex < 0 || vertex >= vertex_count_) {
          values_.fail("there is no vertex " + std::to_string(vertex) + "; the file has " +
                       std::to_string(vertex_count_) + " vertices numbered from 0");
        }
        soup_.corners.push_back(static_cast<std::int32_t>(vertex));
      }
    }
    if (soup_.corners.size() > kMaxElements) values_.fail("more corners than 32-bit numbers can count");
    soup_.polygon_begin.push_back(static_cast<std::int32_t>(soup_.corners.size()));
  }

  Values& values_;
  std::int64_t vertex_count_;
  PolygonSoup soup_;
};

template <class Values>
PolygonSoup read_body(Values values, const PlyHeader& header, std::size_t vertex_count) {
  PlyBody<Values> body(values, vertex_count);
  for (const PlyElement& element : header.elements) body.read(element);
  values.end_body();
  return body.take();
}

}  // namespace

PolygonSoup read_ply(std::string_view content, const std::string& file, const Deadline& deadline) {
  TextScanner scanner(content, file, {0, false}, deadline);
  const PlyHeader header = read_ply_header(scanner);
  const std::size_t vertex_count = check_header(header, scanner).count;
  return with_ply_values(scanner, header, content, file,
                         [&](auto values) { return read_body(std::move(values), header, vertex_count); });
}

}  // namespace leastcost
