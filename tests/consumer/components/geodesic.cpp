// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The shortest path between two vertices of a mesh: geodesic hill.obj
#include <cstdio>

#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include <leastcost/recipes/find_path.hpp>

int main(int, char** arguments) {
  using namespace leastcost;
  const auto mesh = std::make_shared<MeshManifold>(TriangleMesh(read_mesh(arguments[1])));
  const Problem problem{mesh, make_euclidean_cost(3), {}, mesh->vertex(0), mesh->vertex(80)};
  const Result path = find_path(problem);
  std::printf("%s: %.6f\n", word_of(path.certificate.scope).data(), path.curve.cost);
}
