// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "tests/adversarial/measure.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <leastcost/framework/family/find_family.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

void write_line(const std::string& family, std::uint64_t seed, const Result& r,
                const std::optional<TrueGeodesic>& truth, double feature, const std::string& outcome) {
  const char* file = std::getenv("LEASTCOST_ADVERSARIES_CSV");  // NOLINT(concurrency-mt-unsafe)
  if (file == nullptr) return;
  const Certificate& c = r.certificate;
  std::ofstream out(file, std::ios::app);
  out.precision(17);
  out << '"' << family << "\"," << seed << ',' << r.path.u.cols() << ',' << outcome << ',' << c.estimate.value << ','
      << c.estimate.error << ',' << word_of(c.estimate.method) << ',' << (truth ? truth->length : 0) << ','
      << c.spacing;
  for (std::size_t k = 0; k < 3; ++k) out << ',' << (k < c.levels.size() ? c.levels[k].spacing : -1);
  out << ',' << c.longest_segment << ',' << c.estimate.order.value_or(0) << ','
      << (c.resolution ? word_of(c.resolution->verdict) : "not examined") << ',' << feature << ','
      << (c.resolution ? c.resolution->narrowest.value_or(0) : 0) << ','
      << (c.levels.size() > 2 ? c.levels[2].segments : 0) << ',' << r.seconds.solve + r.seconds.certify << ',';
  for (const CertificateFailure& f : c.failures) out << f.name() << ' ';
  out << ',' << (r.notes.empty() ? "" : '"' + r.notes.back() + '"') << '\n';
}

}  // namespace

std::string Tally::row(const std::string& family) const {
  char head[160];
  std::snprintf(head, sizeof head, "  %-28s %5d %5d %9d %5d %8d ", family.c_str(), problems, known, certified,
                false_ones, cautious);
  std::string line = head;
  for (const auto& [name, count] : reasons) line += " " + name + " " + std::to_string(count);
  return line;
}

Tally measure(const AdversaryFamily& family, std::uint64_t first, int count, const CertificateOptions& certificate) {
  constexpr double kRight = 1e-4;
  Tally tally;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t seed = first + 2 * static_cast<std::uint64_t>(i);
    const Adversary a = family.make(seed);
    const FindOptions options{.points = a.points, .certificate = certificate};
    ++tally.problems;
    Result r;
    try {
      r = find_path(a.problem, *a.initializer, Newton(), options);
    } catch (const InitializationError&) {
      continue;  // no first path: refused, with a reason
    }
    const std::optional<TrueGeodesic> truth = a.truth(r);
    const bool certified = r.status == Status::certified;
    const double value = r.certificate.estimate.value;
    std::string outcome = certified ? "certified" : "refused";
    tally.certified += certified;
    if (truth) {
      ++tally.known;
      const double off = std::abs(value - truth->length);
      if (certified && !(off <= r.certificate.estimate.error)) outcome = "false";
      if (!certified && truth->minimum && off <= kRight * truth->length) outcome = "cautious";
      tally.false_ones += outcome == "false";
      tally.cautious += outcome == "cautious";
      if (outcome == "cautious")
        for (const CertificateFailure& f : r.certificate.failures) ++tally.reasons[f.name()];
    }
    write_line(family.name, seed, r, truth, a.feature, outcome);
  }
  return tally;
}

FamilyTally measure_families(std::uint64_t first, int count, int points) {
  const Eigen::Vector3d axes(1, 1, 0.2);
  FamilyTally tally;
  for (int i = 0; i < count; ++i) {
    const Problem problem = oblate_pair(first + 2 * static_cast<std::uint64_t>(i));
    std::vector<FamilyStart> starts = {{"straight", problem, std::make_shared<const StraightInitializer>()}};
    for (const double angle : {0.0, 90.0, 180.0, 270.0})
      starts.push_back({"bow", problem, std::make_shared<const BowInitializer>(BowOptions{0.5, angle})});
    FindOptions options;
    options.points = points;
    const Family family = find_family(starts, Newton(), options);
    const Result& delivered = family.members.front().result;
    const std::optional<TrueGeodesic> truth = geodesic_near(axes, problem, delivered);
    ++tally.pairs;
    if (delivered.status != Status::certified || !truth) continue;
    ++tally.certified;
    const CostEstimate& e = delivered.certificate.estimate;
    tally.false_ones += std::abs(e.value - truth->length) > e.error;
    double shortest = truth->length;
    for (const FamilyMember& m : family.members)
      if (const std::optional<TrueGeodesic> other = geodesic_near(axes, problem, m.result))
        shortest = std::min(shortest, other->length);
    const double excess = truth->length / shortest - 1;
    tally.longer += excess > e.error / shortest;
    tally.worst = std::max(tally.worst, excess);
  }
  return tally;
}

}  // namespace leastcost::test
