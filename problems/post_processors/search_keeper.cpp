// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/post_processors/search_keeper.hpp"

#include <filesystem>
#include <utility>

#include <leastcost/problems/exact/landmark_file.hpp>

namespace leastcost {
namespace {

constexpr int kLandmarksOfIndex = 32;  // of an index whose number is not given

bool same_metric(const MetricRoot& a, const MetricRoot& b) {
  return a.has_value() == b.has_value() && (!a || *a == *b);
}

}  // namespace

KeptSearch::KeptSearch(const Problem& problem, const TriangleMesh& mesh, const MetricRoot& metric,
                       const GlobalBudget& budget, const std::function<bool()>& stop)
    : domain_(problem.manifold), metric_(metric) {
  if (metric) turned_.emplace(mesh, *metric);
  search_ = std::make_unique<ExactSearch>(turned_ ? turned_->mesh() : mesh);
  add_landmarks(budget, stop);
}

/// From the file where there is one; else made, and written where a file was named.
void KeptSearch::add_landmarks(const GlobalBudget& budget, const std::function<bool()>& stop) {
  if (!budget.index.empty() && std::filesystem::exists(budget.index)) {
    search_->use(read_landmarks(budget.index, search_->made_for()));
    return;
  }
  const int count = budget.landmarks.value_or(budget.index.empty() ? 0 : kLandmarksOfIndex);
  if (count == 0) return;
  ExactSearch::Workspace workspace(*search_);
  Landmarks made = search_->make_landmarks(count, workspace, stop);
  give_back(std::move(workspace));
  const bool complete = !stop || !stop();
  if (!budget.index.empty() && complete) write_landmarks(made, budget.index);
  search_->use(std::move(made));
}

bool KeptSearch::is_of(const Problem& problem, const MetricRoot& metric) const {
  return problem.manifold == domain_ && same_metric(metric, metric_);
}

ExactSearch::Workspace KeptSearch::borrow() {
  {
    const std::lock_guard<std::mutex> guard(lock_);
    if (!idle_.empty()) {
      ExactSearch::Workspace workspace = std::move(idle_.back());
      idle_.pop_back();
      return workspace;
    }
  }
  return ExactSearch::Workspace(*search_);
}

void KeptSearch::give_back(ExactSearch::Workspace workspace) {
  const std::lock_guard<std::mutex> guard(lock_);
  idle_.push_back(std::move(workspace));
}

std::shared_ptr<KeptSearch> SearchKeeper::search_for(const Problem& problem, const TriangleMesh& mesh,
                                                     const MetricRoot& metric, const GlobalBudget& budget,
                                                     const std::function<bool()>& stop) {
  const std::lock_guard<std::mutex> guard(lock_);
  if (!last_ || !last_->is_of(problem, metric))
    last_ = std::make_shared<KeptSearch>(problem, mesh, metric, budget, stop);
  return last_;
}

bool SearchKeeper::holds(const Problem& problem, const MetricRoot& metric) {
  const std::lock_guard<std::mutex> guard(lock_);
  return last_ && last_->is_of(problem, metric);
}

}  // namespace leastcost
