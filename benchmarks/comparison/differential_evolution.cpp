// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <Eigen/Core>
#include <algorithm>
#include <random>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "benchmarks/comparison/crossings.hpp"
#include "benchmarks/comparison/methods.hpp"

namespace leastcost::comparison {
namespace {

constexpr double kGenesOff = 0.05, kGenesKnot = 0.02;  // of an edge
constexpr int kPopulation = 30;
constexpr double kWeight = 0.5, kCrossover = 0.5;  // of Storn and Price: F, CR
constexpr double kSpread = 0.2;                    // of the first population around the path
constexpr int kGenerationsOfLook = 100;            // generations that have to gain ...
constexpr double kGenesGain = 1e-6;                // ... this part of the length
constexpr int kMostGenerations = 20000;
constexpr std::uint64_t kSeed = 20190627;

/// Ye, Liu, Zhang, Zhang and He 2019: differential evolution (current to best, binomial crossover) of the crossings'
/// parameters, the sequence of edges changed where crossings gather at a vertex. No code of theirs is public: what the
/// paper leaves open (population, rates) is the constants above. One iteration is one generation.
class DifferentialEvolution final : public Method {
 public:
  void prepare(const TriangleMesh& mesh, const Stop&) override { mesh_ = &mesh; }

  Answer shortest(std::int32_t source, std::int32_t target, const Stop& stop) override {
    Answer answer;
    std::mt19937_64 random(kSeed);
    try {
      CrossingPath path(*mesh_, source, target, kGenesOff, stop);
      answer.lengths.push_back(path.length());
      CrossingPath best = path;
      double best_length = path.length();
      while (true) {
        const bool in_time = evolve(path, random, answer, stop);
        const double length = path.length(), before = best_length;
        if (length < best_length) best = path, best_length = length;
        if (!in_time) answer.outcome = Outcome::out_of_time;
        if (!in_time || answer.iterations >= kMostGenerations || length >= before * (1 - kGenesGain)) break;
        if (!path.untie_all(kGenesKnot)) break;
      }
      answer.path = best.path();
      answer.distance = path_length(answer.path);
    } catch (const InputError& error) {
      answer.outcome = Outcome::failed;
      answer.note = error.what();
    }
    return answer;
  }

 private:
  static double length_at(CrossingPath& path, const std::vector<double>& t) {
    for (std::size_t i = 0; i < t.size(); ++i) path.crossings()[i].t = t[i];
    return path.length();
  }

  bool evolve(CrossingPath& path, std::mt19937_64& random, Answer& answer, const Stop& stop) const {
    const std::size_t n = path.crossings().size();
    if (n == 0) return true;
    std::uniform_real_distribution<double> unit(0, 1);
    std::uniform_int_distribution<int> member(0, kPopulation - 1);
    std::uniform_int_distribution<std::size_t> place(0, n - 1);
    std::vector<std::vector<double>> population(kPopulation, std::vector<double>(n));
    std::vector<double> lengths(kPopulation);
    for (int k = 0; k < kPopulation; ++k) {
      auto& own = population[static_cast<std::size_t>(k)];
      for (std::size_t i = 0; i < n; ++i)
        own[i] = std::clamp(path.crossings()[i].t + (k == 0 ? 0 : kSpread * (2 * unit(random) - 1)), 0.0, 1.0);
    }
    for (std::size_t k = 0; k < kPopulation; ++k) lengths[k] = length_at(path, population[k]);
    const auto best = [&] {
      return static_cast<std::size_t>(std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
    };
    double at_look = lengths[best()];
    bool in_time = true;
    std::vector<double> trial(n);
    for (int generation = 1; answer.iterations < kMostGenerations; ++generation) {
      const std::size_t leader = best();
      for (std::size_t k = 0; k < kPopulation; ++k) {
        const auto &a = population[static_cast<std::size_t>(member(random))],
                   &b = population[static_cast<std::size_t>(member(random))];
        const auto &own = population[k], &lead = population[leader];
        const std::size_t certain = place(random);
        for (std::size_t i = 0; i < n; ++i)
          trial[i] = i == certain || unit(random) < kCrossover
                         ? std::clamp(own[i] + kWeight * (lead[i] - own[i]) + kWeight * (a[i] - b[i]), 0.0, 1.0)
                         : own[i];
        const double length = length_at(path, trial);
        if (length > lengths[k]) continue;
        lengths[k] = length;
        population[k] = trial;
      }
      ++answer.iterations;
      answer.lengths.push_back(lengths[best()]);
      if (stop && stop()) {
        in_time = false;
        break;
      }
      if (generation % kGenerationsOfLook != 0) continue;
      const double now = lengths[best()];
      if (at_look - now <= kGenesGain * now) break;
      at_look = now;
    }
    length_at(path, population[best()]);
    return in_time;
  }

  const TriangleMesh* mesh_ = nullptr;
};

}  // namespace

std::unique_ptr<Method> make_differential_evolution() { return std::make_unique<DifferentialEvolution>(); }

}  // namespace leastcost::comparison
