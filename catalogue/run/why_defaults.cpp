// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/why_defaults.hpp"

#include <fmt/format.h>

#include <leastcost/recipes/recommended.hpp>
#include "catalogue/config/config_facts.hpp"

namespace leastcost {
namespace {

std::string why_proof_of(const RunConfig& config, const RunParts& parts) {
  const std::size_t stated = config.post_process ? config.post_process->size() : 0;
  const auto& steps = parts.options.post_processors;
  if (steps.size() > stated)
    return fmt::format("proof over all paths: {}, {}", steps.back()->name(),
                       why_proof(facts_of(config), first_path_of(config), asked_proof(config)));
  if (config.family.wanted()) return "proof over all paths: none, because a family contains paths of several classes";
  if (proves_shortest(config)) return "proof over all paths: none, because the last post-processor makes another curve";
  return fmt::format("proof over all paths: none, {}",
                     why_proof(facts_of(config), first_path_of(config), asked_proof(config)));
}

}  // namespace

std::vector<std::string> why_defaults(const LoadedConfig& loaded, const RunParts& parts) {
  const RunConfig& config = loaded.config;
  const ProblemFacts facts = facts_of(config);
  const auto open = [&](const char* key) { return node_at(loaded.tree, key) == nullptr; };
  std::vector<std::string> lines;
  const FirstPathMethod first = recommended_first_path(facts);
  // Places without data may have replaced it, and a note says so.
  if (open("initializer") && parts.initializer && parts.initializer->name() == word_of(first))
    lines.push_back(fmt::format("first path: {}, {}", word_of(first), why(first, facts)));
  const bool exact = open("post_process") && (makes_exact_curves(facts) || proves_shortest(config));
  const SolveMethod solver = recommended_solver(facts, exact);
  if (open("solver")) lines.push_back(fmt::format("solver: {}, {}", word_of(solver), why(solver)));
  if (open("post_process")) lines.push_back(why_curve(recommended_curve(facts)));
  if (open("certificate.global") && open("certificate.enabled")) lines.push_back(why_proof_of(config, parts));
  return lines;
}

}  // namespace leastcost
