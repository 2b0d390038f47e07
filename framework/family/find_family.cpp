// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/family/find_family.hpp>

#include <exception>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include "framework/family/family_decision.hpp"
#include "framework/family/family_rank.hpp"
#include "framework/result/feasible_cost.hpp"

namespace leastcost {
namespace {

/// Of an interrupted solve only what its chain costs. What threw while it was solved is not asked again.
double rank_cost(const Problem& problem, const Result& result, const Monitor& monitor) {
  const Certificate& c = result.certificate;
  if (result.status == Status::certified) return c.estimate.value;
  if (result.status == Status::interrupted || (!c.measured && !c.failures.empty())) return result.curve.cost;
  try {
    return feasible_cost(problem, result, monitor.limit());
  } catch (const Interrupted&) {
    return result.curve.cost;
  }
}

std::string no_time(const FamilyStart& start) {
  return "family: there was no time for " + start.origin + " and the starts after it";
}

}  // namespace

Family find_family(const std::vector<FamilyStart>& starts, const Solver& solver, const FindOptions& given,
                   const Monitor& monitor) {
  FindOptions options = given;
  options.certificate.global = GlobalOff{};  // members are paths of other classes than the least one's
  Family family;
  std::exception_ptr first_error;
  std::vector<FamilyMember> pathless;
  FindOptions each = options;  // proofs are dear: decide_family() asks for that of the least path
  if (options.certificate.proof == ProofRule::always && starts.size() > 1) each.certificate.proof = ProofRule::needed;
  each.target_as_given = true;  // starts go to images of their own
  each.certificate.refine = 0;  // so are finer chains: it goes on with what matters alone
  for (const FamilyStart& start : starts)
    if (!start.initializer) throw InputError("family, " + start.origin + ": the initializer is null");
  for (const FamilyStart& start : starts) {
    if (monitor.interrupted() && (!family.members.empty() || first_error)) {
      family.notes.push_back(no_time(start));
      break;
    }
    try {
      FamilyMember member{
          {start.origin}, start.problem, find_path(start.problem, *start.initializer, solver, each, monitor)};
      if (member.result.path.u.size() == 0) {
        if (!family.members.empty()) family.notes.push_back(no_time(start));
        pathless.push_back(std::move(member));
        break;
      }
      member.rank_cost = rank_cost(member.problem, member.result, monitor);
      add_member(std::move(member), family.members);
    } catch (const InitializationError& error) {
      if (!first_error) first_error = std::current_exception();
      family.notes.push_back("family, " + start.origin + ": no first path: " + error.what());
    } catch (const std::exception& error) {  // a start that does not fit, or what a user's part threw
      if (!first_error) first_error = std::current_exception();
      family.notes.push_back("family, " + start.origin + ": " + error.what());
    }
  }
  if (family.members.empty() && !pathless.empty()) return {std::move(pathless), std::move(family.notes)};
  if (family.members.empty() && first_error) std::rethrow_exception(first_error);
  for (std::string& note : decide_family(family.members, solver, options, monitor))
    family.notes.push_back(std::move(note));
  return family;
}

}  // namespace leastcost
