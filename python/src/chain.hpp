// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

#include <leastcost/framework/energy/stopping.hpp>
#include "python/src/arrays.hpp"

namespace leastcost::python {

/// A chain of points that a solver written in Python improves: its energy, and the bookkeeping of the solve. All
/// functions but those of C++ are called with the GIL, and let go of it while they work. Points: one per row, the ends
/// of an open path among them, which stay where they are; shapes are checked by _register.py.
class Chain {
 public:
  Chain(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor);
  ~Chain() {
    const pybind11::gil_scoped_acquire gil;
    first_ = pybind11::reinterpret_steal<pybind11::array>(pybind11::handle());
  }
  Chain(const Chain&) = delete;
  Chain& operator=(const Chain&) = delete;

  pybind11::array points() const { return first_; }
  bool ring() const { return ring_; }

  /// Energy of these points, put onto the domain; infinite where they cannot be, or where the cost is.
  double value(const Numbers& rows);
  /// With its gradient along the domain; 0 at ends. Not finite where the energy is not.
  std::pair<double, pybind11::array> value_and_gradient(const Numbers& rows);
  /// The points moved by `steps` along the domain.
  pybind11::array retract(const Numbers& rows, const Numbers& steps);

  /// The points that the solver has returned; none: it was stopped. Without the GIL, as is finish().
  SolveReport finish(const std::optional<Points>& returned);
  /// Why the solver was stopped, if it was.
  const std::optional<Termination>& ended() const { return ended_; }
  /// Nothing can be asked any more.
  void close() { over_ = true; }

 private:
  /// Does `work` without the GIL; raises SearchEnded once the search must end. Throws InputError.
  template <class Work>
  void search(const Work& work);
  [[noreturn]] void stop();
  /// On the domain; nothing where a point has no place there.
  std::optional<CoordinatePath> path_of(const Points& columns);
  void keep(const CoordinatePath& path, double value);

  PathEnergy& energy_;
  CoordinatePath& path_;  ///< the best so far
  const Monitor& monitor_;
  SolveLoop loop_;
  pybind11::array first_;
  bool ring_;
  bool flat_;  ///< every point is on the domain
  double best_ = 0;
  std::optional<Termination> ended_;
  int stops_ = 0;  ///< how often SearchEnded was raised
  std::atomic<bool> over_ = false;
  std::mutex mutex_;
};

}  // namespace leastcost::python
