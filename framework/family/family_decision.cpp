// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/family/family_decision.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <utility>

#include <leastcost/framework/family/same_path.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include "framework/base/point_text.hpp"
#include "framework/family/family_rank.hpp"
#include "framework/proof/calibrate.hpp"
#include "framework/result/feasible_cost.hpp"
#include "framework/search/point_doubling.hpp"

namespace leastcost {
namespace {

constexpr int kMostLooks = 64;  ///< members that are looked at, saddles' lower neighbours included

bool fails_one_of(const Certificate& certificate, std::initializer_list<Failure> kinds) {
  return std::any_of(certificate.failures.begin(), certificate.failures.end(), [&](const CertificateFailure& f) {
    return std::find(kinds.begin(), kinds.end(), f.kind) != kinds.end();
  });
}

/// Failures that no number of points mends.
bool beyond_help(const Certificate& certificate) {
  return std::any_of(certificate.failures.begin(), certificate.failures.end(),
                     [](const CertificateFailure& f) { return consequences(f.kind).points == PointsHelp::never; });
}

double ranking_cost(const Problem& problem, const Result& result, const Deadline& deadline) {
  return result.status == Status::certified ? result.certificate.estimate.value
                                            : feasible_cost(problem, result, deadline);
}

class Decision {
 public:
  Decision(std::vector<FamilyMember>& members, const Solver& solver, const FindOptions& options, const Monitor& monitor)
      : members_(members), solver_(solver), options_(options), monitor_(monitor), undecided_(members.size(), true) {}

  void run() {
    for (int look = 0; look < kMostLooks && !monitor_.interrupted(); ++look) {
      const std::size_t member = next();
      if (member == members_.size()) return;
      undecided_[member] = false;
      try {
        look_at(member);
      } catch (const InputError&) {  // a finer chain could not be made: the member stays as it is
      } catch (const InitializationError&) {
      } catch (const Interrupted&) {
        return;
      }
    }
  }

 private:
  static bool certified(const Result& result) { return result.status == Status::certified; }

  /// The least cost that the member may turn out to have. Levels that were not solved promise nothing.
  static double promise(const FamilyMember& m) {
    const Certificate& c = m.result.certificate;
    const bool solved = c.measured && !fails_one_of(c, {Failure::stationarity, Failure::refinement});
    return solved && c.estimate.value > 0 ? std::min(m.rank_cost, c.estimate.value) : m.rank_cost;
  }

  /// What a member has to be cheaper than to matter.
  double bound() const {
    double least = std::numeric_limits<double>::infinity(), sure = least;
    for (const FamilyMember& m : members_) {
      if (!is_candidate(m)) continue;
      least = std::min(least, m.rank_cost);
      if (certified(m.result)) sure = std::min(sure, cost_range(m).low);
    }
    return std::isfinite(sure) ? sure : std::nextafter(least, std::numeric_limits<double>::infinity());
  }

  /// The most promising member about which something is to be decided; members_.size(): none.
  std::size_t next() const {
    const double most = bound();
    std::size_t best = members_.size();
    for (std::size_t i = 0; i < members_.size(); ++i) {
      const FamilyMember& m = members_[i];
      if (!undecided_[i] || !is_candidate(m) || certified(m.result) || beyond_help(m.result.certificate)) continue;
      if (promise(m) < most && (best == members_.size() || promise(m) < promise(members_[best]))) best = i;
    }
    return best;
  }

  void look_at(std::size_t i) {
    const Problem problem = members_[i].problem;
    const Search means{solver_, options_, monitor_};
    PointDoubling search(problem, members_[i].result, means);
    for (;;) {
      if (search.fine().certificate.index.verdict == IndexVerdict::saddle && leave(i, search)) return;
      if (!search.may_double()) return say_why(i, search);
      search.double_points();
      if (search.fine().status == Status::interrupted) return;
      if (search.fine().status == Status::collapsed) {
        members_[i].result.status = Status::collapsed;
        members_[i].result.notes.emplace_back("with more points it collapses");
        return;
      }
      if (certified(search.fine())) return take(i, search.delivered(search.fine()));
      if (fails_one_of(search.fine().certificate, {Failure::stationarity}))  // the solver does not get there
        return say_why(i, search);
    }
  }

  /// As for one path: more points were tried, and why no more of them.
  void say_why(std::size_t i, const PointDoubling& search) {
    if (monitor_.interrupted()) return;
    std::vector<std::string>& notes = members_[i].result.notes;
    for (std::string& note : search.notes_of_failure())
      if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(std::move(note));
  }

  /// Down from a saddle; false where no cheaper path was found there.
  bool leave(std::size_t i, const PointDoubling& search) {
    const FamilyMember& from = members_[i];
    const Result& saddle = search.fine();
    FindOptions down = options_;
    down.reference_cost = saddle.reference_cost / static_cast<double>(search.factor());
    down.escape_saddle = true;
    down.cascade = false;
    down.certificate.refine = 0;
    Result lower = joined(saddle, improve_path(from.problem, saddle.path, solver_, down, monitor_));
    if (lower.status == Status::interrupted || lower.path.u.size() == 0) return false;
    FamilyMember found{{"down from the saddle of " + from.origins.front()}, from.problem, std::move(lower)};
    found.rank_cost = rank_cost(found.problem, found.result);
    if (!(found.rank_cost < feasible_cost(from.problem, saddle, monitor_.limit()))) return false;
    if (same_path(from.problem, found.result.path, saddle.path)) return false;
    found.result = search.delivered(std::move(found.result));
    members_[i].left = true;
    add_member(std::move(found), members_);
    undecided_.resize(members_.size(), true);
    return true;
  }

  /// The member is certified by its finer chain, and is perhaps one that was certified before.
  void take(std::size_t i, Result finer) {
    FamilyMember& m = members_[i];
    m.result = std::move(finer);
    m.rank_cost = rank_cost(m.problem, m.result);
    for (std::size_t k = 0; k < members_.size(); ++k) {
      FamilyMember& known = members_[k];
      if (k == i || !certified(known.result) || !same_path(known.problem, known.result.path, m.result.path)) continue;
      known.origins.insert(known.origins.end(), m.origins.begin(), m.origins.end());
      members_.erase(members_.begin() + static_cast<std::ptrdiff_t>(i));
      undecided_.erase(undecided_.begin() + static_cast<std::ptrdiff_t>(i));
      return;
    }
  }

  double rank_cost(const Problem& problem, const Result& result) const {
    return ranking_cost(problem, result, monitor_.limit());
  }

  std::vector<FamilyMember>& members_;
  const Solver& solver_;
  const FindOptions& options_;
  const Monitor& monitor_;
  std::vector<bool> undecided_;
};

/// Certifies the first member anew, with a proof where there can be one; true where it is no longer certified.
bool is_refuted(std::vector<FamilyMember>& members, const Solver& solver, const FindOptions& options,
                const Monitor& monitor) {
  if (options.certificate.proof != ProofRule::always || members.empty()) return false;
  FamilyMember& first = members.front();
  const Certificate& c = first.result.certificate;
  const bool sampled = c.resolution && c.resolution->verdict == ResolutionVerdict::sampled;
  // Half as many segments, as many and twice as many; those of a finer chain were asked for a proof when it was made.
  const bool by_finer = c.levels.size() < 2 || c.levels[1].segments > first.result.path.segment_count() + 1;
  if (first.result.status != Status::certified || !sampled || by_finer) return false;
  if (first.result.path.ring || !can_calibrate(first.problem)) return false;
  FindOptions again = options;
  again.reference_cost = first.result.reference_cost;
  again.cascade = false;
  again.certificate.refine = 0;
  try {
    Result proved = improve_path(first.problem, first.result.path, solver, again, monitor);
    if (proved.status == Status::interrupted) return false;
    proved = joined(first.result, std::move(proved));
    first.rank_cost = ranking_cost(first.problem, proved, monitor.limit());
    first.result = std::move(proved);
  } catch (const InputError&) {  // it stays as it is, sampled
  } catch (const InitializationError&) {
  } catch (const Interrupted&) {
  }
  return first.result.status != Status::certified;
}

}  // namespace

std::vector<std::string> decide_family(std::vector<FamilyMember>& members, const Solver& solver,
                                       const FindOptions& options, const Monitor& monitor) {
  for (bool again = options.certificate.enabled; again && !monitor.interrupted();) {
    Decision(members, solver, options, monitor).run();
    rank_members(members);
    again = is_refuted(members, solver, options, monitor);
  }
  rank_members(members);
  if (members.empty() || members.front().result.status != Status::uncertified || !options.certificate.enabled)
    return {};
  const auto sure = std::find_if(members.begin(), members.end(),
                                 [](const FamilyMember& m) { return m.result.status == Status::certified; });
  if (sure == members.end()) return {};
  const TwoNumbers costs = told_apart(members.front().rank_cost, sure->rank_cost);
  return {"family: the cheapest path, of cost " + costs.first + ", could be neither certified nor ruled out" +
          (monitor.interrupted()            ? " in the available time"
           : options.certificate.refine > 0 ? ", even with more points"
                                            : "") +
          "; the cheapest certified path costs " + costs.second};
}

}  // namespace leastcost
