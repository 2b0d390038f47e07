// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/space/node_set.hpp"

#include <algorithm>
#include <utility>

namespace leastcost::bracket {

NodeSet::NodeSet(std::vector<Place> places, const Place& cells)
    : rows_y_(cells[1] + 2), rows_z_(cells[2] + 2), places_(std::move(places)) {
  std::array<int, 6> nobody;
  nobody.fill(none());
  beside_.assign(places_.size() + 1, nobody);
  begins_.assign(static_cast<std::size_t>(rows_y_) * static_cast<std::size_t>(rows_z_) + 1, 0);
  for (const Place& p : places_) ++begins_[static_cast<std::size_t>(p[2] * rows_y_ + p[1]) + 1];
  for (std::size_t r = 1; r < begins_.size(); ++r) begins_[r] += begins_[r - 1];
  for (int node = 1; node < none(); ++node) {
    const Place &before = place(node - 1), &here = place(node);
    if (before[2] != here[2] || before[1] != here[1] || before[0] + 1 != here[0]) continue;
    beside_[static_cast<std::size_t>(node)][0] = node - 1;
    beside_[static_cast<std::size_t>(node - 1)][1] = node;
  }
  for (int k = 0; k < rows_z_; ++k)
    for (int j = 0; j < rows_y_; ++j) {
      if (j > 0) link(row(j - 1, k), row(j, k), 1);
      if (k > 0) link(row(j, k - 1), row(j, k), 2);
    }
}

NodeSet::Range NodeSet::row(int j, int k) const {
  const auto r = static_cast<std::size_t>(k * rows_y_ + j);
  return {begins_[r], begins_[r + 1]};
}

/// Nodes of two rows that lie beside each other along an axis.
void NodeSet::link(const Range& low, const Range& high, std::size_t axis) {
  for (int a = low.begin, b = high.begin; a < low.end && b < high.end;) {
    const int apart = place(a)[0] - place(b)[0];
    if (apart == 0) {
      beside_[static_cast<std::size_t>(a)][2 * axis + 1] = b;
      beside_[static_cast<std::size_t>(b)][2 * axis] = a;
    }
    if (apart <= 0) ++a;
    if (apart >= 0) ++b;
  }
}

int NodeSet::find(const Place& p) const {
  if (p[1] < 0 || p[2] < 0 || p[1] >= rows_y_ || p[2] >= rows_z_) return none();
  const Range range = row(p[1], p[2]);
  const auto begin = places_.begin() + range.begin, end = places_.begin() + range.end;
  const auto at = std::lower_bound(begin, end, p[0], [](const Place& a, int i) { return a[0] < i; });
  return at != end && (*at)[0] == p[0] ? static_cast<int>(at - places_.begin()) : none();
}

bool NodeSet::is_inner(int node) const {
  for (const int middle : rows_around(node)) {
    const std::array<int, 6>& b = beside(middle);
    if (middle == none() || b[0] == none() || b[1] == none()) return false;
  }
  return true;
}

std::array<int, 9> NodeSet::rows_around(int node) const {
  const int below = beside(node)[4], above = beside(node)[5];
  std::array<int, 9> out;
  std::size_t k = 0;
  for (const int layer : {below, node, above}) {
    out[k++] = beside(layer)[2];
    out[k++] = layer;
    out[k++] = beside(layer)[3];
  }
  return out;
}

}  // namespace leastcost::bracket
