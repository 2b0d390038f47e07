// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <thread>
#include <typeinfo>
#include <vector>

#include <leastcost/framework/path/path.hpp>
#include <leastcost/problems/robots/pair_walls.hpp>

namespace leastcost {

/// The walls of a robot for one solve, whose points move little from one look to the next: they remember, for places
/// where they have looked, which pairs are near and how near. No gap changes by more than the place does, so that
/// most looks beside such a place need no kinematics at all. Walls and gaps are those of PairWalls.
///
/// Whoever made them has the memory; for other threads they are as PairWalls are.
class RememberingWalls final : public Walls {
 public:
  explicit RememberingWalls(std::shared_ptr<const PairWalls> walls);

  Eigen::Index dimension() const override { return walls_->dimension(); }
  double size() const override { return walls_->size(); }
  double computed_from() const override { return walls_->computed_from(); }
  void near(const Vector& x, double reach, std::vector<Wall>& found) const override;
  MoveClearance clearance(const Vector& a, const Vector& b) const override { return walls_->clearance(a, b); }
  void along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const override;
  double room(const Vector& a, const Vector& b, double reach) const override;
  std::string obstacle_name(int obstacle) const override { return walls_->obstacle_name(obstacle); }
  std::string depth_text(int obstacle, double missing) const override { return walls_->depth_text(obstacle, missing); }
  const Walls* decorated(const std::type_info&) const override { return walls_.get(); }

 private:
  /// Of a place where somebody looked: within `radius` no gap but those of `pairs` is below the distance to the rim.
  struct Seen {
    double radius = 0;
    std::vector<PairWalls::PairGap> pairs;  ///< ascending by number
  };

  bool mine() const { return std::this_thread::get_id() == owner_; }
  const Seen& around(const Vector& x, double reach) const;
  const Seen& look(const Vector& x, double reach) const;
  void candidates(const Vector& x, double reach) const;

  std::shared_ptr<const PairWalls> walls_;
  std::thread::id owner_ = std::this_thread::get_id();
  mutable Points places_;  ///< of what was seen, one a column
  mutable std::vector<Seen> seen_;
  mutable std::size_t last_ = 0;
  mutable double from_place_ = 0;  ///< of the last x asked for
  mutable std::vector<PairWalls::Pair> pairs_;
  mutable std::vector<PairWalls::PairGap> bounds_;
};

}  // namespace leastcost
