// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <bit>
#include <string>

#include "problems/readers/byte_reader.hpp"
#include "problems/readers/occupancy_reader.hpp"
#include "problems/readers/text_scanner.hpp"

namespace leastcost {
namespace {

constexpr std::int64_t kWhitest = 65535;

/// The next whole number, on this line or a later one; -1 where the text ends.
std::int64_t next_number(TextScanner& scanner, const char* what) {
  if (scanner.at_line_end() && !scanner.next_line()) scanner.fail(std::string("the file ends before ") + what);
  return scanner.integer(what);
}

void check_value(const TextScanner& scanner, std::int64_t value, int maximum) {
  if (value < 0 || value > maximum)
    scanner.fail("a pixel of " + std::to_string(value) + ", the header allows 0 to " + std::to_string(maximum));
}

void read_text(TextScanner& scanner, GreyImage& image) {
  for (std::uint16_t& value : image.values) {
    const std::int64_t read = next_number(scanner, "a pixel");
    check_value(scanner, read, image.maximum);
    value = static_cast<std::uint16_t>(read);
  }
}

void read_binary(std::string_view bytes, std::size_t start, const TextScanner& scanner, GreyImage& image) {
  ByteReader reader(bytes, start, image.source, std::endian::big);
  reader.skip(1, "the header");
  const bool wide = image.maximum > 255;
  if (reader.bytes_left() < image.values.size() * (wide ? 2 : 1))
    reader.fail(std::to_string(image.values.size()) + " pixels of " + (wide ? "two bytes" : "one byte") +
                " are announced, but " + std::to_string(reader.bytes_left()) + " bytes are left");
  for (std::uint16_t& value : image.values) {
    value = wide ? reader.read<std::uint16_t>("a pixel") : reader.read<std::uint8_t>("a pixel");
    check_value(scanner, value, image.maximum);
  }
}

}  // namespace

GreyImage read_pgm(std::string_view bytes, const std::string& file) {
  TextScanner scanner(bytes, file, {.comment = '#'});
  if (!scanner.next_line()) scanner.fail("the file has no content; a PGM begins with P2 or P5");
  const std::string_view kind = scanner.token();
  if (kind != "P2" && kind != "P5") scanner.fail("expected P2 or P5, found " + printable(kind));
  GreyImage image;
  image.source = file;
  const std::int64_t columns = next_number(scanner, "a width"), rows = next_number(scanner, "a height");
  check_map_size(rows, columns, file + ":" + std::to_string(scanner.line()));
  const std::int64_t maximum = next_number(scanner, "the largest value");
  if (maximum < 1 || maximum > kWhitest)
    scanner.fail("the largest value must be between 1 and 65535, not " + std::to_string(maximum));
  if (static_cast<std::int64_t>(scanner.bytes_left()) < rows * columns)
    scanner.fail(std::to_string(rows * columns) + " pixels are announced, but " + std::to_string(scanner.bytes_left()) +
                 " bytes are left");
  image.rows = static_cast<int>(rows);
  image.columns = static_cast<int>(columns);
  image.maximum = static_cast<int>(maximum);
  image.values.resize(static_cast<std::size_t>(rows * columns));
  if (kind == "P2")
    read_text(scanner, image);
  else
    read_binary(bytes, bytes.size() - scanner.bytes_left(), scanner, image);
  return image;
}

}  // namespace leastcost
