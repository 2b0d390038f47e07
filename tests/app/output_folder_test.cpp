// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/output_folder.hpp"

#include <fstream>
#include <sstream>
#include <thread>

#include "catalogue/output/manifest.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;

namespace {

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

void write_below(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

}  // namespace

TEST_CASE("output folder: appears complete, parents made, nothing left beside it") {
  const ScratchDir dir;
  {
    OutputFolder folder(dir / "a/b/run", false);
    folder.write("x.txt", "hello");
    CHECK_FALSE(fs::exists(dir / "a/b/run"));
    folder.commit();
  }
  CHECK(content(dir / "a/b/run/x.txt") == "hello");
  CHECK(entries(dir / "a/b") == 1);
}

TEST_CASE("output folder: without commit nothing remains") {
  const ScratchDir dir;
  { OutputFolder(dir / "run", false).write("x.txt", "hello"); }
  CHECK(entries(dir.path()) == 0);
}

TEST_CASE("output folder: an empty folder is taken, a full one refused") {
  const ScratchDir dir;
  fs::create_directories(dir / "empty");
  {
    OutputFolder folder(dir / "empty", false);
    folder.write("x.txt", "new");
    folder.commit();
  }
  CHECK(content(dir / "empty/x.txt") == "new");
  CHECK_THROWS_AS(OutputFolder(dir / "empty", false), OutputRefused);
  CHECK(content(dir / "empty/x.txt") == "new");
}

TEST_CASE("output folder: --force replaces only what is ours") {
  const ScratchDir dir;
  write_below(dir / "theirs/manifest.json", "{\"program\": \"other\"}");
  write_below(dir / "plain/file", "precious");
  write_below(dir / "broken/manifest.json", "{");
  write_below(dir / "file", "precious");
  for (const char* name : {"theirs", "plain", "broken", "file"}) {
    CAPTURE(name);
    CHECK_THROWS_AS(OutputFolder(dir / name, true), OutputRefused);
  }
  CHECK(content(dir / "plain/file") == "precious");

  write_below(dir / "ours/manifest.json", "{\"program\": \"leastcost\"}");
  write_below(dir / "ours/path.csv", "old");
  const OutputRefusal refusal = output_refusal(dir / "ours", false);
  CHECK(refusal.replaceable);
  CHECK_THAT(refusal.reason, Contains("not empty") && !Contains("--"));  // flags are words of the program
  CHECK_FALSE(output_refusal(dir / "plain", false).replaceable);
  CHECK_THROWS_AS(OutputFolder(dir / "ours", false), OutputRefused);
  write_below(dir / "ours/notes.txt", "precious");  // of the user, in a folder of ours
  CHECK_THROWS_WITH(OutputFolder(dir / "ours", true), Contains("notes.txt") && Contains("move it away"));
  CHECK(content(dir / "ours/notes.txt") == "precious");
  fs::remove(dir / "ours/notes.txt");
  {
    OutputFolder folder(dir / "ours", true);
    folder.write("new.txt", "new");
    CHECK(content(dir / "ours/path.csv") == "old");
    folder.commit();
  }
  CHECK_FALSE(fs::exists(dir / "ours/path.csv"));
  CHECK(content(dir / "ours/new.txt") == "new");
  CHECK(entries(dir.path()) == 5);
}

TEST_CASE("output folder: what appeared while it was written is not replaced, and nothing is lost") {
  const ScratchDir dir;
  const auto kept = [](const std::string& message) {
    const std::string marker = "the results are in ";
    REQUIRE(message.find(marker) != std::string::npos);
    return fs::path(message.substr(message.find(marker) + marker.size()));
  };
  const auto refused = [&](OutputFolder& folder) -> std::string {
    try {
      folder.commit();
    } catch (const OutputRefused& e) {
      return e.what();
    }
    return "";
  };
  fs::path first, second;
  {
    OutputFolder folder(dir / "run", false);
    folder.write("x.txt", "mine");
    write_below(dir / "run/notes.txt", "precious");
    first = kept(refused(folder));
  }
  CHECK(content(dir / "run/notes.txt") == "precious");
  CHECK(content(first / "x.txt") == "mine");
  {
    // Two runs into one place: the later is refused.
    OutputFolder one(dir / "both", false), two(dir / "both", false);
    one.write("manifest.json", "{\"program\": \"leastcost\"}");
    two.write("x.txt", "two");
    one.commit();
    second = kept(refused(two));
  }
  CHECK(fs::exists(dir / "both/manifest.json"));
  CHECK(content(second / "x.txt") == "two");
  {
    OutputFolder forced(dir / "both", true);
    forced.write("x.txt", "three");
    write_below(dir / "both/notes.txt", "precious");
    CHECK_THAT(refused(forced), Contains("notes.txt"));
  }
  CHECK(content(dir / "both/notes.txt") == "precious");
  {
    // What may be replaced is what was there at first, not what another run has written meanwhile.
    write_below(dir / "forced/manifest.json", "{\"program\": \"leastcost\", \"run\": 0}");
    OutputFolder one(dir / "forced", true), two(dir / "forced", true), none(dir / "nothing", true);
    one.write("manifest.json", "{\"program\": \"leastcost\", \"run\": 1}");
    two.write("x.txt", "two");
    none.write("x.txt", "none");
    one.commit();
    CHECK(content(kept(refused(two)) / "x.txt") == "two");
    CHECK_THAT(content(dir / "forced/manifest.json"), Contains("1}"));
    write_below(dir / "nothing/manifest.json", "{\"program\": \"leastcost\"}");
    CHECK(content(kept(refused(none)) / "x.txt") == "none");
    CHECK(fs::exists(dir / "nothing/manifest.json"));
  }
}

TEST_CASE("output folder: a folder is never taken from under somebody who writes into it, whatever the moment") {
  const ScratchDir dir;
  constexpr int kRounds = 40;
  for (int round = 0; round < kRounds; ++round) {
    const fs::path target = dir / std::to_string(round);
    OutputFolder folder(target, false);
    folder.write("x.txt", "mine");
    std::thread other([&] {
      std::error_code error;
      fs::create_directory(target, error);
      std::ofstream(target / "precious.txt") << "precious";
    });
    bool committed = true;
    try {
      folder.commit();
    } catch (const OutputRefused&) {
      committed = false;
    }
    other.join();
    CAPTURE(round, committed);
    CHECK(fs::exists(target / "x.txt") == committed);
    // It was made in one of the two folders, and is still there, unless the other one came before there was a folder.
    CHECK((committed || content(target / "precious.txt") == "precious"));
  }
}

TEST_CASE("output folder: what could be written stays when the rest cannot") {
  const ScratchDir dir;
  fs::path left;
  {
    OutputFolder folder(dir / "run", false);
    CHECK(folder.leave() == "");  // nothing was written
    folder.write("path.csv", "1,2,3");
    CHECK_THROWS_AS(folder.write("no/such/place", "x"), OutputError);
    const std::string where = folder.leave();
    const std::string before = "; the files that could be written are in ";
    REQUIRE(where.rfind(before, 0) == 0);
    left = where.substr(before.size());
  }
  CHECK(content(left / "path.csv") == "1,2,3");
  CHECK_FALSE(fs::exists(dir / "run"));
}

TEST_CASE("output folder: a place that cannot be written is found out at once") {
  const ScratchDir dir;
  write_below(dir / "file", "x");
  CHECK_THROWS_AS(OutputFolder(dir / "file/run", false), OutputError);
  CHECK_THROWS_AS(OutputFolder("/proc/leastcost/run", false), OutputError);
}

TEST_CASE("output folder: links and odd paths") {
  const ScratchDir dir;
  fs::create_directories(dir / "real");
  fs::create_directory_symlink(dir / "real", dir / "link");
  {
    OutputFolder folder(dir / "link", false);
    folder.write("x", "1");
    folder.commit();
  }
  CHECK(content(dir / "real/x") == "1");
  CHECK(fs::is_symlink(dir / "link"));
  {
    OutputFolder folder((dir / "slash").string() + "/", false);
    folder.write("x", "1");
    folder.commit();
  }
  CHECK(content(dir / "slash/x") == "1");
}

TEST_CASE("manifest: SHA-256 of known texts") {
  CHECK(sha256_of_text("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256_of_text("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const ScratchDir dir;
  write_below(dir / "million", std::string(1000000, 'a'));
  CHECK(sha256_of_file(dir / "million") == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("manifest: times are UTC") {
  CHECK(utc_text(std::chrono::system_clock::time_point{std::chrono::milliseconds{1234567890123}}) ==
        "2009-02-13T23:31:30.123Z");
}

}  // namespace leastcost::test
