// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/compose_run.hpp"

#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/run/compose.hpp"
#include "catalogue/run/run_origin.hpp"

namespace leastcost {

Run run_of(RunConfig config, std::filesystem::path folder, std::vector<InputFile> inputs, RunParts parts,
           std::vector<std::string> why, std::shared_ptr<const PairComposer> pairs, const RunStart& start) {
  Run run;
  run.name = config.name;
  run.max_seconds = config.max_seconds;
  run.parts = parts;
  run.origin =
      std::make_shared<const RunOrigin>(RunOrigin{std::move(config), std::move(folder), std::move(inputs), start.time,
                                                  std::move(parts), std::move(why), std::move(pairs)});
  return run;
}

Run compose_run(const RunConfig& config, const std::filesystem::path& folder) {
  const RunStart start;
  Composer composer(config, folder, [](const OptionError& e) { throw OptionError(e); });
  composer.make_from_options();
  composer.make_from_files();
  RunParts parts = composer.take();
  std::shared_ptr<const PairComposer> pairs = composer.pairs(parts);
  Run run = run_of(config, folder, {}, std::move(parts), {}, std::move(pairs), start);
  run.seconds.read = composer.read_seconds();
  run.seconds.compose = seconds_since(start.clock) - run.seconds.read;
  return run;
}

}  // namespace leastcost
