// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Robots as objects of Python, read as a configuration reads them.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/robots/robot.hpp>
#include "catalogue/config/load_config.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "problems/formula/coordinate_names.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bind.hpp"
#include "python/src/external.hpp"
#include "python/src/source.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

using Made = std::shared_ptr<const Robot>;

/// As a configuration with this block under `robot` makes it. Throws ConfigError, InputError.
Made read_robot(ConfigValue::Block block, const std::filesystem::path& folder) {
  const auto end = [](double x) { return ConfigValue::Block{{"point", ConfigValue::List{x}}}; };
  const ConfigValue::Block around = {{"manifold", "robot"},
                                     {"robot", std::move(block)},
                                     {"cost", "euclidean"},
                                     {"ends", ConfigValue::Block{{"source", end(0)}, {"target", end(1)}}}};
  LoadedConfig loaded = parse_config(around, "config", folder);
  if (!loaded.errors.empty()) throw ConfigError(loaded.errors);
  BuildContext context;
  context.folder = folder;
  try {
    return make<Made>(loaded.config.robot, context);
  } catch (const OptionError& error) {
    loaded.add_error(error.key(), error.reason());
    throw ConfigError(loaded.errors);
  }
}

class RobotObject {
 public:
  RobotObject(const py::dict& block, const std::filesystem::path& folder) {
    ConfigValue::Block plain = block_of(block);
    const py::gil_scoped_release released;
    robot_ = read_robot(std::move(plain), folder);
  }

  /// Name, lower and upper limit, largest velocity: the limits may be infinite.
  std::vector<std::tuple<std::string, double, double, double>> joints() const {
    const Kinematics& kinematics = *robot_->kinematics;
    const Eigen::VectorXd lower = kinematics.lower(), upper = kinematics.upper();
    const std::vector<std::string> names =
        robot_->joints.empty() ? coordinate_names(static_cast<int>(kinematics.dimension())) : robot_->joints;
    std::vector<std::tuple<std::string, double, double, double>> all;
    for (Eigen::Index i = 0; i < lower.size(); ++i)
      all.emplace_back(names[static_cast<std::size_t>(i)], lower[i], upper[i],
                       robot_->velocity.size() > 0 ? robot_->velocity[i] : std::numeric_limits<double>::infinity());
    return all;
  }

  std::vector<std::string> links() const { return frame_names(*robot_); }

  std::map<std::string, py::array> states() const {
    std::map<std::string, py::array> all;
    for (const auto& [name, x] : robot_->states) all.emplace(name, py::array_t<double>(x.size(), x.data()));
    return all;
  }

  /// The frame of a link, moved by an offset in it: (4, 4).
  py::array pose(const Numbers& q, const std::string& link, const std::array<double, 3>& offset) const {
    const NamedFrame frame = find_frame(*robot_, link);
    std::vector<Frame> links;
    robot_->kinematics->place(Eigen::Map<const Eigen::VectorXd>(q.data(), q.size()), links);
    const Frame& at = links[static_cast<std::size_t>(frame.link)];
    Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
    pose.topLeftCorner<3, 3>() = at.rotation * frame.place.rotation;
    pose.topRightCorner<3, 1>() = at.at(frame.place.at(Eigen::Vector3d(offset.data())));
    return rows_of(Eigen::MatrixXd(pose.transpose()));
  }

  int space() const { return robot_->kinematics->space(); }
  External external() const { return {robot_}; }

 private:
  Made robot_;
};

}  // namespace

void bind_robot(py::module_& module) {
  py::class_<RobotObject>(module, "Robot")
      .def(py::init<const py::dict&, const std::filesystem::path&>(), "block"_a, "folder"_a)
      .def("joints", &RobotObject::joints)
      .def("links", &RobotObject::links)
      .def("states", &RobotObject::states)
      .def("pose", &RobotObject::pose, "q"_a, "link"_a, "offset"_a)
      .def("space", &RobotObject::space)
      .def("external", &RobotObject::external);
}

}  // namespace leastcost::python
