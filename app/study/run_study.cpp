// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/app/study/run_study.hpp>

#include <fmt/format.h>

#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "app/study/study.hpp"
#include "app/study/study_summary.hpp"

namespace leastcost {
namespace {

StudyResult result_of(app::StudyRequest request, const std::vector<Override>& overrides, const StudyOptions& options,
                      const Externals& externals) {
  if (options.shards < 1 || options.shard < 0 || options.shard >= options.shards)
    throw InputError(
        fmt::format("shard {} of {}: must be from 0 to {}", options.shard, options.shards, options.shards - 1));
  request.overrides = overrides;
  request.externals = externals;
  request.output = options.output;
  request.force = options.replace;
  request.resume = options.resume;
  request.parallel = options.parallel;
  request.shard = {options.shard, options.shards};
  request.arguments = options.arguments;
  if (options.observe) request.observe = [&](const app::StudyProgress& p) { options.observe(p.finished, p.total); };
  request.stop_requested = options.stop_requested;
  app::StudyOutcome outcome = app::run_study(request);
  const app::StudySummary summary = app::summarize(outcome.journal);
  return {std::move(outcome.output), summary.runs,        summary.failed,
          summary.missing.size(),    outcome.interrupted, app::summary_json(outcome.journal)};
}

}  // namespace

StudyResult run_study(const std::filesystem::path& file, const std::vector<Override>& overrides,
                      const StudyOptions& options, const Externals& externals) {
  app::StudyRequest request;
  request.config_file = file;
  return result_of(std::move(request), overrides, options, externals);
}

StudyResult run_study_text(std::string text, const std::string& name, const std::filesystem::path& folder,
                           const std::vector<Override>& overrides, const StudyOptions& options,
                           const Externals& externals) {
  app::StudyRequest request;
  request.config_file = folder / name;
  request.text = std::move(text);
  return result_of(std::move(request), overrides, options, externals);
}

}  // namespace leastcost
