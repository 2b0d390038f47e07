// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace leastcost {

/// A file in memory, for GDAL alone, which no other thread names alike.
class GdalMemoryFile {
 public:
  explicit GdalMemoryFile(const char* extension);
  ~GdalMemoryFile();
  GdalMemoryFile(const GdalMemoryFile&) = delete;
  GdalMemoryFile& operator=(const GdalMemoryFile&) = delete;

  const char* name() const { return name_.c_str(); }
  /// The text has to stay where it is.
  void show(std::string& text) const;
  /// Empty where nothing was written.
  std::string bytes() const;

 private:
  std::string name_;
};

}  // namespace leastcost
