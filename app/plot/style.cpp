// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Colours, dashes and markers. Colours: Okabe, Ito, "Color Universal Design" (2008), without its yellow, which is too
// light for lines.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "app/plot/chart.hpp"
#include "app/plot/sketch.hpp"
#include "app/plot/text.hpp"

namespace leastcost::app {
namespace {

constexpr int kColours = 7;
constexpr std::array<const char*, 4> kDashes = {"", "6 3", "2 2.5", "8 3 2 3"};

std::string polygon(std::initializer_list<std::array<double, 2>> corners, double x, double y, double r) {
  std::string points;
  for (const auto& [dx, dy] : corners)
    points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ", x + r * dx, y + r * dy);
  return fmt::format("<polygon points=\"{}\"/>", points);
}

std::string shape(int number, double x, double y, double r) {
  switch (number % 6) {
    case 0: return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>", x, y, r);
    case 1: return polygon({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}}, x, y, r);
    case 2: return polygon({{0, -1.25}, {1.15, 0.8}, {-1.15, 0.8}}, x, y, r);
    case 3: return polygon({{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}}, x, y, r);
    case 4: return polygon({{0, 1.25}, {1.15, -0.8}, {-1.15, -0.8}}, x, y, r);
    default:
      return polygon({{-1.1, -0.4},
                      {-0.4, -0.4},
                      {-0.4, -1.1},
                      {0.4, -1.1},
                      {0.4, -0.4},
                      {1.1, -0.4},
                      {1.1, 0.4},
                      {0.4, 0.4},
                      {0.4, 1.1},
                      {-0.4, 1.1},
                      {-0.4, 0.4},
                      {-1.1, 0.4}},
                     x, y, r);
  }
}

struct Colour {
  std::string_view name, light, dark;
};

constexpr std::array<Colour, 14> kPalette = {{{"ink", "#222", "#e6e4df"},
                                              {"soft", "#6b6b6b", "#a19e97"},
                                              {"rule", "#e4e2dd", "#3a3936"},
                                              {"faint", "#f8f6f1", "#232322"},
                                              {"paper", "#fff", "#1c1c1b"},
                                              {"solid", "#bcbab6", "#5f5d59"},
                                              {"pale", "#ebeae7", "#333231"},
                                              {"c0", "#0072B2", "#4aa3dc"},
                                              {"c1", "#D55E00", "#ef8244"},
                                              {"c2", "#009E73", "#33bd93"},
                                              {"c3", "#CC79A7", "#dc98bf"},
                                              {"c4", "#E69F00", "#efb02e"},
                                              {"c5", "#56B4E9", "#86cbf3"},
                                              {"c6", "#222", "#e6e4df"}}};

constexpr std::string_view kFonts =
    R"(font-family:system-ui,-apple-system,"Segoe UI","Helvetica Neue",Helvetica,Arial,sans-serif;)"
    "font-variant-numeric:tabular-nums";

constexpr std::string_view kRules =
    R"(.plot text{font-size:11px;fill:var(--soft)}.plot .title{font-size:12.5px;font-weight:600;fill:var(--ink)}
.plot .axis{stroke:var(--soft);fill:none}.plot .grid{stroke:var(--rule);fill:none}
.plot .s{fill:none;stroke-width:1.7;stroke-linejoin:round;stroke-linecap:round}.plot .bar{stroke-width:1.1}
.plot .quiet{fill:none;stroke:var(--soft);stroke-width:1.2;stroke-dasharray:4 3}
.plot .m{stroke:var(--paper);stroke-width:.8}.plot .m.quiet{fill:var(--soft);stroke:var(--paper)}
.plot .path{fill:none;stroke:var(--c0);stroke-width:3.2;stroke-linejoin:round;stroke-linecap:round}
.plot .first{fill:none;stroke:var(--ink);stroke-width:1.5;stroke-dasharray:6 4;opacity:.75}
.plot .other{fill:none;stroke:var(--c2);stroke-width:1.8}.plot .hidden{stroke-width:1.2;opacity:.6}
.plot path.hidden{stroke-dasharray:3 2.5}
.plot .hand{fill:none;stroke:var(--c1);stroke-width:1.8;stroke-linejoin:round}
.plot .pose path{fill:var(--c0);fill-opacity:.35;stroke:var(--c0);stroke-width:1}
.plot .obstacle{fill:var(--solid)}.plot .obstacle-edge{fill:none;stroke:var(--soft);stroke-width:2.4}
.plot .margin{fill:var(--pale)}.plot .margin-edge{fill:none;stroke:var(--soft);stroke-width:1.4;stroke-dasharray:2 2}
.plot .domain{fill:none;stroke:var(--soft);stroke-width:5;stroke-opacity:.35;stroke-linejoin:round}
.plot .point{fill:var(--paper);stroke:var(--c0);stroke-width:1.2}
.plot .end{fill:var(--c1);stroke:var(--paper);stroke-width:1.5}
.plot .wall{fill:none;stroke:var(--ink);stroke-width:2}.plot .solid{stroke-width:.7;stroke-linejoin:round}
.plot .level{fill:none;stroke:var(--soft);stroke-width:.7;opacity:.7}
.plot .shade0{fill:#6f6a62}.plot .shade{fill:#fff;fill-opacity:.085}
.plot .band0{fill:var(--faint)}.plot .band{fill:var(--soft);fill-opacity:.09}
.plot .warm{fill:var(--c4);fill-opacity:.15}
.plot .out{fill:url(#hatch)}.plot .hatch{stroke:var(--soft);stroke-width:1.2;fill:none}
.plot .s0{stroke:var(--c0)}.plot .s1{stroke:var(--c1)}.plot .s2{stroke:var(--c2)}.plot .s3{stroke:var(--c3)}
.plot .s4{stroke:var(--c4)}.plot .s5{stroke:var(--c5)}.plot .s6{stroke:var(--c6)}
.plot .f0{fill:var(--c0)}.plot .f1{fill:var(--c1)}.plot .f2{fill:var(--c2)}.plot .f3{fill:var(--c3)}
.plot .f4{fill:var(--c4)}.plot .f5{fill:var(--c5)}.plot .f6{fill:var(--c6)}
)";

/// "--ink:#222;--soft:...", of the light or the dark palette.
std::string variables(std::string_view Colour::*shade) {
  std::string out;
  for (const Colour& colour : kPalette) out += fmt::format("--{}:{};", colour.name, colour.*shade);
  return out;
}

/// The style for a file of its own, in the CSS that converters and editors know: no variables, no media queries.
std::string plain_style() {
  std::string out = fmt::format(".plot{{{}}}\n{}", kFonts, kRules);
  for (const Colour& colour : kPalette) {
    const std::string variable = fmt::format("var(--{})", colour.name);
    for (std::size_t at = out.find(variable); at != std::string::npos; at = out.find(variable, at))
      out.replace(at, variable.size(), colour.light);
  }
  return out;
}

/// What differs on paper: black letters, thin lines.
constexpr std::string_view kPaperRules =
    R"(.plot{font-family:Helvetica,Arial,sans-serif}.plot text{fill:#222}.plot .axis{stroke:#222;stroke-width:.7}
.plot .path{stroke-width:2.2}.plot .first{stroke-width:1}
.plot .other{stroke-width:1.3}.plot .hidden{stroke-width:1}.plot .s{stroke-width:1.3}.plot .wall{stroke-width:1.3}
.plot .obstacle-edge{stroke-width:1.6}.plot .point{stroke-width:.8}.plot .end{stroke-width:1}
.plot .grid{stroke-width:.6}.plot .pose path{stroke-width:.6}.plot .domain{stroke-width:3.5}
)";

constexpr double kPointsPerInch = 72, kMillimetresPerInch = 25.4;

}  // namespace

double PrintSize::sketch_width() const { return width / kMillimetresPerInch * kPointsPerInch * kDrawnFont / font_size; }

int PrintSize::pixels(double sketch_length) const {
  return static_cast<int>(std::ceil(sketch_length * font_size / kDrawnFont / kPointsPerInch * dpi));
}

std::string svg(const Sketch& sketch) {
  return svg_element(sketch.title, sketch.description, sketch.width, sketch.height, sketch.content, false);
}

std::string printed_svg(const Sketch& sketch, const PrintSize& size) {
  const double width = size.sketch_width();
  return fmt::format(
      "<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "viewBox=\"0 0 {0:.2f} {1:.2f}\" width=\"{2:.6g}mm\" height=\"{3:.6g}mm\">\n"
      "<title>{4}</title>\n<desc>{5}</desc>\n<style>{6}{7}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<g transform=\"translate({8:.2f} 0)\">\n{9}</g>\n</svg>\n",
      width, sketch.height, size.width, size.width * sketch.height / width, escaped(sketch.title),
      escaped(sketch.description), plain_style(), kPaperRules, (width - sketch.width) / 2, sketch.content);
}

std::string plot_style() {
  return fmt::format(".plot{{{}\n{}}}\n@media (prefers-color-scheme:dark){{.plot{{{}}}}}\n{}",
                     variables(&Colour::light), kFonts, variables(&Colour::dark), kRules);
}

std::string stroke_of(const LineStyle& style) {
  if (style.quiet) return "class=\"quiet\"";
  const char* dash = kDashes[static_cast<std::size_t>(style.number / kColours % 4)];
  const std::string classes = fmt::format("class=\"s s{}\"", style.number % kColours);
  return *dash == '\0' ? classes : fmt::format("{} stroke-dasharray=\"{}\"", classes, dash);
}

std::string marker(const LineStyle& style, double x, double y, double radius) {
  const std::string classes = style.quiet ? "m quiet" : fmt::format("m f{}", style.number % kColours);
  // The seven colours go through the six shapes out of step, so that no two of the first 42 share both.
  return fmt::format("<g class=\"{}\">{}</g>", classes, shape(style.number, x, y, radius));
}

std::string svg_element(const std::string& title, const std::string& description, double width, double height,
                        const std::string& content, bool standalone) {
  std::string out = fmt::format(
      "<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" role=\"img\">\n<title>{2}</title>\n<desc>{3}</desc>\n",
      width, height, escaped(title), escaped(description));
  if (standalone)
    out += fmt::format("<style>{}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n", plain_style());
  return out + content + "</svg>\n";
}

}  // namespace leastcost::app
