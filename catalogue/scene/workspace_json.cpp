// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/scene/workspace_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

using Json = nlohmann::json;
using Eigen::Vector3d;

constexpr double kOfTurns = 1e4;  ///< four decimals of a quaternion

/// Numbers in one list, rounded to 1 / scale.
class Flat {
 public:
  explicit Flat(double scale) : scale_(scale) {}
  void add(double value) { add(value, scale_); }
  void add(double value, double scale) {
    const double rounded = std::round(value * scale) / scale;
    list_.push_back(rounded == 0 ? 0.0 : rounded);
  }
  void add(const Vector3d& x) {
    for (const double value : x) add(value);
  }
  void add_whole(std::size_t value) { list_.push_back(value); }
  Json list() const { return list_; }

 private:
  double scale_;
  Json list_ = Json::array();
};

Json soup_json(const TriangleSoup& soup, double scale) {
  Flat vertices(scale);
  for (const Vector3d& x : soup.vertices) vertices.add(x);
  Json corners = Json::array();
  for (const auto& triangle : soup.triangles)
    for (const int corner : triangle) corners.push_back(corner);
  return {{"vertices", vertices.list()}, {"triangles", corners}};
}

std::vector<double> numbers(const Json& json, std::size_t each, const char* name) {
  auto all = json.get<std::vector<double>>();
  if (all.size() % each != 0)
    throw InputError(std::string("a list of ") + name + " whose length is not a multiple of " + std::to_string(each));
  return all;
}

Vector3d at(const std::vector<double>& all, std::size_t i) { return {all[i], all[i + 1], all[i + 2]}; }

TriangleSoup read_soup(const Json& json) {
  TriangleSoup out;
  const std::vector<double> places = numbers(json.at("vertices"), 3, "places");
  for (std::size_t i = 0; i < places.size(); i += 3) out.vertices.push_back(at(places, i));
  const auto corners = json.at("triangles").get<std::vector<int>>();
  if (corners.size() % 3 != 0) throw InputError("a list of triangles whose length is not a multiple of 3");
  for (const int corner : corners)
    if (corner < 0 || static_cast<std::size_t>(corner) >= out.vertices.size())
      throw InputError("a triangle of a robot's workspace refers to a vertex that is not there");
  for (std::size_t i = 0; i < corners.size(); i += 3)
    out.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  return out;
}

/// The number of a link, below `links`.
std::size_t link_of(double number, std::size_t links) {
  if (!(number >= 0 && number < static_cast<double>(links)))
    throw InputError("a part of a robot that belongs to no link");
  return static_cast<std::size_t>(number);
}

}  // namespace

std::string workspace_json(const Workspace& workspace) {
  const double size = (workspace.upper - workspace.lower).norm();
  const double digits = size > 0 && std::isfinite(size) ? 4 - std::floor(std::log10(size)) : 4;
  const double scale = std::pow(10.0, std::clamp(digits, -200.0, 200.0));
  Flat lower(scale), upper(scale), capsules(scale), plates(scale);
  lower.add(workspace.lower);
  upper.add(workspace.upper);
  for (const DrawnCapsule& capsule : workspace.capsules) {
    capsules.add_whole(capsule.link);
    capsules.add(capsule.from);
    capsules.add(capsule.to);
    capsules.add(capsule.radius);
  }
  for (const DrawnPlate& plate : workspace.plates) {
    plates.add_whole(plate.link);
    for (const Vector3d& corner : plate.corners) plates.add(corner);
  }
  Json poses = Json::array();
  for (const std::vector<DrawnFrame>& pose : workspace.poses) {
    Flat frames(scale);
    for (const DrawnFrame& frame : pose) {
      for (const double value : frame.turn.coeffs()) frames.add(value, kOfTurns);
      frames.add(frame.origin);
    }
    poses.push_back(frames.list());
  }
  const Json json = {{"unit", workspace.unit},
                     {"lower", lower.list()},
                     {"upper", upper.list()},
                     {"capsules", capsules.list()},
                     {"plates", plates.list()},
                     {"poses", poses},
                     {"obstacles", soup_json(workspace.obstacles, scale)},
                     {"ground", soup_json(workspace.ground, scale)},
                     {"notes", workspace.notes}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Workspace read_workspace(const Json& json) {
  constexpr std::size_t kOfCapsule = 8, kOfPlate = 10, kOfFrame = 7;
  Workspace out;
  out.unit = json.at("unit").get<std::string>();
  for (const auto& [name, corner] : {std::pair("lower", &out.lower), std::pair("upper", &out.upper)}) {
    const std::vector<double> place = numbers(json.at(name), 3, "places");
    if (place.size() != 3) throw InputError("a corner of a robot's workspace that is not one place");
    *corner = at(place, 0);
  }
  for (const Json& pose : json.at("poses")) {
    const std::vector<double> frames = numbers(pose, kOfFrame, "frames");
    std::vector<DrawnFrame>& links = out.poses.emplace_back();
    for (std::size_t i = 0; i < frames.size(); i += kOfFrame) {
      const Eigen::Quaterniond turn(frames[i + 3], frames[i], frames[i + 1], frames[i + 2]);
      links.push_back({turn.norm() > 0 ? turn.normalized() : Eigen::Quaterniond::Identity(), at(frames, i + 4)});
    }
    if (links.size() != out.poses.front().size()) throw InputError("poses of a robot with different numbers of links");
  }
  const std::size_t links = out.poses.empty() ? 0 : out.poses.front().size();
  const std::vector<double> capsules = numbers(json.at("capsules"), kOfCapsule, "capsules");
  for (std::size_t i = 0; i < capsules.size(); i += kOfCapsule)
    out.capsules.push_back(
        {link_of(capsules[i], links), at(capsules, i + 1), at(capsules, i + 4), std::abs(capsules[i + 7])});
  const std::vector<double> plates = numbers(json.at("plates"), kOfPlate, "plates");
  for (std::size_t i = 0; i < plates.size(); i += kOfPlate)
    out.plates.push_back({link_of(plates[i], links), {at(plates, i + 1), at(plates, i + 4), at(plates, i + 7)}});
  out.obstacles = read_soup(json.at("obstacles"));
  out.ground = read_soup(json.at("ground"));
  out.notes = json.at("notes").get<std::vector<std::string>>();
  return out;
}

}  // namespace leastcost
