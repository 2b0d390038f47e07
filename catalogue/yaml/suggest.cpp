// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/yaml/suggest.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "problems/formula/edit_distance.hpp"

namespace leastcost {
namespace {

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// Other names of what we have a word for.
std::string synonym(std::string_view word, const std::vector<std::string>& candidates) {
  using Name = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Name, 10> kOurs = {{{"disc", "ball"},
                                                  {"disk", "ball"},
                                                  {"circle", "ball"},
                                                  {"sphere", "ball"},
                                                  {"rectangle", "box"},
                                                  {"cube", "box"},
                                                  {"cuboid", "box"},
                                                  {"plane", "euclidean"},
                                                  {"space", "euclidean"},
                                                  {"length", "euclidean"}}};
  for (const auto& [theirs, ours] : kOurs)
    if (word == theirs && std::find(candidates.begin(), candidates.end(), ours) != candidates.end())
      return std::string(ours);
  return "";
}

bool contains(std::string_view whole, std::string_view part) {
  return part.size() >= 3 && whole.find(part) != std::string_view::npos;
}

/// An abbreviation (max_iter), a mistyped one (max_itr) or a fuller name (mesh_file): far by edits, plain to a reader.
bool is_form_of(std::string_view word, std::string_view candidate) {
  if (contains(candidate, word) || contains(word, candidate)) return true;
  return word.size() >= 5 && candidate.size() > word.size() &&
         edit_distance(word, candidate.substr(0, word.size())) <= 1;
}

}  // namespace

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t kLongestWord = 60;  // the distance is quadratic, and nobody mistypes more than this
  if (word.empty() || word.size() > kLongestWord) return "";
  const std::string wanted = lower_case(word);
  if (std::string same = synonym(wanted, candidates); !same.empty()) return same;
  std::string best, other_form;
  std::size_t least = std::max<std::size_t>(1, wanted.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(wanted, lower_case(candidate));
    if (distance < least) {
      least = distance;
      best = candidate;
    }
    if (other_form.empty() && is_form_of(wanted, candidate)) other_form = candidate;
  }
  return best.empty() ? other_form : best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string best = nearest_word(word, candidates);
  return best.empty() ? "" : " (did you mean '" + best + "'?)";
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
  return all;
}

}  // namespace leastcost
