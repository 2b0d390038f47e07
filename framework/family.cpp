// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/family.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/path_energy.hpp>

namespace leastcost {
namespace {

/// Largest squared distance of a column of `a` from the nearest column of `b`.
double farthest2(const Points& a, const Points& b) {
  double worst = 0;
  for (const auto x : a.colwise()) worst = std::max(worst, (b.colwise() - x).colwise().squaredNorm().minCoeff());
  return worst;
}

double quoted_cost(const Result& result) {
  return result.certificate.measured ? result.certificate.estimate.value : result.curve.cost;
}

bool comes_first(const FamilyMember& a, const FamilyMember& b) {
  const bool certified = a.result.status == Status::certified;
  if (certified != (b.result.status == Status::certified)) return certified;
  return quoted_cost(a.result) < quoted_cost(b.result);
}

/// Adds a result to the member that it repeats, or as a new one.
void add(FamilyMember member, std::vector<FamilyMember>& members) {
  for (FamilyMember& known : members) {
    if (known.result.status != member.result.status || !same_path(known.problem, known.result.path, member.result.path))
      continue;
    known.origins.push_back(member.origins.front());
    return;
  }
  members.push_back(std::move(member));
}

}  // namespace

bool same_path(const Problem& problem, const CoordinatePath& a, const CoordinatePath& b) {
  constexpr double kSameCost = 1e-3;
  PathEnergy energy(problem, 1);
  const double cost = energy.cost(a);
  if (!(std::abs(energy.cost(b) - cost) <= kSameCost * cost)) return false;
  const Points x = positions(*problem.manifold, a), y = positions(*problem.manifold, b);
  const Index m = x.cols() - 1;
  if (m < 1 || y.cols() < 2) return false;
  const double segment2 = (x.rightCols(m) - x.leftCols(m)).colwise().squaredNorm().maxCoeff();
  return std::max(farthest2(x, y), farthest2(y, x)) <= 0.75 * 0.75 * segment2;
}

Family find_family(const std::vector<FamilyStart>& starts, const Solver& solver, const FindOptions& options,
                   const Monitor& monitor) {
  Family family;
  std::exception_ptr first_error;
  std::vector<FamilyMember> pathless;
  for (const FamilyStart& start : starts) {
    if (!start.initializer) throw InputError("family, " + start.origin + ": the initializer is null");
    if (monitor.interrupted() && (!family.members.empty() || first_error)) {
      family.notes.push_back("family, " + start.origin + " and what comes after it: not tried, there was no time");
      break;
    }
    try {
      FamilyMember member{
          {start.origin}, start.problem, find_path(start.problem, *start.initializer, solver, options, monitor)};
      if (member.result.path.u.size() == 0) {
        pathless.push_back(std::move(member));
        break;
      }
      add(std::move(member), family.members);
    } catch (const InitializationError& error) {
      if (!first_error) first_error = std::current_exception();
      family.notes.push_back("family, " + start.origin + ": no first path: " + error.what());
    }
  }
  if (family.members.empty() && !pathless.empty()) return {std::move(pathless), std::move(family.notes)};
  if (family.members.empty() && first_error) std::rethrow_exception(first_error);
  std::stable_sort(family.members.begin(), family.members.end(), comes_first);
  return family;
}

}  // namespace leastcost
