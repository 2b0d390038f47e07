// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/run/plane_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "app/plot/sketch.hpp"
#include "app/plot/text.hpp"

namespace leastcost::app {
namespace {

constexpr double kTop = 12, kBelow = 40, kRight = 8, kBesideLabels = 25;  // px

double widest_label(const std::vector<Tick>& all) {
  double width = 0;
  for (const Tick& tick : all) width = std::max(width, kDrawnFont * text_width(tick.label));
  return width;
}

}  // namespace

PlaneFrame::PlaneFrame(const Eigen::Vector2d& lower, const Eigen::Vector2d& upper, const Look& look)
    : lower_(lower), upper_(upper), most_width_(look.width), most_height_(look.height) {
  left_ = kBesideLabels;
  beyond_ = kRight;
  fit();
  left_ = kBesideLabels + widest_label(ticks_of(1));
  beyond_ = std::max(kRight, widest_label(ticks_of(0)) / 2 + 4);
  fit();
}

void PlaneFrame::fit() {
  const Eigen::Vector2d extent = upper_ - lower_;
  scale_ = std::min((most_width_ - left_ - beyond_) / extent[0], (most_height_ - kTop - kBelow) / extent[1]);
}

double PlaneFrame::top() const { return kTop; }

double PlaneFrame::total_height() const { return bottom() + kBelow; }

std::vector<Tick> PlaneFrame::ticks_of(Index axis) const {
  const double count = axis == 0 ? width() / 70 : height() / 50;
  return ticks(ScaleKind::linear, range(axis), std::max(3, static_cast<int>(count)));
}

std::string PlaneFrame::line(const Points& line) const {
  std::string d;
  for (const auto p : line.colwise())
    if (p.allFinite())
      fmt::format_to(std::back_inserter(d), "{}{:.2f} {:.2f}", d.empty() ? "M" : "L", x(p[0]), y(p[1]));
  return d;
}

std::string PlaneFrame::border() const {
  return fmt::format("M{:.2f} {:.2f}h{:.2f}v{:.2f}H{:.2f}Z", left(), top(), width(), height(), left());
}

std::string PlaneFrame::axes(const std::string& x_name, const std::string& y_name) const {
  std::string out = fmt::format("<path class=\"axis\" d=\"{}\"/>\n", border());
  for (const Tick& t : ticks_of(0))
    out += fmt::format(
        "<path class=\"axis\" d=\"M{0:.1f} {1:.1f}v4\"/><text x=\"{0:.1f}\" y=\"{2:.1f}\" "
        "text-anchor=\"middle\">{3}</text>\n",
        x(t.at), bottom(), bottom() + 16, t.label);
  for (const Tick& t : ticks_of(1))
    out += fmt::format(
        "<path class=\"axis\" d=\"M{0:.1f} {1:.1f}h-4\"/><text x=\"{2:.1f}\" y=\"{3:.1f}\" "
        "text-anchor=\"end\">{4}</text>\n",
        left(), y(t.at), left() - 7, y(t.at) + 3.8, t.label);
  out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", left() + width() / 2,
                     bottom() + 32, escaped(x_name));
  return out + fmt::format("<text transform=\"translate(11 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                           top() + height() / 2, escaped(y_name));
}

}  // namespace leastcost::app
