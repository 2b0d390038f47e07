// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/exact/landmark_file.hpp>

#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

constexpr std::string_view kMagic = "LCLMARKS";
constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kPrecision = sizeof(float);
constexpr std::uint64_t kMostLandmarks = 1U << 16;
constexpr std::uint64_t kMostVertices = 1U << 31;
static_assert(std::endian::native == std::endian::little, "an index is written as it is in memory");

std::uint64_t checksum(std::span<const char> bytes) {
  constexpr std::uint64_t kOffset = 14695981039346656037ULL, kPrime = 1099511628211ULL;
  std::uint64_t hash = kOffset;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
  return hash;
}

template <class T>
void put(std::vector<char>& out, std::span<const T> values) {
  static_assert(std::is_trivially_copyable_v<T>);
  const std::size_t begin = out.size();
  out.resize(begin + values.size_bytes());
  if (!values.empty()) std::memcpy(out.data() + begin, values.data(), values.size_bytes());
}
template <class T>
void put(std::vector<char>& out, const T& value) {
  put(out, std::span<const T>(&value, 1));
}

/// Takes values off the front of what was read.
class Bytes {
 public:
  Bytes(std::span<const char> left, std::string name) : left_(left), name_(std::move(name)) {}

  template <class T>
  std::vector<T> take(std::uint64_t count) {
    if (count > left_.size() / sizeof(T)) throw InputError(name_ + ": the index is truncated; make it again");
    std::vector<T> values(static_cast<std::size_t>(count));
    if (count > 0) std::memcpy(values.data(), left_.data(), values.size() * sizeof(T));
    left_ = left_.subspan(values.size() * sizeof(T));
    return values;
  }
  template <class T>
  T take() {
    return take<T>(1).front();
  }
  bool empty() const { return left_.empty(); }

 private:
  std::span<const char> left_;
  std::string name_;
};

}  // namespace

void write_landmarks(const Landmarks& landmarks, const std::filesystem::path& file) {
  std::vector<char> out(kMagic.begin(), kMagic.end());
  put(out, kVersion);
  put(out, kPrecision);
  put(out, landmarks.made_for());
  put(out, static_cast<std::uint64_t>(landmarks.vertex_count()));
  put(out, static_cast<std::uint64_t>(landmarks.count()));
  put(out, std::span<const std::int32_t>(landmarks.vertices()));
  put(out, landmarks.widths());
  put(out, landmarks.distances());
  put(out, checksum(out));
  std::filesystem::path beside = file;  // a name of its own: nothing that is there is written over
  beside += "." + std::to_string(std::random_device{}()) + ".part";
  std::error_code failed;
  if (std::filesystem::exists(beside, failed)) throw InputError(beside.string() + ": already exists");
  {
    std::ofstream stream(beside, std::ios::binary);
    stream.write(out.data(), static_cast<std::streamsize>(out.size()));
    stream.close();
    if (!stream) throw InputError(file.string() + ": the index cannot be written there");
  }
  std::filesystem::rename(beside, file, failed);
  if (failed) throw InputError(file.string() + ": the index cannot be written there: " + failed.message());
}

Landmarks read_landmarks(const std::filesystem::path& file, std::uint64_t made_for) {
  const std::string name = file.string();
  if (std::filesystem::is_directory(file)) throw InputError(name + ": the index cannot be read: it is a folder");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(name + ": the index cannot be read");
  const std::vector<char> all{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t sealed = sizeof(std::uint64_t);
  if (all.size() < kMagic.size() + sealed || std::string_view(all.data(), kMagic.size()) != kMagic)
    throw InputError(name + ": not an index of landmarks, which begins with " + std::string(kMagic));
  const std::span<const char> body(all.data(), all.size() - sealed);
  Bytes bytes(body.subspan(kMagic.size()), name);
  const auto version = bytes.take<std::uint32_t>(), precision = bytes.take<std::uint32_t>();
  if (version != kVersion || precision != kPrecision)
    throw InputError(name + ": the index has version " + std::to_string(version) + " and distances of " +
                     std::to_string(precision) + " bytes, but this program reads version " + std::to_string(kVersion) +
                     " with " + std::to_string(kPrecision) + "; make it again");
  std::uint64_t seal = 0;
  std::memcpy(&seal, all.data() + body.size(), sealed);
  if (seal != checksum(body)) throw InputError(name + ": the index is truncated or was changed; make it again");
  const auto wanted = bytes.take<std::uint64_t>(), vertices = bytes.take<std::uint64_t>();
  if (wanted != made_for)
    throw InputError(name +
                     ": this index was made for another mesh, other positions of it or another metric, so its "
                     "distances are not bounds here; make it again");
  const auto count = bytes.take<std::uint64_t>();
  if (count > kMostLandmarks || vertices > kMostVertices)
    throw InputError(name + ": the index was not made by this program");
  std::vector<std::int32_t> of = bytes.take<std::int32_t>(count);
  std::vector<double> widths = bytes.take<double>(count);
  std::vector<float> distances = bytes.take<float>(count * vertices);
  if (!bytes.empty()) throw InputError(name + ": the index is longer than its header says; make it again");
  return {wanted, static_cast<std::size_t>(vertices), std::move(of), std::move(widths), std::move(distances)};
}

}  // namespace leastcost
