// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/study/rows/locked_file.hpp"
#include "app/study/rows/run_row.hpp"

namespace leastcost::app {

/// Part i of N of a study: the cells whose number leaves the remainder i. From 0, as Slurm counts arrays (--array=0-7).
struct Shard {
  int index = 0, count = 1;
  bool has(long cell) const { return cell % count == index; }
  bool operator==(const Shard& other) const { return index == other.index && count == other.count; }
};

struct SkippedCell {
  long cell = 0;
  std::vector<std::string> values;
  std::string reason;
};

/// What a study is, apart from its results. Two journals belong together when `configuration` and `data` agree.
struct StudyFacts {
  std::string name;
  std::string configuration;                              ///< SHA-256 of all cells as they are run
  std::vector<std::pair<std::string, std::string>> data;  ///< files of the cells, SHA-256 of each
  std::string version;                                    ///< of the program; noted only
  int seed = 0;
  long cells = 0;        ///< in the full grid
  long repetitions = 1;  ///< of each
  std::vector<std::string> swept_keys;
  std::vector<SkippedCell> skipped;
};

/// journal.jsonl: a line of facts, then one line per finished repetition of a cell.
struct JournalContent {
  StudyFacts facts = {};
  Shard shard = {};
  std::vector<CellResult> results = {};  ///< in the order in which they ended
};

/// Why the results of `other` cannot stand beside those of `facts`; empty when they can.
std::string difference(const StudyFacts& facts, const StudyFacts& other);

std::string facts_line(const StudyFacts& facts, const Shard& shard);

/// Reads a journal; a last line without its end (torn by a kill) does not count. Throws InputError when it is none.
JournalContent read_journal(const std::filesystem::path& file);

/// A journal that is being written. Holds a lock, so that no second process writes to it, until it goes away or the
/// process does. What append() has returned from is on the disk.
class Journal {
 public:
  /// A new journal with its first line. Throws OutputRefused when another process writes to it, or has written since
  /// the folder was looked at, unless it may be replaced; OutputError.
  static Journal create(const std::filesystem::path& file, const StudyFacts& facts, const Shard& shard, bool replace);
  /// Goes on with one that exists, its torn last line cut off; `content` is what it holds. Throws OutputRefused when
  /// another process writes to it, or it belongs to another study or shard; OutputError, InputError.
  static Journal resume(const std::filesystem::path& file, const StudyFacts& facts, const Shard& shard,
                        JournalContent& content);
  void append(const CellResult& result);
  /// In a child: it must not keep the lock when its parent has died.
  void forget() { file_.forget(); }

 private:
  explicit Journal(const std::filesystem::path& file) : file_(file, "this study") {}
  void write_line(const std::string& line);

  LockedFile file_;
};

}  // namespace leastcost::app
