// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/with_more_points.hpp"

#include <exception>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "framework/result/never_worse.hpp"
#include "framework/search/dearer_than_first.hpp"
#include "framework/search/more_points_may_help.hpp"
#include "framework/search/point_doubling.hpp"

namespace leastcost {
namespace {

void go_on(PointDoubling& doubling, const Problem& problem) {
  try {
    while (doubling.may_double() && more_points_may_help(problem, doubling.fine())) doubling.double_points();
  } catch (const InputError&) {  // a finer chain could not be made
  } catch (const InitializationError&) {
  } catch (const Interrupted&) {
  }
}

/// A finer chain that was not certified either, where it alone is no worse than the first path.
bool saves(const Problem& problem, const Result& finer, const Result& found, const Search& search) {
  try {
    return finer.status == Status::uncertified &&
           first_path_is_better(problem, found, search.options, search.monitor.limit()) &&
           !first_path_is_better(problem, finer, search.options, search.monitor.limit());
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

Result with_more_points(const Problem& problem, Result found, const Search& search) {
  refuse_dearer(problem, search, found);
  if (search.options.certificate.refine == 0 || !search.solver.moves_points() || !more_points_may_help(problem, found))
    return found;
  PointDoubling doubling(problem, found, search);
  go_on(doubling, problem);
  if (doubling.fine().status == Status::certified) return doubling.delivered(doubling.fine());
  found.seconds = doubling.fine().seconds;
  const std::vector<std::string> notes = doubling.notes_of_failure();
  if (doubling.factor() > 1 && saves(problem, doubling.fine(), found, search)) {
    Result finer = doubling.delivered(doubling.fine());
    add_notes({notes.begin() + 1, notes.end()}, finer.notes);
    return finer;
  }
  if (search.monitor.interrupted()) {
    found.notes.emplace_back("there was no time to try more points");
    return found;
  }
  add_notes(notes, found.notes);
  return found;
}

}  // namespace leastcost
