// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>
#include "problems/fields/grid_search.hpp"
#include "problems/fields/lattice_box.hpp"
#include "problems/fields/node_moves.hpp"
#include "problems/graph/lattice_route.hpp"
#include "problems/graph/monotone_queue.hpp"

namespace leastcost {

/// What it costs at least to come from the source of a problem to each node of a lattice in two coordinates: the
/// viscosity solution of its Hamilton-Jacobi equation (|grad u| = n for n times length), by the local variational
/// principle over the eight triangles around a node (Bornemann, Rasch: Finite-element discretization of static
/// Hamilton-Jacobi equations based on a local variational principle, Comput. Vis. Sci. 9, 2006, Eq. 5),
///
///     u(x) = min over the edges (a, b) around x and t in [0, 1] of (1 - t) u(a) + t u(b) + c((1 - t) a + t b, x).
///
/// Of a field up to every node the values are of second order where the cost is smooth: see sharpen().
///
/// c may depend on place and direction, and be asymmetric. Nodes are worked off in the order of their costs, and again
/// when they become cheaper, for with a cost that depends on direction no single order is right. Moves and edges that
/// obstacles do not let pass are left out. Between nodes c is by the line elements at both ends of a move, asked once
/// per node (NodeMoves); the problem's own segment cost is asked where some directions are impossible, beside places
/// without a cost, at the ends and on the way back, or, when `exact`, everywhere.
class ArrivalField {
 public:
  /// How it is found. `margin`: so many nodes around those without a cost are left out too, but at the ends. The rest
  /// is for fields without a target.
  struct Way {
    bool exact = false;
    int margin = 0;
    bool whole = false;                                     ///< up to every node, not only until the target is reached
    bool reversed = false;                                  ///< of costs to the source, not from it
    std::vector<Eigen::Vector2d> sources = {};              ///< besides that of the problem, coordinates
    std::optional<std::array<std::int32_t, 2>> cells = {};  ///< along both sides, instead of along the longest
  };

  /// A lattice of so many cells along the longest side of the box. Throws Interrupted.
  ArrivalField(const Problem& problem, const MoveCheck& moves, const LatticeBox& box, int cells, const Way& how,
               const std::function<bool()>& stop);

  /// Nothing where the target is not reached.
  std::optional<double> arrival_cost() const;
  /// The way on which the target is reached, in coordinates, from the source on. Throws InitializationError where it
  /// cannot be followed back.
  std::vector<Eigen::Vector2d> way() const;
  const Lattice& lattice() const { return lattice_; }
  /// What it costs to come to a node; infinite where nothing arrives.
  double value(std::int32_t node) const { return arrivals_[static_cast<std::size_t>(node)].cost; }
  /// Some nodes have no cost.
  bool has_gaps() const { return node_moves_ && node_moves_->any_blocked(); }
  /// Some nodes can be left in some directions only.
  bool is_carried() const { return node_moves_ && node_moves_->any_carried(); }

 private:
  /// A point of an edge between two nodes, (1 - t) a + t b; a node where a = b.
  struct Place {
    std::int32_t a = -1, b = -1;
    double t = 0;
  };
  /// The last move to a point, and what it costs to come there.
  struct Arrival {
    double cost = std::numeric_limits<double>::infinity();
    Place from = {};  ///< a = -1: the source
  };
  struct Edge {
    std::int32_t a, b;
  };

  struct Window {  ///< of nodes, both ends included
    std::array<std::int32_t, 3> low, high;
  };

  using Queue = MonotoneQueue<std::int32_t>;  ///< nodes, and what each cost when it was put there

  void lay(const LatticeBox& box, int cells);
  void spread(const std::function<bool()>& stop);
  void leave_source(const Eigen::Vector2d& u, const Eigen::VectorXd& x, Queue& queue);
  void work_off(Queue& queue, bool leaping, const std::function<bool()>& stop);
  void leap(std::int32_t node, Queue& queue);
  /// By its neighbour `by`, number k of its ring.
  bool improve(std::int32_t node, std::int32_t by, std::size_t k);
  /// Visits the nodes in the box of so many around each that is blocked.
  template <class Visit>
  void beside_blocked(int reach, const Visit& visit) const;
  void keep_off(int margin);
  void mark_doubtful();
  /// From a node near the target on to it; infinite elsewhere.
  double last_move(std::int32_t node) const;
  bool isotropic() const { return node_moves_ && node_moves_->isotropic(); }
  void arrive_at_target();
  /// The cheapest move to x over one edge that obstacles let pass, where it is cheaper than `best`.
  /// `below`: what arriving at the place before x must cost less than, so that no way back goes in circles.
  /// `least`: what the move costs at least.
  void try_edge(const Edge& edge, const Eigen::VectorXd& x, Arrival& best, double below = kNever,
                double least = 0) const;
  Arrival over_edge(const Edge& edge, const Eigen::VectorXd& x, double below, double least) const;
  /// The same by the line elements at the nodes: into `node` from its neighbour `by`, number k of its ring, or over the
  /// edge from there to `other`, number k + turn. False where they do not know.
  /// `bend`: see sharpen().
  bool try_triangle(std::int32_t node, std::int32_t by, std::int32_t other, std::size_t k, int turn, Arrival& best,
                    double bend = 0) const;
  double least_move(std::int32_t node, std::int32_t by, std::int32_t other, std::size_t k, int turn) const;
  void sharpen(const std::function<bool()>& stop);
  /// Whether its value has changed.
  bool sharpen_node(std::int32_t node, std::vector<Eigen::Vector2f>& gradients);
  Eigen::Vector2d gradient_by(std::int32_t node, const Eigen::Vector2d& v) const;
  double bend_along(const std::vector<Eigen::Vector2f>& gradients, std::int32_t by, std::int32_t other,
                    std::size_t k) const;
  bool passes(const Place& from, std::int32_t node) const;
  bool clear(const Edge& edge) const;
  double move(const Eigen::Ref<const Eigen::VectorXd>& a, const Eigen::Ref<const Eigen::VectorXd>& b) const;

  double move_from(const Place& place, const Eigen::VectorXd& x) const;
  double cost_of_ends() const;

  Place before(const Place& place) const;
  Window around(const Eigen::Vector2d& u, int reach) const;
  Window cells_beside(const Place& edge) const;
  std::vector<Edge> edges_in(const Window& window) const;

  bool known(std::int32_t node) const { return arrivals_[static_cast<std::size_t>(node)].cost < kNever; }
  double cost(const Place& place) const;
  Eigen::Vector2d coordinates(const Place& place) const;
  Eigen::VectorXd position(const Place& place) const {
    return x_.col(place.a) + place.t * (x_.col(place.b) - x_.col(place.a));
  }

  static constexpr double kNever = std::numeric_limits<double>::infinity();

  const Problem& problem_;
  const MoveCheck& moves_;
  Way how_;
  Lattice lattice_;
  Eigen::Vector2d lower_, upper_, step_;  ///< the box in coordinates, and from node to node
  Points x_;                              ///< ambient positions of the nodes; not finite off the domain
  Eigen::VectorXd source_, target_;       ///< ambient
  Points more_sources_;                   ///< the same of those besides, one a column
  std::optional<NodeMoves> node_moves_;   ///< none: exact
  std::vector<unsigned char> doubtful_;   ///< per node: beside one that is blocked
  std::vector<Arrival> arrivals_;         ///< per node
  std::vector<double> worked_off_;        ///< the same: its cost when moves from it were last looked at
  std::vector<std::pair<std::int32_t, Eigen::Vector2d>> starts_;  ///< nodes beside a source, and the move from it
  mutable std::vector<signed char> clear_;                        ///< per edge: 1 clear, 0 not, -1 not asked yet
  mutable Points ends_;                                           ///< of the move whose cost is asked
  Arrival at_target_;
};

}  // namespace leastcost
