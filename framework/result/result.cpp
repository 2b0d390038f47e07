// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/result/result.hpp>

#include <algorithm>
#include <utility>

namespace leastcost {

Words<Status> words(Status) {
  using enum Status;
  static constexpr Word<Status> kWords[] = {
      {certified, "certified"}, {uncertified, "uncertified"}, {collapsed, "collapsed"}, {interrupted, "interrupted"}};
  return kWords;
}

void add_notes(const std::vector<std::string>& more, std::vector<std::string>& notes) {
  for (const std::string& note : more)
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

Result joined(const Result& before, Result later) {
  later.first = before.first;
  later.initial = before.initial;
  later.initial_cost = before.initial_cost;
  later.reference_cost = before.reference_cost;
  later.solve = joined(before.solve, std::move(later.solve));
  later.seconds.initialize += before.seconds.initialize;
  later.seconds.solve += before.seconds.solve;
  later.seconds.post_process += before.seconds.post_process;
  later.seconds.prepare += before.seconds.prepare;
  later.seconds.certify += before.seconds.certify;
  const std::vector<std::string> notes = std::exchange(later.notes, before.notes);
  add_notes(notes, later.notes);
  return later;
}

}  // namespace leastcost
