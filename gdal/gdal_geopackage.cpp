// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/gdal/gdal_geopackage.hpp>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_utils.h>

#include <array>
#include <atomic>
#include <memory>
#include <utility>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

struct CloseVector {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using VectorDataset = std::unique_ptr<void, CloseVector>;

/// GDAL prints its errors unless it is told otherwise, for each thread.
struct Silence {
  Silence() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~Silence() { CPLPopErrorHandler(); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
};

/// A file in memory, which no other thread names alike.
class MemoryFile {
 public:
  explicit MemoryFile(const char* extension) {
    static std::atomic<int> count = 0;
    name_ = "/vsimem/leastcost_" + std::to_string(count++) + extension;
  }
  ~MemoryFile() { VSIUnlink(name_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const char* name() const { return name_.c_str(); }
  /// The text has to stay where it is.
  void show(std::string& text) const {
    auto* bytes = reinterpret_cast<GByte*>(text.data());
    VSIFCloseL(VSIFileFromMemBuffer(name(), bytes, text.size(), FALSE));
  }
  std::string bytes() const {
    vsi_l_offset size = 0;
    const GByte* bytes = VSIGetMemFileBuffer(name(), &size, FALSE);
    return bytes == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(bytes), size);
  }

 private:
  std::string name_;
};

[[noreturn]] void refuse(const std::string& layer) {
  throw InputError("GeoPackage: layer " + layer + " cannot be written (GDAL: " + CPLGetLastErrorMsg() + ")");
}

/// Adds a layer to the package, which is made with the first one.
void add_layer(const std::string& name, std::string text, const MemoryFile& package, VectorDataset& made) {
  const MemoryFile file(".geojson");
  file.show(text);
  const VectorDataset source(GDALOpenEx(file.name(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr));
  if (!source) refuse(name);
  std::string format = "-f", gpkg = "GPKG", layer = "-nln", layer_name = name;
  std::array<char*, 5> words = {format.data(), gpkg.data(), layer.data(), layer_name.data(), nullptr};
  GDALVectorTranslateOptions* options = GDALVectorTranslateOptionsNew(words.data(), nullptr);
  GDALDatasetH in = source.get();
  int fault = 0;
  GDALDatasetH out = GDALVectorTranslate(made ? nullptr : package.name(), made.get(), 1, &in, options, &fault);
  GDALVectorTranslateOptionsFree(options);
  if (out == nullptr || fault != 0) refuse(name);
  if (!made) made.reset(out);
}

}  // namespace

std::string gdal_geopackage(const std::vector<std::pair<std::string, std::string>>& layers) {
  GDALAllRegister();
  if (GDALGetDriverByName("GPKG") == nullptr) return "";
  const Silence silence;
  const MemoryFile package(".gpkg");
  VectorDataset made;
  for (const auto& [name, text] : layers) add_layer(name, text, package, made);
  made.reset();  // writes what is left
  return package.bytes();
}

}  // namespace leastcost
