// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/manifest.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <openssl/crypto.h>
#include <unistd.h>

#include <Eigen/Core>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include <leastcost/version.hpp>
#include "catalogue/output/json_numbers.hpp"
#include "catalogue/output/source_commit.hpp"
#include "catalogue/registry/registry.hpp"

namespace leastcost {
namespace {

/// From /proc/cpuinfo; "unknown" where there is none.
std::string cpu_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(':');
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos)
      return line.substr(std::min(colon + 2, line.size()));
  }
  return "unknown";
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

nlohmann::ordered_json libraries() {
  nlohmann::ordered_json out = {
      {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"nlohmann_json",
       fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
      {"yaml-cpp", LEASTCOST_YAML_CPP_VERSION},
      {"openssl", OpenSSL_version(OPENSSL_VERSION_STRING)}};
  for (const PluginKind& kind : plugin_kinds())
    for (const PluginEntry* entry : kind.entries)
      if (!entry->library.empty()) out[entry->type] = entry->library;
  return out;
}

}  // namespace

std::string_view program_version() { return LEASTCOST_VERSION; }

std::string utc_text(std::chrono::system_clock::time_point time) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
  const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(time - seconds).count();
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03d}Z", fmt::gmtime(std::chrono::system_clock::to_time_t(seconds)),
                     milliseconds);
}

std::string manifest_json(const ManifestFacts& facts) {
  nlohmann::ordered_json inputs = nlohmann::ordered_json::array();
  for (const InputFile& input : facts.inputs)
    inputs.push_back({{"role", input.role}, {"file", input.file.string()}, {"sha256", input.sha256}});
  const nlohmann::ordered_json manifest = {
      {"program", kProgramName},
      {"schema_version", kSchemaVersion},
      {"kind", facts.kind},
      {"version", LEASTCOST_VERSION},
      {"commit", source_commit().empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(source_commit())},
      {"build", {{"compiler", LEASTCOST_COMPILER}, {"type", LEASTCOST_BUILD_TYPE}, {"libraries", libraries()}}},
      {"machine",
       {{"host", host_name()}, {"cpu", cpu_name()}, {"hardware_threads", std::thread::hardware_concurrency()}}},
      {"threads", 1},
      {"seed", facts.seed},
      {"arguments", facts.arguments},
      {"working_directory", std::filesystem::current_path().string()},
      {"started", utc_text(facts.started)},
      {"finished", utc_text(facts.finished)},
      {"inputs", inputs}};
  return to_text(manifest);
}

}  // namespace leastcost
