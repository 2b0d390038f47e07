// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/plugins/attached_options.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include "problems/robots/cover_mesh.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;
using Form = AttachedOptions::Shape;

template <class Value>
const Value& needed(const std::optional<Value>& given, const char* key, const char* of) {
  if (!given) throw OptionError(key, std::string("is missing: ") + of + " has one");
  return *given;
}

double positive(const std::optional<double>& given, const char* key, const char* of) {
  const double value = needed(given, key, of);
  if (!(value > 0)) throw OptionError(key, "must be greater than 0");
  return value;
}

Vector3d place(const std::optional<Eigen::VectorXd>& given, const char* key, const char* of) {
  const Eigen::VectorXd& value = needed(given, key, of);
  if (value.size() != 3 || !value.allFinite()) throw OptionError(key, "must be three finite numbers");
  return value;
}

Covering shape_of(const AttachedOptions& object, const std::filesystem::path& folder) {
  switch (object.type) {
    case Form::box: {
      const Vector3d size = place(object.size, "size", "a box");
      return cover_box(size);
    }
    case Form::ball: return {{{0, Vector3d::Zero(), Vector3d::Zero(), positive(object.radius, "radius", "a ball")}}, 0};
    case Form::cylinder:
      return cover_cylinder(positive(object.height, "height", "a cylinder"),
                            positive(object.radius, "radius", "a cylinder"));
    case Form::capsule:
      return {{{0, place(object.from, "from", "a capsule"), place(object.to, "to", "a capsule"),
                positive(object.radius, "radius", "a capsule")}},
              0};
    case Form::mesh: break;
  }
  if (object.file.empty()) throw OptionError("file", "is missing: a mesh has one");
  const PolygonSoup mesh = read_mesh(folder / object.file);
  std::vector<std::array<std::int32_t, 3>> faces;
  for (std::size_t p = 0; p + 1 < mesh.polygon_begin.size(); ++p) {
    const auto begin = static_cast<std::size_t>(mesh.polygon_begin[p]),
               end = static_cast<std::size_t>(mesh.polygon_begin[p + 1]);
    for (std::size_t k = begin + 2; k < end; ++k)
      faces.push_back({mesh.corners[begin], mesh.corners[k - 1], mesh.corners[k]});
  }
  return cover_mesh(mesh.positions, faces);
}

/// Options of other shapes, which would be passed over.
void refuse_others(const AttachedOptions& object) {
  const auto refuse = [&](bool given, const char* key, std::initializer_list<Form> shapes) {
    if (given && std::count(shapes.begin(), shapes.end(), object.type) == 0)
      throw OptionError(key, "is not an option of this type of shape");
  };
  refuse(object.size.has_value(), "size", {Form::box});
  refuse(object.radius.has_value(), "radius", {Form::ball, Form::cylinder, Form::capsule});
  refuse(object.height.has_value(), "height", {Form::cylinder});
  refuse(object.from.has_value(), "from", {Form::capsule});
  refuse(object.to.has_value(), "to", {Form::capsule});
  refuse(!object.file.empty(), "file", {Form::mesh});
}

std::string name_of(const AttachedOptions& object) {
  if (!object.id.empty()) return object.id;
  for (const auto& word : words(object.type))
    if (word.value == object.type) return "the attached " + std::string(word.word);
  return "the attached object";
}

}  // namespace

Words<AttachedOptions::Shape> words(AttachedOptions::Shape) {
  static constexpr std::array<Word<Form>, 5> kWords = {{{Form::box, "box"},
                                                        {Form::ball, "ball"},
                                                        {Form::cylinder, "cylinder"},
                                                        {Form::capsule, "capsule"},
                                                        {Form::mesh, "mesh"}}};
  return kWords;
}

void AttachedOptions::fields(FieldVisitor& visit) {
  visit.field("id", id, {.help = "Name of the object in messages."});
  visit.field("link", link, {.help = "Name of the link that carries the object; default: the last one."});
  visit.choice(
      "type", type,
      {.help = "Shape, in the object's own frame, placed in it like an obstacle of this type.", .required = true});
  visit.field("size", size, {.help = "Edge lengths of a box.", .unit = "length"});
  visit.field("radius", radius, {.help = "Radius of a ball, a cylinder or a capsule.", .unit = "length", .minimum = 0});
  visit.field("height", height, {.help = "Height of a cylinder, along its z axis.", .unit = "length", .minimum = 0});
  visit.field("from", from, {.help = "One end of the axis of a capsule.", .unit = "length"});
  visit.field("to", to, {.help = "The other end of the axis of a capsule.", .unit = "length"});
  visit.file("file", file, {.help = "File of a mesh: OBJ, OFF, PLY or STL; it is taken as solid."});
  visit.group("pose", {.help = "Position and rotation of the object's frame in the link's frame."},
              [&](FieldVisitor& inner) { pose.fields(inner); });
  visit.field(
      "touches", touches,
      {.help = "Links, and ids of other objects, that the object may touch; it may always touch the link that carries "
               "it and what moves with that link."});
}

bool has_files(const std::vector<AttachedOptions>& attached) {
  return std::any_of(attached.begin(), attached.end(),
                     [](const AttachedOptions& object) { return object.type == Form::mesh; });
}

std::shared_ptr<const Robot> attach(std::shared_ptr<const Robot> robot, const std::vector<AttachedOptions>& attached,
                                    const std::filesystem::path& folder) {
  if (attached.empty()) return robot;
  std::vector<AttachedObject> objects;
  for (std::size_t i = 0; i < attached.size(); ++i) {
    const AttachedOptions& given = attached[i];
    try {
      if (std::count_if(attached.begin(), attached.end(), [&](const auto& one) { return one.id == given.id; }) > 1 &&
          !given.id.empty())
        throw OptionError("id", "'" + given.id + "' is given to two objects: each needs an id of its own");
      refuse_others(given);
      const Eigen::Isometry3d pose = pose_of(given.pose, 3);
      objects.push_back({.name = name_of(given),
                         .link = given.link,
                         .pose = {pose.linear(), pose.translation()},
                         .shape = shape_of(given, folder),
                         .touches = given.touches});
    } catch (const OptionError& error) {
      throw error.under("attached." + std::to_string(i));
    }
  }
  try {
    return with_attached(*robot, objects);
  } catch (const OptionError& error) {
    throw error.under("attached");
  }
}

}  // namespace leastcost
