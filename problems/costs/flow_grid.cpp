// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/costs/flow_grid.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/sound_size.hpp"

namespace leastcost {
namespace {

constexpr double kSameNode = 1e-6;  ///< of the extent: coordinates that differ by less are one
constexpr double kSameStep = 1e-3;  ///< of a step: coordinates are printed with few digits

constexpr std::array<const char*, 3> kAxisNames = {"x", "y", "z"};

/// The axis whose nodes are these numbers, each given many times.
template <int D>
typename FlowGrid<D>::Axis axis_of(Eigen::VectorXd at, std::size_t k, const std::string& file) {
  const auto refuse = [&](const std::string& why) { throw InputError(file + ": " + why + " along " + kAxisNames[k]); };
  std::sort(at.begin(), at.end());
  const double room = kSameNode * (at[at.size() - 1] - at[0]);
  std::vector<double> nodes;
  for (const double x : at)
    if (nodes.empty() || x - nodes.back() > room) nodes.push_back(x);
  const auto count = static_cast<Eigen::Index>(nodes.size());
  if (count < FlowGrid<D>::kFewest)
    refuse("the grid has " + std::to_string(count) + " nodes, but needs at least " +
           std::to_string(FlowGrid<D>::kFewest));
  check_sound_size(file + ": the extent along " + kAxisNames[k], nodes.back() - nodes.front());
  typename FlowGrid<D>::Axis axis{nodes.front(), (nodes.back() - nodes.front()) / static_cast<double>(count - 1),
                                  count};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (std::abs(nodes[i] - axis.first - axis.step * static_cast<double>(i)) <= kSameStep * axis.step) continue;
    std::ostringstream out;
    out << "the nodes of a regular grid must have equal steps, but " << count << " nodes from " << nodes.front()
        << " to " << nodes.back() << " include one at " << nodes[i];
    refuse(out.str());
  }
  return axis;
}

}  // namespace

template <int D>
FlowGrid<D> flow_grid(const Eigen::MatrixXd& rows, const std::string& file) {
  std::array<typename FlowGrid<D>::Axis, D> axes;
  Eigen::Index nodes = 1;
  for (std::size_t k = 0; k < D; ++k) {
    axes[k] = axis_of<D>(rows.col(static_cast<Eigen::Index>(k)), k, file);
    nodes *= axes[k].count;
  }
  if (nodes != rows.rows())
    throw InputError(file + ": a grid of " + std::to_string(nodes) +
                     " nodes must have one row per node; the number of rows is " + std::to_string(rows.rows()));
  Points values(D, nodes);
  std::vector<bool> given(static_cast<std::size_t>(nodes), false);
  for (Eigen::Index row = 0; row < nodes; ++row) {
    Eigen::Index node = 0;
    for (std::size_t k = D; k-- > 0;) {
      const double position = (rows(row, static_cast<Eigen::Index>(k)) - axes[k].first) / axes[k].step;
      node = node * axes[k].count + static_cast<Eigen::Index>(std::lround(position));
    }
    if (given[static_cast<std::size_t>(node)]) {
      std::ostringstream out;
      out << file << ": the node at (" << rows.row(row).head(D) << ") is given twice";
      throw InputError(out.str());
    }
    given[static_cast<std::size_t>(node)] = true;
    values.col(node) = rows.row(row).tail(D).transpose();
  }
  return FlowGrid<D>(axes, std::move(values));
}

template FlowGrid<2> flow_grid<2>(const Eigen::MatrixXd&, const std::string&);
template FlowGrid<3> flow_grid<3>(const Eigen::MatrixXd&, const std::string&);

}  // namespace leastcost
