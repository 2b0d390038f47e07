// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/manifold.hpp>
#include <leastcost/framework/options.hpp>
#include <leastcost/framework/segment_cost.hpp>
#include <leastcost/problems/costs/sampled_tensors.hpp>

namespace leastcost {

struct MetricFieldOptions {
  std::string type = {};
  std::vector<std::string> entries = {};          ///< formula: upper triangle of the tensor, row by row
  std::map<std::string, double> parameters = {};  ///< formula
  TensorFileOptions tensor_file = {};
  CurvatureMetricOptions curvature = {};
  std::string reading = "metric";
  std::string rule = "auto";
  void fields(FieldVisitor& visit);
  bool needs_domain() const;  ///< the tensors belong to the data of the manifold
  bool averages() const;      ///< the tensor of a segment is the mean of those at its ends
};

/// Length under a metric tensor that depends on the place, in an ambient space of dimension 2 or 3: half-plane,
/// Poincare disc, Fisher-Rao metric of the normal distributions (mu, sigma), formulas, tensors given on the vertices or
/// faces of a mesh or the points of a cloud (interpolated: problems/geometry/tensor_samples), or the isophotic metric
/// from the curvatures of one of them. On a surface it is the metric induced on the tangent planes.
///
/// The paper uses T both as the metric, VFCS Eq. (1), and as a root of it, Sec. 4.5: `reading: metric` is c = sqrt(d' T
/// d), `reading: root` is c = |T d|, d = b - a. T is taken in the middle of the segment, or as the mean of both ends
/// (`rule: average`, VFCS Sec. 4.5, the default for tensors given on data, whose ends lie on the surface); both have
/// order
/// 2. +infinity where an end or the middle lies outside the domain of the metric, or where T is not positive definite;
/// the cost says which (ExplainsInfinity). `domain` and `folder` (of the tensor file) are asked only by fields that
/// need them. Throws OptionError, InputError.
std::shared_ptr<const SegmentCost> make_metric_field_cost(const MetricFieldOptions& options, int dim,
                                                          const ConstraintManifold* domain = nullptr,
                                                          const std::filesystem::path& folder = {});

}  // namespace leastcost
