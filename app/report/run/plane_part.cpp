// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The plane, drawn to scale: cost as bands, box, the domain where it is a curve, first path, path, points and ends.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/plot/chart.hpp"
#include "app/plot/contour.hpp"
#include "app/plot/text.hpp"
#include "app/report/run/run_parts.hpp"

namespace leastcost::app {
namespace {

constexpr double kMostWidth = 860, kMostHeight = 560, kLeast = 58, kBelow = 64, kTop = 12, kRight = 14;
constexpr double kFontSize = 12, kBesideLabels = 30;  // pixels
constexpr int kBands = 8;

/// The part of the plane that is shown, and how it is mapped to the drawing.
class Frame {
 public:
  Frame(const Eigen::Vector2d& lower, const Eigen::Vector2d& upper) : lower_(lower), upper_(upper) {
    fit();
    left_ = std::max(kLeast, kBesideLabels + widest(ticks_of(1)));
    right_ = std::max(kRight, widest(ticks_of(0)) / 2 + 4);
    fit();
  }
  double left() const { return left_; }
  double right() const { return right_; }
  double x(double value) const { return left_ + scale_ * (value - lower_[0]); }
  double y(double value) const { return kTop + scale_ * (upper_[1] - value); }
  double width() const { return scale_ * (upper_[0] - lower_[0]); }
  double height() const { return scale_ * (upper_[1] - lower_[1]); }
  Range range(Index i) const { return {lower_[i], upper_[i]}; }
  std::vector<Tick> ticks_of(Index axis) const {
    const double size = axis == 0 ? width() / 80 : height() / 60;
    return ticks(ScaleKind::linear, range(axis), std::max(2, static_cast<int>(size)));
  }
  bool contains(const Eigen::VectorXd& p) const {
    return (p.array() >= lower_.array()).all() && (p.array() <= upper_.array()).all();
  }

 private:
  void fit() {
    const Eigen::Vector2d extent = upper_ - lower_;
    scale_ = std::min((kMostWidth - left_ - right_) / extent[0], (kMostHeight - kTop - kBelow) / extent[1]);
  }
  /// Of labels, pixels.
  static double widest(const std::vector<Tick>& all) {
    double width = 0;
    for (const Tick& tick : all) width = std::max(width, kFontSize * text_width(tick.label));
    return width;
  }

  Eigen::Vector2d lower_, upper_;
  double scale_ = 1, left_ = kLeast, right_ = kRight;
};

Frame frame_of(const RunFiles& files) {
  const Scene& scene = files.scene;
  if (scene.cost) return {scene.cost->lower, scene.cost->upper};
  if (scene.relief) return {scene.relief->lower, scene.relief->upper};
  Eigen::AlignedBox2d box(Eigen::Vector2d(files.points.col(0)));
  const auto grow = [&](const Points& x) {
    for (const auto p : x.colwise())
      if (p.allFinite()) box.extend(Eigen::Vector2d(p));
  };
  grow(files.points);
  grow(scene.lines.path);
  grow(scene.lines.first);
  for (const Points& curve : scene.curves) grow(curve);
  const double longest = std::max(box.sizes().maxCoeff(), 1e-12);
  const Eigen::Vector2d missing = ((0.35 * longest - box.sizes().array()) / 2).max(0.0) + 0.08 * longest;
  return {box.min() - missing, box.max() + missing};
}

std::string points_of(const Points& line, const Frame& frame) {
  std::string d;
  for (const auto p : line.colwise())
    if (p.allFinite())
      fmt::format_to(std::back_inserter(d), "{}{:.2f} {:.2f}", d.empty() ? "M" : "L", frame.x(p[0]), frame.y(p[1]));
  return d;
}

std::string stroke(const Points& line, const Frame& frame, const char* classes) {
  return fmt::format("<path class=\"{}\" d=\"{}\"/>\n", classes, points_of(line, frame));
}

/// Levels between which the bands lie: evenly in the logarithm, where the middle 96 % of the values are.
std::vector<double> levels_of(const Raster& raster) {
  std::vector<double> finite;
  for (const double value : raster.values)
    if (std::isfinite(value) && value > 0) finite.push_back(value);
  if (finite.empty()) return {};
  std::sort(finite.begin(), finite.end());
  const double low = finite[finite.size() / 50], high = finite[finite.size() - 1 - finite.size() / 50];
  std::vector<double> levels;
  levels.reserve(kBands);
  for (int k = 0; k < kBands; ++k) levels.push_back(low * std::pow(high / low, (k + 0.5) / kBands));
  return levels;
}

/// From nodes of a raster to the drawing.
ToDrawing columns_of(const Raster& raster, const Frame& frame) {
  return [&](double i) {
    return frame.x(raster.lower[0] + (raster.upper[0] - raster.lower[0]) * i / (raster.columns - 1));
  };
}
ToDrawing rows_of(const Raster& raster, const Frame& frame) {
  return
      [&](double j) { return frame.y(raster.lower[1] + (raster.upper[1] - raster.lower[1]) * j / (raster.rows - 1)); };
}

std::string cost_bands(const Raster& raster, const Frame& frame) {
  const std::vector<double> levels = levels_of(raster);
  const Grid grid{raster.columns, raster.rows, raster.values};
  const ToDrawing x = columns_of(raster, frame), y = rows_of(raster, frame);
  std::string out =
      fmt::format("<rect class=\"band0\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
                  frame.x(raster.lower[0]), frame.y(raster.upper[1]), frame.width(), frame.height());
  for (const double level : levels)
    out += fmt::format("<path class=\"band\" d=\"{}\"/>\n", region_above(grid, level, x, y));
  return out + fmt::format("<path class=\"out\" d=\"{}\"/>\n", region_infinite(grid, x, y));
}

/// Ground in the sun and in the shade, in steps.
std::string hillshade(const Raster& raster, const Frame& frame) {
  constexpr int kShades = 14;
  double darkest = 1, lightest = 0;
  for (const double value : raster.values)
    if (std::isfinite(value)) darkest = std::min(darkest, value), lightest = std::max(lightest, value);
  const Grid grid{raster.columns, raster.rows, raster.values};
  const ToDrawing x = columns_of(raster, frame), y = rows_of(raster, frame);
  std::string out =
      fmt::format("<rect class=\"shade0\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
                  frame.x(raster.lower[0]), frame.y(raster.upper[1]), frame.width(), frame.height());
  for (int k = 1; k < kShades; ++k)
    out += fmt::format("<path class=\"shade\" d=\"{}\"/>\n",
                       region_above(grid, darkest + (lightest - darkest) * k / kShades, x, y));
  return out + fmt::format("<path class=\"out\" d=\"{}\"/>\n", region_infinite(grid, x, y));
}

/// Level lines of a potential in the part of the plane where it was needed.
std::string potential_lines(const Raster& raster, const Frame& frame) {
  constexpr int kLines = 20;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : raster.values)
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  if (!(low < high)) return "";
  const Grid grid{raster.columns, raster.rows, raster.values};
  const ToDrawing x = columns_of(raster, frame), y = rows_of(raster, frame);
  std::string out;
  for (int k = 1; k < kLines; ++k)
    out += fmt::format("<path class=\"level\" d=\"{}\"/>\n", line_at(grid, low + (high - low) * k / kLines, x, y));
  return out;
}

std::string axes(const Frame& frame) {
  std::string out = fmt::format("<rect class=\"axis\" x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
                                frame.left(), kTop, frame.width(), frame.height());
  const double bottom = kTop + frame.height();
  for (const Tick& t : frame.ticks_of(0))
    out += fmt::format(
        "<path class=\"axis\" d=\"M{0:.1f} {1:.1f}v5\"/><text x=\"{0:.1f}\" y=\"{2:.1f}\" "
        "text-anchor=\"middle\">{3}</text>\n",
        frame.x(t.at), bottom, bottom + 18, t.label);
  for (const Tick& t : frame.ticks_of(1))
    out += fmt::format(
        "<path class=\"axis\" d=\"M{0} {1:.1f}h-5\"/><text x=\"{2}\" y=\"{3:.1f}\" text-anchor=\"end\">{4}</text>\n",
        frame.left(), frame.y(t.at), frame.left() - 8, frame.y(t.at) + 3.8, t.label);
  out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">x</text>\n",
                     frame.left() + frame.width() / 2, bottom + 34);
  return out + fmt::format("<text x=\"12\" y=\"{:.1f}\">y</text>\n", kTop + frame.height() / 2);
}

/// The sides of the box that lie within the frame.
std::string box_sides(const Scene& scene, const Frame& frame) {
  if (scene.lower.size() == 0) return "";
  std::string d;
  for (const double x : {scene.lower[0], scene.upper[0]})
    if (x >= frame.range(0).least && x <= frame.range(0).largest)
      d += fmt::format("M{:.1f} {:.1f}v{:.1f}", frame.x(x), kTop, frame.height());
  for (const double y : {scene.lower[1], scene.upper[1]})
    if (y >= frame.range(1).least && y <= frame.range(1).largest)
      d += fmt::format("M{} {:.1f}h{:.1f}", frame.left(), frame.y(y), frame.width());
  return d.empty() ? "" : fmt::format("<path class=\"wall\" d=\"{}\"/>\n", d);
}

std::string path_marks(const RunFiles& files, const Frame& frame) {
  std::string out;
  const double radius = files.points.cols() > 120 ? 1.5 : 2.4;
  if (files.points.cols() <= 400)
    for (const auto p : files.points.colwise())
      out += fmt::format("<circle class=\"point\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\"/>", frame.x(p[0]), frame.y(p[1]),
                         radius);
  if (files.result.flag("ring")) return out;
  for (const Index end : {Index(0), files.points.cols() - 1})
    out += fmt::format("<circle class=\"end\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"5.5\"/>", frame.x(files.points(0, end)),
                       frame.y(files.points(1, end)));
  return out + "\n";
}

}  // namespace

std::string plane_svg(const RunFiles& files) {
  const Frame frame = frame_of(files);
  const Scene& scene = files.scene;
  std::string inside;
  if (scene.cost) inside += cost_bands(*scene.cost, frame);
  if (scene.relief) inside += hillshade(*scene.relief, frame);
  if (scene.potential) inside += potential_lines(*scene.potential, frame);
  // On the ground all of them are outlines of obstacles.
  for (const Points& curve : scene.curves) inside += stroke(curve, frame, scene.relief ? "obstacle" : "domain");
  inside += box_sides(scene, frame);
  inside += stroke(scene.lines.first, frame, "first");
  for (const Points& other : scene.lines.others) inside += stroke(other, frame, "other");
  inside += stroke(scene.lines.path, frame, "path");
  std::string out = fmt::format(
      "<defs><clipPath id=\"inside\"><rect x=\"{}\" y=\"{}\" width=\"{:.1f}\" height=\"{:.1f}\"/></clipPath><pattern "
      "id=\"hatch\" width=\"7\" "
      "height=\"7\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><path class=\"hatch\" d=\"M0 "
      "0v7\"/></pattern></defs>\n",
      frame.left(), kTop, frame.width(), frame.height());
  out += fmt::format("<g clip-path=\"url(#inside)\">\n{}</g>\n{}{}", inside, axes(frame), path_marks(files, frame));
  return svg_element("The path in the plane", "The path, its points, its ends and the first path, drawn to scale",
                     frame.left() + frame.width() + frame.right(), kTop + frame.height() + kBelow - 20, out, false);
}

}  // namespace leastcost::app
