// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/gdal/gdal_geopackage.hpp>

#include <array>
#include <memory>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "gdal/gdal_library.hpp"
#include "gdal/memory_file.hpp"

namespace leastcost {
namespace {

[[noreturn]] void refuse(const std::string& layer) {
  throw InputError("GeoPackage: layer " + layer + " cannot be written (GDAL: " + gdal().last_error_message() + ")");
}

/// Adds a layer to the package, which is made with the first one.
void add_layer(const std::string& name, std::string text, const GdalMemoryFile& package, GdalDataset& made) {
  const GdalMemoryFile file(".geojson");
  file.show(text);
  const GdalDataset source(gdal().open(file.name(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr));
  if (!source) refuse(name);
  std::string format = "-f", gpkg = "GPKG", layer = "-nln", layer_name = name;
  std::array<char*, 5> words = {format.data(), gpkg.data(), layer.data(), layer_name.data(), nullptr};
  GDALVectorTranslateOptions* options = gdal().new_translate_options(words.data(), nullptr);
  GDALDatasetH in = source.get();
  int fault = 0;
  GDALDatasetH out = gdal().translate_vectors(made ? nullptr : package.name(), made.get(), 1, &in, options, &fault);
  gdal().free_translate_options(options);
  if (out == nullptr || fault != 0) refuse(name);
  if (!made) made.reset(out);
}

bool writes_packages() {
  try {
    gdal().register_all();
  } catch (const InputError&) {
    return false;  // a file that nobody has asked for is no reason to lose a result
  }
  return gdal().driver_by_name("GPKG") != nullptr;
}

}  // namespace

std::string gdal_geopackage(const std::vector<std::pair<std::string, std::string>>& layers) {
  if (!writes_packages()) return "";
  const GdalSilence silence;
  const GdalMemoryFile package(".gpkg");
  GdalDataset made;
  for (const auto& [name, text] : layers) add_layer(name, text, package, made);
  made.reset();  // writes what is left
  return package.bytes();
}

}  // namespace leastcost
