// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/run/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plot/text.hpp"
#include "app/report/page/page.hpp"
#include "app/report/page/provenance.hpp"
#include "app/report/run/run_parts.hpp"

namespace leastcost::app {
namespace {

/// Digits no finer than the bar: the last one is that of its first.
std::string cost_text(double value, double bar) {
  if (!std::isfinite(value) || value == 0) return number_text(value);
  if (!std::isfinite(bar)) return number_text(value, 9);
  if (bar <= 0) return fmt::format("{:.15g}", value);
  const int before = static_cast<int>(std::floor(std::log10(std::abs(value))));
  const int decimals = -static_cast<int>(std::floor(std::log10(bar)));
  return fmt::format("{:.{}g}", value, std::clamp(before + decimals + 1, 3, 15));
}

std::string duration(double seconds) {
  if (seconds < 1e-3) return number_text(1e6 * seconds) + " µs";
  if (seconds < 1) return number_text(1e3 * seconds) + " ms";
  return number_text(seconds) + " s";
}

double total_seconds(const JsonFile& result) {
  double sum = 0;
  for (const char* stage :
       {"read", "compose", "initialize", "solve", "post_process", "prepare", "certify", "other_members", "write"}) {
    const std::string key = std::string("seconds.") + stage;
    if (result.has(key)) sum += result.number(key);  // older files, and runs without a family, have fewer stages
  }
  return sum;
}

std::string bar_text(const JsonFile& result) {
  if (!result.flag("certificate.measured")) return "error not measured";
  const double bar = result.number("cost.error_estimate"), geometry = result.number("certificate.geometry_error");
  std::string text = std::isfinite(bar) ? "± " + number_text(bar, 2) : "error unknown";
  if (std::isfinite(geometry)) text += "; domain ± " + number_text(geometry, 2);
  return text + " (" + result.text("cost.method") + ")";
}

std::string solver_text(const JsonFile& result) {
  if (result.text("solver.name") == "none") return "the first path unchanged";
  return fmt::format("{} after {} iteration{}", result.text("solver.termination"), result.text("solver.iterations"),
                     result.text("solver.iterations") == "1" ? "" : "s");
}

std::vector<KeyFigure> key_figures_of(const JsonFile& result) {
  const double bar = result.flag("certificate.measured") ? result.number("cost.error_estimate") : std::nan("");
  return {{"cost", cost_text(result.number("cost.value"), bar) + " " + result.text("cost.unit"), bar_text(result)},
          {"spacing", number_text(result.number("spacing")), "largest / smallest cost − 1"},
          {"points", result.text("points"), result.flag("ring") ? "of a closed path" : "between the ends"},
          {"solver", result.text("solver.name"), solver_text(result)},
          {"time", duration(total_seconds(result)), duration(result.number("seconds.solve")) + " of it in the solver"}};
}

/// "34,835".
std::string with_commas(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

/// An end of the path: the vertex of a mesh, by its number in the file, or a place.
std::string end_text(const RunFiles& files, std::size_t row) {
  for (const char* corner : {"0", "1", "2"}) {
    const std::string weight = std::string("b") + corner, vertex = std::string("v") + corner;
    if (files.path.has(weight) && files.path.has(vertex) && files.path[weight][row] == 1)
      return fmt::format("vertex {:.0f}", files.path[vertex][row]);
  }
  if (files.points.rows() > 3) return "";
  std::string text;
  for (Index i = 0; i < files.points.rows(); ++i)
    text += (text.empty() ? "" : ", ") + fmt::format("{:.4g}", files.points(i, static_cast<Index>(row)));
  return "(" + text + ")";
}

/// "bunny.obj, 34,835 vertices, from vertex 11812 to vertex 20997; ": what was solved, as far as the files tell.
std::string problem_text(const RunFiles& files) {
  std::string text;
  for (const JsonFile& input : files.manifest.objects("inputs"))
    if (input.text("role") == "data") text += std::filesystem::path(input.text("file")).filename().string() + ", ";
  if (files.clicks && files.clicks->has("mesh.vertices"))
    text += with_commas(files.clicks->size("mesh.vertices") / 3) + " vertices, ";
  const std::size_t rows = files.path.rows();
  const std::string source = rows > 1 && !files.result.flag("ring") ? end_text(files, 0) : "";
  if (!source.empty()) text += "from " + source + " to " + end_text(files, rows - 1) + ", ";
  if (text.empty()) return "";
  return text.substr(0, text.size() - 2) + "; ";
}

Headline headline_of(const RunFiles& files) {
  const JsonFile& result = files.result;
  const std::string status = result.text("status");
  Headline headline{"run", result.text("name"),
                    problem_text(files) + fmt::format("{} manifold, {} cost, kernel {}, first path {}",
                                                      result.text("problem.manifold"), result.text("problem.cost"),
                                                      result.text("problem.kernel"), result.text("initializer")),
                    status, "bad"};
  if (result.flag("certified")) {
    headline.verdict = status + ", " + result.text("scope");
    std::replace(headline.verdict.begin(), headline.verdict.end(), '_', ' ');
    headline.style = "good";
  } else if (!result.flag("certificate.measured") && status != "collapsed") {
    headline.verdict += ", certificate not measured";
    headline.style = "mild";
  }
  return headline;
}

std::string failures_of(const JsonFile& result) {
  std::string items;
  for (const JsonFile& f : result.objects("failures"))
    items += fmt::format("<li><strong>{}</strong>: {}</li>\n", escaped(f.text("name")), escaped(f.text("message")));
  return items.empty() ? "" : "<div class=\"why\">Why it is not certified:<ul>\n" + items + "</ul></div>\n";
}

std::string family_of(const JsonFile& result) {
  const std::vector<JsonFile> members = result.objects("family");
  if (members.empty()) return "";
  Table table{{{"cost", true}, {"bar", true}, {"status"}, {"index"}, {"iterations", true}, {"from"}}, {}, ""};
  for (const JsonFile& m : members) {
    std::string from, why;
    for (const std::string& origin : m.texts("from")) from += (from.empty() ? "" : "; ") + origin;
    for (const JsonFile& f : m.objects("failures")) why += (why.empty() ? "" : "; ") + f.text("message");
    const std::string status = m.text("status");
    table.rows.push_back({{cost_text(m.number("cost"), m.number("error_estimate"))},
                          {number_text(m.number("error_estimate"), 2)},
                          {status, status == "certified" ? "good" : "bad", why},
                          {m.text("index") + (m.flag("tied") ? ", tied" : "")},
                          {m.text("iterations")},
                          {from}});
  }
  return section("Family", paragraph("The distinct locally least-cost paths that were found, by cost; the first one "
                                     "was delivered. Tied: their error bars overlap.") +
                               html(table));
}

std::string notes_of(const JsonFile& result) {
  std::string items;
  for (const std::string& note : result.texts("notes")) items += "<li>" + escaped(note) + "</li>\n";
  return items.empty() ? "" : section("Notes", "<ul>\n" + items + "</ul>\n");
}

std::string work_of(const JsonFile& result) {
  Table table{{{"stage"}, {"time", true}}, {}, ""};
  const std::pair<const char*, const char*> stages[] = {
      {"read", "read the domain"},      {"compose", "compose"},
      {"initialize", "first path"},     {"solve", "solve"},
      {"post_process", "post-process"}, {"prepare", "coarser domains"},
      {"certify", "certify"},           {"other_members", "other members of the family"},
      {"write", "write files"}};
  for (const auto& [key, name] : stages) {
    const std::string stage = std::string("seconds.") + key;
    if (result.has(stage)) table.rows.push_back({{name}, {fmt::format("{:.3f} ms", 1e3 * result.number(stage))}});
  }
  Table counters{{{"counted"}, {"number", true}}, {}, ""};
  for (const char* key : {"energies", "gradients", "hessians", "projections", "linear_solves"}) {
    std::string name = key;
    std::replace(name.begin(), name.end(), '_', ' ');
    counters.rows.push_back({{name}, {result.text(std::string("solver.counters.") + key)}});
  }
  return "<div class=\"row\">" + html(table) + html(counters) + "</div>\n";
}

}  // namespace

std::string run_report(const std::filesystem::path& folder) {
  RunFiles files = read_run_files(folder);
  if (std::filesystem::exists(folder / "clicks.json")) files.clicks.emplace(folder / "clicks.json");
  const JsonFile& result = files.result;
  const Picture picture = picture_of(files);
  std::string body = failures_of(result) + key_figures(key_figures_of(result)) + picture.part;
  body += family_of(result);
  body += notes_of(result);
  body += section("Certificate", certificate_part(result));
  body += section("Convergence", convergence_part(files));
  body += section("Spacing", spacing_part(files));
  body += residual_part(files);
  body += section("Work", work_of(result), false);
  body += section("Configuration", "<pre>" + escaped(files.configuration) + "</pre>\n", false);
  body += section("Provenance", provenance_part(files.manifest), false);
  return page(headline_of(files), body, picture.script);
}

}  // namespace leastcost::app
