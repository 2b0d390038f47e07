// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/has_interfaces.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/problems/layers/has_layers.hpp>

namespace leastcost {

struct LayersOptions {
  Eigen::VectorXd interfaces = {};              ///< K offsets, in rising order
  std::optional<Eigen::VectorXd> speeds = {};   ///< K + 1, of the layers from the lowest on
  std::optional<Eigen::VectorXd> indices = {};  ///< or these: cost of a unit of length
  std::optional<Eigen::MatrixXd> normals = {};  ///< one row for all interfaces, or K; default: the last axis
  void fields(FieldVisitor& visit);
};

/// A cost with layers. Its chains are first order at the interfaces, where it has kinks: it is the post-processor
/// `refract` that knows them.
class LayersCost : public SegmentCost, public HasLayers, public HasInterfaces {
 public:
  std::vector<Crossing> crossings(const Points& polyline, const ConstraintManifold& domain) const override;
};

/// c(a, b) of a straight move: the sum of index times length over the layers that it passes; along an interface the
/// lower index; +infinity from, to or through places where interfaces have crossed. Unit: s with speeds, length with
/// indices. Throws OptionError; dim >= 2.
std::shared_ptr<const LayersCost> make_layers_cost(const LayersOptions& options, int dim);

}  // namespace leastcost
