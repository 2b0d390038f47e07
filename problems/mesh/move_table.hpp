// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include "problems/mesh/edge_search.hpp"

namespace leastcost {

/// The moves of a mesh, kept from query to query: where the moves of every vertex that a search has left lead, and how
/// long they are. Vertices have places, numbered in the order in which searches met them, later in patches, so that
/// what a search needs next lies beside what it used last. About 110 bytes of a vertex that was left, 8 of one that was
/// only met, nothing of the others. The mesh must outlive it.
class MoveTable {
 public:
  MoveTable(const TriangleMesh& mesh, bool diagonals)
      : mesh_(&mesh),
        diagonals_(diagonals),
        place_of_(static_cast<std::int32_t*>(
            std::calloc(static_cast<std::size_t>(mesh.vertex_count()) + 1, sizeof(std::int32_t)))),
        moves_(1) {
    if (!place_of_) throw std::bad_alloc();
  }

  bool diagonals() const { return diagonals_; }  ///< whether moves across edges are in it
  std::int32_t size() const { return static_cast<std::int32_t>(vertices_.size()); }  ///< vertices that were met
  std::int32_t vertex(std::int32_t place) const { return vertices_[at(place)]; }
  /// Of a vertex, which counts as met from now on.
  std::int32_t place(std::int32_t vertex) {
    std::int32_t& known = place_of_[at(vertex)];  // from 1 on; 0: not met
    if (known == 0) meet(vertex);
    return known - 1;
  }

  /// To a place. A length is off by a rounding of a float; its unit is the caller's.
  struct Move {
    std::int32_t to;
    float length;
  };
  /// Makes the moves of a place, lengths times `scale`; returns their number in the table, which is never 0.
  template <class Cost>
  std::uint32_t make_moves(std::int32_t place, const Cost& cost, double scale) {
    const std::int32_t from = vertex(place);
    const Eigen::Vector3d& here = mesh_->position(from);
    const auto add = [this, scale](std::int32_t to, double length) {
      if (length < std::numeric_limits<double>::infinity())
        moves_.push_back({this->place(to), static_cast<float>(scale * length)});
    };
    const std::size_t head = moves_.size();
    moves_.push_back({});
    for (const std::int32_t to : mesh_->neighbours(from)) add(to, cost(here, mesh_->position(to)));
    const std::size_t edges = moves_.size() - head - 1;
    if (diagonals_)
      for_diagonals(*mesh_, from, [&](std::int32_t halfedge, std::int32_t to) {
        if (to != from) add(to, move_across(*mesh_, cost, here, halfedge, to).cost);
      });
    moves_[head] = {static_cast<std::int32_t>(edges),
                    std::bit_cast<float>(static_cast<std::int32_t>(moves_.size() - head - 1))};
    return static_cast<std::uint32_t>(head);
  }
  /// Of a place, by the number that make_moves() returned: along edges, and then across them. Valid until others are
  /// made.
  std::span<const Move> moves(std::uint32_t number, bool diagonals) const {
    const Move* head = &moves_[number];
    return {head + 1, static_cast<std::size_t>(diagonals ? std::bit_cast<std::int32_t>(head->length) : head->to)};
  }
  /// Has the moves brought near that will soon be asked for.
  void expect(std::uint32_t number) const {
    const char* first = reinterpret_cast<const char*>(moves_.data() + number);
    for (std::ptrdiff_t line = 0; line < kLines; ++line) __builtin_prefetch(first + line * kLine);
  }

 private:
  static constexpr std::ptrdiff_t kLine = 64, kLines = 3;  // of the cache: bytes, and how many hold a vertex's moves
  struct Free {
    void operator()(std::int32_t* numbers) const { std::free(numbers); }
  };
  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
  /// In large searches with those around it: what a later search comes to from another side lies together as well.
  void meet(std::int32_t vertex) {
    constexpr std::size_t kLarge = 16384, kPatch = 64;  // vertices
    std::size_t next = vertices_.size();
    const std::size_t limit = next + (next < kLarge ? 1 : kPatch);
    number(vertex);
    for (; next < vertices_.size() && vertices_.size() < limit; ++next)
      for (const std::int32_t beside : mesh_->neighbours(vertices_[next]))
        if (place_of_[at(beside)] == 0 && vertices_.size() < limit) number(beside);
  }
  void number(std::int32_t vertex) {
    vertices_.push_back(vertex);
    place_of_[at(vertex)] = size();
  }

  const TriangleMesh* mesh_;
  bool diagonals_;
  std::unique_ptr<std::int32_t[], Free> place_of_;  // zeros whose pages are not touched until they are asked for
  std::vector<std::int32_t> vertices_;
  std::vector<Move> moves_;  // before those of a place their counts: along edges, and (the bits of `length`) all
};

}  // namespace leastcost
