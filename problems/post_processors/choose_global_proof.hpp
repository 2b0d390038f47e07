// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/offers_global_proof.hpp>

namespace leastcost {

/// The proof over all paths that fits, chosen by what the domain and the cost are: exact windows on a mesh, tangents
/// among obstacles in the plane, layers, cells of a raster, else a potential in a box or over terrain. `proof`: its
/// budget.
GlobalProofStep global_proof(const Problem& problem, const GlobalProof& proof);

/// The domains that such proofs speak of.
class KnowsGlobalProofs : public OffersGlobalProof {
 public:
  GlobalProofStep offered_proof(const Problem& problem, const GlobalProof& proof) const final {
    return global_proof(problem, proof);
  }
};

}  // namespace leastcost
