// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

// The judge shares no code with what it judges: only the standard library and, in its .cpp files, Boost.Multiprecision.
#include <iosfwd>
#include <vector>

namespace judge {

using Place = std::vector<double>;  ///< 2 or 3 coordinates

/// A thing to keep `radius` + clearance away from: a point, a box, or a simple polygon with its inside (in the plane).
struct Thing {
  enum class Kind { ball, box, polygon } kind = Kind::ball;
  double radius = 0;
  std::vector<Place> corners = {};  ///< one: the centre; two: the lower and the upper corner; else in order
};

struct Scene {
  int dimension = 2;
  double clearance = 0;
  Place source, target;
  std::vector<Thing> things;

  /// Largest side of the box of ends and things, with what is to be kept away from them.
  double diameter() const;
};

/// Text, a line each: "scene 2", "clearance c", "source x y", "target x y", "ball r x y", "box x y x y", "polygon m x y
/// ..."; 17 digits, so that what is read is what was written, bit for bit. Throws std::runtime_error.
void write(const Scene& scene, std::ostream& out);
Scene read_scene(std::istream& in);

/// A line with the coordinates of each point.
void write(const std::vector<Place>& path, std::ostream& out);
std::vector<Place> read_path(std::istream& in, int dimension);

}  // namespace judge
