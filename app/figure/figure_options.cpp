// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/figure/figure_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/yaml/suggest.hpp"

namespace leastcost::app {
namespace {

/// A number and what follows it; nothing where there is no finite one.
std::optional<std::pair<double, std::string>> number_and_rest(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return std::pair(value, std::string(rest, end));
}

/// The part of a list between commas.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) c == ',' ? static_cast<void>(words.emplace_back()) : words.back().push_back(c);
  return words;
}

constexpr std::array<std::pair<std::string_view, FigureFormat>, 5> kFormats = {{{".svg", FigureFormat::svg},
                                                                                {".pdf", FigureFormat::pdf},
                                                                                {".png", FigureFormat::png},
                                                                                {".vtp", FigureFormat::vtp},
                                                                                {".ply", FigureFormat::ply}}};

constexpr std::array<std::pair<std::string_view, FigurePicture>, 6> kPictures = {
    {{"best", FigurePicture::best},
     {"space", FigurePicture::space},
     {"map", FigurePicture::map},
     {"poses", FigurePicture::poses},
     {"coordinates", FigurePicture::coordinates},
     {"convergence", FigurePicture::convergence}}};

}  // namespace

FigureFormat figure_format(const std::string& file) {
  const std::string ending = file.substr(std::min(file.size(), file.rfind('.')));
  for (const auto& [name, format] : kFormats)
    if (ending == name) return format;
  throw InputError(
      fmt::format("'{}' must end in .svg, .pdf or .png, or in .vtp or .ply for the surface with the path", file));
}

double paper_width(const std::string& text) {
  constexpr std::array<std::pair<std::string_view, double>, 4> kUnits = {
      {{"mm", 1}, {"cm", 10}, {"in", 25.4}, {"pt", 25.4 / 72}}};
  constexpr double kLeast = 20, kMost = 2000;
  if (const auto value = number_and_rest(text))
    for (const auto& [unit, millimetres] : kUnits) {
      if (value->second != unit) continue;
      const double width = value->first * millimetres;
      if (width >= kLeast && width <= kMost) return width;
      throw InputError(
          fmt::format("a width of '{}' is outside {:g}mm to {:g}mm; a column is 84mm", text, kLeast, kMost));
    }
  throw InputError(fmt::format("'{}' is not a width: give a number with mm, cm, in or pt, like 84mm", text));
}

double font_size(const std::string& text) {
  constexpr double kLeast = 2, kMost = 100;
  const auto value = number_and_rest(text);
  if (!value || !(value->second.empty() || value->second == "pt"))
    throw InputError(fmt::format("'{}' is not a font size: give a number of points, like 8", text));
  if (value->first < kLeast || value->first > kMost)
    throw InputError(fmt::format("a font size of '{}' is outside {:g} to {:g} points", text, kLeast, kMost));
  return value->first;
}

PrintSize print_size(const std::string& width, const std::string& font) {
  constexpr double kLeast = 130;  // px: axes and some labels
  PrintSize size;
  size.width = paper_width(width);
  size.font_size = font_size(font);
  if (size.sketch_width() >= kLeast) return size;
  throw InputError(fmt::format("letters of {:g} pt do not fit in a width of {}: use at most {:.2g} pt", size.font_size,
                               width, std::floor(10 * size.font_size * size.sketch_width() / kLeast) / 10));
}

Angles view_angles(const std::string& text) {
  const std::vector<std::string> words = split(text);
  std::array<double, 2> angles{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto value = words.size() == 2 ? number_and_rest(words[i]) : std::nullopt;
    if (!value || !value->second.empty())
      throw InputError(
          fmt::format("'{}' is not a view: give two angles in degrees, azimuth and elevation, like 30,20", text));
    angles[i] = value->first;
  }
  constexpr double kVertical = 90;
  if (std::abs(angles[1]) > kVertical)
    throw InputError(fmt::format("an elevation of {:g} is outside -90 to 90 degrees", angles[1]));
  return {angles[0], angles[1]};
}

const std::vector<std::string>& figure_parts() {
  static const std::vector<std::string> parts = {"path", "first",     "others",  "points",
                                                 "ends", "obstacles", "shading", "legend"};
  return parts;
}

FigureParts parts_shown(const std::string& text) {
  FigureParts shown;
  if (text.empty()) return shown;
  Look& look = shown.look;
  const std::array<bool*, 8> flags = {&look.path, &look.first,     &look.others,  &look.points,
                                      &look.ends, &look.obstacles, &look.shading, &shown.legend};
  for (bool* flag : flags) *flag = false;
  for (const std::string& word : split(text)) {
    const auto found = std::find(figure_parts().begin(), figure_parts().end(), word);
    if (found == figure_parts().end())
      throw InputError(fmt::format("'{}' is not a part of a figure{}: list some of {}", word,
                                   did_you_mean(word, figure_parts()), joined(figure_parts())));
    *flags[static_cast<std::size_t>(found - figure_parts().begin())] = true;
  }
  return shown;
}

FigurePicture picture_named(const std::string& text) {
  std::vector<std::string> names;
  for (const auto& [name, picture] : kPictures) {
    if (text == name) return picture;
    names.emplace_back(name);
  }
  throw InputError(
      fmt::format("'{}' is not a picture{}: use one of {}", text, did_you_mean(text, names), joined(names)));
}

}  // namespace leastcost::app
