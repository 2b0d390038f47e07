// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/add_global_proof.hpp"

#include <algorithm>
#include <string_view>
#include <variant>

#include <leastcost/framework/problem/offers_global_proof.hpp>

namespace leastcost {

FindOptions with_global_proof(const Problem& problem, const FindOptions& options, std::vector<std::string>& notes) {
  FindOptions out = options;
  auto& steps = out.post_processors;
  const auto any = [&](auto condition) {
    return std::any_of(steps.begin(), steps.end(), [&](const auto& step) { return step && condition(*step); });
  };
  const GlobalProof& asked = options.certificate.global;
  if (!options.certificate.enabled || !std::holds_alternative<GlobalBudget>(asked) || !problem.manifold) return out;
  if (!problem.cost || any([](const PostProcessor& step) { return step.bounds_all_paths(); })) return out;
  const auto* domain = find_ability<OffersGlobalProof>(*problem.manifold);
  GlobalProofStep proof;
  if (domain != nullptr) proof = domain->offered_proof(problem, asked);
  if (!proof.step) {
    notes.push_back("certificate.global: there is no bound over all paths: " +
                    (domain != nullptr ? proof.why_not : std::string("no proof is known for this domain")));
    return out;
  }
  const auto is_before = [&](const PostProcessor& step) { return step.name() == proof.before->name(); };
  if (proof.before && !any(is_before)) steps.push_back(proof.before);
  steps.push_back(proof.step);
  return out;
}

}  // namespace leastcost
