// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/energy/path_energy.hpp>

namespace leastcost {

/// Stored steps s and gradient changes y, as coordinate-space vectors of the free points, newest last.
class LbfgsHistory {
 public:
  /// Throws OptionError for a memory that holds no pair.
  explicit LbfgsHistory(int memory) {
    if (memory < 1) throw OptionError("memory", "at least one pair must be stored, not " + std::to_string(memory));
    pairs_.resize(static_cast<std::size_t>(memory));
  }
  bool empty() const { return count_ == 0; }
  void clear() { count_ = 0; }

  void push(const Points& s, const Points& y) {
    const double sy = s.cwiseProduct(y).sum();
    if (!(sy > kCautious * s.norm() * y.norm())) return;
    if (count_ == pairs_.size())
      std::rotate(pairs_.begin(), pairs_.begin() + 1, pairs_.end());
    else
      ++count_;
    Pair& p = pairs_[count_ - 1];
    p.s = s;
    p.y = y;
  }

  /// Vector transport by projection onto the tangent spaces of `frames`, and the tangent coordinates that direction()
  /// works in. A pair that has lost its curvature on the way is dropped.
  void transport(PathEnergy& energy, const Frames& frames) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      Pair& p = pairs_[i];
      energy.to_tangent(frames, p.s, p.ts);
      energy.to_tangent(frames, p.y, p.ty);
      if (!frames.identity) {
        energy.from_tangent(frames, p.ts, p.s);
        energy.from_tangent(frames, p.ty, p.y);
      }
      const double sy = p.ts.dot(p.ty);
      if (!(sy > kCautious * p.ts.norm() * p.ty.norm())) continue;
      p.rho = 1 / sy;
      if (kept != i) std::swap(pairs_[kept], pairs_[i]);
      ++kept;
    }
    count_ = kept;
  }

  /// Without transport: the pairs as they were stored, for methods that know no tangent spaces but the current one.
  void use_as_stored() {
    for (std::size_t i = 0; i < count_; ++i) {
      Pair& p = pairs_[i];
      p.ts = p.s.reshaped();
      p.ty = p.y.reshaped();
      p.rho = 1 / p.ts.dot(p.ty);
    }
  }

  /// Two-loop recursion; `inverse` applies H0 in place: gamma P^-1 or gamma I (Nocedal, Wright, Alg. 7.4).
  template <class Inverse>
  void direction(const Eigen::VectorXd& gradient, Inverse inverse, Eigen::VectorXd& d) {
    d = -gradient;
    for (std::size_t i = count_; i-- > 0;) {
      Pair& p = pairs_[i];
      p.alpha = p.rho * p.ts.dot(d);
      d -= p.alpha * p.ty;
    }
    if (count_ > 0) {
      const Pair& newest = pairs_[count_ - 1];
      scratch_ = newest.ty;
      inverse(scratch_);
      inverse(d);
      d *= 1 / (newest.rho * newest.ty.dot(scratch_));
    } else {
      inverse(d);
    }
    for (std::size_t i = 0; i < count_; ++i) {
      Pair& p = pairs_[i];
      d += (p.alpha - p.rho * p.ty.dot(d)) * p.ts;
    }
  }

 private:
  static constexpr double kCautious = 1e-10;  ///< least s.y / (|s| |y|) of a stored pair

  struct Pair {
    Points s, y;
    Eigen::VectorXd ts, ty;
    double rho = 0, alpha = 0;
  };
  std::vector<Pair> pairs_;
  std::size_t count_ = 0;
  Eigen::VectorXd scratch_;
};

}  // namespace leastcost
