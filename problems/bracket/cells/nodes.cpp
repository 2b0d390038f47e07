// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/cells/nodes.hpp"

#include <algorithm>
#include <utility>

namespace leastcost::bracket {
namespace {

std::vector<Place<3>> all_places(const Place<3>& cells) {
  std::vector<Place<3>> out;
  for (int k = 0; k <= cells[2] + 1; ++k)
    for (int j = 0; j <= cells[1] + 1; ++j)
      for (int i = 0; i <= cells[0] + 1; ++i) out.push_back({i, j, k});
  return out;
}

/// Flags of the places of a grid and of the layer around it.
class PlaceFlags {
 public:
  explicit PlaceFlags(const Place<3>& cells)
      : size_{cells[0] + 2, cells[1] + 2, cells[2] + 2},
        flags_(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
               static_cast<std::size_t>(size_[2])) {}
  unsigned char& at(const Place<3>& p) {
    return flags_[(static_cast<std::size_t>(p[2]) * static_cast<std::size_t>(size_[1]) +
                   static_cast<std::size_t>(p[1])) *
                      static_cast<std::size_t>(size_[0]) +
                  static_cast<std::size_t>(p[0])];
  }
  /// Sets those within `reach` of a flag along each axis.
  void spread(int reach) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      PlaceFlags out = *this;
      Place<3> p;
      for (p[2] = 0; p[2] < size_[2]; ++p[2])
        for (p[1] = 0; p[1] < size_[1]; ++p[1])
          for (p[0] = 0; p[0] < size_[0]; ++p[0]) {
            if (!at(p)) continue;
            Place<3> q = p;
            const int begin = std::max(0, p[axis] - reach), end = std::min(size_[axis] - 1, p[axis] + reach);
            for (q[axis] = begin; q[axis] <= end; ++q[axis]) out.at(q) = 1;
          }
      flags_ = std::move(out.flags_);
    }
  }

 private:
  Place<3> size_;
  std::vector<unsigned char> flags_;
};

/// The cell of the coarse grid that holds a cell of the fine one; the layers around them correspond.
int coarse_index(int fine, int parts) { return (fine + parts - 1) / parts; }

}  // namespace

NodeSet::NodeSet(const Place<3>& cells) : NodeSet(all_places(cells), cells) {}

NodeSet::NodeSet(std::vector<Place<3>> places, const Place<3>& cells)
    : rows_y_(cells[1] + 2), rows_z_(cells[2] + 2), places_(std::move(places)) {
  std::array<int, 6> nobody;
  nobody.fill(none());
  beside_.assign(places_.size() + 1, nobody);
  begins_.assign(static_cast<std::size_t>(rows_y_) * static_cast<std::size_t>(rows_z_) + 1, 0);
  for (const Place<3>& p : places_) ++begins_[static_cast<std::size_t>(p[2] * rows_y_ + p[1]) + 1];
  for (std::size_t r = 1; r < begins_.size(); ++r) begins_[r] += begins_[r - 1];
  for (int node = 1; node < none(); ++node) {
    const Place<3>&before = place(node - 1), &here = place(node);
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

int NodeSet::find(const Place<3>& p) const {
  if (p[1] < 0 || p[2] < 0 || p[1] >= rows_y_ || p[2] >= rows_z_) return none();
  const Range range = row(p[1], p[2]);
  const auto begin = places_.begin() + range.begin, end = places_.begin() + range.end;
  const auto at = std::lower_bound(begin, end, p[0], [](const Place<3>& a, int i) { return a[0] < i; });
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

NodeSet nodes_around(const Grid<3>& coarse, const Grid<3>& fine, const std::vector<Place<3>>& cells, int parts) {
  constexpr int kMargin = 8;  // fine cells; 12 and 6 give the same bounds
  PlaceFlags flags(coarse.cells);
  for (const Place<3>& p : cells)
    flags.at({coarse_index(p[0], parts), coarse_index(p[1], parts), coarse_index(p[2], parts)}) = 1;
  flags.spread((kMargin + parts - 1) / parts);
  std::vector<Place<3>> places;
  for (int k = 0; k <= fine.cells[2] + 1; ++k)
    for (int j = 0; j <= fine.cells[1] + 1; ++j)
      for (int i = 0; i <= coarse.cells[0] + 1; ++i) {
        if (!flags.at({i, coarse_index(j, parts), coarse_index(k, parts)})) continue;
        if (i == 0) places.push_back({0, j, k});
        if (i > coarse.cells[0]) places.push_back({fine.cells[0] + 1, j, k});
        if (i == 0 || i > coarse.cells[0]) continue;
        for (int p = 1; p <= parts; ++p) places.push_back({(i - 1) * parts + p, j, k});
      }
  return NodeSet(std::move(places), fine.cells);
}

}  // namespace leastcost::bracket
