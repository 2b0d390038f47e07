// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/catalogue/pairs/solve_pairs.hpp>
#include "python/src/arrays.hpp"
#include "python/src/bind.hpp"
#include "python/src/ends.hpp"
#include "python/src/signals.hpp"
#include "python/src/source.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

py::dict dict_of(const PairResult& pair) {
  return py::dict(
      "outcome"_a = pair.outcome, "message"_a = pair.message, "cost"_a = pair.cost, "error"_a = pair.error,
      "lower_bound"_a = pair.lower_bound,
      "scope"_a = pair.scope ? py::object(py::str(std::string(word_of(*pair.scope)))) : py::object(py::none()),
      "failures"_a = pair.failures, "notes"_a = pair.notes, "points"_a = rows_of(pair.points),
      "seconds"_a = pair.seconds);
}

/// One dict per pair, in their order. `ends`: none for those of the file that the configuration names.
py::list pairs(const Source& source, const std::optional<py::list>& ends, int threads, bool points) {
  std::vector<EndPair> given;
  for (const py::handle& pair : ends.value_or(py::list()))
    given.push_back({end_of(pair.cast<py::tuple>()[0]), end_of(pair.cast<py::tuple>()[1])});
  Signals signals;
  const auto errors = std::make_shared<CallErrors>();
  std::vector<PairResult> results;
  try {
    const py::gil_scoped_release released;
    std::atomic<bool> stop = false;
    // The search asks from several threads whether to stop, and signals are heard in this one.
    std::future<void> work = std::async(std::launch::async, [&] {
      const Run run = source.read({}, errors);
      const PairsOptions options{
          .threads = threads, .points = points, .stop_requested = [&] { return stop || errors->any(); }};
      const PairDone done = [&](PairResult result) { results.push_back(std::move(result)); };
      if (ends)
        solve_pairs(run, given, done, options);
      else
        solve_pairs(run, done, options);
    });
    while (work.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready) stop = stop || signals.stop();
    work.get();
  } catch (const std::exception&) {
    signals.raise();
    errors->raise();
    throw;
  }
  errors->raise();
  errors->end();
  signals.raise();
  py::list out;
  for (const PairResult& result : results) out.append(dict_of(result));
  return out;
}

}  // namespace

void bind_pairs(py::module_& module) { module.def("pairs", &pairs, "source"_a, "ends"_a, "threads"_a, "points"_a); }

}  // namespace leastcost::python
