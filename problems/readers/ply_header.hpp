// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "problems/readers/text_scanner.hpp"

namespace leastcost {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyFormat { text, little_endian, big_endian };

std::size_t ply_size(PlyType type);
bool ply_is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
  std::size_t line = 0;  ///< where the header names it
};

struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::vector<PlyElement> elements;
};

/// Reads from 'ply' to 'end_header'; the scanner stays on that line. Throws InputError on anything that is not PLY 1.0:
/// names twice, elements without properties, types that do not exist.
PlyHeader read_ply_header(TextScanner& scanner);

}  // namespace leastcost
