// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "problems/readers/byte_reader.hpp"
#include "problems/readers/format_readers.hpp"
#include "problems/readers/ply_header.hpp"

/// The body of a PLY file, value by value, as text or binary behind one interface. Shared by the readers of meshes and
/// clouds.
namespace leastcost {

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
      fail(std::string("expected ") + what + " that is finite, found " +
           (std::isnan(value) ? "nan" : "an infinite one"));
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

/// Fewest bytes that one record of the element can take.
template <class Values>
std::size_t least_bytes(const Values& values, const PlyElement& element) {
  std::size_t least = 0;
  for (const PlyProperty& p : element.properties) least += values.least_bytes(p.is_list ? p.count_type : p.type);
  return least;
}

/// Before any memory is taken: can the rest of the file hold so many records of `least` bytes?
template <class Values>
void check_count(const Values& values, const PlyElement& element, std::size_t least) {
  if (element.count <= std::min(values.bytes_left() / least, kMaxElements)) return;
  values.fail("the header declares " + std::to_string(element.count) + " of element " + printable(element.name) +
              ", at least " + std::to_string(least) + " bytes each, but only " + std::to_string(values.bytes_left()) +
              " bytes are left");
}

template <class Values>
void skip_property(Values& values, const PlyProperty& p) {
  if (!p.is_list) return values.skip(p.type);
  const std::int64_t count = values.integer(p.count_type, "the length of a list");
  if (count < 0) values.fail("a list has the negative length " + std::to_string(count));
  for (std::int64_t k = 0; k < count; ++k) values.skip(p.type);
}

/// Calls read(values) with the values of the body in the format that the header states; the scanner is on the header's
/// last line.
template <class Read>
auto with_ply_values(TextScanner& scanner, const PlyHeader& header, std::string_view content, const std::string& file,
                     Read read) {
  if (header.format == PlyFormat::text) return read(TextValues(scanner));
  const std::endian order = header.format == PlyFormat::big_endian ? std::endian::big : std::endian::little;
  return read(BinaryValues(ByteReader(content, scanner.next_line_offset(), file, order)));
}

}  // namespace leastcost
