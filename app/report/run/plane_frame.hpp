// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include <leastcost/framework/path/path.hpp>
#include "app/plot/scale.hpp"
#include "app/report/space/look.hpp"

namespace leastcost::app {

/// The part of the plane that is shown, and how it is mapped to the drawing.
class PlaneFrame {
 public:
  PlaneFrame(const Eigen::Vector2d& lower, const Eigen::Vector2d& upper, const Look& look);
  double left() const { return left_; }
  double right() const { return left_ + width(); }
  double top() const;
  double bottom() const { return top() + height(); }
  double x(double value) const { return left_ + scale_ * (value - lower_[0]); }
  double y(double value) const { return top() + scale_ * (upper_[1] - value); }
  double width() const { return scale_ * (upper_[0] - lower_[0]); }
  double height() const { return scale_ * (upper_[1] - lower_[1]); }
  Range range(Index i) const { return {lower_[i], upper_[i]}; }
  std::vector<Tick> ticks_of(Index axis) const;

  /// SVG path data of a polyline, without points at infinity.
  std::string line(const Points& line) const;
  /// Of its own border.
  std::string border() const;
  /// The border with ticks, labels and the names of the axes.
  std::string axes(const std::string& x_name, const std::string& y_name) const;
  /// Of everything, labels included.
  double total_width() const { return right() + beyond_; }
  double total_height() const;

 private:
  void fit();

  Eigen::Vector2d lower_, upper_;
  double most_width_, most_height_, scale_ = 1, left_ = 0, beyond_ = 0;
};

}  // namespace leastcost::app
