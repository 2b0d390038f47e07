// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/space/space_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/plot/text.hpp"

namespace leastcost::app {

Projector::Projector(const Eigen::AlignedBox2d& area, const SpaceView& view, double width, double height,
                     const Margins& margins)
    : view_(view), margins_(margins) {
  const Eigen::Vector2d extent = area.diagonal().cwiseMax(1e-300);
  scale_ =
      std::min((width - margins.left - margins.right) / extent[0], (height - margins.top - margins.bottom) / extent[1]);
  middle_ = area.center();
  half_ = scale_ * extent / 2;
}

Eigen::Vector3d Projector::place_seen(const Eigen::Vector3d& p) const {
  return {margins_.left + half_[0] + scale_ * (p[0] - middle_[0]),
          margins_.top + half_[1] - scale_ * (p[1] - middle_[1]), p[2]};
}

std::string line_in_space(const Points& x, const char* name, const Projector& projector, const DepthMap& depths) {
  std::string seen, hidden;
  bool was_seen = false;
  for (Index i = 0; i < x.cols(); ++i) {
    if (!x.col(i).allFinite()) continue;
    const bool sees = depths.sees(x.col(i));
    std::string& d = sees ? seen : hidden;
    const Eigen::Vector3d p = projector.place(x.col(i));
    if (i > 0 && (sees != was_seen || d.empty())) {
      const Eigen::Vector3d before = projector.place(x.col(i - 1));
      fmt::format_to(std::back_inserter(d), "M{:.1f} {:.1f}", before[0], before[1]);
    }
    fmt::format_to(std::back_inserter(d), "{}{:.1f} {:.1f}", d.empty() ? "M" : "L", p[0], p[1]);
    was_seen = sees;
  }
  std::string out;
  if (!hidden.empty()) out += fmt::format("<path class=\"{} hidden\" d=\"{}\"/>\n", name, hidden);
  if (!seen.empty()) out += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", name, seen);
  return out;
}

std::string circles_in_space(const Points& x, const char* name, double radius, bool hidden_too,
                             const Projector& projector, const DepthMap& depths) {
  std::string out;
  for (const auto column : x.colwise()) {
    const bool seen = depths.sees(column);
    if (!seen && !hidden_too) continue;
    const Eigen::Vector3d p = projector.place(column);
    fmt::format_to(std::back_inserter(out), "<circle class=\"{}{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2g}\"/>\n", name,
                   seen ? "" : " hidden", p[0], p[1], radius);
  }
  return out;
}

std::string image_element(const ShadedImage& image, const Projector& projector) {
  const Eigen::Vector3d corner = projector.place_seen({image.area.min()[0], image.area.max()[1], 0});
  const Eigen::Vector2d size = projector.scale() * image.area.sizes();
  return fmt::format(
      "<image x=\"{:.3f}\" y=\"{:.3f}\" width=\"{:.3f}\" height=\"{:.3f}\" preserveAspectRatio=\"none\" "
      "xlink:href=\"data:image/png;base64,{}\"/>\n",
      corner[0], corner[1], size[0], size[1], base64(image.png));
}

std::string length_bar(const Projector& projector, double top, const std::string& unit) {
  constexpr double kBarLeft = 8;
  const double wanted = projector.width() / projector.scale() / 4,
               power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double factor = wanted / power, length = power * (factor < 2 ? 1 : factor < 5 ? 2 : 5);
  constexpr double kLong = 1e4, kKilo = 1e3;
  const bool kilometres = unit == "m" && length >= kLong;
  const std::string label =
      number_text(kilometres ? length / kKilo : length, 1) + (unit.empty() ? "" : " ") + (kilometres ? "km" : unit);
  return fmt::format(
      "<path class=\"axis\" d=\"M{0:.2f} {1:.1f}v6m0 -3h{2:.3f}m0 -3v6\"/><text x=\"{3:.1f}\" "
      "y=\"{4:.1f}\">{5}</text>\n",
      kBarLeft, top, projector.scale() * length, kBarLeft + projector.scale() * length + 6, top + 6.8, escaped(label));
}

}  // namespace leastcost::app
