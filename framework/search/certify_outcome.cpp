// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/certify_outcome.hpp"

#include <array>
#include <exception>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/certificate/certify.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/search/prepare.hpp>
#include "framework/result/delivery.hpp"
#include "framework/search/among_obstacles.hpp"
#include "framework/search/free_passage.hpp"
#include "framework/search/make_curve.hpp"
#include "framework/search/other_ways.hpp"

namespace leastcost {
namespace {

/// Part of the certificate: if one throws, the certificate fails as `exception`.
constexpr std::array<Step, 2> kNotes = {note_cheaper_image, note_free_ways};
/// Of the delivered path, whether it was certified or not.
constexpr std::array<Step, 2> kJudgements = {judge_homotopy_class, judge_free_passage};

/// Without a deadline they are made now. With one there are those that prepare() has made, or none.
void make_coarser_versions(const Search& search, Outcome& out) {
  if (search.monitor.deadline || find_ability<HasCoarserVersion>(*out.solved.manifold) == nullptr) return;
  const auto start = Monitor::Clock::now();
  prepare(out.solved);
  out.result.seconds.prepare = std::chrono::duration<double>(Monitor::Clock::now() - start).count();
}

/// The path is found: what a part throws now takes nothing away from it.
void certify_delivered(const Search& search, Outcome& out) {
  Result& result = out.result;
  const auto fail = [&](Failure failure, const std::string& why) {
    result.certificate.failures.push_back({failure, why});
  };
  if (search.monitor.interrupted()) return fail(Failure::interrupted, "there was no time for the certificate");
  timed(Stage::certify, search, result.seconds.certify, [&] {
    try {
      make_coarser_versions(search, out);
      result.certificate = certify(out.solved, result.reference_cost, out.curve, curve_maker(search, out),
                                   search.options.certificate, search.monitor);
      for (const Step note : kNotes) note(search, out);
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      fail(Failure::exception, std::string("while certifying: ") + error.what());
    } catch (...) {
      fail(Failure::exception, "while certifying: an exception not derived from std::exception");
    }
  });
  result.seconds.certify -= result.seconds.prepare;
}

Status status_of(const Search& search, const Result& result, bool collapsed) {
  const Termination end = result.solve.termination;
  if (end == Termination::cancelled || end == Termination::time_limit) return Status::interrupted;
  if (search.monitor.interrupted() && !result.certificate.certified()) return Status::interrupted;
  if (collapsed) return Status::collapsed;
  return result.certificate.certified() ? Status::certified : Status::uncertified;
}

}  // namespace

void certify_outcome(const Search& search, Outcome& out) {
  Result& result = out.result;
  const bool collapsed = out.free_segment || has_collapsed(result, out.curve);
  PathEnergy energy(out.solved, result.reference_cost, search.monitor.deadline);
  deliver(out.curve, energy.costs(out.curve.chain), result);
  result.post_processed = true;
  if (out.curve_fault)
    result.certificate.failures.push_back({Failure::post_process, "the curve was left unchanged: " + *out.curve_fault});
  if (search.options.certificate.enabled && !collapsed && !out.curve_fault) certify_delivered(search, out);
  for (const Step judge : kJudgements) judge(search, out);
  result.status = status_of(search, result, collapsed);
}

}  // namespace leastcost
