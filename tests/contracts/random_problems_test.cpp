// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The library never aborts, crashes or throws what has no type, whatever it is asked: every plug-in with every other
// one, random options past the checks of a configuration, bad numbers, bad ends. One process for all, as in a host.
// LEASTCOST_RANDOM_PROBLEMS: how many (10,000 before a release); LEASTCOST_RANDOM_SEED: the first one's seed. A failure
// names the seed of its problem.
#include <leastcost/catalogue/plugins/abilities.hpp>
#include <leastcost/framework/search/find_path.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <set>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/registry/registry.hpp"
#include "problems/formula/coordinate_names.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/random_fields.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

using Random = std::mt19937_64;
template <class T>
using Shared = std::shared_ptr<const T>;

bool chance(Random& random, double p) { return std::uniform_real_distribution<double>(0, 1)(random) < p; }
std::size_t below(Random& random, std::size_t count) {
  return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
}

/// A few small files, good and bad.
std::vector<std::string> write_files(const std::filesystem::path& folder) {
  const std::map<std::string, std::string> files = {
      {"octahedron.obj",
       "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\nf 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\n"
       "f 4 2 6\nf 1 4 6\n"},
      {"two_parts.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 4 5 6\n"},
      {"needle.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 1 1e-12 0\nf 1 3 4\nf 1 2 3\n"},
      {"fan.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n"},
      {"empty.obj", ""},
      {"hills.asc",
       "ncols 6\nnrows 5\nxllcorner -3\nyllcorner -3\ncellsize 1\nNODATA_value -1\n1 2 3 2 1 1\n2 3 4 3 2 1\n1 2 9 2 1 "
       "1\n"
       "2 2 2 2 2 2\n1 1 1 1 1 -1\n"},
      {"path.csv", "index,x,y,z\n0,0,0,0\n1,1,1,1\n"}};
  std::vector<std::string> names = {"no_such_file.obj", "octahedron.obj", "octahedron.obj", "octahedron.obj",
                                    "sphere.xyz",       "sphere.xyz",     "path.csv",       "hills.asc"};
  for (const auto& [name, text] : files) {
    std::ofstream(folder / name) << text;
    names.push_back(name);
  }
  std::ofstream cloud(folder / "sphere.xyz");
  Random random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 400; ++i) {
    const Eigen::Vector3d p = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    cloud << p.transpose() << '\n';
  }
  return names;
}

class Asker {
 public:
  Asker(const std::filesystem::path& folder, std::vector<std::string> files)
      : folder_(folder), files_(std::move(files)) {}

  /// Makes one problem and solves it. Whatever is thrown must be one of the library's own.
  std::string ask(std::uint64_t seed) {
    Random random(seed);
    try {
      return solve(random);
    } catch (const Error& error) {
      if (std::getenv("LEASTCOST_RANDOM_REASONS") != nullptr) WARN(error.what());
      return error.what()[0] == '\0' ? "an error without words" : "refused";
    } catch (const std::exception& error) {
      return std::string("untyped exception: ") + error.what();
    } catch (...) {
      return "untyped exception";
    }
  }

 private:
  /// Mostly one that fits what was chosen before.
  const PluginEntry* pick(const PluginKind& all, Random& random) const {
    const auto fits = [&](const PluginEntry& entry) {
      const bool rings = std::count(entry.provides.begin(), entry.provides.end(), MakesRings::kAbility) > 0;
      const bool met = std::all_of(entry.needs.begin(), entry.needs.end(),
                                   [&](const std::string& need) { return provided_.count(need) > 0; });
      return entry.missing.empty() && met && (all.name != "initializer" || !ring_ || rings);
    };
    const PluginEntry* entry = nullptr;
    for (int tries = 0; tries < 20 && (entry == nullptr || !fits(*entry)); ++tries) {
      entry = all.entries[below(random, all.entries.size())];
      if (!sane_ && entry->missing.empty()) break;
      if (all.name == "cost" && chance(random, 0.5)) entry = all.entries[0];
      if (sane_ && all.name == "manifold" && chance(random, 0.2)) entry = all.entries[0];
      if (entry->type == "constraint" && chance(random, 0.7)) entry = nullptr;  // it needs more than luck
      // Nobody means a path that is not solved, or obstacles that are not there.
      if (sane_ && entry != nullptr && (entry->type == "none" || entry->type == "taut") && chance(random, 0.9))
        entry = nullptr;
    }
    if (entry == nullptr) entry = all.entries[0];
    return entry->missing.empty() ? entry : all.entries[0];
  }

  std::vector<std::string> files_for(const PluginEntry& entry) const {
    if (!sane_) return files_;
    return {entry.type == "mesh" ? "octahedron.obj" : entry.type == "file" ? "path.csv" : "sphere.xyz"};
  }

  template <class T>
  Shared<T> any(const char* kind_name, Random& random, const BuildContext& context) {
    const PluginEntry* entry = pick(kind(kind_name), random);
    const std::vector<std::string> files = files_for(*entry);
    const PluginChoice choice = choose(*entry, kind_name);
    const int dimension = context.dimension > 0 ? context.dimension : 2 + static_cast<int>(below(random, 2));
    const double boldness = !sane_ ? 0.4 : chance(random, 0.7) ? 0 : 0.1;
    RandomFields fields(random, files, dimension, boldness, sane_ ? 0.005 : 0.15);
    choice.options->fields(fields);
    provided_.insert(entry->provides.begin(), entry->provides.end());
    return make<Shared<T>>(choice, context);
  }

  double coordinate(Random& random) const {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    if (chance(random, sane_ ? 0.001 : 0.03))
      return std::array{0.0, kNaN, 1e300, -1e-300, std::numeric_limits<double>::infinity()}[below(random, 5)];
    return std::normal_distribution<double>(0, 1)(random);
  }

  /// On the manifold, or anywhere, or of another dimension.
  PathEnd end(const ConstraintManifold& manifold, Random& random) {
    const int wanted = manifold.dimensions().coordinate;
    PathEnd out{Eigen::VectorXd(sane_ || chance(random, 0.98) ? wanted : wanted + 1), kNoSite};
    for (double& x : out.u) x = coordinate(random);
    if (!sane_ && chance(random, 0.1)) {
      out.site = static_cast<Site>(below(random, 20)) - 5;
      return out;
    }
    return project_end(manifold, out.u);
  }

  std::string solve(Random& random) {
    sane_ = chance(random, 0.7);
    ring_ = chance(random, 0.15);
    provided_.clear();
    BuildContext context{folder_};
    context.seed = static_cast<int>(below(random, 1000));
    Problem problem;
    problem.manifold = any<ConstraintManifold>("manifold", random, context);
    context.manifold = problem.manifold;
    context.dimension = problem.manifold->dimensions().ambient;
    if (chance(random, 0.95)) context.coordinates = point_coordinates(*problem.manifold);
    problem.ring = ring_;
    problem.based = problem.ring && chance(random, 0.3);
    problem.source = end(*problem.manifold, random);
    problem.target = chance(random, 0.03) ? problem.source : end(*problem.manifold, random);
    const bool fits = problem.source.u.size() == problem.manifold->dimensions().coordinate;
    if (fits && chance(random, 0.9)) context.source = positions(*problem.manifold, {problem.source.u, {}, true});
    problem.cost = any<SegmentCost>("cost", random, context);
    problem.kernel = any<Kernel>("kernel", random, context);
    const Shared<Initializer> initializer = any<Initializer>("initializer", random, context);
    const Shared<Solver> solver = any<Solver>("solver", random, context);
    FindOptions options;
    options.points = chance(random, 0.95) ? static_cast<int>(1 + below(random, 24)) : -1;
    if (chance(random, 0.05)) options.points.reset();
    if (chance(random, 0.1)) options.reference_cost = coordinate(random);
    options.cascade = chance(random, 0.1);
    options.escape_saddle = chance(random, 0.1);
    options.certificate.enabled = chance(random, 0.7);
    options.certificate.refine = options.points.value_or(0) % 4 == 0 ? 2 : 0;  // (no draw: the problems stay)
    if (chance(random, 0.4)) options.post_processors.push_back(any<PostProcessor>("post_processor", random, context));
    Monitor monitor;
    monitor.deadline = Monitor::Clock::now() + std::chrono::milliseconds(40);
    const Result result = find_path(problem, *initializer, *solver, options, monitor);
    if (result.status == Status::certified && !(result.certificate.estimate.value >= 0)) return "certified nonsense";
    return std::string(word_of(result.status));
  }

  std::filesystem::path folder_;
  std::vector<std::string> files_;
  bool sane_ = true;  ///< the present problem is one that somebody could mean
  bool ring_ = false;
  std::set<std::string> provided_;  ///< abilities, in words
};

std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

constexpr int kProblems = 400;

}  // namespace

TEST_CASE("random problems end in a status or in an error of the library") {
  const ScratchDir folder;
  Asker asker(folder.path(), write_files(folder.path()));
  const std::uint64_t first = number_from("LEASTCOST_RANDOM_SEED", 1),
                      count =
                          number_from("LEASTCOST_RANDOM_PROBLEMS", nightly() ? kProblems : test::trials(kProblems / 4));
  std::map<std::string, int> outcomes;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    CAPTURE(seed);
    const std::string outcome = asker.ask(seed);
    ++outcomes[outcome];
    const bool known = outcome == "refused" || outcome == "certified" || outcome == "uncertified" ||
                       outcome == "collapsed" || outcome == "interrupted";
    INFO(outcome);
    CHECK(known);
  }
  // The generator has something to say: it is not refused throughout.
  if (count >= 400) {
    CHECK(outcomes["certified"] > static_cast<int>(count / 50));
    CHECK(outcomes["refused"] < static_cast<int>(count * 9 / 10));
  }
}

}  // namespace leastcost::test
