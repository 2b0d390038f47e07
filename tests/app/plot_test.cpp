// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

#include "app/plot/chart.hpp"
#include "app/plot/contour.hpp"
#include "app/plot/scale.hpp"
#include "app/plot/text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

using namespace app;
using Catch::Contains;

namespace {

std::vector<double> places(const std::vector<Tick>& ticks, bool labelled = false) {
  std::vector<double> out;
  for (const Tick& t : ticks)
    if (!labelled || !t.label.empty()) out.push_back(t.at);
  return out;
}

/// Area of all polygons of path data with absolute M, L, H, V and Z, by the shoelace formula.
double area_of(const std::string& d) {
  double area = 0, x = 0, y = 0, start_x = 0, start_y = 0;
  const char* at = d.c_str();
  const auto number = [&] {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    at = end;
    return value;
  };
  const auto to = [&](double to_x, double to_y) {
    area += (x * to_y - to_x * y) / 2;
    x = to_x, y = to_y;
  };
  while (*at != '\0') {
    const char command = *at++;
    if (command == 'M') {
      x = start_x = number();
      y = start_y = number();
    } else if (command == 'L') {
      const double to_x = number();
      to(to_x, number());
    } else if (command == 'H') {
      to(number(), y);
    } else if (command == 'V') {
      to(x, number());
    } else {
      REQUIRE(command == 'Z');
      to(start_x, start_y);
    }
  }
  return area;
}

}  // namespace

TEST_CASE("plot: what ends an element or an attribute is escaped") {
  CHECK(escaped("a<b> & \"c\" 'd'") == "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
  CHECK(escaped("</script><script>alert(1)</script>") == "&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;");
  CHECK(escaped("Möbius, 10⁻¹², 𝒮\n\t") == "Möbius, 10⁻¹², 𝒮\n\t");
}

TEST_CASE("plot: what is no text becomes the replacement character") {
  const std::string r = "\xEF\xBF\xBD";
  CHECK(escaped(std::string("a\0b", 3)) == "a" + r + "b");
  CHECK(escaped("\x1b[31m") == r + "[31m");
  CHECK(escaped("\xff\xfe") == r + r);
  CHECK(escaped("\xc0\xbc") == r + r);          // an overlong form of <
  CHECK(escaped("\xe0\x80\xbc") == r + r + r);  // another one
  CHECK(escaped("\xed\xa0\x80") == r + r + r);  // half of a surrogate pair
  CHECK(escaped("end \xe2\x82") == "end " + r + r);
}

TEST_CASE("plot: numbers for people") {
  CHECK(app::number_text(0) == "0");
  CHECK(app::number_text(1234.5678, 6) == "1234.57");
  CHECK(app::number_text(0.05, 2) == "0.050");
  CHECK(app::number_text(1.149e-30) == "1.15 × 10⁻³⁰");
  CHECK(app::number_text(-2e7, 1) == "−2 × 10⁷");
  CHECK(app::number_text(9.996e-4, 3) == "0.00100");  // rounding carries
  CHECK(app::number_text(std::nan("")) == "n/a");
  CHECK(app::number_text(-1.0 / 0.0) == "−∞");
}

TEST_CASE("plot: linear ticks are round, and within the range") {
  CHECK(places(ticks(ScaleKind::linear, {0, 10}, 5)) == std::vector<double>{0, 2, 4, 6, 8, 10});
  const std::vector<Tick> fine = ticks(ScaleKind::linear, {-0.12, 0.31}, 4);
  REQUIRE(fine.size() == 5);
  CHECK(fine[0].label == "−0.1");
  CHECK(fine[1].label == "0.0");
  CHECK(fine[4].label == "0.3");
  const std::vector<Tick> tiny = ticks(ScaleKind::linear, {-1.1e-4, 1.3e-4}, 4);
  CHECK(tiny.front().label == "−1.0·10⁻⁴");
  CHECK(ticks(ScaleKind::linear, {4412030.25, 4412030.75}, 5).front().label == "4412030.3");  // of a map
  CHECK(ticks(ScaleKind::linear, {0, 3e6}, 3).back().label == "3·10⁶");
  const auto [least, largest] = GENERATE(table<double, double>({{0, 1}, {-3e5, 7e6}, {1e-9, 3e-9}, {0.9999, 1.0001}}));
  for (const Tick& t : ticks(ScaleKind::linear, {least, largest}, 5)) {
    CHECK(t.at >= least - 1e-9 * (largest - least));
    CHECK(t.at <= largest + 1e-9 * (largest - least));
  }
  CHECK(ticks(ScaleKind::linear, {least, largest}, 5).size() >= 2);
}

TEST_CASE("plot: logarithmic ticks") {
  CHECK(places(ticks(ScaleKind::log, {1, 1e4}, 6)) == std::vector<double>{1, 10, 100, 1e3, 1e4});
  CHECK(places(ticks(ScaleKind::log, {20, 200}, 6)) == std::vector<double>{20, 50, 100, 200});
  const std::vector<Tick> wide = ticks(ScaleKind::log, {1e-30, 1}, 4);
  const std::vector<double> labelled = places(wide, true);
  CHECK(labelled.size() == 4);
  CHECK(labelled[0] == Approx(1e-30));
  CHECK(wide.back().label == "10⁰");
}

TEST_CASE("plot: logarithmic axes have two labels at least, however narrow") {
  const auto [least, largest, wanted] = GENERATE(table<double, double, int>(
      {{210, 460, 6}, {4.2, 4.8, 4}, {0.99, 1.01, 2}, {3, 450, 2}, {2e-7, 3e-4, 2}, {5e-30, 5e30, 2}}));
  CAPTURE(least, largest);
  const std::vector<double> labelled = places(ticks(ScaleKind::log, {least, largest}, wanted), true);
  CHECK(labelled.size() >= 2);
  for (const double at : labelled) {
    CHECK(at >= least * (1 - 1e-9));
    CHECK(at <= largest * (1 + 1e-9));
  }
}

TEST_CASE("plot: a file of its own has colours for whoever draws it") {
  Chart chart;
  chart.series = {{"a", {0, 1, 2, 3}, {1, 2, 3, 4}}, {"b", {0, 1, 2, 3}, {4, 2, 1, 4}}};
  chart.series[1].style.number = 1;
  const std::string file = svg(chart, true);
  // Converters and editors know neither variables nor media queries, and draw what they do not understand in black.
  CHECK(file.find("var(") == std::string::npos);
  CHECK(file.find("@media") == std::string::npos);
  CHECK_THAT(file, Contains(".plot .s0{stroke:#0072B2}") && Contains(".plot .s{fill:none"));
  CHECK_THAT(plot_style(), Contains("prefers-color-scheme:dark") && Contains("--c0:#4aa3dc") && Contains("var(--c0)"));
  if (std::system("rsvg-convert --version >/dev/null 2>&1") != 0)
    return record_skip("colours of SVG files", "rsvg-convert is not installed");
  const ScratchDir dir;
  const auto drawn = [&](const std::string& name, const std::string& text) {
    std::ofstream(dir / (name + ".svg")) << text;
    const std::string out = (dir / (name + ".png")).string();
    CHECK(std::system(("rsvg-convert '" + (dir / (name + ".svg")).string() + "' -o '" + out + "'").c_str()) == 0);
    std::ifstream in(out, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  // Every stroke, fill and width of the style is seen: without one of them the picture is another one.
  const std::string picture = drawn("whole", file);
  for (const char* rule :
       {".plot .s{fill:none", ".plot .s0{stroke:#0072B2}", ".plot .s1{stroke:#D55E00}", ".plot .grid{"}) {
    std::string without = file;
    REQUIRE(without.find(rule) != std::string::npos);
    without.replace(without.find(rule), 5, ".none");
    CAPTURE(rule);
    const bool seen = drawn("without", without) != picture;
    CHECK(seen);
  }
}

TEST_CASE("plot: counts have no fractions, and labels have room") {
  Chart chart;
  chart.x = {"iterations"};
  chart.x.whole = true;
  chart.series = {{"", {0, 1, 2, 3}, {1, 2, 3, 4}}};
  const std::string counts = svg(chart);
  CHECK_THAT(counts, Contains("middle\">0<") && Contains("middle\">1<") && Contains("middle\">3<"));
  CHECK(counts.find("middle\">0.5<") == std::string::npos);
  chart.x = {"seconds"};
  chart.width = 200;
  chart.series[0].x = {0, 1e-4, 2e-4, 3.1e-4};
  const std::string narrow = svg(chart);
  std::size_t labels = 0;
  for (std::size_t at = narrow.find("·10"); at != std::string::npos; at = narrow.find("·10", at + 1)) ++labels;
  CHECK(labels >= 1);
  CHECK(labels <= 3);  // some 130 px, 50 for each
}

TEST_CASE("plot: ranges leave out what a scale cannot show") {
  const double infinity = std::numeric_limits<double>::infinity();
  const Range log = range_of({0, -1, std::nan(""), infinity, 1e-3, 10}, ScaleKind::log);
  CHECK(log.least > 0);
  CHECK(log.least < 1e-3);
  CHECK(log.largest > 10);
  const Range same = range_of({5, 5}, ScaleKind::linear);
  CHECK(same.least < 5);
  CHECK(same.largest > 5);
  const Range none = range_of({}, ScaleKind::linear);
  CHECK(none.least < none.largest);
  CHECK(position_in(ScaleKind::log, {1, 100}, 10) == Approx(0.5));
  CHECK(std::isnan(position_in(ScaleKind::log, {1, 100}, 0)));
}

TEST_CASE("plot: a chart says what it is, and leaves gaps where there is no value") {
  Chart chart;
  chart.title = "a < b";
  chart.description = "one & two";
  chart.x = {"x"};
  chart.y = {"y", ScaleKind::log};
  chart.series = {{"s<1>", {1, 2, 3, 4}, {1, 0, 10, 100}, {0, true, true}}};
  const std::string text = svg(chart, true);
  CHECK_THAT(text, Contains("<title>a &lt; b</title>") && Contains("<desc>one &amp; two</desc>") &&
                       Contains("s&lt;1&gt;") && Contains("<style>"));
  const std::string line = text.substr(text.find("<path class=\"s s0\" d=\""));
  const std::string d = line.substr(0, line.find("/>"));
  CHECK(std::count(d.begin(), d.end(), 'M') == 2);  // before and after the zero
  CHECK(text.find("nan") == std::string::npos);
  CHECK(text.find("inf") == std::string::npos);
}

TEST_CASE("plot: seven colours, then dashes, shapes differ as well") {
  CHECK(stroke_of({0}) == "class=\"s s0\"");
  CHECK_THAT(stroke_of({7}), Contains("s s0") && Contains("stroke-dasharray"));
  std::set<std::string> looks;
  for (int k = 0; k < 28; ++k) looks.insert(stroke_of({k}) + marker({k}, 0, 0));
  CHECK(looks.size() == 28);
}

TEST_CASE("plot: the region above a level") {
  const auto same = [](double v) { return 10 * v; };
  Grid grid{5, 4, {}};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 5; ++i) grid.values.push_back(i);
  // f = x on [0, 4] x [0, 3]: above 1.5 lies 2.5 x 3, in units of the drawing 100 times as much.
  CHECK(std::abs(area_of(region_above(grid, 1.5, same, same))) == Approx(750));
  CHECK(std::abs(area_of(region_above(grid, -1, same, same))) == Approx(1200));
  CHECK(region_above(grid, 9, same, same).empty());
  for (int j = 0; j < 4; ++j) grid.values[static_cast<std::size_t>(5 * j)] = std::numeric_limits<double>::infinity();
  CHECK(std::abs(area_of(region_infinite(grid, same, same))) == Approx(300));
  CHECK(region_above(grid, 2.5, same, same).find("nan") == std::string::npos);
}

}  // namespace leastcost::test
