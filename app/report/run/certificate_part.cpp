// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/plot/text.hpp"
#include "app/report/page/page.hpp"
#include "app/report/run/run_parts.hpp"

namespace leastcost::app {
namespace {

/// The table of tests, row by row.
class CertificateTable {
 public:
  explicit CertificateTable(const JsonFile& result) : result_(result) {
    table_.columns = {{"test"}, {"measured", true}, {"allowed", true}, {"verdict"}, {"meaning"}};
    table_.style = "tests";
    for (const JsonFile& f : result.objects("failures")) {
      failures_.push_back(f.text("name"));
      messages_.push_back(f.text("message"));
    }
  }

  Table table() {
    simple("stationarity", "certificate.stationarity", "certificate.thresholds.stationarity",
           "Relative amount by which one more Newton step would lower the cost.", {}, "mesh: 1.0 × 10⁻⁶");
    simple("residual", "certificate.residual", "certificate.thresholds.residual",
           "Distance of the points from the domain, in diameters of the path.");
    simple("spacing", "certificate.spacing", "certificate.thresholds.spacing",
           "Largest over smallest cost of a segment, minus 1. For a cost that is not additive, it must fall at second "
           "order when segments are halved.",
           {}, "or falling");
    value();
    bracket();
    doubling();
    simple("longest segment", "certificate.longest_segment", "certificate.thresholds.longest_segment",
           "Largest cost of the curve between two points, over the mean.", {"longest_segment"});
    index();
    resolution();
    simple("clearance", "certificate.clearance.lower", "",
           "Least distance of the whole path from an obstacle, minus the required clearance.", {"touches"});
    simple("straightness", "certificate.straightness", "",
           "Smallest angle at a point of the straightened path, minus π, measured by an independent checker; radians.");
    simple("asymmetry", "certificate.asymmetry", "", "Cost of the reversed path over the cost of the path, minus 1.");
    simple("domain", "certificate.geometry_error", "",
           "Cost error due to the samples or the grid of the domain, found by solving on coarser ones; not part of the "
           "error bar.",
           {"geometry_error"});
    simple("rounded below", "certificate.regularization.below", "",
           "How far the least cost may be below the minimised one, because a kink of the cost was rounded; part of the "
           "error bar.");
    simple("tilted above", "certificate.regularization.above", "",
           "How far the least cost may be above the minimised one, because a flat part was tilted; part of the error "
           "bar.");
    simple("flat part", "certificate.regularization.free_share", "",
           "Share of the cost, 0 to 1, where other paths cost the same: only the value is certified, not the path.");
    return std::move(table_);
  }

 private:
  bool failed(const std::vector<std::string>& names) const {
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      return std::find(failures_.begin(), failures_.end(), name) != failures_.end();
    });
  }

  std::string reasons(const std::vector<std::string>& names) const {
    std::string all;
    for (std::size_t i = 0; i < failures_.size(); ++i)
      if (std::find(names.begin(), names.end(), failures_[i]) != names.end())
        all += (all.empty() ? "" : "; ") + messages_[i];
    return all;
  }

  void row(const std::string& test, const std::string& measured, const std::string& allowed,
           const std::vector<std::string>& names, const std::string& words, bool informs = false) {
    Cell verdict{informs ? "–" : "passed", informs ? "mild" : "good"};
    if (failed(names)) verdict = {"failed", "bad", reasons(names)};
    table_.rows.push_back({{test}, {measured}, {allowed}, verdict, {words}});
  }

  /// A number with a threshold (key may be empty: it informs); left out where it was not measured.
  void simple(const std::string& test, const std::string& key, const std::string& threshold, const std::string& words,
              std::vector<std::string> names = {}, const std::string& otherwise = "") {
    const double measured = result_.has(key) ? result_.number(key) : std::nan("");
    if (names.empty()) names = {test};
    if (std::isnan(measured) && !failed(names)) return;
    const bool has_threshold = !threshold.empty() && result_.has(threshold);
    const double allowed = has_threshold ? result_.number(threshold) : std::nan("");
    // A larger value may pass: docs/numerics.md names the domains and costs where another rule takes the threshold's
    // place.
    const bool other_rule = has_threshold && measured > allowed && !failed(names);
    row(test, number_text(measured),
        !has_threshold ? ""
        : other_rule   ? otherwise
                       : number_text(allowed, 2),
        names, words, !has_threshold);
  }

  void value() {
    const std::string method = result_.text("cost.method");
    if (method.empty()) return;
    const double order = result_.number("cost.order");
    const std::vector<std::string> names = {"refinement", "not_asymptotic", "error_bar", "collapsed"};
    std::string words =
        "The value is the cost of the delivered curve itself; nothing was extrapolated. Method: " + method + ".";
    if (!result_.objects("certificate.levels").empty())
      words =
          "The path is solved again with half, the same and twice the number of segments; the value and its bar follow "
          "from "
          "these levels. Method: " +
          method + ".";
    if (std::isfinite(order)) words += " The order is observed; smooth paths have 2.";
    row("refinement", std::isfinite(order) ? "order " + number_text(order) : method, "", names, words);
  }

  void bracket() {
    const double lower = result_.number("cost.lower"), upper = result_.number("cost.upper");
    if (!std::isfinite(lower) || !std::isfinite(upper)) return;
    row("bracket", "width " + number_text(upper - lower, 2), "", {},
        fmt::format("The least cost lies between a bound below, {:.12g}, and the cost of a feasible curve, {:.12g}.",
                    lower, upper),
        true);
  }

  void doubling() {
    const double measured = result_.number("certificate.doubling"),
                 expected = result_.number("certificate.doubling_expected");
    if (!std::isfinite(measured) && !failed({"doubling"})) return;
    const double allowed = result_.number("certificate.thresholds.doubling");
    row("doubling", number_text(std::abs(measured / expected - 1)), number_text(allowed, 2), {"doubling"},
        fmt::format(
            "Energy over that of twice as many segments, {}, against {} for an evenly spaced path (VFCS Eq. 8); "
            "relative deviation.",
            number_text(measured, 6), number_text(expected, 6)));
  }

  std::string narrowest() const {
    const double width = result_.number("certificate.narrowest");
    if (!(width > 0)) return "";
    return fmt::format(" A detail {} wide along the path, in cost, contains a sample with 99.9 % probability.",
                       number_text(width, 2));
  }

  void resolution() {
    const std::string verdict = result_.text("certificate.resolution");
    if (verdict.empty()) return;
    row("resolution", verdict, "", {"unresolved"}, words_of_resolution(verdict), verdict != "unresolved");
  }

  std::string words_of_resolution(const std::string& verdict) const {
    if (verdict != "proved")
      return "Whether the cost and the domain have details between the points; checked with one more chain." +
             narrowest();
    const std::string half_width = number_text(result_.number("certificate.tube.half_width"), 2);
    if (result_.text("certificate.minimum") != "proved")
      return fmt::format("In interval arithmetic: within {} of the path, in cost, nothing is finer than its segments.",
                         half_width);
    return fmt::format("In interval arithmetic: no path within {} of this one, in cost, costs less than {}.",
                       half_width, number_text(result_.number("certificate.tube.lower"), 10));
  }

  void index() {
    const std::string verdict = result_.text("certificate.index.verdict");
    const std::vector<std::string> names = {"saddle", "degenerate", "index_not_applicable"};
    const bool not_applicable = verdict == "not_applicable";
    const std::string words =
        not_applicable
            ? "Not defined here: the energy of a path on a polyhedron has kinks, and with H = s it has no curvature "
              "along the path."
            : fmt::format(
                  "Directions in which the energy falls, by the signs of the pivots of its Hessian: {}; flat ones: {}.",
                  result_.text("certificate.index.negatives"), result_.text("certificate.index.nullity"));
    row("index", not_applicable ? "not applicable" : verdict, not_applicable ? "" : "minimum", names, words,
        not_applicable);
  }

  const JsonFile& result_;
  std::vector<std::string> failures_, messages_;
  Table table_;
};

std::string levels(const JsonFile& result) {
  const std::vector<JsonFile> levels = result.objects("certificate.levels");
  if (levels.empty()) return "";
  Table table{{{"segments", true}, {"cost", true}, {"change", true}, {"spacing", true}, {"iterations", true}}, {}, ""};
  double before = std::nan("");
  for (const JsonFile& level : levels) {
    const double cost = level.number("cost");
    table.rows.push_back({{level.text("segments")},
                          {fmt::format("{:.12g}", cost)},
                          {std::isnan(before) ? "" : number_text(cost - before)},
                          {number_text(level.number("spacing"))},
                          {level.text("iterations")}});
    before = cost;
  }
  return "<h3>Levels of the refinement</h3>\n" + html(table);
}

/// "0.0023 %".
std::string percent(double part) { return fmt::format("{:.2g} %", 100 * part); }

/// What a bracket of the globally least cost says: a bound by a potential on cells.
std::string what_bracket_says(const JsonFile& result) {
  const std::string outcome = result.text("global.outcome"), category = result.text("global.category");
  if (outcome == "blocked")
    return "A bound on the cost of all paths was requested, but there is none: " + result.text("global.reason") + ".";
  const auto corner = [&](const char* name) {
    return fmt::format("({:.6g})", fmt::join(result.numbers(std::string("global.box.") + name), ", "));
  };
  const std::string work =
      fmt::format("a potential, finest on a part of {:g} cells; {} cells searched in total, {:.2g} s; {}",
                  fmt::join(result.numbers("global.grid"), " x "), result.text("global.cells"),
                  result.number("global.seconds"), category);
  const std::string bound = fmt::format(
      "{} path in the box from {} to {} is cheaper by more than {}: none costs less than {:.12g}, and the "
      "smooth curve through the points no more than {:.12g} ({}).",
      category == "sampled" ? "It looks as if no" : "No", corner("lower"), corner("upper"),
      percent(result.number("global.gap")), result.number("global.lower_bound"), result.number("global.upper_bound"),
      work);
  if (category == "sampled")
    return bound +
           " Sampled: the inequality behind it holds at four points of every cell, but is not proved between them. The "
           "scope stays local.";
  if (outcome != "bounded") return bound + " Paths that leave the box are not covered; other paths may cost as much.";
  return bound + " That is more than the tolerance: the scope stays local.";
}

/// A search over all paths: what it counted, among what it looked, and what it says nothing about.
struct SearchWords {
  const char* counts;
  const char* where;
  const char* caution = "";
};
constexpr std::array<SearchWords, 4> kSearches = {
    {{"windows", "on this polyhedron", " This does not cover a smooth surface that the mesh approximates."},
     {"tangents", "among these obstacles"},
     {"words", "through these layers"},
     {"places", "over these cells"}}};

const SearchWords& search_of(const JsonFile& result) {
  const auto found = std::find_if(kSearches.begin(), kSearches.end(), [&](const SearchWords& search) {
    return result.has(std::string("global.") + search.counts);
  });
  return found == kSearches.end() ? kSearches.front() : *found;
}

/// What the scope means, in words.
std::string what_it_says(const JsonFile& result) {
  const std::string outcome = result.has("global.outcome") ? result.text("global.outcome") : "";
  std::string local = "A certificate covers this path and its neighbours; it does not exclude a better path elsewhere.";
  if (outcome.empty()) return local;
  if (result.has("global.cells")) return what_bracket_says(result);
  const std::string lower = fmt::format("{:.12g}", result.number("global.lower_bound"));
  const SearchWords& search = search_of(result);
  const std::string work = fmt::format("{} {}, guided by {}", result.text(std::string("global.") + search.counts),
                                       search.counts, result.text("global.bound"));
  if (outcome == "proved" || outcome == "improved")
    return fmt::format(
        "No path {} costs less than {}, by a search over all of them ({}): none is shorter than the delivered one by "
        "more than {} of it; others may be as short.{}",
        search.where, lower, work, number_text(result.number("global.gap"), 1), search.caution);
  return fmt::format("{} A search over all paths was not finished ({}; {}): no path costs less than {}.", local, work,
                     outcome == "blocked" ? result.text("global.reason") : "the budget is used up", lower);
}

}  // namespace

std::string certificate_part(const JsonFile& result) {
  if (!result.flag("certificate.measured"))
    return paragraph("The certificate was not measured: it is switched off, or the run was interrupted.");
  return paragraph("Measured by the framework after the solve, independently of the solver. Scope: " +
                   result.text("scope") + ". " + what_it_says(result)) +
         html(CertificateTable(result).table()) + levels(result);
}

}  // namespace leastcost::app
