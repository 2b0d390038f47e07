// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <Eigen/Core>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <leastcost/catalogue/run/run.hpp>
#include "python/src/call_errors.hpp"

namespace leastcost::python {

/// A finished run, or what pickle keeps of one: its numbers, not the objects that it was made of.
class Outcome {
 public:
  /// `functions`: of the run, with the costs in it that are written in Python.
  Outcome(RunOutcome run, std::shared_ptr<const CallErrors> functions)
      : run_(std::move(run)), functions_(std::move(functions)) {}
  /// Of state().
  explicit Outcome(pybind11::tuple state) : state_(std::move(state)) {}

  /// Throws OutputError where only numbers are left.
  const RunOutcome& run() const;
  pybind11::object points() const;
  pybind11::object curve() const;
  pybind11::object json() const;
  /// The quickest motion along the path: a dict of arrays and numbers. `limits`: a joint_limits.yaml of MoveIt, for
  /// what is not given; then come the limits of the robot's file. Throws InputError, OutputError.
  pybind11::dict trajectory(std::optional<Eigen::VectorXd> velocity, std::optional<Eigen::VectorXd> acceleration,
                            const std::optional<std::filesystem::path>& limits, double interval) const;
  /// Throws OutputError.
  std::filesystem::path write(const std::filesystem::path& folder, bool replace) const;
  /// (points, curve, json).
  pybind11::tuple state() const;

  /// For Python's garbage collector, which cannot see into the libraries: visits the functions of the costs, which may
  /// lead back to this result (tp_traverse), and lets go of them (tp_clear). No other object holds these costs.
  int traverse(visitproc visit, void* arg) const;
  void clear() const;

 private:
  std::optional<RunOutcome> run_;
  std::shared_ptr<const CallErrors> functions_;
  pybind11::tuple state_;  // without run_
};

}  // namespace leastcost::python
