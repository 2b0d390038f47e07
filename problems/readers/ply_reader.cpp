// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Stanford PLY 1.0, text and binary: x, y, z of 'vertex' and the list vertex_indices (or vertex_index) of 'face'. Other
// properties and elements are passed over.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "problems/readers/byte_reader.hpp"
#include "problems/readers/format_readers.hpp"
#include "problems/readers/ply_header.hpp"

namespace leastcost {
namespace {

/// The values of the body as text: one line per element.
class TextValues {
 public:
  explicit TextValues(TextScanner& scanner) : scanner_(scanner) {}
  void begin_record() {
    if (!scanner_.next_line()) fail("the file ends before its last element");
  }
  void end_record() { scanner_.expect_line_end("the properties of this element"); }
  double number(PlyType, const char* what) { return scanner_.number(what); }
  std::int64_t integer(PlyType, const char* what) { return scanner_.integer(what); }
  void skip(PlyType) {
    if (scanner_.token().empty()) fail("expected the value of a property, found the end of the line");
  }
  std::size_t least_bytes(PlyType) const { return 2; }  // a digit and what separates it from the next
  std::size_t bytes_left() const { return scanner_.bytes_left() + 1; }
  void end_body() {
    if (scanner_.next_line()) fail("unexpected " + printable(scanner_.token()) + " after the last element");
  }
  [[noreturn]] void fail(const std::string& message) const { scanner_.fail(message); }

 private:
  TextScanner& scanner_;
};

class BinaryValues {
 public:
  explicit BinaryValues(ByteReader reader) : reader_(std::move(reader)) {}
  void begin_record() {}
  void end_record() {}
  double number(PlyType type, const char* what) {
    const double value = read<double>(type, what);
    if (!std::isfinite(value))
      fail(std::string("expected ") + what + " that is finite, found " + std::to_string(value));
    return value;
  }
  std::int64_t integer(PlyType type, const char* what) { return read<std::int64_t>(type, what); }
  void skip(PlyType type) { reader_.skip(ply_size(type), "a property"); }
  std::size_t least_bytes(PlyType type) const { return ply_size(type); }
  std::size_t bytes_left() const { return reader_.bytes_left(); }
  void end_body() {
    if (bytes_left() > 0) fail(std::to_string(bytes_left()) + " bytes are left after the last element");
  }
  [[noreturn]] void fail(const std::string& message) const { reader_.fail(message); }

 private:
  template <class To>
  To read(PlyType type, const char* what) {
    switch (type) {
      case PlyType::int8: return static_cast<To>(reader_.read<std::int8_t>(what));
      case PlyType::uint8: return static_cast<To>(reader_.read<std::uint8_t>(what));
      case PlyType::int16: return static_cast<To>(reader_.read<std::int16_t>(what));
      case PlyType::uint16: return static_cast<To>(reader_.read<std::uint16_t>(what));
      case PlyType::int32: return static_cast<To>(reader_.read<std::int32_t>(what));
      case PlyType::uint32: return static_cast<To>(reader_.read<std::uint32_t>(what));
      case PlyType::float32: return static_cast<To>(reader_.read<float>(what));
      case PlyType::float64: break;
    }
    return static_cast<To>(reader_.read<double>(what));
  }

  ByteReader reader_;
};

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
    check_size(element);
    if (element.name == "vertex") soup_.positions.reserve(element.count);
    if (element.name == "face") soup_.polygon_begin.reserve(element.count + 1);
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.begin_record();
      if (element.name == "vertex") {
        read_vertex(element);
      } else if (element.name == "face") {
        read_face(element);
      } else {
        for (const PlyProperty& p : element.properties) skip(p);
      }
      values_.end_record();
    }
  }

  PolygonSoup take() { return std::move(soup_); }

 private:
  /// Before any memory is taken: can the rest of the file hold so many?
  void check_size(const PlyElement& element) const {
    std::size_t least = 0;
    for (const PlyProperty& p : element.properties) {
      least += values_.least_bytes(p.is_list ? p.count_type : p.type);
      if (element.name == "face" && is_index_list(p)) least += 3 * values_.least_bytes(p.type);
    }
    if (element.count > std::min(values_.bytes_left() / least, kMaxElements)) {
      values_.fail("the header declares " + std::to_string(element.count) + " of element " + printable(element.name) +
                   ", at least " + std::to_string(least) + " bytes each, but only " +
                   std::to_string(values_.bytes_left()) + " bytes are left");
    }
  }

  void skip(const PlyProperty& p) {
    if (!p.is_list) return values_.skip(p.type);
    const std::int64_t count = values_.integer(p.count_type, "the length of a list");
    if (count < 0) values_.fail("a list has the negative length " + std::to_string(count));
    for (std::int64_t k = 0; k < count; ++k) values_.skip(p.type);
  }

  void read_vertex(const PlyElement& element) {
    Eigen::Vector3d position;
    for (const PlyProperty& p : element.properties) {
      const bool is_axis = !p.is_list && p.name.size() == 1 && p.name[0] >= 'x' && p.name[0] <= 'z';
      if (is_axis) {
        position[p.name[0] - 'x'] = values_.number(p.type, "a coordinate of a vertex");
      } else {
        skip(p);
      }
    }
    soup_.positions.push_back(position);
  }

  void read_face(const PlyElement& element) {
    for (const PlyProperty& p : element.properties) {
      if (!is_index_list(p)) {
        skip(p);
        continue;
      }
      const std::int64_t count = values_.integer(p.count_type, "the number of corners of a face");
      if (count < 3) values_.fail("a face needs at least 3 corners, found " + std::to_string(count));
      for (std::int64_t k = 0; k < count; ++k) {
        const std::int64_t vertex = values_.integer(p.type, "a vertex number of a face");
        if (vertex < 0 || vertex >= vertex_count_) {
          values_.fail("there is no vertex " + std::to_string(vertex) + ", the file has " +
                       std::to_string(vertex_count_) + " vertices numbered from 0");
        }
        soup_.corners.push_back(static_cast<std::int32_t>(vertex));
      }
    }
    if (soup_.corners.size() > kMaxElements) values_.fail("more corners than 32-bit numbers can name");
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

PolygonSoup read_ply(std::string_view content, const std::string& file) {
  TextScanner scanner(content, file, {0, false});
  const PlyHeader header = read_ply_header(scanner);
  const std::size_t vertex_count = check_header(header, scanner).count;
  if (header.format == PlyFormat::text) return read_body(TextValues(scanner), header, vertex_count);
  const std::endian order = header.format == PlyFormat::big_endian ? std::endian::big : std::endian::little;
  return read_body(BinaryValues(ByteReader(content, scanner.next_line_offset(), file, order)), header, vertex_count);
}

}  // namespace leastcost
