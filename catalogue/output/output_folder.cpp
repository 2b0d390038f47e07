// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
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

}  // namespace

bool is_result_file(const fs::path& file) {
  static const std::set<std::string> ours = {
      "clicks.json", "config.resolved.yaml", "curve.csv", "first_path.csv", "history.csv", "manifest.json", "path.csv",
      "path.geojson", "path_points.geojson", "path.gpkg", "path.obj", "path.vtp", "report.html", "residuals.csv",
      "result.json", "scene.json", "trajectory.csv", "trajectory.json", "waypoints.csv",
      "paths.jsonl",  // of many pairs of ends
      // of studies
      "journal.jsonl", "runs.csv", "study.resolved.yaml", "summary.json", "traces.csv", "accuracy.svg", "data.svg",
      "evaluations.svg", "order.svg", "performance.svg", "seconds.svg"};
  return ours.count(without_temporary(file.filename().string())) > 0;
}

namespace {

/// A file that no run of ours wrote, or an empty path: --force must not take it away. What cannot be looked at is
/// foreign.
fs::path foreign_file(const fs::path& folder) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    if (!is_result_file(entry->path())) return entry->path();
  return error ? folder : fs::path();
}

/// Which folder this is, and whose: another one of the same name, or one that a run has written meanwhile, differs.
/// Empty where there is none, or nothing in it.
std::string identity(const fs::path& folder) {
  std::error_code error;
  struct stat facts {};
  if (::lstat(folder.c_str(), &facts) != 0 || fs::is_empty(folder, error)) return "";
  std::ifstream in(folder / "manifest.json", std::ios::binary);
  return fmt::format("{}:{}:", facts.st_dev, facts.st_ino) + std::string(std::istreambuf_iterator<char>(in), {});
}

/// Swaps two folders in one step, so that there is no moment without results. Not every file system can.
bool exchange(const fs::path& a, const fs::path& b) {
#ifdef RENAME_EXCHANGE
  return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
#else
  return false;
#endif
}

/// Writes a file to its end, or leaves none. `shown`: the name it has for the user. Throws OutputError.
void write_file(const fs::path& file, const std::string& content, const fs::path& shown) {
  std::FILE* out = std::fopen(file.c_str(), "wb");
  if (out == nullptr) throw OutputError(fmt::format("{}: cannot be made: {}", shown.string(), last_error()));
  const bool written = std::fwrite(content.data(), 1, content.size(), out) == content.size();
  const int write_error = errno;
  const bool closed = std::fclose(out) == 0;  // a full disk may show only here
  if (written && closed) return;
  const std::string reason = std::generic_category().message(written ? errno : write_error);
  std::error_code ignored;
  fs::remove(file, ignored);
  throw OutputError(fmt::format("{}: cannot be written: {}", shown.string(), reason));
}

/// The same by way of a second name, so that an earlier file is there until this one is whole.
void write_and_rename(const fs::path& file, const std::string& content, const fs::path& shown) {
  const fs::path temporary = file.string() + std::string(kTemporary);
  write_file(temporary, content, shown);
  std::error_code error;
  fs::rename(temporary, file, error);
  if (error) throw OutputError(fmt::format("{}: cannot be made: {}", shown.string(), error.message()));
}

}  // namespace

OutputRefusal output_refusal(const fs::path& target, bool force) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(target, error))) return {};
  if (!fs::is_directory(target, error)) return {target.string() + ": exists and is not a folder"};
  const bool nothing_in_it = fs::is_empty(target, error);
  if (error) return {fmt::format("{}: cannot be read: {}", target.string(), error.message())};
  if (nothing_in_it) return {};
  const bool ours = holds_our_manifest(target);
  const fs::path foreign = foreign_file(target);
  if (!force) return {target.string() + ": the output folder is not empty", ours && foreign.empty()};
  if (!ours)
    return {target.string() + ": only a folder with a manifest.json of leastcost is replaced, and this one has none"};
  if (foreign.empty()) return {};
  return {foreign.string() + ": would be removed with the folder to be replaced, but no run wrote it; move it away"};
}

OutputFolder::OutputFolder(const fs::path& target, bool force) : force_(force) {
  std::error_code error;
  target_ = fs::weakly_canonical(fs::absolute(target), error);
  if (error) throw OutputError(fmt::format("{}: {}", target.string(), error.message()));
  if (!target_.has_filename()) target_ = target_.parent_path();
  const OutputRefusal refusal = output_refusal(target_, force);
  if (!refusal.empty()) throw OutputRefused(refusal.reason, refusal.replaceable);
  if (force) replaced_ = identity(target_);
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
  if (!done_) fs::remove_all(temporary_, ignored);
}

void OutputFolder::write(const std::string& name, const std::string& content) {
  write_and_rename(temporary_ / name, content, target_ / name);
}

void write_whole_file(const fs::path& file, const std::string& content) { write_and_rename(file, content, file); }

std::string OutputFolder::leave() {
  std::error_code error;
  if (done_ || fs::is_empty(temporary_, error) || error) return "";
  done_ = true;
  return "; the files that could be written are in " + temporary_.string();
}

void OutputFolder::keep(const std::string& reason, bool refused) {
  done_ = true;  // nothing is removed: hours of work may be in there
  const std::string message = fmt::format("{}; the results are in {}", reason, temporary_.string());
  if (refused) throw OutputRefused(message);
  throw OutputError(message);
}

void OutputFolder::commit() {
  std::error_code error;
  fs::rename(temporary_, target_, error);  // onto nothing, or an empty folder: fails where something has appeared
  if (!error) {
    done_ = true;
    return;
  }
  const OutputRefusal refusal = output_refusal(target_, force_);
  if (!refusal.empty()) keep(refusal.reason, true);
  const std::string there = identity(target_);
  if (there.empty()) keep(fmt::format("{}: cannot be made: {}", target_.string(), error.message()), false);
  if (there != replaced_) keep(target_.string() + ": another run has written there in the meantime", true);
  replace();
}

/// In the moment between the look and the exchange somebody may still have written there. So what was exchanged is
/// looked at once more, now that nobody can write there under its name, and put back if it is not what was to go.
void OutputFolder::replace() {
  std::error_code error;
  fs::path old = temporary_.string() + ".old";
  if (exchange(temporary_, target_)) {
    fs::rename(temporary_, old, error);
    if (error) old = temporary_;
  } else {
    fs::rename(target_, old, error);
    if (error) keep(fmt::format("{}: cannot be replaced: {}", target_.string(), error.message()), false);
    fs::rename(temporary_, target_, error);  // again onto nothing, or fails
    if (error) {
      const std::string reason = error.message();
      fs::rename(old, target_, error);
      keep(fmt::format("{}: cannot be replaced: {}{}", target_.string(), reason,
                       error ? "; the previous contents are in " + old.string() : ""),
           false);
    }
  }
  if (identity(old) != replaced_ || !foreign_file(old).empty()) put_back(old);
  done_ = true;
  fs::remove_all(old, error);
}

void OutputFolder::put_back(const fs::path& old) {
  std::error_code error;
  if (exchange(old, target_)) {
    fs::rename(old, temporary_, error);
    if (error) temporary_ = old;
    keep(target_.string() + ": something has appeared there in the meantime", true);
  }
  done_ = true;
  throw OutputRefused(
      fmt::format("{}: something had appeared there in the meantime and is now in {}; the results are in {}",
                  target_.string(), old.string(), target_.string()));
}

}  // namespace leastcost
