// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <system_error>

#include "catalogue/output/manifest.hpp"

namespace leastcost {
namespace {

namespace fs = std::filesystem;

std::string last_error() { return std::generic_category().message(errno); }

bool holds_our_manifest(const fs::path& folder) {
  std::ifstream in(folder / "manifest.json");
  const nlohmann::json manifest = nlohmann::json::parse(in, nullptr, false);
  return manifest.is_object() && manifest.contains("program") && manifest["program"] == kProgramName;
}

constexpr std::string_view kTemporary = ".tmp";

/// What a file that was being written when its program was killed would have been called.
std::string without_temporary(std::string name) {
  if (name.size() > kTemporary.size() && name.substr(name.size() - kTemporary.size()) == kTemporary)
    name.resize(name.size() - kTemporary.size());
  return name;
}

/// A file that no run of ours wrote, or an empty path: --force must not take it away.
fs::path foreign_file(const fs::path& folder) {
  static const std::set<std::string> ours = {
      "config.resolved.yaml", "curve.csv", "first_path.csv", "history.csv", "manifest.json", "path.csv", "path.obj",
      "path.vtp", "report.html", "residuals.csv", "result.json", "scene.json",
      // of studies
      "journal.jsonl", "runs.csv", "study.resolved.yaml", "summary.json", "traces.csv", "accuracy.svg", "data.svg",
      "evaluations.svg", "order.svg", "performance.svg", "seconds.svg"};
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (ours.count(without_temporary(entry.path().filename().string())) == 0) return entry.path();
  return {};
}

/// Swaps two folders in one step where the file system can, so that there is no moment without results.
bool exchange(const fs::path& a, const fs::path& b) {
#ifdef RENAME_EXCHANGE
  return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
#else
  return false;
#endif
}

/// Writes a file to its end. `shown`: the name it has for the user. Throws OutputError.
void write_file(const fs::path& file, const std::string& content, const fs::path& shown) {
  std::FILE* out = std::fopen(file.c_str(), "wb");
  if (out == nullptr) throw OutputError(fmt::format("{}: cannot be made: {}", shown.string(), last_error()));
  const bool written = std::fwrite(content.data(), 1, content.size(), out) == content.size();
  const int write_error = errno;
  const bool closed = std::fclose(out) == 0;  // a full disk may show only here
  if (written && closed) return;
  const std::string reason = std::generic_category().message(written ? errno : write_error);
  throw OutputError(fmt::format("{}: cannot be written: {}", shown.string(), reason));
}

}  // namespace

std::string output_refusal(const fs::path& target, bool force) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(target, error))) return "";
  if (!fs::is_directory(target, error)) return target.string() + ": exists and is not a folder";
  if (fs::is_empty(target, error)) return "";
  if (error) return fmt::format("{}: cannot be read: {}", target.string(), error.message());
  if (!force) return target.string() + ": the output folder is not empty; --force replaces it, -o chooses another";
  if (holds_our_manifest(target)) {
    const fs::path foreign = foreign_file(target);
    if (foreign.empty()) return "";
    return foreign.string() + ": --force would remove this file, which no run wrote; move it away";
  }
  return target.string() + ": --force replaces only a folder with a manifest.json of leastcost, and this has none";
}

OutputFolder::OutputFolder(const fs::path& target, bool force) : force_(force) {
  std::error_code error;
  target_ = fs::weakly_canonical(fs::absolute(target), error);
  if (error) throw OutputError(fmt::format("{}: {}", target.string(), error.message()));
  if (!target_.has_filename()) target_ = target_.parent_path();
  const std::string refusal = output_refusal(target_, force);
  if (!refusal.empty()) throw OutputRefused(refusal);
  fs::create_directories(target_.parent_path(), error);
  if (error) throw OutputError(fmt::format("{}: cannot be made: {}", target_.parent_path().string(), error.message()));
  std::string name = (target_.parent_path() / fmt::format(".{}.XXXXXX", target_.filename().string())).string();
  if (::mkdtemp(name.data()) == nullptr)
    throw OutputError(fmt::format("{}: cannot be written: {}", target_.parent_path().string(), last_error()));
  temporary_ = name;
  // mkdtemp() is for the owner only; results are as readable as any other folder of the user.
  fs::permissions(temporary_,
                  fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read |
                      fs::perms::others_exec,
                  error);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!committed_) fs::remove_all(temporary_, ignored);
}

void OutputFolder::write(const std::string& name, const std::string& content) {
  write_file(temporary_ / name, content, target_ / name);
}

void write_whole_file(const fs::path& file, const std::string& content) {
  const fs::path temporary = file.string() + std::string(kTemporary);
  write_file(temporary, content, file);
  std::error_code error;
  fs::rename(temporary, file, error);
  if (error) throw OutputError(fmt::format("{}: cannot be made: {}", file.string(), error.message()));
}

void OutputFolder::keep(const std::string& reason, bool refused) {
  committed_ = true;  // nothing is removed: hours of work may be in there
  const std::string message = fmt::format("{}; the results lie in {}", reason, temporary_.string());
  if (refused) throw OutputRefused(message);
  throw OutputError(message);
}

void OutputFolder::commit() {
  std::error_code error;
  fs::rename(temporary_, target_, error);  // onto nothing, or an empty folder: fails where something has appeared
  if (!error) {
    committed_ = true;
    return;
  }
  const std::string refusal = output_refusal(target_, force_);
  if (!refusal.empty()) keep(refusal, true);
  if (!fs::exists(target_) || fs::is_empty(target_))
    keep(fmt::format("{}: cannot be made: {}", target_.string(), error.message()), false);
  const fs::path aside = temporary_.string() + ".old";
  if (exchange(temporary_, target_)) {
    fs::rename(temporary_, aside, error);
  } else {
    fs::rename(target_, aside, error);
    if (error) keep(fmt::format("{}: cannot be replaced: {}", target_.string(), error.message()), false);
    fs::rename(temporary_, target_, error);
  }
  if (error) keep(fmt::format("{}: cannot be replaced: {}", target_.string(), error.message()), false);
  committed_ = true;
  // Looked at once more, now that nobody can write there under its name.
  const fs::path foreign = foreign_file(aside);
  if (!foreign.empty())
    throw OutputRefused(fmt::format("{}: appeared in the replaced folder, which is kept there", foreign.string()));
  fs::remove_all(aside, error);
}

}  // namespace leastcost
