// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {

/// Reads binary values one after the other, never past the end, and knows where it is.
class ByteReader {
 public:
  ByteReader(std::string_view bytes, std::size_t start, std::string file, std::endian order)
      : bytes_(bytes), at_(start), file_(std::move(file)), swap_(order != std::endian::native) {}

  template <class T>
  T read(const char* what) {
    need(sizeof(T), what);
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data() + at_, sizeof(T));
    if (swap_) std::reverse(raw.begin(), raw.end());
    at_ += sizeof(T);
    return std::bit_cast<T>(raw);
  }

  void skip(std::size_t count, const char* what) {
    need(count, what);
    at_ += count;
  }

  std::size_t bytes_left() const { return bytes_.size() - at_; }

  /// Throws InputError("file:byte offset: message").
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(file_ + ":byte " + std::to_string(at_) + ": " + message);
  }

 private:
  void need(std::size_t count, const char* what) const {
    if (count <= bytes_left()) return;
    fail("the file ends within " + std::string(what) + ": " + std::to_string(count) + " bytes needed, " +
         std::to_string(bytes_left()) + " left");
  }

  std::string_view bytes_;
  std::size_t at_;
  std::string file_;
  bool swap_;
};

}  // namespace leastcost
