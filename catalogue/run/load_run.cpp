// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/catalogue/run/load_run.hpp>

#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/config/load_config.hpp"
#include "catalogue/config/raster_reading.hpp"
#include "catalogue/inputs/input_file.hpp"
#include "catalogue/run/compose.hpp"
#include "catalogue/run/compose_run.hpp"
#include "catalogue/run/missing_files.hpp"
#include "catalogue/run/why_defaults.hpp"
#include "catalogue/run/with_notes.hpp"

namespace leastcost {
namespace {

/// The data as it is when it is used: a file may change while a long run goes on.
std::vector<InputFile> inputs_of(const LoadedConfig& loaded) {
  const auto absolute = [](const std::filesystem::path& p) { return std::filesystem::absolute(p).lexically_normal(); };
  const std::filesystem::path file =
      loaded.file.empty() ? std::filesystem::path("<" + loaded.errors.file() + ">") : absolute(loaded.file);
  std::vector<InputFile> inputs = {{"configuration", file, sha256_of_text(loaded.text)}};
  for (const std::string& name : files_of(loaded.config))
    inputs.push_back({"data", absolute(loaded.folder / name), sha256_of_file(loaded.folder / name)});
  return inputs;
}

/// Throws InputError for a file that is not there.
void check_files(const LoadedConfig& loaded) {
  const std::vector<MissingFile> missing = missing_files(loaded);
  if (!missing.empty())
    throw InputError(loaded.errors.where(missing[0].named) + ": " + missing[0].file + ": no such file");
}

/// What is thrown about files tells how they were read.
void make_from_files(Composer& composer, const BuildProgress& progress) {
  try {
    composer.make_from_files(progress);
  } catch (const InputError& e) {
    throw InputError(with_notes(e.what(), composer.told()));
  }
}

Run composed(LoadedConfig loaded, const BuildProgress& progress, const RunStart& start) {
  const auto stop_at_errors = [&] {
    if (!loaded.errors.empty()) throw ConfigError(loaded.errors);
  };
  stop_at_errors();
  const Composer* made = nullptr;
  bool told = false;  // once is enough
  Composer composer(loaded.config, loaded.folder, [&](const OptionError& e) {
    const bool tell = !told && made != nullptr && !made->told().empty();
    loaded.add_error(e.key(), tell ? with_notes(e.reason(), made->told()) : e.reason());
    told = told || tell;
  });
  made = &composer;
  composer.make_from_options();
  stop_at_errors();
  check_files(loaded);
  make_from_files(composer, progress);
  stop_at_errors();
  const auto hashing = std::chrono::steady_clock::now();
  std::vector<InputFile> inputs = inputs_of(loaded);
  const double hashed = seconds_since(hashing);
  RunParts parts = composer.take();
  if (std::string word = word_on_interpolation(loaded); !word.empty()) parts.notes.push_back(std::move(word));
  std::shared_ptr<const PairComposer> pairs = composer.pairs(parts);
  std::vector<std::string> why = why_defaults(loaded, parts);
  Run run = run_of(std::move(loaded.config), loaded.folder, std::move(inputs), std::move(parts), std::move(why),
                   std::move(pairs), start);
  run.seconds.read = composer.read_seconds() + hashed;
  run.seconds.compose = seconds_since(start.clock) - run.seconds.read;
  return run;
}

}  // namespace

Run load_run(const std::filesystem::path& file, const std::vector<Override>& overrides, const BuildProgress& progress,
             const Externals& externals, EndsFrom ends) {
  const RunStart start;
  return composed(load_config(file, overrides, externals, ends), progress, start);
}

Run parse_run(std::string text, const std::string& name, const std::filesystem::path& folder,
              const std::vector<Override>& overrides, const BuildProgress& progress, const Externals& externals,
              EndsFrom ends) {
  const RunStart start;
  return composed(parse_config(std::move(text), name, folder, overrides, externals, ends), progress, start);
}

Run parse_run(const ConfigValue::Block& tree, const std::string& name, const std::filesystem::path& folder,
              const std::vector<Override>& overrides, const BuildProgress& progress, const Externals& externals,
              EndsFrom ends) {
  const RunStart start;
  return composed(parse_config(tree, name, folder, overrides, externals, ends), progress, start);
}

}  // namespace leastcost
