// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/straighten/ring_funnel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "problems/mesh/surface_walk.hpp"
#include "problems/straighten/plane_vectors.hpp"

namespace leastcost {
namespace {

constexpr double kTurn = 1e-10;  // radians; the certificate asks for 1e-9

/// From direction a to direction b, left positive.
double angle_from(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return std::atan2(cross(a, b), a.dot(b)); }

}  // namespace

/// False: nothing is left.
bool RingFunnel::reduce(std::vector<Door>& doors) {
  Strip strip;
  for (const Door& door : doors) unfolding_->append(door, strip);
  std::size_t first = 0, last = strip.doors.size();
  while (last - first >= 2 && mesh().across(strip.doors[last - 1].halfedge) == strip.doors[first].halfedge)
    ++first, --last;
  doors.assign(strip.doors.begin() + static_cast<std::ptrdiff_t>(first),
               strip.doors.begin() + static_cast<std::ptrdiff_t>(last));
  return doors.size() >= 2;
}

void RingFunnel::lay_out_period() {
  Strip strip;
  for (const Door& door : doors_) unfolding_->append(door, strip);
  unfolding_->append(doors_.front(), strip);
  const std::int32_t h = doors_.front().halfedge;
  const StripEnd start{(mesh().position(mesh().tail(h)) + mesh().position(mesh().head(h))) / 2, -1, h};
  unfolding_->lay_out(start, strip.doors, start);
  period_ = unfolding_->doors();
  turning_ = 0;
  for (std::size_t i = 1; i < period_.size(); ++i) {
    const Door& door = strip.doors[i];
    const double turn = std::atan2(door.sine, door.cosine);
    turning_ += door.kept == period_[i - 1].left_vertex ? turn : -turn;
  }
  one_sided_ = period_.back().left_vertex != period_.front().left_vertex;
}

bool RingFunnel::around_one_vertex() const {
  const UnfoldedDoor& first = period_.front();
  const auto left = [&](const UnfoldedDoor& d) { return d.left_vertex == first.left_vertex; };
  const auto right = [&](const UnfoldedDoor& d) { return d.right_vertex == first.right_vertex; };
  return std::all_of(period_.begin(), period_.end(), left) || std::all_of(period_.begin(), period_.end(), right);
}

/// Whether a line in direction `along` passes through all doors: the one through `on`, or any of its parallels, of
/// which the one in the middle is taken. Leaves it in line_.
bool RingFunnel::in_corridor(const Eigen::Vector2d& on, const Eigen::Vector2d& along, bool anywhere) {
  double right = -std::numeric_limits<double>::infinity(), left = -right;
  for (const UnfoldedDoor& d : period_) {
    left = std::min(left, cross(along, d.left - on));
    right = std::max(right, cross(along, d.right - on));
  }
  const double height = anywhere ? (left + right) / 2 : 0;
  if (!(left - height > tolerance_ && height - right > tolerance_)) return false;
  line_ = {};
  for (std::size_t i = 0; i < doors_.size(); ++i) {
    const UnfoldedDoor& d = period_[i];
    const double a = cross(along, d.left - on) - height, b = height - cross(along, d.right - on);
    const Eigen::Vector3d &p = mesh().position(d.left_vertex), &q = mesh().position(d.right_vertex);
    const double t = a / (a + b);
    const Eigen::Vector3d x = t < 0.5 ? Eigen::Vector3d(p + t * (q - p)) : Eigen::Vector3d(q + (1 - t) * (p - q));
    if (i == 0)
      line_.points.push_back(x);
    else
      append_point(line_, x, mesh().across(doors_[i - 1].halfedge) / 3);
  }
  append_point(line_, line_.points.front(), mesh().across(doors_.back().halfedge) / 3);
  return true;
}

bool RingFunnel::find_line() {
  const UnfoldedDoor &first = period_.front(), &last = period_.back();
  if (!one_sided_) {
    const Eigen::Vector2d shift = last.left - first.left;
    return std::abs(turning_) <= kTurn && shift.norm() > tolerance_ &&
           in_corridor(first.left, shift.normalized(), true);
  }
  // The axis of a glide reflection halves every segment from a point to its image, and the angle between a direction
  // and its image.
  const Eigen::Vector2d shift = last.right - first.left, on = (first.left + last.right) / 2;
  const Eigen::Vector2d sum = first.along - last.along, other(-first.along.y(), first.along.x());
  Eigen::Vector2d along = sum.norm() > 1e-8 ? Eigen::Vector2d(sum.normalized()) : other;
  if (along.dot(shift) < 0) along = -along;
  return in_corridor(on, along, false);
}

std::int32_t RingFunnel::vertex_of(const Corner& corner) const {
  const UnfoldedDoor& d = period_[corner.door];
  return corner.left ? d.left_vertex : d.right_vertex;
}

/// From a corner all around to the same corner, without the doors at it.
Strip RingFunnel::strip_from(const Corner& corner) const {
  const StripEnd v{mesh().position(vertex_of(corner)), vertex_of(corner), -1};
  const std::size_t count = doors_.size();
  Strip strip{doors_[corner.door].halfedge / 3, {}};
  for (std::size_t k = 0; k < count; ++k) unfolding_->append(doors_[(corner.door + k) % count], strip);
  trim(mesh(), v, v, strip);
  return strip;
}

RingFunnel::Pulled RingFunnel::pull_from(const Corner& corner) {
  const std::int32_t vertex = vertex_of(corner);
  const StripEnd v{mesh().position(vertex), vertex, -1};
  const Strip strip = strip_from(corner);
  Pulled pulled;
  if (strip.doors.empty()) return pulled;
  std::size_t skipped = 0;  // doors at the corner
  while (on_door(mesh(), v, doors_[(corner.door + skipped) % doors_.size()].halfedge)) ++skipped;
  unfolding_->lay_out(v, strip.doors, v);
  const std::vector<UnfoldedDoor>& doors = unfolding_->doors();
  const std::vector<Touch>& touched = funnel_.pull(doors, unfolding_->end());
  Eigen::Vector2d at = Eigen::Vector2d::Zero(), before = at;
  double sum = 0, most = 0;
  for (std::size_t k = 0; k <= touched.size(); ++k) {
    const Eigen::Vector2d next = k < touched.size() ? touched[k].at : unfolding_->end();
    const Eigen::Vector2d step = next - at;
    pulled.length += step.norm();
    if (k > 0) {
      const double turn = angle_from(before, step);
      const Touch& bend = touched[k - 1];
      const bool left = doors[bend.door].left_vertex == bend.vertex;
      sum += turn;
      if (left == corner.left && std::abs(turn) >= most) {
        most = std::abs(turn);
        pulled.has_next = true;
        pulled.next = {(corner.door + skipped + bend.door) % doors_.size(), left};
      }
    }
    at = next;
    if (step.squaredNorm() > 0) before = step;
  }
  pulled.turn = turning_ - sum;
  return pulled;
}

/// From corner to corner of one side, each on a shorter string than the one before, until the string bends around the
/// corner that it starts from and not away from it.
RingFunnel::Corner RingFunnel::descend(Corner corner) {
  double length = std::numeric_limits<double>::infinity();
  for (;;) {
    const Pulled pulled = pull_from(corner);
    const double wrong = corner.left ? -pulled.turn : pulled.turn;
    if (wrong <= kTurn || !pulled.has_next || pulled.length >= length) return corner;
    length = pulled.length;
    corner = pulled.next;
  }
}

/// By trying every corner: for strips with one side, which the turning of the doors tells nothing about.
RingFunnel::Corner RingFunnel::shortest_corner() {
  Corner best{0, true};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < doors_.size(); ++i) {
    for (const bool left : {true, false}) {
      const Corner corner{i, left};
      if (i > 0 && vertex_of(corner) == vertex_of({i - 1, left})) continue;
      const double length = pull_from(corner).length;
      if (length < least) least = length, best = corner;
    }
  }
  return best;
}

RingFunnel::Outcome RingFunnel::pull(std::vector<Door> doors) {
  if (!reduce(doors)) return Outcome::collapsed;
  doors_ = std::move(doors);
  lay_out_period();
  if (around_one_vertex()) return Outcome::collapsed;
  if (find_line()) return Outcome::straight;
  const Corner corner = one_sided_ ? shortest_corner() : descend({0, turning_ >= -kTurn});
  strip_ = strip_from(corner);
  if (strip_.doors.empty()) return Outcome::collapsed;
  const std::int32_t v = vertex_of(corner);
  bend_ = {mesh().position(v), v, -1};
  return Outcome::bent;
}

}  // namespace leastcost
