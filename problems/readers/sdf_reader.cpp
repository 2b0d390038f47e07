// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/readers/sdf_reader.hpp"

#include <string>

#include "problems/readers/file_content.hpp"
#include "problems/readers/text_scanner.hpp"

namespace leastcost {
namespace {

void next_grid_line(TextScanner& scanner, const char* what) {
  if (!scanner.next_line()) scanner.fail(std::string("the file ends where ") + what + " should be");
}

GridShape read_grid_header(TextScanner& scanner, double memory) {
  GridShape shape;
  next_grid_line(scanner, "the number of nodes along x, y and z");
  double nodes = 1;
  for (int& count : shape.count) {
    const std::int64_t n = scanner.integer("a number of nodes");
    constexpr std::int64_t kMost = 1 << 20;
    if (n < GridShape::kFewest || n > kMost)
      scanner.fail(std::to_string(n) + " nodes along an axis; a cubic needs at least " +
                   std::to_string(GridShape::kFewest) + ", and the limit is " + std::to_string(kMost));
    count = static_cast<int>(n);
    nodes *= static_cast<double>(n);
  }
  scanner.expect_line_end("the number of nodes along x, y and z");
  if (kBytesPerNode * nodes > memory)
    scanner.fail("a grid of " + std::to_string(static_cast<long long>(nodes)) + " nodes takes " +
                 bytes_in_words(kBytesPerNode * nodes) + ", more than the memory limit of " + bytes_in_words(memory));
  next_grid_line(scanner, "the position of the first node");
  for (int axis = 0; axis < 3; ++axis) shape.origin[axis] = scanner.number("a coordinate of the first node");
  scanner.expect_line_end("the position of the first node");
  next_grid_line(scanner, "the cell size");
  shape.cell = scanner.number("the cell size");
  if (!(shape.cell > 0)) scanner.fail("the cell size must be positive");
  scanner.expect_line_end("the cell size");
  return shape;
}

}  // namespace

GridSamples read_sdf(std::string_view content, const std::string& file, double memory) {
  TextScanner scanner(content, file, {});
  GridSamples samples;
  samples.shape = read_grid_header(scanner, memory);
  const std::size_t nodes = samples.shape.nodes();
  samples.values.reserve(nodes);
  while (scanner.next_line()) {
    while (!scanner.at_line_end()) {
      if (samples.values.size() == nodes)
        scanner.fail("more values than the " + std::to_string(nodes) + " nodes of the grid");
      samples.values.push_back(scanner.number("a distance"));
    }
  }
  if (samples.values.size() != nodes)
    scanner.fail("the file ends after " + std::to_string(samples.values.size()) + " of " + std::to_string(nodes) +
                 " values");
  return samples;
}

GridSamples read_sdf(const std::filesystem::path& file, double memory) {
  return read_sdf(read_content(file), file.string(), memory);
}

}  // namespace leastcost
