// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/make_curve.hpp"

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/result/delivery.hpp"
#include "framework/search/free_passage.hpp"

namespace leastcost {

void make_curve(const Search& search, Outcome& out) {
  look_at_clock(search.monitor.deadline);
  join_at_free_place(search, out);
  PathEnergy energy(out.solved, out.result.reference_cost, search.monitor.deadline);
  out.curve = chain_as_curve(energy, out.result.path);
  out.curve.unsolved = !search.solver.moves_points();
  timed(Stage::post_process, search, out.result.seconds.post_process, [&] {
    out.curve_fault = post_process_or_say_why(out.solved, out.result.first, search.options, search.monitor, out.curve);
  });
}

ToCurve curve_maker(const Search& search, const Outcome& out) {
  return [&search, &out](const CoordinatePath& chain) {
    PathEnergy energy(out.solved, out.result.reference_cost, search.monitor.limit());
    PostProcessed curve = chain_as_curve(energy, chain);
    post_process(out.solved, out.result.first, search.options, search.monitor, curve);
    return curve;
  };
}

}  // namespace leastcost
