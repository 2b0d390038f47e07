// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/problems/mesh/surface_path.hpp>

/// The methods that VFCS Sec. 5 compares, behind one interface and under one contract.
namespace leastcost::comparison {

/// True: give up. Asked now and then.
using Stop = std::function<bool()>;

enum class Outcome {
  found,
  out_of_time,     ///< the path, where there is one, is the best so far
  out_of_windows,  ///< of a window method: the memory it may use is spent
  failed           ///< `note` says why
};

/// A path on the mesh from source to target, connected face by face, and what a method says of it.
struct Answer {
  SurfacePath path;
  Outcome outcome = Outcome::found;
  /// What the method takes for the distance. Of a field it may lie below the exact one: the path never does.
  double distance = std::numeric_limits<double>::quiet_NaN();
  int iterations = 0;           ///< of a method that improves a path; 0: not such a method
  std::vector<double> lengths;  ///< of its path before the first iteration and after each of them, or after `looks`
  std::vector<int> looks;
  long windows = 0;  ///< of a window method
  std::string note;
};

enum class Kind {
  exact,  ///< delivers the shortest path
  field,  ///< approximates distances, or paths along edges, of the whole mesh
  local   ///< shortens a first path
};

/// One object answers queries on one mesh, which must outlive it.
class Method {
 public:
  virtual ~Method() = default;
  /// What does not depend on the ends.
  virtual void prepare(const TriangleMesh& mesh, const Stop& stop) = 0;
  /// Between two vertices of one component.
  virtual Answer shortest(std::int32_t source, std::int32_t target, const Stop& stop) = 0;
  /// Fills in `lengths` where shortest() does not; may take many times as long.
  virtual void measure_lengths(std::int32_t, std::int32_t, const Stop&, Answer&) {}
};

struct MethodEntry {
  std::string_view name;
  Kind kind;
  std::string_view summary;
  std::unique_ptr<Method> (*make)();
};

/// All of them, in the order of the tables.
const std::vector<MethodEntry>& all_methods();

}  // namespace leastcost::comparison
