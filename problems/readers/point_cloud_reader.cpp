// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/readers/point_cloud_reader.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/readers/file_content.hpp"
#include "problems/readers/ply_values.hpp"

namespace leastcost {
namespace {

constexpr std::array<std::string_view, 4> kTextExtensions = {".xyz", ".txt", ".csv", ".asc"};

bool is_separator(char c) { return c == ',' || c == ';'; }

/// Blanks in place of commas and semicolons, each of which must stand between two values.
std::string without_separators(std::string text, const std::string& file) {
  std::size_t line = 1;
  bool value = false, comment = false;
  for (char& c : text) {
    if (c == '\n') {
      ++line;
      value = comment = false;
    } else if (c == '#') {
      comment = true;
    } else if (is_separator(c) && !comment) {
      if (!value) throw InputError(file + ":" + std::to_string(line) + ": a value is missing before '" + c + "'");
      value = false;
      c = ' ';
    } else if (c != ' ' && c != '\t' && c != '\r') {
      value = true;
    }
  }
  return text;
}

PointSamples read_xyz(const std::string& content, const std::string& file) {
  const std::string text = without_separators(content, file);
  TextScanner scanner(text, file, {});
  PointSamples samples;
  std::array<double, 6> row{};
  std::size_t columns = 0;
  while (scanner.next_line()) {
    std::size_t count = 0;
    for (; !scanner.at_line_end() && count < row.size(); ++count) row[count] = scanner.number("a coordinate");
    if (!scanner.at_line_end()) scanner.fail("more than 6 values; a row is x y z or x y z nx ny nz");
    if (count != 3 && count != 6)
      scanner.fail(std::to_string(count) + (count == 1 ? " value" : " values") + "; a row is x y z or x y z nx ny nz");
    if (columns == 0) columns = count;
    if (count != columns)
      scanner.fail(std::to_string(count) + " values, but the first row has " + std::to_string(columns));
    samples.positions.emplace_back(row[0], row[1], row[2]);
    if (count == 6) samples.normals.emplace_back(row[3], row[4], row[5]);
    if (samples.positions.size() > kMaxElements) scanner.fail("more points than 32-bit numbers can count");
  }
  return samples;
}

/// 0, 1, 2 for x, y, z and 3, 4, 5 for nx, ny, nz.
std::optional<std::size_t> slot_of(const PlyProperty& p) {
  constexpr std::array<std::string_view, 6> kNames = {"x", "y", "z", "nx", "ny", "nz"};
  const auto* const it = std::find(kNames.begin(), kNames.end(), p.name);
  if (p.is_list || it == kNames.end()) return std::nullopt;
  return static_cast<std::size_t>(it - kNames.begin());
}

/// Whether the vertices have normals.
bool check_point_header(const PlyHeader& header, const TextScanner& scanner) {
  const auto vertex = std::find_if(header.elements.begin(), header.elements.end(),
                                   [](const PlyElement& e) { return e.name == "vertex"; });
  if (vertex == header.elements.end()) scanner.fail("the header declares no element 'vertex'");
  std::array<bool, 6> has{};
  for (const PlyProperty& p : vertex->properties)
    if (const auto slot = slot_of(p)) has[*slot] = true;
  constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (has[axis]) continue;
    std::string message = "element 'vertex' has no number ";
    message += kAxes[axis];
    scanner.fail_at(vertex->line, message);
  }
  const auto normals = std::count(has.begin() + 3, has.end(), true);
  if (normals != 0 && normals != 3) scanner.fail_at(vertex->line, "a normal needs nx, ny and nz");
  return normals == 3;
}

template <class Values>
PointSamples read_elements(Values values, const PlyHeader& header, bool normals) {
  PointSamples samples;
  std::array<double, 6> row{};
  for (const PlyElement& element : header.elements) {
    check_count(values, element, least_bytes(values, element));
    const bool vertices = element.name == "vertex";
    if (vertices) samples.positions.reserve(element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      values.begin_record();
      for (const PlyProperty& p : element.properties) {
        const auto slot = vertices ? slot_of(p) : std::nullopt;
        if (slot)
          row[*slot] = values.number(p.type, *slot < 3 ? "a coordinate of a vertex" : "a normal of a vertex");
        else
          skip_property(values, p);
      }
      values.end_record();
      if (vertices) samples.positions.emplace_back(row[0], row[1], row[2]);
      if (vertices && normals) samples.normals.emplace_back(row[3], row[4], row[5]);
    }
  }
  values.end_body();
  return samples;
}

PointSamples read_ply_points(const std::string& content, const std::string& file) {
  TextScanner scanner(content, file, {0, false});
  const PlyHeader header = read_ply_header(scanner);
  const bool normals = check_point_header(header, scanner);
  return with_ply_values(scanner, header, content, file,
                         [&](auto values) { return read_elements(std::move(values), header, normals); });
}

void normalise(PointSamples& samples) {
  std::size_t zeros = 0;
  for (Eigen::Vector3d& n : samples.normals) {
    const double length = n.stableNorm();
    if (length > 0)
      n /= length;
    else
      ++zeros;
  }
  if (zeros == 0) return;
  samples.normals.clear();
  samples.notes.push_back("the normals of the file are not used: " + std::to_string(zeros) + " of them are zero");
}

/// Keeps the first of equal points.
void remove_duplicates(PointSamples& samples) {
  const std::size_t n = samples.positions.size();
  std::vector<std::int32_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  const auto position = [&](std::int32_t i) -> const Eigen::Vector3d& {
    return samples.positions[static_cast<std::size_t>(i)];
  };
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    const auto &p = position(a), &q = position(b);
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end()) || (p == q && a < b);
  });
  std::vector<char> repeated(n, 0);
  for (std::size_t i = 1; i < n; ++i)
    if (position(order[i]) == position(order[i - 1])) repeated[static_cast<std::size_t>(order[i])] = 1;
  samples.count_in_file = static_cast<std::int32_t>(n);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (repeated[i] != 0) continue;
    samples.positions[kept] = samples.positions[i];
    if (!samples.normals.empty()) samples.normals[kept] = samples.normals[i];
    samples.in_file.push_back(static_cast<std::int32_t>(i));
    ++kept;
  }
  if (kept == n) return;
  samples.positions.resize(kept);
  if (!samples.normals.empty()) samples.normals.resize(kept);
  samples.notes.push_back(std::to_string(n - kept) + " of " + std::to_string(n) +
                          " points removed: exact duplicates of earlier points");
}

}  // namespace

PointSamples read_point_cloud(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::string extension = lower_case(file.extension().string());
  const bool ply = extension == ".ply";
  if (!ply && std::count(kTextExtensions.begin(), kTextExtensions.end(), extension) == 0)
    throw InputError(name + ": unknown point cloud format " + printable(extension) +
                     "; a cloud must be a .ply, .xyz, .txt, .csv or .asc file");
  const std::string content = read_content(file);
  PointSamples samples = ply ? read_ply_points(content, name) : read_xyz(content, name);
  if (samples.positions.empty()) throw InputError(name + ": no points");
  samples.source = name;
  normalise(samples);
  remove_duplicates(samples);
  return samples;
}

}  // namespace leastcost
