// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/page/results_folder.hpp"

#include <leastcost/framework/base/errors.hpp>
#include "app/report/page/json_file.hpp"
#include "catalogue/output/manifest.hpp"

namespace leastcost::app {

namespace fs = std::filesystem;

std::string kind_of_results(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw InputError(folder.string() +
                     ": is not a folder; give the output folder of `leastcost run` or `leastcost study`");
  const fs::path file = folder / "manifest.json";
  if (!fs::exists(file))
    throw InputError(folder.string() +
                     ": has no manifest.json; give the output folder of `leastcost run` or `leastcost study`");
  const JsonFile manifest(file);
  if (!manifest.has("program") || manifest.text("program") != kProgramName)
    throw InputError(file.string() + ": was not written by leastcost");
  return manifest.has("kind") ? manifest.text("kind") : "run";
}

}  // namespace leastcost::app
