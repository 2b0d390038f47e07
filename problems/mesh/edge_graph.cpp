// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/edge_graph.hpp>

#include <span>

#include "problems/mesh/edge_search.hpp"

namespace leastcost {
namespace {

/// Of moves by a function, which is asked for each.
struct FunctionCost {
  using Vector = Eigen::Vector3d;
  static constexpr int kLookEvery = 32;  // a move may be dear

  double operator()(const Vector& a, const Vector& b) const { return (*move)(a, b); }
  bool may_be_below(const Vector&, const Vector&, double) const { return true; }
  DiagonalMove across(const Vector& a, const Vector& tail, const Vector& head, const Vector& b) const {
    const auto crossing = unfolded_crossing(head - tail, a - tail, b - tail);
    if (!crossing) return {};
    const Vector x = tail + crossing->at * (head - tail);
    return {(*move)(a, x) + (*move)(x, b), crossing->at};
  }
  void aim(const Vector&, std::span<const std::int32_t>) const {}
  double rest(std::int32_t, const Vector& x) const { return *bound ? (*bound)(x) : 0; }

  const MoveCost* move;
  const CostBound* bound;
};

}  // namespace

struct EdgeGraphSearch::State {
  EdgeSearch<FunctionCost> search;
};

EdgeGraphSearch::EdgeGraphSearch(const TriangleMesh& mesh)
    : state_(std::make_unique<State>(State{EdgeSearch<FunctionCost>(mesh)})) {}
EdgeGraphSearch::~EdgeGraphSearch() = default;
EdgeGraphSearch::EdgeGraphSearch(EdgeGraphSearch&&) noexcept = default;
EdgeGraphSearch& EdgeGraphSearch::operator=(EdgeGraphSearch&&) noexcept = default;

EdgePath EdgeGraphSearch::shortest(const SurfacePoint& source, const SurfacePoint& target, const MoveCost& cost,
                                   const EdgePathOptions& options) {
  return state_->search.shortest(source, target, {&cost, &options.lower_bound}, options.diagonals, options.stop);
}

}  // namespace leastcost
