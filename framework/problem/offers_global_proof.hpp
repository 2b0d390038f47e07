// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <leastcost/framework/problem/global_bound.hpp>
#include <leastcost/framework/problem/post_processor.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// The step that bounds the cost of all paths of a problem between its two ends, whatever class they are of.
struct GlobalProofStep {
  std::shared_ptr<const PostProcessor> step;    ///< null: there is no such proof
  std::shared_ptr<const PostProcessor> before;  ///< makes the curve that it speaks of; null: any curve will do
  std::string why_not;                          ///< in words, where there is none
};

/// Ability of a domain that knows such proofs. A bound that is asked for (CertificateOptions::global) is made by it
/// where none of the given post-processors makes one.
class OffersGlobalProof {
 public:
  virtual ~OffersGlobalProof() = default;
  /// The step that proves a bound over all paths; none where it has no proof for this problem.
  virtual GlobalProofStep offered_proof(const Problem& problem, const GlobalProof& proof) const = 0;
};

}  // namespace leastcost
