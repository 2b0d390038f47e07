// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/inputs/png_image.hpp"

#include <png.h>

#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "problems/readers/occupancy_reader.hpp"

namespace leastcost {
namespace {

/// Before memory is taken: the compression of a PNG makes one byte of at most 1032 (RFC 1951), each of at most eight
/// pixels.
void check_png_bytes(const png_image& png, std::size_t bytes, const std::string& file) {
  constexpr std::uint64_t kMostPerByte = 8 * 1032;
  const std::uint64_t pixels = std::uint64_t{png.height} * png.width;
  if (pixels / kMostPerByte <= bytes) return;
  throw InputError(file + ": not a readable PNG image: " + std::to_string(pixels) +
                   " pixels are announced, which do not fit in the " + std::to_string(bytes) + " bytes of the file");
}

}  // namespace

GreyImage read_png(std::string_view bytes, const std::string& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> freed(&png, &png_image_free);
  const auto refuse = [&] { throw InputError(file + ": not a readable PNG image: " + std::string(png.message)); };
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) refuse();
  check_map_size(png.height, png.width, file);
  check_png_bytes(png, bytes.size(), file);
  png.format &= ~static_cast<png_uint_32>(PNG_FORMAT_FLAG_LINEAR | PNG_FORMAT_FLAG_COLORMAP);  // bytes, no palette
  const std::size_t channels = PNG_IMAGE_PIXEL_CHANNELS(png.format);
  std::vector<png_byte> samples(PNG_IMAGE_SIZE(png));
  if (png_image_finish_read(&png, nullptr, samples.data(), 0, nullptr) == 0) refuse();
  GreyImage image;
  image.rows = static_cast<int>(png.height);
  image.columns = static_cast<int>(png.width);
  image.maximum = static_cast<int>(255 * channels);
  image.source = file;
  image.values.reserve(samples.size() / channels);
  for (auto pixel = samples.begin(); pixel != samples.end(); pixel += static_cast<std::ptrdiff_t>(channels))
    image.values.push_back(
        static_cast<std::uint16_t>(std::accumulate(pixel, pixel + static_cast<std::ptrdiff_t>(channels), 0)));
  return image;
}

std::string png_of_rgb(const std::vector<std::uint8_t>& rgb, int width, int height) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(width);
  png.height = static_cast<png_uint_32>(height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, rgb.data(), 0, nullptr) == 0)
    throw Error("a PNG image could not be made: " + std::string(png.message));
  bytes.resize(size);
  return bytes;
}

}  // namespace leastcost
