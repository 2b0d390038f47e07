// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/figure/figure.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>

#include <leastcost/framework/base/errors.hpp>
#include "app/figure/rsvg.hpp"
#include "app/plot/text.hpp"
#include "app/report/space/space_image.hpp"
#include "catalogue/inputs/png_image.hpp"
#include "catalogue/output/write_run.hpp"
#include "tests/app/called.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;

namespace {

const char* const kFigurePlan = R"(manifold: {type: euclidean, lower: [-1, -0.65], upper: [5, 3]}
obstacles:
  - {type: polygon, corners: [[1, -0.5], [2, -0.5], [2, 0.5], [1, 0.5]]}
  - {type: ball, center: [3, 0.2], radius: 0.4}
clearance: 0.1
cost: euclidean
ends: {source: {point: [0, 0]}, target: {point: [4, 0]}}
path: {points: 20}
)";
const char* const kFigureFall = R"(manifold: euclidean
cost: {type: travel_time, gravity: 1}
ends: {source: {point: [0, 0]}, target: {point: [3, -2]}}
path: {points: 15}
)";
const char* const kFigureSphere = R"(manifold: {type: parametric, surface: sphere}
cost: euclidean
ends: {source: {point: [0, 0.2]}, target: {point: [1, 0.9]}}
path: {points: 12}
)";
const char* const kFigureBody = R"(manifold: {type: euclidean, dimension: 3}
robot: {type: rigid_body, shape: [[-0.5, 0, 0.5, 0, 0.1]]}
obstacles: [{type: ball, center: [2, 5], radius: 0.5}]
cost: euclidean
ends: {source: {point: [0, 0, 0]}, target: {point: [4, 1, 0.5]}}
path: {points: 4}
certificate: {enabled: false}
)";

/// An arm that reaches over a board.
const char* const kFigureArm = R"(manifold: robot
robot: {type: dh_arm, model: panda}
obstacles:
  - {type: box, lower: [0.3, -0.5, 0.2], upper: [0.8, 0.5, 0.25]}
  - {type: half_space, normal: [0, 0, 1], offset: -0.05}
cost: euclidean
ends:
  source: {point: [0.9, -0.785, 0, -2.356, 0, 1.571, 0.785]}
  target: {point: [-0.5, -0.785, 0, -2, 0, 1.571, 0.785]}
path: {points: 8}
certificate: {enabled: false}
)";

/// The folder of a run, made by the program itself.
std::string finished_run(const ScratchDir& dir, const std::string& config) {
  const std::string file = (dir / "a.yaml").string(), out = (dir / "run").string();
  std::ofstream(file) << config;
  const Called run = call({"run", file, "-q", "-o", out, "--force"});
  INFO(run.err);
  REQUIRE(fs::exists(fs::path(out) / "scene.json"));
  return out;
}

/// Without most of each long attribute: images and path data are too much for std::regex.
std::string shortened(const std::string& svg) {
  constexpr std::size_t kLong = 200, kKept = 100;
  std::string out;
  for (std::size_t at = 0, end = 0; at < svg.size(); at = end) {
    const std::size_t open = svg.find('"', at), close = open == std::string::npos ? open : svg.find('"', open + 1);
    end = close == std::string::npos ? svg.size() : close + 1;
    const std::size_t length = close == std::string::npos ? 0 : close - open;
    out += length > kLong ? svg.substr(at, open + kKept - at) + '"' : svg.substr(at, end - at);
  }
  return out;
}

std::string figure_of(const ScratchDir& dir, const std::string& config, std::vector<std::string> options = {}) {
  const std::string file = (dir / "a.svg").string();
  options.insert(options.begin(), {"figure", finished_run(dir, config), "-o", file});
  const Called drawn = call(options);
  INFO(drawn.err);
  REQUIRE(drawn.exit == 0);
  return shortened(content(file));
}

/// What the first match of a pattern has in its parentheses.
std::string first_match(const std::string& text, const std::string& pattern) {
  std::smatch match;
  const std::regex regex(pattern);
  return std::regex_search(text, match, regex) ? match[1].str() : "";
}
double first_number(const std::string& text, const std::string& pattern) {
  const std::string word = first_match(text, pattern);
  INFO(pattern);
  REQUIRE(!word.empty());
  return std::stod(word);
}

bool has_part(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Converters know no variables, and fill with black what has no colour.
void check_literal_colours(const std::string& svg) {
  CHECK_FALSE(has_part(svg, "var("));
  const std::string style = first_match(svg, "<style>([^<]*)</style>");
  const std::regex classes("class=\"([^\"]*)\"");
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), classes); it != std::sregex_iterator(); ++it) {
    std::istringstream words((*it)[1].str());
    bool has_colour = false;
    std::string all = (*it)[1].str();
    for (std::string word; words >> word;)
      has_colour = has_colour || word == "plot" || std::regex_search(style, std::regex("\\." + word + "[ {]"));
    INFO(all);
    CHECK(has_colour);
  }
  const std::regex bare("<(path|rect|circle|polygon) (?![^>]*(class|fill)=)[^>]*>");
  for (auto it = std::sregex_iterator(svg.begin(), svg.end(), bare); it != std::sregex_iterator(); ++it) {
    const std::string element = (*it)[0].str();
    const std::string before = svg.substr(0, static_cast<std::size_t>(it->position(0)));
    INFO(element);
    const std::size_t clip = before.rfind("<clipPath"), end = before.rfind("</clipPath");
    if (clip != std::string::npos && (end == std::string::npos || end < clip)) continue;  // it is not painted
    CHECK(has_part(before.substr(before.rfind("<g ")), "class="));
  }
}

}  // namespace

TEST_CASE("figure: a plan has literal colours, its width, axes with a unit and all that it shows in its legend") {
  const ScratchDir dir;
  const std::string svg = figure_of(dir, kFigurePlan, {"--width", "3.5in", "--unit", "m"});
  check_literal_colours(svg);
  CHECK(has_part(svg, "width=\"88.9mm\""));
  for (const char* text : {">x (m)<", ">y (m)<", ">path<", ">first path<", ">points<", ">ends<", ">obstacles<",
                           ">clearance<", ">outside the box<"}) {
    INFO(text);
    CHECK(has_part(svg, text));
  }
  // Letters of 8 pt: 11 px of the drawing.
  CHECK(first_number(svg, "viewBox=\"0 0 ([0-9.]+)") == Approx(3.5 * 72 / 8 * 11).epsilon(1e-4));
}

TEST_CASE("figure: --what leaves out what it does not name") {
  const ScratchDir dir;
  const std::string svg = figure_of(dir, kFigurePlan, {"--what", "path,obstacles"});
  CHECK(has_part(svg, "class=\"path\""));
  CHECK(has_part(svg, "class=\"obstacle\""));
  for (const char* part : {"class=\"first\"", "class=\"point\"", "class=\"end\"", ">path<"}) {
    INFO(part);
    CHECK_FALSE(has_part(svg, part));
  }
}

TEST_CASE("figure: shading has a bar as long as the x axis, with its levels in order") {
  const ScratchDir dir;
  const std::string svg = figure_of(dir, kFigureFall);
  check_literal_colours(svg);
  CHECK(has_part(svg, ">cost per unit of length (s)<"));
  CHECK(has_part(svg, ">cannot be reached<"));
  const std::string bar = svg.substr(svg.rfind("class=\"axis\" x="));
  const double left = first_number(bar, "x=\"([0-9.]+)\""), width = first_number(bar, "width=\"([0-9.]+)\"");
  const double axis_left = first_number(svg, "class=\"axis\" d=\"M([0-9.]+)"),
               axis_width = first_number(svg, "class=\"axis\" d=\"M[0-9. ]+h([0-9.]+)");
  CHECK(left == Approx(axis_left).margin(0.02));
  CHECK(width == Approx(axis_width).margin(0.02));
  // The fall is slow above: 1 / sqrt(2 g depth), from below its least on.
  const std::string levels = svg.substr(svg.rfind("class=\"band\" x=") - 900);
  CHECK(first_number(levels, "middle\">([0-9.]+)<") < 2);
  CHECK(first_number(levels, "middle\">([0-9.]+)<") > 0.4);
}

TEST_CASE("figure: a surface is an image of 300 dpi with a bar that is as long as it says") {
  const ScratchDir dir;
  const std::string svg = figure_of(dir, kFigureSphere, {"--view", "30,20"});
  check_literal_colours(svg);
  REQUIRE(has_part(svg, "data:image/png;base64,iVBORw0KGgo"));
  const double image = first_number(svg, "<image [^>]*width=\"([0-9.]+)\""),
               bar = first_number(svg, "class=\"axis\" d=\"M[^\"]*h([0-9.]+)m"),
               length = first_number(svg, "v6\"/><text [^>]*>([0-9.]+)<");
  CHECK(bar / image == Approx(length / 2).epsilon(0.01));  // the sphere is 2 wide

  Scene scene;
  scene.surface.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  scene.surface.triangles = {{0, 1, 2}};
  const app::PrintSize size = app::print_size("84mm", "8");
  const app::ShadedImage png =
      app::shaded_image(scene.surface, app::view_from({-90, 90}, scene.up), size.pixels(size.sketch_width()));
  const auto byte = [&](std::size_t i) { return static_cast<int>(static_cast<unsigned char>(png.png[i])); };
  CHECK(byte(18) * 256 + byte(19) >= 84 / 25.4 * 300);  // IHDR: width
  CHECK(png.area.min()[0] == Approx(0).margin(0.01));
  CHECK(png.area.max()[0] == Approx(1).margin(0.01));
}

TEST_CASE("figure: a view is read back as its angles, also from straight above") {
  for (const app::Angles angles : {app::Angles{0, 0}, {30, 20}, {215, -40}, {270, 90}}) {
    for (const Eigen::Vector3d& up :
         {Eigen::Vector3d::UnitX().eval(), Eigen::Vector3d::UnitY().eval(), Eigen::Vector3d::UnitZ().eval()}) {
      const app::SpaceView view = app::view_from(angles, up);
      CHECK((view.axes * view.axes.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-14);
      CHECK(view.axes.determinant() == Approx(1));
      CHECK(app::angles_of(view, up).azimuth == angles.azimuth);
      CHECK(app::angles_of(view, up).elevation == angles.elevation);
    }
  }
}

TEST_CASE("figure: a path under a roof is seen from below, one on it from above") {
  Scene scene;
  scene.dimension = 3;
  scene.surface.vertices = {{-1, -1, 0},    {1, -1, 0},    {1, 1, 0},    {-1, 1, 0},
                            {-1, -1, -0.9}, {1, -1, -0.9}, {1, 1, -0.9}, {-1, 1, -0.9}};
  scene.surface.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 1}, {1, 5, 6},
                             {1, 6, 2}, {2, 6, 7}, {2, 7, 3}, {3, 7, 4}, {3, 4, 0}};
  const auto path_at = [&](double height) {
    scene.lines.path.resize(3, 20);
    for (Index i = 0; i < 20; ++i)
      scene.lines.path.col(i) = Eigen::Vector3d(-0.4 + 0.04 * static_cast<double>(i), 0.1, height);
    return app::choose_view(scene).direction()[2];
  };
  CHECK(path_at(-0.5) < 0);
  CHECK(path_at(0.001) > 0);
}

TEST_CASE("figure: of a robot the poses and the way of its hand, which its files have too") {
  const ScratchDir dir;
  const std::string svg = figure_of(dir, kFigureBody, {"--what", "path,obstacles,legend"});
  check_literal_colours(svg);
  CHECK(has_part(svg, "class=\"hand\""));
  CHECK(has_part(svg, ">path of the hand<"));
  const std::string vtp = content(dir / "run" / "path.vtp");
  CHECK(has_part(vtp, "Name=\"coordinates\""));
  const std::string points = vtp.substr(vtp.find("Name=\"Points\""));
  CHECK_THAT(points.substr(0, points.find("</DataArray>")), Contains("4 1 0\n"));  // not the angle as a height
}

TEST_CASE("figure: of a robot in space obstacles and poses as an image, under the way of its hand and axes") {
  const ScratchDir dir;
  const std::string svg = figure_of(dir, kFigureArm, {"--view", "30,25"});
  check_literal_colours(svg);
  for (const char* part : {"data:image/png;base64,iVBORw0KGgo", ">x (m)<", ">y (m)<", ">z (m)<", ">start<", ">between<",
                           ">target<", ">obstacles<", "class=\"hand"}) {
    INFO(part);
    CHECK(has_part(svg, part));
  }
  const Called again = call({"figure", (dir / "run").string(), "-o", (dir / "b.svg").string(), "--what", "obstacles"});
  REQUIRE(again.exit == 0);
  CHECK_FALSE(has_part(content(dir / "b.svg"), "class=\"hand"));

  const std::string vtp = (dir / "a.vtp").string();
  REQUIRE(call({"figure", (dir / "run").string(), "-o", vtp}).exit == 0);
  const std::string xml = content(vtp), parts = xml.substr(xml.find("Name=\"part\""));
  const std::string numbers = parts.substr(0, parts.find("</DataArray>"));
  for (const char* part : {"\n1\n", "\n3\n", "\n4\n", "\n5\n"}) CHECK(has_part(numbers, part));
}

TEST_CASE("figure: what stands in front hides what is behind, and shines through where it is pale") {
  // Seen from above: a small square over a large one.
  const auto square = [](double half, double height) {
    return TriangleSoup{{{-half, -half, height}, {half, -half, height}, {half, half, height}, {-half, half, height}},
                        {{0, 1, 2}, {0, 2, 3}}};
  };
  const app::SpaceView view = app::view_from({-90, 90}, Eigen::Vector3d::UnitZ());
  const Eigen::AlignedBox2d area(Eigen::Vector2d(-2, -2), Eigen::Vector2d(2, 2));
  const auto middle = [&](const std::vector<app::ImageLayer>& layers) {
    const GreyImage image = read_png(app::shaded_image(layers, view, area, 8).png, "image");
    return image.values[static_cast<std::size_t>(4 * image.columns + 4)];
  };
  const app::ImageLayer below{square(2, 0), {250, 250, 250}}, above{square(1, 1), {100, 100, 100}};
  app::ImageLayer pale = above, away = above;
  pale.opacity = 0.5;
  away.surface.triangles = {{0, 2, 1}, {0, 3, 2}};
  away.one_sided = true;
  CHECK(middle({above, below}) == middle({below, above}));
  CHECK(middle({below, above}) == middle({above}));
  CHECK(middle({below, away}) == middle({below}));
  CHECK(middle({below, pale}) > middle({below, above}) + 10);
  CHECK(middle({below, pale}) < middle({below}) - 10);
}

TEST_CASE("figure: surface and path as VTP and PLY have as many of everything as they announce") {
  const ScratchDir dir;
  const std::string folder = finished_run(dir, kFigureFall), ply = (dir / "a.ply").string(),
                    vtp = (dir / "a.vtp").string();
  REQUIRE(call({"figure", folder, "-o", ply}).exit == 0);
  REQUIRE(call({"figure", folder, "-o", vtp}).exit == 0);
  const std::string text = content(ply);
  const auto announced = [&](const char* element) {
    return first_number(text, "element " + std::string(element) + " ([0-9]+)");
  };
  const std::string body = text.substr(text.find("end_header\n") + 11);
  CHECK(static_cast<double>(std::count(body.begin(), body.end(), '\n')) ==
        announced("vertex") + announced("face") + announced("edge"));
  CHECK(announced("face") > 100);
  CHECK(announced("edge") == 16);
  CHECK(has_part(text, "property double cost_per_length"));
  const std::string xml = content(vtp);
  CHECK(first_number(xml, "NumberOfPoints=\"([0-9]+)\"") == announced("vertex"));
  CHECK(first_number(xml, "NumberOfPolys=\"([0-9]+)\"") == announced("face"));
  CHECK(has_part(xml, "NumberOfLines=\"1\""));
}

TEST_CASE("figure: bad options are one sentence with what would be right, and nothing is written") {
  const ScratchDir dir;
  const std::string folder = finished_run(dir, kFigureFall), good = (dir / "a.svg").string();
  struct Case {
    std::vector<std::string> options;
    int exit;
    const char* words;
  };
  for (const Case& c :
       std::vector<Case>{{{"-o", (dir / "a.jpg").string()}, 2, "must end in .svg, .pdf or .png"},
                         {{"-o", (dir / "none" / "a.svg").string()}, 8, "none"},
                         {{"-o", good, "--width", "84"}, 2, "give a number with mm, cm, in or pt, like 84mm"},
                         {{"-o", good, "--width", "wide"}, 2, "'wide' is not a width"},
                         {{"-o", good, "--width", "9m"}, 2, "'9m' is not a width"},
                         {{"-o", good, "--width", "1mm"}, 2, "outside 20mm to 2000mm"},
                         {{"-o", good, "--font-size", "big"}, 2, "'big' is not a font size"},
                         {{"-o", good, "--what", "path,pionts"}, 2, "did you mean 'points'"},
                         {{"-o", good, "--picture", "convergense"}, 2, "did you mean 'convergence'"},
                         {{"-o", good, "--view", "30"}, 2, "azimuth and elevation, like 30,20"},
                         {{"-o", good, "--view", "30,100"}, 2, "outside -90 to 90"},
                         {{"-o", good, "--view", "30,20"}, 4, "--view is for pictures of space"},
                         {{"-o", good, "--picture", "poses"}, 4, "it has map, coordinates, convergence"},
                         {{"-o", good, "--widht", "84mm"}, 2, "did you mean '--width'"}}) {
    std::vector<std::string> all = {"figure", folder};
    all.insert(all.end(), c.options.begin(), c.options.end());
    const Called drawn = call(all);
    INFO(c.words);
    CHECK(drawn.exit == c.exit);
    CHECK_THAT(drawn.err, Contains(c.words));
    CHECK_FALSE(fs::exists(good));
  }
  const Called empty = call({"figure", dir.path().string(), "-o", good});
  CHECK(empty.exit == 4);
  CHECK_THAT(empty.err, Contains("has no manifest.json; give the output folder of `leastcost run`"));
}

TEST_CASE("figure: letters too large for the width are refused with the size that fits") {
  const ScratchDir dir;
  const std::string folder = finished_run(dir, kFigureFall), file = (dir / "a.svg").string();
  const Called refused = call({"figure", folder, "-o", file, "--width", "20mm", "--font-size", "8"});
  CHECK(refused.exit == 2);
  const std::string size = first_match(refused.err, "use at most ([0-9.]+) pt");
  REQUIRE(!size.empty());
  CHECK(call({"figure", folder, "-o", file, "--width", "20mm", "--font-size", size}).exit == 0);
}

TEST_CASE("figure: PDF and PNG by rsvg-convert, in words where it is not") {
  const app::Figure figure{"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"10mm\" height=\"10mm\"/>"};
  CHECK_THROWS_WITH(app::converted_svg(figure.svg, app::FigureFormat::pdf, 300, "no-such-converter"),
                    Contains("no-such-converter is needed for .pdf and was not found: install librsvg2-bin"));
  CHECK_THROWS_WITH(app::require_converter(app::FigureFormat::png, "no-such-converter"),
                    Contains("no-such-converter is needed for .png and was not found"));
  CHECK_NOTHROW(app::require_converter(app::FigureFormat::svg, "no-such-converter"));
  CHECK_THROWS_WITH(app::converted_svg(figure.svg, app::FigureFormat::png, 300, "false"),
                    Contains("false could not make the .png"));
  try {
    const std::string pdf = app::converted_svg(figure.svg, app::FigureFormat::pdf, 300);
    CHECK(pdf.substr(0, 5) == "%PDF-");
    const std::string png = app::converted_svg(figure.svg, app::FigureFormat::png, 300);
    CHECK(static_cast<unsigned char>(png[19]) == std::ceil(10 / 25.4 * 300));
  } catch (const HostError&) {
    record_skip("rsvg-convert", "not installed (Debian package librsvg2-bin)");
  }
}

TEST_CASE("figure: bytes in base 64") {
  CHECK(app::base64("") == "");
  CHECK(app::base64("f") == "Zg==");
  CHECK(app::base64("fo") == "Zm8=");
  CHECK(app::base64("foobar") == "Zm9vYmFy");
  CHECK(app::base64("\xff\xfe\xfd") == "//79");
}

}  // namespace leastcost::test
