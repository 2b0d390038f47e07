// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/field/field_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost::app {
namespace {

std::string csv(const CostField& field, const std::array<std::string, 2>& names) {
  std::string out = fmt::format("{},{},cost\n", names[0], names[1]);
  for (std::int32_t j = 0; j < field.count[1]; ++j)
    for (std::int32_t i = 0; i < field.count[0]; ++i) {
      const Eigen::Vector2d x = field.node(i, j);
      fmt::format_to(std::back_inserter(out), "{},{},{}\n", x.x(), x.y(), field.value(i, j));
    }
  return out;
}

/// Little-endian, whatever the host is.
void append(std::string& out, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  for (int byte = 0; byte < 8; ++byte) out += static_cast<char>(bits >> (8 * byte) & 0xFF);
}

std::string npy(const CostField& field) {
  constexpr std::size_t kLengthAt = 8, kBefore = 10, kAlignment = 64;
  std::string header =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}), }}", field.count[1], field.count[0]);
  header.append(kAlignment - 1 - (kBefore + header.size()) % kAlignment, ' ') += '\n';
  std::string out = std::string("\x93NUMPY\x01\x00", kLengthAt);
  out += static_cast<char>(header.size() & 0xFF);
  out += static_cast<char>(header.size() >> 8);
  out += header;
  out.reserve(out.size() + 8 * field.values.size());
  for (std::int32_t j = field.count[1] - 1; j >= 0; --j)
    for (std::int32_t i = 0; i < field.count[0]; ++i) append(out, field.value(i, j));
  return out;
}

std::string asc(const CostField& field) {
  constexpr double kRounding = 1e-9, kNoPath = -9999;
  if (std::abs(field.step.x() - field.step.y()) > kRounding * field.step.x())
    throw InputError(
        fmt::format("an .asc file needs cells with equal sides (found {} and {}): write .csv or .npy, or set "
                    "--resolution",
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

}  // namespace

FieldFormat field_format(std::string_view file) {
  const std::string_view ending = file.substr(std::min(file.size(), file.rfind('.')));
  if (ending == ".csv") return FieldFormat::csv;
  if (ending == ".npy") return FieldFormat::npy;
  if (ending == ".asc") return FieldFormat::asc;
  throw InputError(std::string(file) + ": a field can be written as .csv, .npy or .asc");
}

std::string field_text(const CostField& field, FieldFormat format, const std::array<std::string, 2>& names) {
  switch (format) {
    case FieldFormat::csv: return csv(field, names);
    case FieldFormat::npy: return npy(field);
    case FieldFormat::asc: return asc(field);
  }
  return "";
}

std::string ways_csv(const std::vector<FieldWay>& ways, const std::array<std::string, 2>& names) {
  std::string out = fmt::format("way,{},{}\n", names[0], names[1]);
  for (std::size_t k = 0; k < ways.size(); ++k)
    for (const Eigen::Vector2d& x : ways[k].points)
      fmt::format_to(std::back_inserter(out), "{},{},{}\n", k, x.x(), x.y());
  return out;
}

}  // namespace leastcost::app
