// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "problems/exact/propagation.hpp"
#include "problems/exact/propagation_parts.hpp"

/// Where the ray along the side of a window runs through a vertex, rounding does not tell on which side of the vertex
/// the window ends, and it goes on on both. In a lattice, whose vertices lie on common rays, each vertex would double
/// the windows along the ray. They are slivers: no wider than rounding, beside that vertex, all with the same root and
/// image but for rounding. One of them, a little wider and less certain, stands for the others.
namespace leastcost {
using exact::value;
namespace {

constexpr double kSliver = 1e-9;    // of the edge: a window no wider than this may be a sliver
constexpr double kRoundings = 256;  // by which a kept sliver is wider and less certain: some fifteen faces' worth
// A lattice with noise has slivers that differ by more: after the first few of one root over an edge, each is wider
// than the one before by this factor, up to this share of the distance.
constexpr int kFew = 16;
constexpr double kWider = 1.5, kMostWider = 1e-12;

}  // namespace

template <class Real>
bool Propagation<Real>::is_sliver(const Window<Real>& w, const Real& length) const {
  return value(Real(w.end - w.begin)) <= kSliver * value(length) && (!(value(w.begin) > 0) || !(w.end < length));
}

/// Whether every path that w stands for is one that `kept` stands for: the same root, no farther, the part within that
/// of `kept`, the true image as near to its image.
template <class Real>
bool Propagation<Real>::stands_for(const Window<Real>& kept, const Window<Real>& w) const {
  if (kept.root != w.root || kept.sigma > w.sigma || kept.begin > w.begin || kept.end < w.end) return false;
  const double apart = std::abs(value(Real(kept.x - w.x))) + std::abs(value(Real(kept.height - w.height)));
  return w.error + apart * (1 + 4 * exact::kEpsilon) <= kept.error && w.turned <= kept.turned;
}

/// Of a sliver over the edge of h: true where one before stands for it. Else it is made to stand for those to come.
template <class Real>
bool Propagation<Real>::merged(std::int32_t h, const Real& length, Window<Real>& w) {
  const std::int32_t first = slivers_.first(h, w.root);
  int kept = 0;
  for (std::int32_t i = first; i >= 0; i = slivers_[i].next, ++kept)
    if (stands_for(slivers_[i].window, w)) return true;

  const double x = value(w.x), height = value(w.height), begin = value(w.begin), end = value(w.end);
  const double aside = std::max({0.0, begin - x, x - end}), distance = std::max(aside, height);
  const double least = kRoundings * kRoundingOf<Real>;
  const double share = kept <= kFew ? least : std::clamp(least * std::pow(kWider, kept - kFew), least, kMostWider);
  const double more = share * (std::abs(x) + height + value(length));
  if (!(more < kSliver * distance)) return false;  // the root is as near as that
  w.error += more;
  w.turned += more;
  w.begin = w.begin - Real(more) > Real(0.0) ? Real(w.begin - Real(more)) : Real(0.0);
  w.end = w.end + Real(more) < length ? Real(w.end + Real(more)) : length;
  w.rise += 2 * more;
  w.spread += 2 * more / distance;

  for (std::int32_t i = first; i >= 0; i = slivers_[i].next)
    if (stands_for(w, slivers_[i].window)) {
      slivers_[i].window = w;
      return false;
    }
  slivers_.add(h, w);
  return false;
}

template bool Propagation<double>::is_sliver(const Window<double>&, const double&) const;
template bool Propagation<double>::merged(std::int32_t, const double&, Window<double>&);
template bool Propagation<DoubleDouble>::is_sliver(const Window<DoubleDouble>&, const DoubleDouble&) const;
template bool Propagation<DoubleDouble>::merged(std::int32_t, const DoubleDouble&, Window<DoubleDouble>&);

}  // namespace leastcost
