// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace leastcost::app {

/// A file that grows line by line, under a lock, so that no second process writes to it until this object goes away or
/// its process does.
class LockedFile {
 public:
  /// Opens it, or makes it. `what` is said where another process writes to it: "this study". Throws OutputRefused,
  /// OutputError.
  LockedFile(std::filesystem::path file, const std::string& what);
  ~LockedFile();
  LockedFile(LockedFile&& other) noexcept;
  LockedFile& operator=(LockedFile&&) = delete;

  const std::filesystem::path& path() const { return file_; }
  bool empty() const;
  /// Cuts what is beyond the first `size` bytes. Throws OutputError.
  void cut(std::size_t size);
  /// One write: a kill leaves at most a torn last line. So does a full disk, whose part is cut off again. Throws
  /// OutputError.
  void append(std::string_view text);
  /// What was appended is on the disk afterwards. Throws OutputError.
  void sync();
  /// In a child: it must not keep the lock when its parent has died.
  void forget();

 private:
  [[noreturn]] void fail(const std::string& reason) const;

  std::filesystem::path file_;
  int fd_ = -1;
};

}  // namespace leastcost::app
