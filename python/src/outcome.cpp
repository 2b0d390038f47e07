// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "python/src/outcome.hpp"

#include <pybind11/stl.h>

#include <leastcost/catalogue/output/write_run.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/robots/robot_trajectory.hpp>
#include "catalogue/inputs/joint_limits.hpp"
#include "problems/formula/coordinate_names.hpp"
#include "python/src/arrays.hpp"
#include "python/src/python_cost.hpp"

namespace leastcost::python {

namespace py = pybind11;

const RunOutcome& Outcome::run() const {
  if (!run_)
    throw OutputError(
        "a result that was pickled has no files, no picture and no trajectory any more: make them before");
  return *run_;
}

py::object Outcome::points() const { return run_ ? rows_of(run_->result.path.u) : py::object(state_[0]); }

py::object Outcome::curve() const { return run_ ? rows_of(run_->result.curve.x) : py::object(state_[1]); }

py::object Outcome::json() const { return run_ ? py::str(result_json(*run_)) : py::object(state_[2]); }

py::dict Outcome::trajectory(std::optional<Eigen::VectorXd> velocity, std::optional<Eigen::VectorXd> acceleration,
                             const std::optional<std::filesystem::path>& limits, double interval) const {
  using namespace py::literals;
  const RunOutcome& outcome = run();
  const Robot* robot = outcome.parts.robot.get();
  TrajectoryOptions options;
  options.velocity = std::move(velocity);
  options.acceleration = std::move(acceleration);
  options.interval = interval;
  Trajectory motion;
  std::vector<std::string> notes;
  try {
    const py::gil_scoped_release released;
    if (limits) {
      if (robot == nullptr) throw OptionError("limits", "has limits of joints, but there is no robot");
      options = with_joint_limits(*limits, *robot, std::move(options),
                                  [&](std::string note) { notes.push_back(std::move(note)); });
    }
    if (robot != nullptr) options = with_limits_of(*robot, std::move(options));
    motion = make_trajectory(outcome.parts.problem, outcome.result, options);
  } catch (const OptionError& error) {
    throw InputError(error.what());
  }
  const std::vector<std::string> names =
      robot != nullptr && !robot->joints.empty() ? robot->joints : space_coordinates(*outcome.parts.problem.manifold);
  return py::dict("names"_a = names, "times"_a = py::array_t<double>(motion.time.size(), motion.time.data()),
                  "positions"_a = rows_of(motion.x), "velocities"_a = rows_of(motion.velocity),
                  "accelerations"_a = rows_of(motion.acceleration), "duration"_a = motion.duration,
                  "least_duration"_a = motion.least_duration, "deviation"_a = motion.deviation,
                  "touches"_a = motion.touches, "notes"_a = notes);
}

std::filesystem::path Outcome::write(const std::filesystem::path& folder, bool replace) const {
  const RunOutcome& outcome = run();
  const py::gil_scoped_release released;
  return write_run(outcome, folder, {.replace = replace});
}

py::tuple Outcome::state() const { return py::make_tuple(points(), curve(), json()); }

int Outcome::traverse(visitproc visit, void* arg) const {
  Py_VISIT(state_.ptr());
  if (functions_ == nullptr) return 0;
  for (const auto& held : functions_->costs())
    if (const auto cost = held.lock())
      if (const int stop = cost->traverse(visit, arg); stop != 0) return stop;
  return 0;
}

void Outcome::clear() const {
  if (functions_ == nullptr) return;
  for (const auto& held : functions_->costs())
    if (const auto cost = held.lock()) cost->clear();
}

}  // namespace leastcost::python
