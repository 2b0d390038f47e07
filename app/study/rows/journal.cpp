// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/rows/journal.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

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
  if (json.at("format") != kFormat) throw InputError("is not a study journal");
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

Journal Journal::create(const fs::path& file, const StudyFacts& facts, const Shard& shard, bool replace) {
  Journal journal(file);
  if (!replace && !journal.file_.empty())
    throw OutputRefused(file.string() + ": another study has been written there meanwhile");
  journal.file_.cut(0);
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
    throw OutputRefused(
        fmt::format("{}: belongs to another study: {}; use -o for another folder, or --force to start again",
                    file.string(), reason));
  if (!(content.shard == shard))
    throw OutputRefused(fmt::format("{}: holds shard {}/{} of this study, not {}/{}", file.string(),
                                    content.shard.index, content.shard.count, shard.index, shard.count));
  journal.file_.cut(text.size());
  if (text.empty()) journal.write_line(facts_line(facts, shard));
  return journal;
}

void Journal::append(const CellResult& result) { write_line(to_json_line(result) + "\n"); }

void Journal::write_line(const std::string& line) {
  file_.append(line);
  file_.sync();
}

}  // namespace leastcost::app
