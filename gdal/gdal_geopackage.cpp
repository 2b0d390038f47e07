// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/gdal/gdal_geopackage.hpp>

#include <array>
#include <atomic>
#include <memory>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "gdal/gdal_library.hpp"

namespace leastcost {
namespace {

/// A file in memory, which no other thread names alike.
class MemoryFile {
 public:
  explicit MemoryFile(const char* extension) {
    static std::atomic<int> count = 0;
    name_ = "/vsimem/leastcost_" + std::to_string(count++) + extension;
  }
  ~MemoryFile() { gdal().unlink(name_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const char* name() const { return name_.c_str(); }
  /// The text has to stay where it is.
  void show(std::string& text) const {
    auto* bytes = reinterpret_cast<GByte*>(text.data());
    gdal().close_file(gdal().file_from_buffer(name(), bytes, text.size(), FALSE));
  }
  std::string bytes() const {
    vsi_l_offset size = 0;
    const GByte* bytes = gdal().file_buffer(name(), &size, FALSE);
    return bytes == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(bytes), size);
  }

 private:
  std::string name_;
};

[[noreturn]] void refuse(const std::string& layer) {
  throw InputError("GeoPackage: layer " + layer + " cannot be written (GDAL: " + gdal().last_error_message() + ")");
}

/// Adds a layer to the package, which is made with the first one.
void add_layer(const std::string& name, std::string text, const MemoryFile& package, GdalDataset& made) {
  const MemoryFile file(".geojson");
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
  const MemoryFile package(".gpkg");
  GdalDataset made;
  for (const auto& [name, text] : layers) add_layer(name, text, package, made);
  made.reset();  // writes what is left
  return package.bytes();
}

}  // namespace leastcost
