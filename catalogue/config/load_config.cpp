// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/config/load_config.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/config/config_defaults.hpp"
#include "catalogue/config/run_checks.hpp"
#include "catalogue/options/options_reader.hpp"
#include "catalogue/yaml/overrides.hpp"
#include "catalogue/yaml/value_reader.hpp"
#include "catalogue/yaml/yaml_reader.hpp"
#include "catalogue/yaml/yaml_writer.hpp"

namespace leastcost {

LoadedConfig parse_config(std::string text, const std::string& file_name, const std::filesystem::path& folder,
                          const std::vector<Override>& overrides, const Externals& externals, EndsFrom ends) {
  LoadedConfig loaded{{}, folder, std::move(text), {}, {1, 1, 1, ""}, {}, {file_name, ""}};
  loaded.errors = Diagnostics(file_name, loaded.text);
  loaded.tree = read_yaml(loaded.text, loaded.errors);
  const bool readable = loaded.errors.empty();
  apply_overrides(overrides, loaded.tree, loaded.errors);
  // A text that is no YAML gives one error, not one more for every key that was never reached.
  if (!readable && !loaded.tree.is_block()) return loaded;
  const std::string stem = std::filesystem::path(file_name).stem().string();
  read_tree(loaded, stem.empty() ? "run" : stem, externals, ends);
  return loaded;
}

LoadedConfig parse_config(const ConfigValue::Block& tree, const std::string& name, const std::filesystem::path& folder,
                          const std::vector<Override>& overrides, const Externals& externals, EndsFrom ends) {
  LoadedConfig loaded{{}, folder, "", {}, {0, 0, 1, name}, {}, {name, ""}};
  loaded.tree = read_value(tree, name, loaded.errors);
  loaded.text = to_yaml(loaded.tree);
  apply_overrides(overrides, loaded.tree, loaded.errors);
  if (loaded.errors.empty() || loaded.tree.is_block()) read_tree(loaded, name, externals, ends);
  return loaded;
}

void read_tree(LoadedConfig& loaded, const std::string& name, const Externals& externals, EndsFrom ends) {
  if (const ConfigEntry* problems = loaded.tree.find("problems"))
    return loaded.errors.error(problems->place,
                               "this file has 'problems', so it is a study: run it with leastcost study");
  loaded.config.name = name;
  loaded.config.ends_from = ends;
  complete_types(loaded.tree, externals);
  OptionsReader reader(loaded.tree, "", loaded.place, loaded.errors, &externals);
  loaded.config.fields(reader);
  reader.finish();
  check_and_complete(loaded);
}

std::string config_text(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError(file.string() + ": is a folder, not a configuration file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string() + ": cannot be opened: " + std::generic_category().message(errno));
  std::string text = config_text(in);
  if (in.bad()) throw InputError(file.string() + ": cannot be read");
  return text;
}

std::string config_text(std::istream& in) {
  std::string text;
  constexpr std::size_t kPart = 1 << 16;
  while (in && text.size() <= kLargestConfiguration) {
    const std::size_t before = text.size(), part = std::min(kPart, kLargestConfiguration + 1 - before);
    text.resize(before + part);
    in.read(text.data() + before, static_cast<std::streamsize>(part));
    text.resize(before + static_cast<std::size_t>(in.gcount()));
  }
  return text;
}

LoadedConfig load_config(const std::filesystem::path& file, const std::vector<Override>& overrides,
                         const Externals& externals, EndsFrom ends) {
  LoadedConfig loaded = parse_config(config_text(file), file.string(), file.parent_path(), overrides, externals, ends);
  loaded.file = file;
  return loaded;
}

}  // namespace leastcost
