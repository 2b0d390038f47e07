// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The shortest path between two vertices of a mesh, proved to be the shortest of all: mesh_geodesic hill.obj 0 80
#include <cstdio>
#include <cstdlib>

#include <leastcost/leastcost.hpp>

int main(int count, char** arguments) {
  using namespace leastcost;
  if (count != 4) return 2;
  const auto mesh = std::make_shared<MeshManifold>(TriangleMesh(read_mesh(arguments[1])));
  const Problem problem{.manifold = mesh,
                        .cost = make_euclidean_cost(3),
                        .kernel = {},
                        .source = mesh->vertex(std::atoi(arguments[2])),
                        .target = mesh->vertex(std::atoi(arguments[3]))};
  const Result path = find_path(problem);
  std::printf("%s: %.6f\n", word_of(path.certificate.scope).data(), path.curve.cost);
  return path.certificate.certified() ? 0 : 1;
}
