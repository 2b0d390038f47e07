// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Map files of all kinds, and what is said of those that do not fit.
#include "catalogue/inputs/map_file.hpp"

#include <array>
#include <fstream>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/inputs/png_image.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

/// Grey, 3 x 2: 0 254 205, 255 100 0.
constexpr std::array<unsigned char, 73> kGrey = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00, 0x00,
    0x03, 0x00, 0x00, 0x00, 0x02, 0x08, 0x00, 0x00, 0x00, 0x00, 0xb8, 0x1f, 0x39, 0xc6, 0x00, 0x00, 0x00, 0x10, 0x49,
    0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0x60, 0xf8, 0x77, 0x96, 0xe1, 0x7f, 0x0a, 0x03, 0x00, 0x0d, 0xc2, 0x03, 0x2f,
    0xd4, 0x52, 0x58, 0xa1, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
/// Red, green, blue, alpha: white, and white that is transparent.
constexpr std::array<unsigned char, 69> kTransparent = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
    0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x06, 0x00, 0x00, 0x00, 0xf4, 0x22, 0x7f, 0x8a, 0x00, 0x00, 0x00,
    0x0c, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0xf8, 0x0f, 0x01, 0x0c, 0x00, 0x22, 0xe6, 0x06, 0xfa, 0x08,
    0xfa, 0x02, 0x27, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

/// 11,000 x 11,000 pixels by its header, and 20 bytes of them.
constexpr std::array<unsigned char, 56> kVast = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00, 0x2a,
    0xf8, 0x00, 0x00, 0x2a, 0xf8, 0x08, 0x00, 0x00, 0x00, 0x00, 0xeb, 0x44, 0xc5, 0x56, 0x00, 0x00, 0x00, 0x0b, 0x49,
    0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0x60, 0xc0, 0x04, 0x00, 0x00, 0x14, 0x00, 0x01, 0x7d, 0xfe, 0x1e, 0xee};

template <std::size_t N>
std::string text_of(const std::array<unsigned char, N>& bytes) {
  return {bytes.begin(), bytes.end()};
}

void write_file(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string map_refusal(const std::filesystem::path& folder, const std::string& file) {
  try {
    OccupancyOptions options;
    options.file = file;
    options.cell = 7;
    read_map(options, folder);
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("map files: PNG") {
  const GreyImage image = read_png(text_of(kGrey), "a.png");
  CHECK((image.rows == 2 && image.columns == 3 && image.maximum == 255));
  CHECK(image.values == std::vector<std::uint16_t>{0, 254, 205, 255, 100, 0});
  const GreyImage transparent = read_png(text_of(kTransparent), "a.png");
  CHECK(transparent.maximum == 4 * 255);  // the mean of four channels, of which one is the opacity
  CHECK(transparent.values == std::vector<std::uint16_t>{4 * 255, 3 * 255});
  const std::string whole = text_of(kGrey);
  CHECK_THROWS_AS(read_png(whole.substr(0, 50), "a.png"), InputError);
  CHECK_THROWS_AS(read_png("no image", "a.png"), InputError);
  std::string flipped = whole;
  flipped[45] = static_cast<char>(flipped[45] ^ 1);
  CHECK_THROWS_AS(read_png(flipped, "a.png"), InputError);
  CHECK_THROWS_WITH(read_png(text_of(kVast), "a.png"),
                    "a.png: not a readable PNG image: 121000000 pixels are "
                    "announced, which do not fit in the 56 bytes of the file");
}

TEST_CASE("map files: a map_server YAML brings everything") {
  const ScratchDir folder;
  write_file(folder / "hall.png", text_of(kGrey));
  const std::string yaml =
      "image: hall.png\nresolution: 0.5\norigin: [-1.5, 2, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: "
      "0.196\n";
  write_file(folder / "hall.yaml", yaml);
  OccupancyOptions options;
  options.file = "hall.yaml";
  const OccupancyGrid grid = read_map(options, folder.path());
  CHECK((grid.rows == 2 && grid.columns == 3 && grid.cell == 0.5));
  CHECK(grid.origin == Eigen::Vector2d(-1.5, 2));
  CHECK((!grid.free(1, 0) && grid.free(1, 1) && !grid.free(1, 2)));
  CHECK((grid.free(0, 0) && !grid.free(0, 1) && !grid.free(0, 2)));

  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = yaml;
    changed.replace(changed.find(from), from.size(), to);
    write_file(folder / "b.yaml", changed);
    return map_refusal(folder.path(), "b.yaml");
  };
  CHECK(with("negate: 0", "negate: false\nmode: trinary") == "accepted");
  CHECK_THAT(with("0.5\n", "-0.5\n"), Catch::Contains("b.yaml:2:13") && Catch::Contains("greater than 0"));
  CHECK_THAT(with("0.0]", "0.3]"), Catch::Contains("b.yaml:3") && Catch::Contains("rotated"));
  CHECK_THAT(with(", 0.0]", "]"), Catch::Contains("three numbers"));
  CHECK_THAT(with("negate: 0", "mode: scale"), Catch::Contains("must be trinary"));
  CHECK_THAT(with("negate: 0", "negate: 2"), Catch::Contains("must be 0 or 1"));
  CHECK_THAT(with("occupied_thresh: 0.65\n", ""), Catch::Contains("missing key 'occupied_thresh'"));
  CHECK_THAT(with("0.65", "0.1"), Catch::Contains("'free_thresh' must not be above"));
  CHECK_THAT(with("hall.png", "none.png"), Catch::Contains("none.png: no such file"));
  CHECK_THAT(with("hall.png", "hall.yaml"), Catch::Contains("must be a .png or .pgm file"));
  CHECK_THAT(with("image: hall.png", "image: [1"), Catch::Contains("b.yaml:"));
}

TEST_CASE("map files: kinds are told apart by their extension") {
  const ScratchDir folder;
  write_file(folder / "a.txt", "type octile\nheight 1\nwidth 1\nmap\n.\n");
  write_file(folder / "a.map", "type octile\nheight 1\nwidth 1\nmap\n.\n");
  write_file(folder / "a.pgm", "P2 1 1 255\n255\n");
  CHECK(map_refusal(folder.path(), "a.map") == "accepted");
  CHECK(map_refusal(folder.path(), "a.pgm") == "accepted");
  CHECK_THAT(map_refusal(folder.path(), "a.txt"),
             Catch::Contains("a map must be a .map (Moving AI), .png, .pgm or .yaml"));
  if (const auto maze = data_file("planning/ompl_maze_normal.png")) {
    OccupancyOptions options;
    options.file = maze->string();
    const OccupancyGrid grid = read_map(options, "");
    CHECK((grid.rows == 450 && grid.columns == 450));
  }
}

}  // namespace leastcost::test
