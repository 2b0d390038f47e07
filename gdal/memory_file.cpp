// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "gdal/memory_file.hpp"

#include <atomic>

#include "gdal/gdal_library.hpp"

namespace leastcost {

GdalMemoryFile::GdalMemoryFile(const char* extension) {
  static std::atomic<int> count = 0;
  name_ = "/vsimem/leastcost_" + std::to_string(count++) + extension;
}

GdalMemoryFile::~GdalMemoryFile() { gdal().unlink(name_.c_str()); }

void GdalMemoryFile::show(std::string& text) const {
  auto* bytes = reinterpret_cast<GByte*>(text.data());
  gdal().close_file(gdal().file_from_buffer(name(), bytes, text.size(), FALSE));
}

std::string GdalMemoryFile::bytes() const {
  vsi_l_offset size = 0;
  const GByte* bytes = gdal().file_buffer(name(), &size, FALSE);
  return bytes == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(bytes), size);
}

}  // namespace leastcost
