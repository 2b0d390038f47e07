// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "problems/straighten/string_moves.hpp"
#include "problems/straighten/taut_string.hpp"

namespace leastcost {

/// Local search between classes of paths: a vertex of positive curvature beside a straight string that sees more than
/// half of its cone angle on the string's side would be passed sooner on its other side. Tries that, straightens,
/// keeps what is shorter, until no such vertex is left (docs/numerics.md Sec. 5.3).
class StringFlipper {
 public:
  StringFlipper(StringPuller& puller, StringMover& mover) : puller_(&puller), mover_(&mover) {}

  /// False: stopped. The string is straight in either case.
  bool improve(TautString& string, const std::function<bool()>& stop);
  std::int64_t flips() const { return flips_; }

 private:
  struct Candidate {
    std::int32_t vertex;
    std::size_t first_door, last_door;  // of the piece, those that end at the vertex
    double excess;                      // angle beyond half of the cone angle
  };
  void find_candidates(const TautString& string, std::size_t piece);
  void add_candidate(std::int32_t v, std::size_t first, std::size_t last, const Eigen::Vector2d& at);
  bool flip(const TautString& string, std::size_t piece, const Candidate& candidate);
  bool try_flip(TautString& string, std::size_t piece, const Candidate& candidate, const std::function<bool()>& stop);

  StringPuller* puller_;
  StringMover* mover_;
  std::vector<Candidate> candidates_;
  TautString trial_;
  std::int64_t flips_ = 0;
};

}  // namespace leastcost
