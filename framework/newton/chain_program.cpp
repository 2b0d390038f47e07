// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/newton/chain_program.hpp"

#include <algorithm>
#include <cmath>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

using Eigen::VectorXd;

constexpr double kFirstGap = 1e-3;   ///< slacks begin at no less
constexpr double kLastGap = 1e-14;   ///< of slack times multiplier
constexpr double kGoodGap = 1e-10;   ///< the same, where rounding leaves no more
constexpr double kBold = 0.01;       ///< of that, after a step that went nearly all of its way
constexpr double kCareful = 0.5;     ///< and after one that could not
constexpr double kToBorder = 0.995;  ///< of the way to where a slack or a multiplier is 0
constexpr double kLongWay = 0.8, kNoWay = 0.01;
constexpr double kFeasible = 1e-12;
constexpr int kMostSteps = 80;

/// The longest step, at most 1, that leaves all of `values` above 0.
double step_within(const VectorXd& values, const VectorXd& change) {
  double step = 1;
  for (Index k = 0; k < values.size(); ++k)
    if (change[k] < 0) step = std::min(step, -kToBorder * values[k] / change[k]);
  return step;
}

/// What rows do, for blocks whose size the compiler may know.
template <int K>
class Rows {
 public:
  explicit Rows(const ChainHalfSpaces& rows) : rows_(rows), k_(rows.block()) {}

  void times(const VectorXd& z, VectorXd& out) const {
    out.resize(rows_.count());
    for (Index r = 0; r < out.size(); ++r) {
      const Index b = rows_.first_block(r);
      out[r] = own(r).dot(Part(z.data() + k_ * b, k_));
      if (rows_.couples(r)) out[r] += next(r).dot(Part(z.data() + k_ * (b + 1), k_));
    }
  }
  /// h += sum weight a a', a the normal of a row.
  void add_squares(const VectorXd& weights, ChainSystem& h) const {
    for (Index r = 0; r < weights.size(); ++r) {
      const Index b = rows_.first_block(r);
      add(weights[r], own(r), own(r), h.diagonal(b));
      if (!rows_.couples(r)) continue;
      add(weights[r], own(r), next(r), h.coupling(b));
      add(weights[r], next(r), next(r), h.diagonal(b + 1));
    }
  }
  void add_transposed(const VectorXd& weights, VectorXd& out) const {
    for (Index r = 0; r < weights.size(); ++r) {
      const Index b = rows_.first_block(r);
      Eigen::Map<Vector>(out.data() + k_ * b, k_) += weights[r] * own(r);
      if (rows_.couples(r)) Eigen::Map<Vector>(out.data() + k_ * (b + 1), k_) += weights[r] * next(r);
    }
  }

 private:
  using Vector = Eigen::Matrix<double, K, 1>;
  using Part = Eigen::Map<const Vector>;

  Part own(Index r) const { return Part(rows_.normal(r), k_); }
  Part next(Index r) const { return Part(rows_.normal(r) + k_, k_); }
  /// A block of the system is whole columns: its numbers lie side by side.
  void add(double weight, const Part& a, const Part& b, Eigen::Block<Points> to) const {
    Eigen::Map<Eigen::Matrix<double, K, K>>(to.data(), k_, k_) += (weight * a) * b.transpose();
  }

  const ChainHalfSpaces& rows_;
  Index k_;
};

template <int K>
std::optional<VectorXd> least(const ChainSystem& h, const VectorXd& force, const ChainHalfSpaces& half_spaces,
                              const VectorXd& begin, const Deadline& deadline) {
  const Rows<K> rows(half_spaces);
  const Index count = half_spaces.count();
  VectorXd offsets(count), at, back, change, weights;
  for (Index k = 0; k < count; ++k) offsets[k] = half_spaces.offset(k);
  VectorXd z = begin;
  rows.times(z, at);
  VectorXd slack = (at - offsets).cwiseMax(kFirstGap), multiplier = kFirstGap * slack.cwiseInverse();
  double gap = count > 0 ? slack.dot(multiplier) / static_cast<double>(count) : 0;
  bool bold = true;
  ChainSystem system;
  for (int step = 0; step < kMostSteps; ++step) {
    const VectorXd off = at - offsets - slack;
    if (step > 0 && gap <= kLastGap && (count == 0 || off.cwiseAbs().maxCoeff() <= kFeasible)) break;
    const double wanted = (bold ? kBold : kCareful) * gap;
    system = h;
    weights = multiplier.cwiseQuotient(slack);
    rows.add_squares(weights, system);
    if (!system.factor(deadline)) break;
    h.multiply(z, back);
    VectorXd way = force - back;
    weights = (wanted - multiplier.array() * off.array()) / slack.array();
    rows.add_transposed(weights, way);
    system.solve(way);
    if (!way.allFinite()) break;
    rows.times(way, change);
    const VectorXd slack_change = change + off;
    const VectorXd multiplier_change =
        (wanted - slack.array() * multiplier.array() - multiplier.array() * slack_change.array()) / slack.array();
    const double length = std::min(step_within(slack, slack_change), step_within(multiplier, multiplier_change));
    if (gap <= kGoodGap && length < kNoWay) break;
    bold = length > kLongWay;
    z += length * way;
    slack += length * slack_change;
    multiplier += length * multiplier_change;
    gap = count > 0 ? slack.dot(multiplier) / static_cast<double>(count) : 0;
    rows.times(z, at);
  }
  const bool within = count == 0 || (at - offsets).minCoeff() >= -2 * kFeasible;
  return within && z.allFinite() ? std::optional<VectorXd>(std::move(z)) : std::nullopt;
}

}  // namespace

void ChainHalfSpaces::clear() {
  blocks_.clear();
  couples_.clear();
  normals_.clear();
  offsets_.clear();
}

void ChainHalfSpaces::add(Index block, const VectorXd& own, double offset) {
  if (own.size() != k_) throw InputError("a half-space of a chain has a normal for each block");
  add_row(block, own, offset);
}

void ChainHalfSpaces::add(Index block, const VectorXd& own, const VectorXd& next, double offset) {
  if (own.size() != k_ || next.size() != k_) throw InputError("a half-space of a chain has a normal for each block");
  add_row(block, own, offset);
  couples_.back() = 1;
  std::copy_n(next.data(), k_, normals_.end() - k_);
}

/// Of one block; the numbers of the next are 0.
void ChainHalfSpaces::add_row(Index block, const VectorXd& own, double offset) {
  blocks_.push_back(block);
  couples_.push_back(0);
  normals_.resize(normals_.size() + 2 * static_cast<std::size_t>(k_), 0);
  std::copy_n(own.data(), k_, normals_.end() - 2 * k_);
  offsets_.push_back(offset);
}

std::optional<VectorXd> least_of_chain(const ChainSystem& h, const VectorXd& force, const ChainHalfSpaces& half_spaces,
                                       const VectorXd& z, const Deadline& deadline) {
  if (half_spaces.block() != h.block() || force.size() != h.size() || z.size() != h.size())
    throw InputError("a program of a chain has a matrix, a force, half-spaces and a start of one shape");
  for (Index r = 0; r < half_spaces.count(); ++r)
    if (half_spaces.first_block(r) < 0 || half_spaces.first_block(r) + (half_spaces.couples(r) ? 1 : 0) >= h.count())
      throw InputError("a half-space of a chain is of blocks that it does not have");
  switch (h.block()) {
    case 2: return least<2>(h, force, half_spaces, z, deadline);
    case 3: return least<3>(h, force, half_spaces, z, deadline);
    case 6: return least<6>(h, force, half_spaces, z, deadline);
    case 7: return least<7>(h, force, half_spaces, z, deadline);
    default: return least<Eigen::Dynamic>(h, force, half_spaces, z, deadline);
  }
}

}  // namespace leastcost
