// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <deque>

#include <leastcost/framework/base/errors.hpp>
#include "benchmarks/comparison/crossings.hpp"
#include "benchmarks/comparison/methods.hpp"

namespace leastcost::comparison {
namespace {

constexpr double kLbfgsOff = 0.05;    // of an edge: where the crossings start beside a vertex
constexpr double kLbfgsKnot = 1e-2;   // of an edge
constexpr double kLbfgsGain = 1e-10;  // decrease per iteration that ends a round
constexpr std::size_t kLbfgsMemory = 10;
constexpr int kMostIdle = 3;          // iterations in a row
constexpr int kMostWithoutGain = 20;  // rounds in a row: what a change of sides gains may take further changes
constexpr int kMostIterations = 200000, kMostRounds = 20000, kMostOfRound = 1000;

/// Liu, Chen, Xin, He, Liu and Zhao 2017: the length as a function of the crossings' parameters, minimised by L-BFGS
/// within [0, 1]; where a crossing comes to rest at a vertex, the sequence of edges changes to its other side, and the
/// minimisation goes on.
class CrossingLbfgs final : public Method {
 public:
  void prepare(const TriangleMesh& mesh, const Stop&) override { mesh_ = &mesh; }

  Answer shortest(std::int32_t source, std::int32_t target, const Stop& stop) override {
    Answer answer;
    try {
      CrossingPath path(*mesh_, source, target, kLbfgsOff, stop);
      answer.lengths.push_back(path.length());
      CrossingPath best = path;
      double best_length = answer.lengths.back();
      int without_gain = 0;
      for (int round = 0; round < kMostRounds; ++round) {
        const bool in_time = minimise(path, answer, stop);
        const double length = path.length();
        without_gain = length < best_length * (1 - kLbfgsGain) ? 0 : without_gain + 1;
        if (length < best_length) best = path, best_length = length;
        if (!in_time) {
          answer.outcome = Outcome::out_of_time;
          break;
        }
        if (without_gain > kMostWithoutGain || !path.untie_all(kLbfgsKnot)) break;
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
  void read(const CrossingPath& path) {
    const auto& c = path.crossings();
    base_.resize(3, static_cast<Eigen::Index>(c.size()));
    edge_ = base_;
    for (std::size_t i = 0; i < c.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      base_.col(k) = mesh_->position(mesh_->tail(c[i].halfedge));
      edge_.col(k) = mesh_->position(mesh_->head(c[i].halfedge)) - base_.col(k);
    }
    from_ = path.point(0);
    to_ = path.point(c.size() + 1);
  }

  double value(const Eigen::VectorXd& t, Eigen::VectorXd& gradient) const {
    gradient.setZero(t.size());
    double sum = 0;
    Eigen::Vector3d last = from_;
    for (Eigen::Index i = 0; i <= t.size(); ++i) {
      const Eigen::Vector3d next = i < t.size() ? Eigen::Vector3d(base_.col(i) + t[i] * edge_.col(i)) : to_;
      const Eigen::Vector3d d = next - last;
      const double length = d.norm();
      sum += length;
      if (length > 0) {
        if (i < t.size()) gradient[i] += d.dot(edge_.col(i)) / length;
        if (i > 0) gradient[i - 1] -= d.dot(edge_.col(i - 1)) / length;
      }
      last = next;
    }
    return sum;
  }

  /// False: out of time.
  bool minimise(CrossingPath& path, Answer& answer, const Stop& stop) {
    read(path);
    const auto n = static_cast<Eigen::Index>(path.crossings().size());
    if (n == 0) return true;
    Eigen::VectorXd t(n), gradient;
    for (Eigen::Index i = 0; i < n; ++i) t[i] = path.crossings()[static_cast<std::size_t>(i)].t;
    double length = value(t, gradient);
    struct Pair {
      Eigen::VectorXd s, y;
      double rho;
    };
    std::deque<Pair> memory;
    bool in_time = true;
    int idle = 0;
    for (int i = 0; i < kMostOfRound && answer.iterations < kMostIterations; ++i) {
      if (stop && stop()) {
        in_time = false;
        break;
      }
      const auto free = [&](Eigen::Index k, double direction) {
        return !(t[k] <= 0 && direction < 0) && !(t[k] >= 1 && direction > 0);
      };
      Eigen::VectorXd direction = -gradient;
      for (Eigen::Index k = 0; k < n; ++k)
        if (!free(k, direction[k])) direction[k] = 0;
      std::vector<double> alpha(memory.size());
      for (std::size_t k = memory.size(); k-- > 0;) {
        alpha[k] = memory[k].rho * memory[k].s.dot(direction);
        direction -= alpha[k] * memory[k].y;
      }
      if (!memory.empty()) {
        direction *= 1 / (memory.back().rho * memory.back().y.squaredNorm());
      } else {
        direction *= 0.1 / std::max(1e-300, direction.cwiseAbs().maxCoeff());
      }
      for (std::size_t k = 0; k < memory.size(); ++k)
        direction += (alpha[k] - memory[k].rho * memory[k].y.dot(direction)) * memory[k].s;
      for (Eigen::Index k = 0; k < n; ++k)
        if (!free(k, direction[k]) || !free(k, -gradient[k])) direction[k] = 0;
      if (!(gradient.dot(direction) < 0)) {
        if (memory.empty()) break;
        memory.clear();
        continue;
      }
      // Armijo, along the projected line.
      Eigen::VectorXd trial, trial_gradient;
      double step = 1, trial_length = length;
      bool accepted = false;
      for (int halvings = 0; halvings < 40; ++halvings, step /= 2) {
        trial = (t + step * direction).cwiseMax(0).cwiseMin(1);
        trial_length = value(trial, trial_gradient);
        if (trial_length <= length + 1e-4 * gradient.dot(trial - t)) {
          accepted = true;
          break;
        }
      }
      if (!accepted) {
        if (memory.empty()) break;
        memory.clear();
        continue;
      }
      const Eigen::VectorXd s = trial - t, y = trial_gradient - gradient;
      if (s.dot(y) > 1e-14 * s.norm() * y.norm()) memory.push_back({s, y, 1 / s.dot(y)});
      if (memory.size() > kLbfgsMemory) memory.pop_front();
      const double gain = length - trial_length;
      t = trial;
      gradient = trial_gradient;
      length = trial_length;
      ++answer.iterations;
      answer.lengths.push_back(length);
      idle = gain <= kLbfgsGain * length ? idle + 1 : 0;
      if (idle >= kMostIdle) break;
    }
    for (Eigen::Index i = 0; i < n; ++i) path.crossings()[static_cast<std::size_t>(i)].t = t[i];
    return in_time;
  }

  const TriangleMesh* mesh_ = nullptr;
  Eigen::Matrix3Xd base_, edge_;
  Eigen::Vector3d from_, to_;
};

}  // namespace

std::unique_ptr<Method> make_crossing_lbfgs() { return std::make_unique<CrossingLbfgs>(); }

}  // namespace leastcost::comparison
