// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/cell/prepare_cell.hpp"

#include <exception>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/options/options_writer.hpp"
#include "catalogue/run/compose.hpp"
#include "catalogue/yaml/yaml_writer.hpp"

namespace leastcost::app {

std::string shared_composition(const StudyCell& cell) {
  OptionsWriter writer;
  RunConfig config = cell.config;
  config.fields(writer);
  const ConfigNode all = writer.take();
  std::string text = cell.folder.string() + "\n";
  for (const char* part : {"manifold", "cost", "ends", "obstacles", "robot"})
    if (const ConfigEntry* entry = all.find(part)) text += std::string(part) + ": " + to_yaml(entry->value) + "\n";
  return text;
}

void prepare_cell(const StudyCell& cell) {
  try {
    Composer(cell.config, cell.folder, [](const OptionError&) {}).make_from_options();
  } catch (const std::exception&) {
    return;  // the cell will say so
  }
}

}  // namespace leastcost::app
