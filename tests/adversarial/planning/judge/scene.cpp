// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "tests/adversarial/planning/judge/scene.hpp"

#include <algorithm>
#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace judge {
namespace {

constexpr int kDigits = 17;

void put(const Place& x, std::ostream& out) {
  for (const double v : x) out << ' ' << v;
}

Place take(std::istream& in, int dimension) {
  Place x(static_cast<std::size_t>(dimension));
  for (double& v : x)
    if (!(in >> v)) throw std::runtime_error("a coordinate is missing, or no number");
  return x;
}

Thing take_thing(const std::string& word, std::istream& in, int dimension) {
  Thing thing;
  int corners = 1;
  if (word == "ball") {
    in >> thing.radius;
  } else if (word == "box") {
    thing.kind = Thing::Kind::box;
    corners = 2;
  } else if (word == "polygon") {
    thing.kind = Thing::Kind::polygon;
    in >> corners;
  } else {
    throw std::runtime_error("unknown word '" + word + "'");
  }
  for (int i = 0; i < corners; ++i) thing.corners.push_back(take(in, dimension));
  return thing;
}

}  // namespace

double Scene::diameter() const {
  double widest = 0;
  for (std::size_t k = 0; k < source.size(); ++k) {
    double low = std::min(source[k], target[k]), high = std::max(source[k], target[k]);
    for (const Thing& thing : things)
      for (const Place& x : thing.corners) {
        low = std::min(low, x[k] - thing.radius - clearance);
        high = std::max(high, x[k] + thing.radius + clearance);
      }
    widest = std::max(widest, high - low);
  }
  return widest;
}

void write(const Scene& scene, std::ostream& out) {
  out.precision(kDigits);
  out << "scene " << scene.dimension << "\nclearance " << scene.clearance << "\nsource";
  put(scene.source, out);
  out << "\ntarget";
  put(scene.target, out);
  out << '\n';
  for (const Thing& thing : scene.things) {
    if (thing.kind == Thing::Kind::ball) out << "ball " << thing.radius;
    if (thing.kind == Thing::Kind::box) out << "box";
    if (thing.kind == Thing::Kind::polygon) out << "polygon " << thing.corners.size();
    for (const Place& x : thing.corners) put(x, out);
    out << '\n';
  }
}

Scene read_scene(std::istream& in) {
  Scene scene;
  std::string word;
  while (in >> word) {
    if (word == "scene")
      in >> scene.dimension;
    else if (word == "clearance")
      in >> scene.clearance;
    else if (word == "source")
      scene.source = take(in, scene.dimension);
    else if (word == "target")
      scene.target = take(in, scene.dimension);
    else
      scene.things.push_back(take_thing(word, in, scene.dimension));
  }
  if (scene.source.empty() || scene.target.empty()) throw std::runtime_error("a scene has a source and a target");
  return scene;
}

void write(const std::vector<Place>& path, std::ostream& out) {
  out.precision(kDigits);
  for (const Place& x : path) {
    put(x, out);
    out << '\n';
  }
}

std::vector<Place> read_path(std::istream& in, int dimension) {
  std::vector<Place> path;
  std::string line;
  while (std::getline(in, line)) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::istringstream numbers(line);
    path.push_back(take(numbers, dimension));
  }
  return path;
}

}  // namespace judge
