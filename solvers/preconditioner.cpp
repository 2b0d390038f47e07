// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/preconditioner.hpp>

#include <array>

namespace leastcost {

Words<Preconditioner> words(Preconditioner) {
  static constexpr std::array<Word<Preconditioner>, 2> kWords = {
      {{Preconditioner::chain, "chain"}, {Preconditioner::none, "none"}}};
  return kWords;
}

}  // namespace leastcost
