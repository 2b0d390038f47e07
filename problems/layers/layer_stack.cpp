// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/layers/layer_stack.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/counted.hpp"
#include "framework/base/dense_solves.hpp"

namespace leastcost {
namespace {

constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();  ///< of the terms of a height

void check_sizes(const Eigen::MatrixXd& normals, const Eigen::VectorXd& offsets, const Eigen::VectorXd& indices) {
  const auto count = [](Eigen::Index n) { return std::to_string(n); };
  if (offsets.size() == 0) throw OptionError("interfaces", "missing: give at least one interface");
  if (!offsets.allFinite()) throw OptionError("interfaces", "must be finite numbers");
  if (indices.size() != offsets.size() + 1)
    throw OptionError("indices", "has " + counted(indices.size(), "number") + ", but must have one for each of the " +
                                     counted(offsets.size() + 1, "layer") + ": one more than interfaces");
  for (Eigen::Index i = 0; i < indices.size(); ++i)
    if (!(indices[i] > 0) || !std::isfinite(indices[i]))
      throw OptionError("indices", "number " + count(i + 1) + " must be greater than 0, and finite");
  if (normals.rows() < 2) throw OptionError("normals", "layers need a space of at least two dimensions");
  if (normals.cols() != offsets.size())
    throw OptionError("normals", "there are " + count(normals.cols()) + " for " + count(offsets.size()) +
                                     " interfaces: give one for all, or one for each");
}

/// Parallel interfaces that are out of order leave layers without a place.
void check_order(const Eigen::VectorXd& offsets) {
  for (Eigen::Index k = 1; k < offsets.size(); ++k)
    if (!(offsets[k] > offsets[k - 1]))
      throw OptionError("interfaces",
                        "must increase: number " + std::to_string(k + 1) + " is not above the previous one");
}

}  // namespace

LayerStack::LayerStack(const Eigen::MatrixXd& normals, const Eigen::VectorXd& offsets, Eigen::VectorXd indices)
    : normals_(normals), offsets_(offsets), indices_(std::move(indices)) {
  check_sizes(normals, offsets, indices_);
  for (Eigen::Index k = 0; k < normals_.cols(); ++k) {
    const double length = normals_.col(k).norm();
    if (!(length > 0) || !std::isfinite(length))
      throw OptionError("normals", "number " + std::to_string(k + 1) + " has no direction");
    normals_.col(k) /= length;
    offsets_[k] /= length;
    const Eigen::MatrixXd q = orthogonal_factor(normals_.col(k));
    tangents_.emplace_back(q.rightCols(normals_.rows() - 1));
  }
  parallel_ = (normals_.colwise() - Eigen::VectorXd(normals_.col(0))).isZero(0);
  if (parallel_) check_order(offsets_);
}

bool LayerStack::lies_on(int k, const Eigen::VectorXd& x) const {
  const double terms = normals_.col(k).cwiseAbs().dot(x.cwiseAbs()) + std::abs(offsets_[k]);
  return std::abs(height(k, x)) <= kRounding * terms;
}

std::optional<int> LayerStack::layer_of(const Eigen::VectorXd& x) const {
  const std::vector<int> at = layers_at(x);
  return at.empty() ? std::nullopt : std::optional(at.front());
}

std::vector<int> LayerStack::layers_at(const Eigen::VectorXd& x) const {
  std::vector<int> at;
  int below = 0;  // interfaces that x is above, as a run from the first one
  while (below < interfaces() && height(below, x) > 0 && !lies_on(below, x)) ++below;
  at.push_back(below);
  int k = below;
  for (; k < interfaces() && lies_on(k, x); ++k) at.push_back(k + 1);
  for (; k < interfaces(); ++k)
    if (height(k, x) > 0 && !lies_on(k, x)) return {};
  return at;
}

std::optional<int> LayerStack::layer_of_leg(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  const std::vector<int> from = layers_at(a), to = layers_at(b);
  std::optional<int> best;
  for (const int layer : from)
    if (std::count(to.begin(), to.end(), layer) > 0 && (!best || index(layer) < index(*best))) best = layer;
  return best;
}

}  // namespace leastcost
