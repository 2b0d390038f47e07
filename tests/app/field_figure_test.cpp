// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// `leastcost field --figure`: what is in the picture, and what is refused.
#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "tests/app/called.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;

const char* const kRoom = "manifold: {type: euclidean, lower: [0, 0], upper: [4, 2]}\ncost: euclidean\n";

/// The attributes `d` of paths of a class.
std::vector<std::string> paths_of(const std::string& svg, const std::string& name) {
  std::vector<std::string> all;
  const std::regex path("<path class=\"" + name + "\"[^>]* d=\"([^\"]*)\"");
  for (std::sregex_iterator it(svg.begin(), svg.end(), path), end; it != end; ++it) all.push_back((*it)[1]);
  return all;
}

/// The places that path data without curves name.
std::vector<Eigen::Vector2d> points_in(const std::string& d) {
  std::vector<Eigen::Vector2d> points;
  const std::regex place("[ML]([-0-9.]+) ([-0-9.]+)");
  for (std::sregex_iterator it(d.begin(), d.end(), place), end; it != end; ++it)
    points.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  return points;
}

/// The middle of the first circle of a class that stands in the drawing, not in its legend.
Eigen::Vector2d circle_in(const std::string& svg, const std::string& name) {
  const std::regex circle("<circle class=\"" + name + "\" cx=\"([-0-9.]+)\" cy=\"([-0-9.]+)\"");
  std::smatch found;
  REQUIRE(std::regex_search(svg, found, circle));
  return {std::stod(found[1]), std::stod(found[2])};
}

}  // namespace

TEST_CASE("field figure: lines of equal distance are circles around the place, at the round values of the bar") {
  const ScratchDir dir;
  const std::string config = text_file(dir / "room.yaml", kRoom), file = (dir / "f.svg").string();
  const Called called = call({"field", config, "--figure", file, "--from", "1,1", "--to", "3,1", "--unit", "m"});
  CHECK(called.err == "");
  REQUIRE(called.exit == 0);
  CHECK_THAT(called.out, Contains("f.svg: 201 x 101 nodes"));
  const std::string svg = content(file);
  CHECK_THAT(svg, Contains("least cost from the source (m)") && Contains(">x (m)<") && Contains(">equal cost<") &&
                      Contains(">path<") && Contains(">2.0<") && Contains("width=\"84mm\""));
  CHECK_THAT(svg, !Contains(">no path<") && !Contains(">obstacles<"));
  const Eigen::Vector2d place = circle_in(svg, "end"), target = circle_in(svg, "point");
  const double scale = (target[0] - place[0]) / 2;  // px per length
  REQUIRE(scale > 1);
  CHECK(target[1] == Approx(place[1]));
  // Levels at 0.2, 0.4, ... 3.0 or at multiples of another round value; the legend has a sample of one line.
  std::vector<double> levels;
  for (const std::string& line : paths_of(svg, "level")) {
    const std::vector<Eigen::Vector2d> points = points_in(line);
    if (points.size() < 3) continue;
    levels.push_back((points[0] - place).norm() / scale);
    for (const Eigen::Vector2d& point : points)
      CHECK((point - place).norm() / scale == Approx(levels.back()).margin(0.3 / scale));
  }
  REQUIRE(levels.size() >= 5);
  for (std::size_t k = 0; k < levels.size(); ++k)
    CHECK(levels[k] == Approx((double(k) + 1) * levels[0]).margin(0.3 / scale));
  const std::vector<Eigen::Vector2d> way = points_in(paths_of(svg, "path").at(0));
  CHECK((way.front() - place).norm() < 0.1);
  CHECK((way.back() - target).norm() < 0.1);
}

TEST_CASE("field figure: obstacles are drawn over the field, and a corridor has its ends and its cheapest way") {
  const ScratchDir dir;
  const std::string config = text_file(dir / "disc.yaml", std::string(kRoom) +
                                                              "obstacles: [{type: ball, center: [2, 1], radius: 0.5}]\n"
                                                              "ends: {source: {point: [1, 1]}, target: {point: [3, "
                                                              "1.2]}}\n");
  const std::string file = (dir / "f.svg").string(), table = (dir / "f.csv").string();
  const Called called = call({"field", config, "--figure", file, "--corridor", "-o", table});
  CHECK(called.err == "");
  REQUIRE(called.exit == 0);
  CHECK(fs::exists(table));
  const std::string svg = content(file);
  CHECK_THAT(svg, Contains("cost of a detour above the least") && Contains(">ends<") && Contains(">obstacles<") &&
                      Contains(">path<"));
  CHECK_THAT(svg, !Contains(">no path<"));  // the nodes in the disc are behind it
  REQUIRE(call({"field", config, "--figure", file, "--what", "shading,ends"}).exit == 0);
  CHECK_THAT(content(file), !Contains("class=\"obstacle\"") && !Contains(">obstacles<") && Contains("class=\"warm\""));

  // A closed room in the corner.
  const std::string closed =
      text_file(dir / "closed.yaml", std::string(kRoom) +
                                         "obstacles: [{type: box, lower: [3, 0], upper: [3.1, 1]}, {type: box, lower: "
                                         "[3, 0.9], upper: [4, 1]}]\nclearance: 0.02\n");
  REQUIRE(call({"field", closed, "--figure", file, "--from", "1,1"}).exit == 0);
  CHECK_THAT(content(file), Contains(">no path<"));
}

TEST_CASE("field figure: what is refused") {
  const ScratchDir dir;
  const std::string config = text_file(dir / "room.yaml", kRoom);
  const auto refused = [&](std::vector<std::string> more, int exit, const std::string& words) {
    std::vector<std::string> all = {"field", config, "--from", "1,1"};
    all.insert(all.end(), more.begin(), more.end());
    const Called called = call(all);
    CHECK(called.exit == exit);
    CHECK_THAT(called.err, Contains(words));
  };
  refused({}, 2, "--output FILE, --figure FILE, or both");
  refused({"--figure", (dir / "f.ply").string()}, 2, "must end in .svg, .pdf or .png");
  refused({"--figure", (dir / "f.svg").string(), "--width", "3"}, 2, "is not a width");
  refused({"--figure", (dir / "none/f.svg").string()}, 8, "none");
  text_file(dir / "fold.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string mesh = text_file(dir / "mesh.yaml", "manifold: {type: mesh, file: fold.obj}\ncost: euclidean\n");
  const Called called = call({"field", mesh, "--from", "0", "--figure", (dir / "f.svg").string()});
  CHECK(called.exit == 4);
  CHECK_THAT(called.err, Contains("write one on a mesh as .ply or .vtp"));
}

}  // namespace leastcost::test
