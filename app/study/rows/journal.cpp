// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/rows/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>
#include <thread>

#include "app/study/rows/row_json.hpp"
#include "catalogue/output/json_numbers.hpp"
#include "catalogue/output/output_folder.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* kFormat = "leastcost study journal";

std::string last_error() { return std::generic_category().message(errno); }

std::string whole_lines(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string() + ": cannot be opened: " + last_error());
  std::ostringstream text;
  text << in.rdbuf();
  std::string all = std::move(text).str();
  const std::size_t end = all.rfind('\n');
  all.resize(end == std::string::npos ? 0 : end + 1);
  return all;
}

void read_facts(const std::string& line, JournalContent& content) {
  const Json json = Json::parse(line);
  if (json.at("format") != kFormat) throw InputError("is no journal of a study");
  if (json.at("schema_version") != kSchemaVersion)
    throw InputError("was written by a version of leastcost with another layout");
  StudyFacts& facts = content.facts;
  facts.name = json.at("name");
  facts.version = json.at("version");
  facts.configuration = json.at("configuration");
  for (const auto& [file, hash] : json.at("data").items()) facts.data.emplace_back(file, hash);
  facts.seed = json.at("seed");
  facts.cells = json.at("cells");
  facts.repetitions = json.at("repetitions");
  facts.swept_keys = json.at("swept_keys").get<std::vector<std::string>>();
  for (const Json& s : json.at("skipped"))
    facts.skipped.push_back({s.at("cell"), s.at("values").get<std::vector<std::string>>(), s.at("reason")});
  content.shard = {json.at("shard").at(0), json.at("shard").at(1)};
}

/// A repetition of a cell of the study, and only once: twice the same line is one.
void add_result(CellResult result, std::map<std::pair<long, long>, std::size_t>& places, JournalContent& content) {
  const RunRow& row = result.row;
  if (row.cell < 0 || row.cell >= content.facts.cells || row.repetition < 0 ||
      row.repetition >= content.facts.repetitions)
    throw InputError(fmt::format("the study has no cell {}, repetition {}", row.cell, row.repetition));
  const auto [place, is_new] = places.try_emplace({row.cell, row.repetition}, content.results.size());
  if (is_new)
    content.results.push_back(std::move(result));
  else if (to_json_line(content.results[place->second]) != to_json_line(result))
    throw InputError(
        fmt::format("cell {}, repetition {} is there already, with another result", row.cell, row.repetition));
}

JournalContent parse_journal(const std::string& text, const fs::path& file) {
  JournalContent content;
  std::map<std::pair<long, long>, std::size_t> places;
  std::istringstream in(text);
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    try {
      if (number == 1)
        read_facts(line, content);
      else
        add_result(from_json_line(line), places, content);
    } catch (const std::exception& e) {
      throw InputError(fmt::format("{}:{}: not a line of a study's journal: {}", file.string(), number, e.what()));
    }
  }
  return content;
}

}  // namespace

std::string difference(const StudyFacts& facts, const StudyFacts& other) {
  for (const auto& [file, hash] : facts.data)
    for (const auto& [other_file, other_hash] : other.data)
      if (file == other_file && hash != other_hash) return fmt::format("the data file {} has changed", file);
  if (facts.configuration == other.configuration) return "";
  if (facts.cells != other.cells) return fmt::format("it had {} cells and now has {}", other.cells, facts.cells);
  if (facts.repetitions != other.repetitions)
    return fmt::format("it had {} repetitions and now has {}", other.repetitions, facts.repetitions);
  return "the options of its cells, or which of them are left out, have changed";
}

std::string facts_line(const StudyFacts& facts, const Shard& shard) {
  Json skipped = Json::array(), data = Json::object();
  for (const SkippedCell& s : facts.skipped)
    skipped.push_back({{"cell", s.cell}, {"values", s.values}, {"reason", s.reason}});
  for (const auto& [file, hash] : facts.data) data[file] = hash;
  const Json json = {{"format", kFormat},
                     {"schema_version", kSchemaVersion},
                     {"name", facts.name},
                     {"version", facts.version},
                     {"configuration", facts.configuration},
                     {"data", data},
                     {"seed", facts.seed},
                     {"cells", facts.cells},
                     {"repetitions", facts.repetitions},
                     {"shard", {shard.index, shard.count}},
                     {"swept_keys", facts.swept_keys},
                     {"skipped", skipped}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

JournalContent read_journal(const fs::path& file) {
  const std::string text = whole_lines(file);
  if (text.empty()) throw InputError(file.string() + ": is empty: the study was killed before it began");
  return parse_journal(text, file);
}

Journal::Journal(fs::path file) : file_(std::move(file)) {
  fd_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (fd_ < 0) throw OutputError(fmt::format("{}: cannot be written: {}", file_.string(), last_error()));
  // A killed predecessor's children may hold the lock for the moment it takes them to die.
  constexpr int kTries = 20;
  constexpr std::chrono::milliseconds kPause{50};
  for (int i = 0; ::flock(fd_, LOCK_EX | LOCK_NB) != 0; ++i) {
    if (i < kTries) {
      std::this_thread::sleep_for(kPause);
      continue;
    }
    ::close(fd_);
    throw OutputRefused(file_.string() + ": another process is writing to this study");
  }
}

Journal::~Journal() { forget(); }

Journal::Journal(Journal&& other) noexcept : file_(std::move(other.file_)), fd_(other.fd_) { other.fd_ = -1; }

void Journal::forget() {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

void Journal::cut(std::size_t size) {
  if (::ftruncate(fd_, static_cast<off_t>(size)) != 0)
    throw OutputError(fmt::format("{}: cannot be written: {}", file_.string(), last_error()));
}

Journal Journal::create(const fs::path& file, const StudyFacts& facts, const Shard& shard, bool replace) {
  Journal journal(file);
  if (!replace && ::lseek(journal.fd_, 0, SEEK_END) > 0)
    throw OutputRefused(file.string() + ": another study has been written there meanwhile");
  journal.cut(0);
  journal.write_line(facts_line(facts, shard));
  return journal;
}

Journal Journal::resume(const fs::path& file, const StudyFacts& facts, const Shard& shard, JournalContent& content) {
  Journal journal(file);
  const std::string text = whole_lines(file);
  content = {facts, shard, {}};
  if (!text.empty()) content = parse_journal(text, file);
  const std::string reason = difference(facts, content.facts);
  if (!reason.empty())
    throw OutputRefused(fmt::format("{}: belongs to another study: {}; -o chooses another folder, --force begins anew",
                                    file.string(), reason));
  if (!(content.shard == shard))
    throw OutputRefused(fmt::format("{}: holds shard {}/{} of this study, not {}/{}", file.string(),
                                    content.shard.index, content.shard.count, shard.index, shard.count));
  journal.cut(text.size());
  if (text.empty()) journal.write_line(facts_line(facts, shard));
  return journal;
}

void Journal::append(const CellResult& result) { write_line(to_json_line(result) + "\n"); }

/// One write per line: a kill leaves at most a torn last one. So does a full disk, whose part of a line is cut off
/// again.
void Journal::write_line(const std::string& line) {
  const off_t before = ::lseek(fd_, 0, SEEK_END);
  ssize_t written = -1;
  do {
    written = ::write(fd_, line.data(), line.size());
  } while (written < 0 && errno == EINTR);
  if (written == static_cast<ssize_t>(line.size()) && ::fdatasync(fd_) == 0) return;
  const std::string reason = written < 0 ? last_error() : "the disk is full";
  if (written > 0 && ::ftruncate(fd_, before) != 0) {
    // Nothing more can be done: the torn line is cut off on resume.
  }
  throw OutputError(fmt::format("{}: cannot be written: {}", file_.string(), reason));
}

}  // namespace leastcost::app
