// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/growing_folder.hpp"

#include <fmt/format.h>

#include <system_error>
#include <vector>

#include "catalogue/output/output_folder.hpp"

namespace leastcost {
namespace {

namespace fs = std::filesystem;

/// Whether a program was killed in this folder before it had a log.
bool barely_begun(const fs::path& folder) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().stem() != "manifest" && entry.path().stem() != "manifest.json" &&
        entry.path().filename() != "config.resolved.yaml")
      return false;
  return true;
}

void check_place(const GrowingFolder& wanted, const fs::path& folder) {
  std::error_code error;
  const bool holds_log = fs::exists(folder / wanted.log, error);
  if (wanted.resume && (holds_log || barely_begun(folder))) return;
  if (wanted.resume && fs::is_directory(folder, error))
    throw OutputRefused(fmt::format("{}: has no {} to resume (no {})", folder.string(), wanted.what, wanted.log));
  OutputRefusal refusal = output_refusal(folder, wanted.force);
  if (refusal.empty()) return;
  if (holds_log && !wanted.force) refusal.reason += fmt::format("; use --resume to continue the {} in it", wanted.what);
  throw OutputRefused(refusal.reason, refusal.replaceable);
}

}  // namespace

fs::path prepare_folder(const GrowingFolder& wanted) {
  std::error_code error;
  fs::path folder = fs::weakly_canonical(fs::absolute(wanted.target), error);
  if (!folder.has_filename()) folder = folder.parent_path();
  if (error) throw OutputError(fmt::format("{}: {}", folder.string(), error.message()));
  check_place(wanted, folder);
  fs::create_directories(folder, error);
  if (error) throw OutputError(fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
  return folder;
}

void clear_folder(const fs::path& folder, const std::string& log) {
  std::error_code error;
  std::vector<fs::path> ours;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error))
    if (is_result_file(entry->path()) && entry->path().filename() != log && entry->path().filename() != "manifest.json")
      ours.push_back(entry->path());
  for (const fs::path& file : ours) fs::remove(file, error);
}

}  // namespace leastcost
