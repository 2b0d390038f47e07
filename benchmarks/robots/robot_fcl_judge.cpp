// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Whether exact shapes meet each other in given poses, by the collision library FCL. It knows nothing of this library.
// random_robots.py starts it. Standard input, words and then binary doubles:
//   links L
//   shapes N       then N lines: link KIND NUMBERS POSE
//   obstacles M    then M lines: KIND NUMBERS POSE
//   walls W        then W lines: SHAPE OBSTACLE  (pairs that must not meet)
//   pairs P        then P lines: SHAPE SHAPE
//   places K       then a line break and K * L poses of links, 12 doubles each: three rows of a 3 x 4 matrix
// KIND NUMBERS: sphere r; capsule r length; cylinder r length; cone r height; box x y z; half_space nx ny nz offset;
// hull V x y z .. F a b c .. (a convex polyhedron); faces V x y z .. F a b c .. (a surface). POSE: 12 numbers.
// Standard output: a line `wall|pair FIRST SECOND PLACE COUNT` for each pair that meets, then `judged PLACES TESTS`.
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>

#include <cstddef>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Pose = fcl::Transform3d;
using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

template <class Number>
Number next(std::istream& in) {
  Number value{};
  if (!(in >> value)) throw std::runtime_error("a number or a word is missing");
  return value;
}

void expect(std::istream& in, const std::string& word) {
  if (next<std::string>(in) != word) throw std::runtime_error("'" + word + "' is missing");
}

Pose pose_of(const double* numbers) {
  Pose pose = Pose::Identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) pose(row, column) = numbers[4 * row + column];
  return pose;
}

Pose read_pose(std::istream& in) {
  double numbers[12];
  for (double& number : numbers) number = next<double>(in);
  return pose_of(numbers);
}

Geometry read_faces(std::istream& in, bool hull) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>(next<std::size_t>(in));
  for (fcl::Vector3d& vertex : *vertices)
    for (int i = 0; i < 3; ++i) vertex[i] = next<double>(in);
  const int count = next<int>(in);
  auto faces = std::make_shared<std::vector<int>>();
  auto mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  mesh->beginModel();
  for (int face = 0; face < count; ++face) {
    std::size_t corner[3];
    faces->push_back(3);
    for (std::size_t& one : corner) faces->push_back(static_cast<int>(one = next<std::size_t>(in)));
    mesh->addTriangle(vertices->at(corner[0]), vertices->at(corner[1]), vertices->at(corner[2]));
  }
  mesh->endModel();
  if (hull) return std::make_shared<fcl::Convexd>(vertices, count, faces);
  return mesh;
}

Geometry read_geometry(std::istream& in) {
  const auto kind = next<std::string>(in);
  if (kind == "hull" || kind == "faces") return read_faces(in, kind == "hull");
  const auto a = next<double>(in);
  if (kind == "sphere") return std::make_shared<fcl::Sphered>(a);
  const auto b = next<double>(in);
  if (kind == "capsule") return std::make_shared<fcl::Capsuled>(a, b);
  if (kind == "cylinder") return std::make_shared<fcl::Cylinderd>(a, b);
  if (kind == "cone") return std::make_shared<fcl::Coned>(a, b);
  const auto c = next<double>(in);
  if (kind == "box") return std::make_shared<fcl::Boxd>(a, b, c);
  if (kind == "half_space") return std::make_shared<fcl::Halfspaced>(fcl::Vector3d(a, b, c), next<double>(in));
  throw std::runtime_error("'" + kind + "' is no known shape");
}

struct Shape {
  std::size_t link = 0;
  Geometry geometry;
  Pose local, place;
  fcl::Vector3d centre;

  void move(const Pose& link_pose) {
    place = link_pose * local;
    centre = place * geometry->aabb_center;
  }
};

std::vector<Shape> read_shapes(std::istream& in, const std::string& word, bool of_links) {
  expect(in, word);
  std::vector<Shape> shapes(next<std::size_t>(in));
  for (Shape& shape : shapes) {
    if (of_links) shape.link = next<std::size_t>(in);
    shape.geometry = read_geometry(in);
    shape.geometry->computeLocalAABB();
    shape.local = read_pose(in);
    shape.move(Pose::Identity());
  }
  return shapes;
}

struct Pair {
  std::size_t first = 0, second = 0;
  long place = -1, count = 0;
};

std::vector<Pair> read_pairs(std::istream& in, const std::string& word) {
  expect(in, word);
  std::vector<Pair> pairs(next<std::size_t>(in));
  for (Pair& pair : pairs) {
    pair.first = next<std::size_t>(in);
    pair.second = next<std::size_t>(in);
  }
  return pairs;
}

bool meet(const Shape& first, const Shape& second, long& tests) {
  const double reach = first.geometry->aabb_radius + second.geometry->aabb_radius;
  const bool everywhere = second.geometry->getNodeType() == fcl::GEOM_HALFSPACE;
  if (!everywhere && (first.centre - second.centre).squaredNorm() > reach * reach) return false;
  ++tests;
  fcl::CollisionResultd result;
  return fcl::collide(first.geometry.get(), first.place, second.geometry.get(), second.place, fcl::CollisionRequestd(),
                      result) > 0;
}

void judge(std::istream& in) {
  expect(in, "links");
  const auto links = next<std::size_t>(in);
  std::vector<Shape> shapes = read_shapes(in, "shapes", true), obstacles = read_shapes(in, "obstacles", false);
  std::vector<Pair> walls = read_pairs(in, "walls"), pairs = read_pairs(in, "pairs");
  expect(in, "places");
  const auto places = next<long>(in);
  in.get();
  std::vector<double> numbers(12 * links);
  long tests = 0;
  for (long place = 0; place < places; ++place) {
    in.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(numbers.size() * sizeof(double)));
    if (!in) throw std::runtime_error("poses are missing");
    for (Shape& shape : shapes) shape.move(pose_of(&numbers.at(12 * shape.link)));
    const auto count = [&](std::vector<Pair>& all, const std::vector<Shape>& others) {
      for (Pair& pair : all) {
        if (!meet(shapes.at(pair.first), others.at(pair.second), tests)) continue;
        if (pair.count++ == 0) pair.place = place;
      }
    };
    count(walls, obstacles);
    count(pairs, shapes);
  }
  const auto print = [](const char* word, const std::vector<Pair>& all) {
    for (const Pair& pair : all)
      if (pair.count > 0)
        std::cout << word << ' ' << pair.first << ' ' << pair.second << ' ' << pair.place << ' ' << pair.count << '\n';
  };
  print("wall", walls);
  print("pair", pairs);
  std::cout << "judged " << places << ' ' << tests << '\n';
}

}  // namespace

int main() {
  try {
    judge(std::cin);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "robot_fcl_judge: " << error.what() << '\n';
    return 1;
  }
}
