// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>

namespace leastcost {

struct MetricTensorOptions {
  Eigen::MatrixXd matrix = {};
  void fields(FieldVisitor& visit);
};

/// c(a, b) = sqrt((b - a)' M (b - a)), M symmetric positive definite, d x d, in the ambient space; on a surface it is
/// the metric that M induces on the tangent planes. (M is the metric tensor; VFCS Sec. 4.5 uses T = M^(1/2).) Throws
/// OptionError.
std::shared_ptr<const ConstantMetricCost> make_metric_tensor_cost(const MetricTensorOptions& options, int dim);

}  // namespace leastcost
