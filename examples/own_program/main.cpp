// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The program leastcost with a cost and a solver of one's own (docs/extend.md):
//
//     own_program describe cost ray_time
//     own_program run ray.yaml
//     own_program study compare.yaml
#include "own_parts.hpp"

#include <leastcost/app/app.hpp>

int main(int argc, char** argv) {
  using namespace own;
  register_cost<RayTimeOptions>(
      "ray_time", "Time of a ray through a medium whose speed grows with depth.",
      [](const RayTimeOptions& options, const BuildContext&) { return make_segment_cost(RayTime{options.gain}); });
  register_solver<GaussNewton, GaussNewtonOptions>("gauss_newton",
                                                   "Gauss-Newton steps, halved until the energy falls.");
  return run_program(argc, argv);
}
