// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/registry/built_in.hpp"

#include <leastcost/problems/costs/clearance_length.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/costs/end_effector_length.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/formula_cost.hpp>
#include <leastcost/problems/costs/kinetic_energy.hpp>
#include <leastcost/problems/costs/layers.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/costs/refractive_index.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/costs/walking.hpp>
#include <leastcost/problems/costs/weighted_length.hpp>
#include <leastcost/problems/costs/zermelo.hpp>
#include "catalogue/inputs/raster_file.hpp"
#include "catalogue/plugins/registration.hpp"
#include "catalogue/registry/combined_costs.hpp"

namespace leastcost {
namespace {

void check_map(const CostMapOptions& options, const BuildContext& context) {
  check(options.raster);
  const std::string why = why_no_map_of(context.manifold.get());
  if (!why.empty()) throw OptionError("type", why);
}

}  // namespace

const std::vector<CostPlugin>& built_in::costs() {
  using O = const BuildContext&;
  static const std::vector<CostPlugin> all = {
      plugin<CostPlugin, NoOptions>("euclidean", "Length: c(a, b) = |b - a|.",
                                    [](const NoOptions&, O c) { return make_euclidean_cost(c.dimension); }),
      plugin<CostPlugin, MetricTensorOptions>(
          "metric_tensor", "Length under a constant metric tensor M: c(a, b) = sqrt((b - a)' M (b - a)).",
          [](const MetricTensorOptions& o, O c) { return make_metric_tensor_cost(o, c.dimension); }),
      plugin<CostPlugin, MetricFieldOptions>("metric_field",
                                             "Length under a metric tensor that varies with position: by name, by "
                                             "formulas, from a file, or from curvature.",
                                             [](const MetricFieldOptions& o, O c) {
                                               return make_metric_field_cost(o, c.dimension, c.manifold.get(),
                                                                             c.folder);
                                             })
          .waiting<MetricFieldOptions>(
              [](const MetricFieldOptions& o) { return o.needs_domain() ? WaitsFor::domain : WaitsFor::nothing; }),
      plugin<CostPlugin, TravelTimeOptions>(
          "travel_time", "Time of a bead that slides without friction, under gravity or in a potential.",
          [](const TravelTimeOptions& o, O c) { return make_travel_time_cost(o, c.dimension, c.source); })
          .waiting<TravelTimeOptions>([](const TravelTimeOptions&) { return WaitsFor::domain; })
          .checked_by<TravelTimeOptions>(
              [](const TravelTimeOptions& o, O c) { check_travel_time(o, c.source.has_value()); })
          .following_source(),
      plugin<CostPlugin, ClearanceLengthOptions>(
          "clearance", "Length with a weight that increases smoothly near obstacles.",
          [](const ClearanceLengthOptions& o, O c) { return make_clearance_length(o, c.dimension, c.manifold); })
          .waiting<ClearanceLengthOptions>([](const ClearanceLengthOptions&) { return WaitsFor::domain; }),
      plugin<CostPlugin, CostMapOptions>(
          "cost_map", "Length times a cost per unit of length in the plane, from a raster.",
          [](const CostMapOptions& o, O c) {
            check_map(o, c);
            return make_cost_map(read_raster(o.raster, c.folder, Resampling::nearest, c.note), o.interpolation,
                                 c.dimension);
          })
          .waiting()
          .checked_by<CostMapOptions>(check_map),
      plugin<CostPlugin, WeightedLengthOptions>(
          "weighted_length", "Length with a weight for each factor of the domain, or for each coordinate.",
          [](const WeightedLengthOptions& o, O c) { return make_weighted_length(o, *c.manifold); })
          .waiting<WeightedLengthOptions>([](const WeightedLengthOptions&) { return WaitsFor::domain; }),
      plugin<CostPlugin, LayersOptions>(
          "layers", "Length or time through layers of constant index, with refraction at the interfaces.",
          [](const LayersOptions& o, O c) { return make_layers_cost(o, c.dimension); }),
      plugin<CostPlugin, KineticEnergyOptions>(
          "kinetic_energy",
          "Length under the kinetic energy of an arm; least-cost paths are its motions without forces.",
          [](const KineticEnergyOptions& o, O c) { return make_kinetic_energy_cost(o, c.dimension); }),
      plugin<CostPlugin, EndEffectorLengthOptions>(
          "end_effector_length", "Length of the path of an arm's tool, plus a small part of that of its joints.",
          [](const EndEffectorLengthOptions& o, O c) { return make_end_effector_length(o, c.dimension); }),
      plugin<CostPlugin, ZermeloOptions>(
          "zermelo", "Travel time of a vehicle of given speed in wind or current, by formula or on a grid.",
          [](const ZermeloOptions& o, O c) { return make_zermelo_cost(o, c.dimension, c.folder); })
          .waiting<ZermeloOptions>(
              [](const ZermeloOptions& o) { return o.reads_file() ? WaitsFor::files : WaitsFor::nothing; })
          .checked_by<ZermeloOptions>([](const ZermeloOptions& o, O c) { check_zermelo(o, c.dimension); }),
      plugin<CostPlugin, WalkingOptions>(
          "walking",
          "Time or energy of walking over terrain, with switchbacks on steep slopes; the last of three coordinates is "
          "height.",
          [](const WalkingOptions& o, O c) { return make_walking_cost(o, c.dimension); }),
      plugin<CostPlugin, RefractiveIndexOptions>(
          "refractive_index", "Optical length under an index n(x): linear velocity, lenses, layers, powers, formulas.",
          [](const RefractiveIndexOptions& o, O c) { return make_refractive_index_cost(o, c.dimension); }),
      plugin<CostPlugin, FormulaCostOptions>(
          "formula",
          "Any cost per unit of length F(x, v), as a formula in position and direction; asymmetric costs are allowed.",
          [](const FormulaCostOptions& o, O c) {
            return make_formula_cost(o, c.dimension, checked_region(*c.manifold, c.source, c.target));
          })
          .waiting<FormulaCostOptions>([](const FormulaCostOptions&) { return WaitsFor::domain; }),
      plugin<CostPlugin, SumCostOptions>("sum", "A sum of costs with positive weights.",
                                         [](const SumCostOptions& o, O c) { return make_sum(o, c); })
          .waiting<SumCostOptions>([](const SumCostOptions& o) { return waits_of(o); })
          .checked_by<SumCostOptions>([](const SumCostOptions& o, O c) { check_parts_of(o, c); })
          .following_source(),
      plugin<CostPlugin, ScaledCostOptions>("scaled", "A cost times a positive field f(x), given as a formula.",
                                            [](const ScaledCostOptions& o, O c) { return make_scaled(o, c); })
          .waiting<ScaledCostOptions>([](const ScaledCostOptions& o) { return waits_of(o); })
          .checked_by<ScaledCostOptions>([](const ScaledCostOptions& o, O c) { check_parts_of(o, c); })
          .following_source(),
  };
  return all;
}

}  // namespace leastcost
