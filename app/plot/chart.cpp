// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/plot/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/plot/text.hpp"

namespace leastcost::app {
namespace {

constexpr double kFont = kDrawnFont, kTitle = 24, kNoTitle = 8, kBelow = 42, kRight = 14, kLegendRow = 16, kSample = 26;
constexpr std::size_t kMostBelow = 4;  ///< entries of a legend below the chart; longer ones stand beside it

std::vector<double> all_values(const Chart& chart, bool of_x) {
  std::vector<double> out;
  for (const Series& s : chart.series) {
    const std::vector<double>& values = of_x ? s.x : s.y;
    out.insert(out.end(), values.begin(), values.end());
    if (of_x) continue;
    out.insert(out.end(), s.low.begin(), s.low.end());
    out.insert(out.end(), s.high.begin(), s.high.end());
  }
  return out;
}

Range shown(const Axis& axis, const std::vector<double>& values) {
  Range range = range_of(values, axis.kind);
  if (axis.least) range.least = *axis.least;
  if (axis.largest) range.largest = *axis.largest;
  if (!(range.largest > range.least)) range.largest = range.least + 1;
  return range;
}

std::vector<const Series*> named(const std::vector<Series>& series) {
  std::vector<const Series*> out;
  for (const Series& s : series)
    if (!s.name.empty()) out.push_back(&s);
  return out;
}

/// Width of an entry of a legend: sample, name, room.
double entry_width(const std::vector<const Series*>& legend) {
  double widest = 0;
  for (const Series* s : legend) widest = std::max(widest, kFont * text_width(s->name));
  return kSample + 22 + widest;
}

/// Draws one chart. Holds where the axes lie.
class Drawing {
 public:
  explicit Drawing(const Chart& chart)
      : chart_(chart),
        x_range_(shown(chart.x, all_values(chart, true))),
        y_range_(shown(chart.y, all_values(chart, false))),
        legend_(chart.legend ? named(chart.series) : std::vector<const Series*>()) {
    y_ticks_ = ticks(chart.y.kind, y_range_, static_cast<int>(chart.height / 42));
    double label = 0;
    for (const Tick& t : y_ticks_) label = std::max(label, text_width(t.label));
    left_ = 30 + kFont * label;
    top_ = chart.heading ? kTitle : kNoTitle;
    width_ = chart.width - left_ - kRight;
    height_ = chart.height - top_ - kBelow;
    total_height_ = chart.height;
    place_legend();
    x_ticks_ = ticks_below();
  }

  double height() const { return total_height_; }

  Sketch sketch() const {
    std::string out;
    if (chart_.heading) out += fmt::format("<text class=\"title\" x=\"0\" y=\"13\">{}</text>\n", escaped(chart_.title));
    out += axes();
    out += "<g>\n";
    for (const Series& s : chart_.series) out += series(s);
    out += "</g>\n" + legend();
    return {chart_.title, chart_.description, chart_.width, total_height_, out};
  }

  std::string draw(bool standalone) const {
    const Sketch drawn = sketch();
    return svg_element(drawn.title, drawn.description, drawn.width, drawn.height, drawn.content, standalone);
  }

 private:
  /// As many ticks as have room for their labels.
  std::vector<Tick> ticks_below() const {
    int wanted = std::max(2, static_cast<int>(width_ / 48));
    if (chart_.x.whole) wanted = std::clamp(static_cast<int>(x_range_.largest - x_range_.least), 1, wanted);
    std::vector<Tick> out = ticks(chart_.x.kind, x_range_, wanted);
    while (wanted > 2 && !has_room(out)) out = ticks(chart_.x.kind, x_range_, --wanted);
    if (!has_room(out)) thin(out);
    return out;
  }

  /// The left and the right end of a label.
  std::pair<double, double> extent(const Tick& t) const {
    const double half = kFont * text_width(t.label) / 2 + 3;
    return {px(t.at) - half, px(t.at) + half};
  }

  bool has_room(const std::vector<Tick>& all) const {
    double end = -kFont;
    for (const Tick& t : all) {
      if (t.label.empty()) continue;
      if (extent(t).first < end) return false;
      end = extent(t).second;
    }
    return true;
  }

  /// Takes away the labels that would run into the one before.
  void thin(std::vector<Tick>& all) const {
    double end = -kFont;
    for (Tick& t : all) {
      if (t.label.empty()) continue;
      const auto [from, to] = extent(t);
      if (from < end)
        t.label.clear();
      else
        end = to;
    }
  }

  void place_legend() {
    if (legend_.empty()) return;
    beside_ = legend_.size() > kMostBelow;
    column_ = entry_width(legend_);
    const double rows = static_cast<double>(legend_.size()) * kLegendRow;
    if (beside_) {
      width_ -= column_ + 4;
      total_height_ = std::max(total_height_, top_ + rows + 8);
      return;
    }
    per_row_ = std::clamp<std::size_t>(static_cast<std::size_t>((chart_.width - left_) / column_), 1, legend_.size());
    total_height_ += std::ceil(static_cast<double>(legend_.size()) / static_cast<double>(per_row_)) * kLegendRow + 2;
  }

  double px(double x) const { return left_ + width_ * position_in(chart_.x.kind, x_range_, x); }
  double py(double y) const { return top_ + height_ * (1 - position_in(chart_.y.kind, y_range_, y)); }
  bool visible(double x, double y) const {
    const double a = position_in(chart_.x.kind, x_range_, x), b = position_in(chart_.y.kind, y_range_, y);
    return a >= -1e-9 && a <= 1 + 1e-9 && b >= -1e-9 && b <= 1 + 1e-9;
  }

  std::string axes() const {
    std::string out;
    for (const Tick& t : y_ticks_) {
      const double y = py(t.at);
      out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}h{:.1f}\"/>", left_, y, width_);
      if (!t.label.empty())
        out +=
            fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", left_ - 6, y + 3.8, t.label);
    }
    for (const Tick& t : x_ticks_) {
      const double x = px(t.at);
      out += fmt::format("<path class=\"axis\" d=\"M{:.1f} {:.1f}v{}\"/>", x, top_ + height_, t.label.empty() ? 3 : 5);
      if (!t.label.empty())
        out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", x, top_ + height_ + 17,
                           t.label);
    }
    out += fmt::format("<path class=\"axis\" d=\"M{:.1f} {:.1f}h{:.1f}\"/>\n", left_, top_ + height_, width_);
    out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", left_ + width_ / 2,
                       top_ + height_ + 33, escaped(chart_.x.title));
    return out + fmt::format("<text transform=\"translate(11 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                             top_ + height_ / 2, escaped(chart_.y.title));
  }

  /// A path through the points that can be shown, with a gap where one cannot.
  std::string line(const Series& s) const {
    std::string d;
    bool pen_down = false;
    double last_y = 0;
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      if (!visible(s.x[i], s.y[i])) {
        pen_down = false;
        continue;
      }
      const double x = px(s.x[i]), y = py(s.y[i]);
      if (!pen_down)
        d += fmt::format("M{:.1f} {:.1f}", x, y);
      else if (s.steps)
        d += fmt::format("L{:.1f} {:.1f}L{:.1f} {:.1f}", x, last_y, x, y);
      else
        d += fmt::format("L{:.1f} {:.1f}", x, y);
      pen_down = true;
      last_y = y;
    }
    return d.empty() ? "" : fmt::format("<path {} d=\"{}\"/>\n", stroke_of(s.style), d);
  }

  std::string series(const Series& s) const {
    std::string out = s.style.line ? line(s) : "";
    for (std::size_t i = 0; i < s.low.size(); ++i) {
      if (!visible(s.x[i], s.low[i]) || !visible(s.x[i], s.high[i])) continue;
      LineStyle solid = s.style;
      solid.number %= 7;
      out += fmt::format("<path {} d=\"M{:.1f} {:.1f}V{:.1f}\" style=\"stroke-width:1\"/>", stroke_of(solid),
                         px(s.x[i]), py(s.low[i]), py(s.high[i]));
    }
    const bool all = s.style.markers || s.x.size() == 1;
    const std::size_t step = all ? 1 : s.marks > 0 ? std::max<std::size_t>(1, s.x.size() / (s.marks + 1)) : s.x.size();
    if (all || s.marks > 0)
      for (std::size_t i = all ? 0 : step; i < s.x.size(); i += step)
        if (visible(s.x[i], s.y[i])) out += marker(s.style, px(s.x[i]), py(s.y[i]), s.x.size() > 60 ? 2 : 3.2);
    return out + "\n";
  }

  std::string legend() const {
    std::string out;
    for (std::size_t k = 0; k < legend_.size(); ++k) {
      const Series& s = *legend_[k];
      double x = left_ + width_ + 14, y = top_ + 8 + static_cast<double>(k) * kLegendRow;
      if (!beside_) {
        x = left_ + static_cast<double>(k % per_row_) * column_;
        const std::size_t row = k / per_row_;
        y = top_ + height_ + kBelow + 6 + static_cast<double>(row) * kLegendRow;
      }
      if (s.style.line) out += fmt::format("<path {} d=\"M{:.1f} {:.1f}h{}\"/>", stroke_of(s.style), x, y, kSample);
      if (s.style.markers || s.marks > 0) out += marker(s.style, x + kSample / 2, y);
      out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x + kSample + 6, y + 3.8, escaped(s.name));
    }
    return out;
  }

  const Chart& chart_;
  Range x_range_, y_range_;
  std::vector<const Series*> legend_;
  std::vector<Tick> x_ticks_, y_ticks_;
  double left_ = 0, top_ = 0, width_ = 0, height_ = 0, total_height_ = 0, column_ = 0;
  std::size_t per_row_ = 1;
  bool beside_ = false;
};

}  // namespace

double legend_width(const std::vector<Series>& series) {
  const std::vector<const Series*> legend = named(series);
  return legend.size() > kMostBelow ? entry_width(legend) + 4 : 0;
}

Sketch sketch(const Chart& chart) { return Drawing(chart).sketch(); }

std::string svg(const Chart& chart, bool standalone) { return Drawing(chart).draw(standalone); }

std::string panels_svg(const std::string& title, const std::string& description, const std::vector<Chart>& charts) {
  constexpr double kMargin = 12, kGap = 22, kHeading = 30;
  std::string out = fmt::format("<text class=\"title\" x=\"{0}\" y=\"24\">{1}</text>\n", kMargin, escaped(title));
  double x = kMargin, height = 0;
  for (const Chart& chart : charts) {
    const Drawing drawing(chart);
    out += fmt::format("<svg x=\"{:.0f}\" y=\"{:.0f}\"{}", x, kMargin + kHeading, drawing.draw(false).substr(4));
    x += chart.width + kGap;
    height = std::max(height, drawing.height());
  }
  return svg_element(title, description, x - kGap + kMargin, height + kHeading + 2 * kMargin, out, true);
}

}  // namespace leastcost::app
