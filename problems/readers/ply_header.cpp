// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/readers/ply_header.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace leastcost {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> kTypeNames = {{{"char", PlyType::int8},
                                                  {"int8", PlyType::int8},
                                                  {"uchar", PlyType::uint8},
                                                  {"uint8", PlyType::uint8},
                                                  {"short", PlyType::int16},
                                                  {"int16", PlyType::int16},
                                                  {"ushort", PlyType::uint16},
                                                  {"uint16", PlyType::uint16},
                                                  {"int", PlyType::int32},
                                                  {"int32", PlyType::int32},
                                                  {"uint", PlyType::uint32},
                                                  {"uint32", PlyType::uint32},
                                                  {"float", PlyType::float32},
                                                  {"float32", PlyType::float32},
                                                  {"double", PlyType::float64},
                                                  {"float64", PlyType::float64}}};

PlyType read_type(TextScanner& scanner) {
  const std::string_view token = scanner.token();
  const auto match =
      std::find_if(kTypeNames.begin(), kTypeNames.end(), [&](const TypeName& t) { return t.name == token; });
  if (match == kTypeNames.end()) {
    scanner.fail("unknown type " + printable(token) +
                 "; known are char, uchar, short, ushort, int, uint, float, double and int8 ... float64");
  }
  return match->type;
}

PlyFormat read_format(TextScanner& scanner) {
  const std::string_view name = scanner.token();
  const std::string_view version = scanner.token();
  if (version != "1.0") scanner.fail("expected format version 1.0, found " + printable(version));
  if (name == "ascii") return PlyFormat::text;
  if (name == "binary_little_endian") return PlyFormat::little_endian;
  if (name == "binary_big_endian") return PlyFormat::big_endian;
  scanner.fail("unknown format " + printable(name) + "; known are ascii, binary_little_endian, binary_big_endian");
}

template <class Named>
bool has_name(const std::vector<Named>& list, std::string_view name) {
  return std::any_of(list.begin(), list.end(), [&](const Named& item) { return item.name == name; });
}

PlyElement read_element(TextScanner& scanner, const PlyHeader& header) {
  PlyElement element;
  element.name = scanner.token();
  element.line = scanner.line();
  if (has_name(header.elements, element.name))
    scanner.fail("element " + printable(element.name) + " is declared twice");
  const std::int64_t count = scanner.integer("the number of elements");
  if (count < 0) scanner.fail("the number of elements is negative");
  element.count = static_cast<std::size_t>(count);
  return element;
}

PlyProperty read_property(TextScanner& scanner, const PlyHeader& header) {
  if (header.elements.empty()) scanner.fail("a property before the first element");
  PlyProperty property;
  TextScanner ahead = scanner;
  if (ahead.token() == "list") {
    scanner.token();
    property.is_list = true;
    property.count_type = read_type(scanner);
    if (!ply_is_integer(property.count_type)) scanner.fail("the length of a list must have an integer type");
  }
  property.type = read_type(scanner);
  property.name = scanner.token();
  if (property.name.empty()) scanner.fail("expected the name of a property, found the end of the line");
  if (has_name(header.elements.back().properties, property.name)) {
    scanner.fail("property " + printable(property.name) + " is declared twice");
  }
  return property;
}

}  // namespace

std::size_t ply_size(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8: return 1;
    case PlyType::int16:
    case PlyType::uint16: return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32: return 4;
    case PlyType::float64: break;
  }
  return 8;
}

bool ply_is_integer(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

PlyHeader read_ply_header(TextScanner& scanner) {
  if (!scanner.next_line() || scanner.token() != "ply") scanner.fail("expected 'ply' on the first line");
  scanner.expect_line_end("'ply'");
  PlyHeader header;
  bool has_format = false;
  while (scanner.next_line()) {
    const std::string_view keyword = scanner.token();
    if (keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "end_header") {
      if (!has_format) scanner.fail("no format line before the end of the header");
      for (const PlyElement& element : header.elements) {
        if (element.properties.empty())
          scanner.fail_at(element.line, "element " + printable(element.name) + " has no properties");
      }
      return header;
    }
    if (keyword == "format" && !has_format) {
      header.format = read_format(scanner);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(read_element(scanner, header));
    } else if (keyword == "property") {
      PlyProperty property = read_property(scanner, header);  // checks that there is an element
      header.elements.back().properties.push_back(std::move(property));
    } else {
      scanner.fail("unexpected " + printable(keyword) +
                   " in the header; expected format (once), comment, obj_info, element, property or end_header");
    }
    scanner.expect_line_end("this declaration");
  }
  scanner.fail("the file ends before 'end_header'");
}

}  // namespace leastcost
