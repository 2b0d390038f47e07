// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/written_places.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost::app {
namespace {

void read_lines(std::istream& in, const std::string& file, std::vector<WrittenPlace>& places) {
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    constexpr const char* kByteOrderMark = "\xEF\xBB\xBF";  // spreadsheets write it
    if (++number == 1 && line.starts_with(kByteOrderMark))
      line.erase(0, std::char_traits<char>::length(kByteOrderMark));
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    const std::string where = fmt::format("{}:{}", file, number);
    places.push_back({line, where, where});
  }
}

}  // namespace

std::vector<WrittenPlace> written_places(const std::vector<std::string>& words, const std::string& option,
                                         const std::function<bool(const std::string&)>& is_place,
                                         const std::function<bool(const std::string&)>& is_like_one,
                                         const std::string& example) {
  std::vector<WrittenPlace> places;
  for (const std::string& word : words) {
    const std::string in_full = fmt::format("{} {}", option, word);
    std::ifstream in;
    if (!is_place(word)) in.open(word);
    if (is_place(word) || (!in && is_like_one(word))) {
      places.push_back({word, option, in_full});
      continue;
    }
    if (!in)
      throw InputError(fmt::format("{}: there is no such file, and it is not a place like {}", in_full, example));
    const std::size_t before = places.size();
    read_lines(in, word, places);
    if (places.size() == before) throw InputError(fmt::format("{}: the file has no places", in_full));
  }
  return places;
}

bool is_whole_number(const std::string& word) {
  return !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace leastcost::app
