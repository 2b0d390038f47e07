// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace leastcost::app {

/// A place as it was written on the command line, or in a line of a file.
struct WrittenPlace {
  std::string text;
  std::string where;    ///< of the word or the line, for messages about the place: "--from", "places.txt:3"
  std::string in_full;  ///< the same with the place itself: "--from 3,4", "places.txt:3"
};

/// The places that the words of an option stand for: each word is a place, or a text file with one place a line,
/// without lines that are empty or begin with #. `is_place`: whether a word is a place whatever files there are;
/// `is_like_one`: whether it is one if it is no file. `example`: what a place looks like. Throws InputError for words
/// that are neither, and for files without a place.
std::vector<WrittenPlace> written_places(const std::vector<std::string>& words, const std::string& option,
                                         const std::function<bool(const std::string&)>& is_place,
                                         const std::function<bool(const std::string&)>& is_like_one,
                                         const std::string& example);

/// Whether a word has digits alone, as the number of a vertex.
bool is_whole_number(const std::string& word);

}  // namespace leastcost::app
