// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

// What fuzzers and their replay ask of every reader: whatever the bytes are, it returns or throws an Error of the
// library. Anything else, a crash or a sanitizer's report included, is a finding.
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/obstacles/map_obstacles.hpp>
#include <leastcost/problems/obstacles/mesh_obstacle.hpp>
#include <leastcost/problems/obstacles/raster_obstacles.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include <leastcost/problems/readers/point_cloud_reader.hpp>
#include <leastcost/problems/readers/sdf_reader.hpp>
#include <leastcost/problems/readers/tensor_reader.hpp>
#include "app/report/page/json_file.hpp"
#include "app/report/run/run_files.hpp"
#include "app/study/grid/grid.hpp"
#include "app/study/rows/journal.hpp"
#include "app/study/rows/run_table.hpp"
#include "catalogue/config/load_config.hpp"
#include "catalogue/inputs/map_file.hpp"
#include "catalogue/pairs/pair_reader.hpp"
#include "catalogue/run/compose.hpp"
#include "catalogue/scene/scene.hpp"
#include "catalogue/yaml/diagnostics.hpp"
#include "catalogue/yaml/overrides.hpp"
#include "problems/formula/formula.hpp"
#include "problems/occupancy/free_mesh.hpp"
#include "problems/raster/raster_function.hpp"
#include "problems/readers/raster_reader.hpp"
#include "problems/readers/waypoint_reader.hpp"

namespace leastcost::fuzz {

/// A file with these bytes, for readers that take files. One per process and ending.
inline std::filesystem::path file_with(std::string_view bytes, const std::string& ending) {
  static const std::filesystem::path folder = [] {
    std::string name = (std::filesystem::temp_directory_path() / "leastcost-fuzz-XXXXXX").string();
    return std::filesystem::path(::mkdtemp(name.data()));
  }();
  std::filesystem::path file = folder / ("input" + ending);
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

/// Reads a mesh, and makes one of what was read: most of what can be wrong shows there.
inline void mesh(std::string_view bytes, const std::string& ending) {
  const TriangleMesh made(read_mesh(file_with(bytes, ending)));
}

/// A map as a domain and as obstacles, and what lies between them and a segment.
inline void map(std::string_view bytes, const std::string& ending) {
  OccupancyOptions options;
  const std::filesystem::path file = file_with(bytes, ending);
  if (ending == ".yaml") {  // the image that it names
    static const bool written = [&] {
      std::ofstream(file.parent_path() / "map.pgm") << "P2\n3 2\n255\n0 254 254\n254 254 0\n";
      return true;
    }();
    static_cast<void>(written);
  }
  options.file = file.filename().string();
  const OccupancyGrid grid = read_map(options, file.parent_path());
  const TriangleMesh made(free_mesh(grid, free_boxes(grid)).triangles);
  double t = 0;
  for (const auto& obstacle : map_obstacles(grid))
    obstacle->distance_of_segment(Eigen::Vector2d(-1, 0.5), Eigen::Vector2d(4, 1), t);
}

/// A mesh of which only its faces are in the way, and one whose inside is.
inline void mesh_obstacle(std::string_view bytes) {
  const TriangleMesh made(read_mesh(file_with(bytes, ".obj")));
  for (const MeshInside inside : {MeshInside::surface, MeshInside::closed, MeshInside::solid}) {
    const auto obstacle = make_mesh_obstacle(made, inside, 0.1);
    Eigen::VectorXd away(3);
    double t = 0;
    obstacle->distance(Eigen::Vector3d(0.2, 0.2, 0.2), away);
    obstacle->distance_of_segment(Eigen::Vector3d(-1, 0.1, 0.2), Eigen::Vector3d(1, 0.3, 0.1), t);
  }
}

/// A raster as a terrain, a cost map and obstacles.
inline void raster(RasterFile file) {
  const RasterGrid grid = placed(std::move(file), {});
  const auto look = [&grid](const RasterFunction& f) {
    const Eigen::Vector2d from = grid.place(0, 0), to = grid.place(grid.rows - 1, grid.columns - 1);
    f.at(from[0], from[1]);
    f.at(0.3 * from[0] + 0.7 * to[0], 0.7 * from[1] + 0.3 * to[1]);
    f.patches().cut<double>({0, 0}, f.patches().in_cells(to[0], to[1]),
                            [&f](const RasterPatch& patch, double, double) { f.bounds(patch); });
  };
  look(BilinearFunction(grid));
  look(SplineFunction::near(grid));
  look(SplineFunction::through(grid));
  make_raster_obstacles(grid, {});
}

/// A configuration with what its last line puts in: the option after `--set`.
inline void override_of(std::string_view bytes) {
  Diagnostics errors("fuzz.yaml", "");
  ConfigNode root;
  apply_overrides({set_option(std::string(bytes))}, root, errors);
  errors.render();
}

inline void configuration(std::string_view bytes) {
  LoadedConfig loaded = parse_config(std::string(bytes), "fuzz.yaml", "/nonexistent");
  if (loaded.errors.empty()) check_parts(loaded);
  loaded.errors.render();
}

inline void study(std::string_view bytes) {
  app::LoadedStudy loaded = app::parse_study(std::string(bytes), "fuzz.yaml", "/nonexistent");
  loaded.errors.render();
}

inline void formula(std::string_view bytes) {
  const Formula f(bytes, {"x", "y"}, {{"a", 2}});
  const std::array<double, 2> at = {0.3, -1.5};
  f.operator()<double>(at);
}

inline void csv(std::string_view bytes) {
  const std::string text(bytes);
  try {
    app::read_runs_csv(text, "runs.csv");
  } catch (const Error&) {
  }
  try {
    app::read_traces_csv(text, "traces.csv");
  } catch (const Error&) {
  }
  const app::NumberTable table(file_with(bytes, ".csv"));
}

inline void json(std::string_view bytes) {
  try {
    read_scene(bytes, "scene.json");
  } catch (const Error&) {
  }
  const app::JsonFile file(file_with(bytes, ".json"));
  for (const std::string key : {"a", "a.b", "status", "failures"}) {
    try {
      static_cast<void>(file.number(key));
    } catch (const Error&) {
    }
    try {
      static_cast<void>(file.objects(key));
    } catch (const Error&) {
    }
  }
}

struct Target {
  std::string name;  ///< of its corpus, too
  void (*read)(std::string_view bytes);
};

inline const std::vector<Target>& targets() {
  static const std::vector<Target> all = {
      {"obj", [](std::string_view b) { mesh(b, ".obj"); }},
      {"off", [](std::string_view b) { mesh(b, ".off"); }},
      {"ply", [](std::string_view b) { mesh(b, ".ply"); }},
      {"stl", [](std::string_view b) { mesh(b, ".stl"); }},
      {"mesh_obstacle", mesh_obstacle},
      {"moving_ai", [](std::string_view b) { map(b, ".map"); }},
      {"pgm", [](std::string_view b) { map(b, ".pgm"); }},
      {"png", [](std::string_view b) { map(b, ".png"); }},
      {"map_server", [](std::string_view b) { map(b, ".yaml"); }},
      {"xyz", [](std::string_view b) { read_point_cloud(file_with(b, ".xyz")); }},
      {"cloud_ply", [](std::string_view b) { read_point_cloud(file_with(b, ".ply")); }},
      {"esri_grid", [](std::string_view b) { raster(read_esri_grid(b, "fuzz.asc")); }},
      {"csv_raster", [](std::string_view b) { raster(read_csv_raster(b, "fuzz.csv")); }},
      {"sdf", [](std::string_view b) { read_sdf(b, "fuzz.sdf", 1e8); }},
      {"tensors", [](std::string_view b) { read_tensors(file_with(b, ".txt")); }},
      {"waypoints",
       [](std::string_view b) {
         read_waypoints(file_with(b, ".csv"), {"x", "y", "z"});
       }},
      {"pairs",
       [](std::string_view b) {
         PairReader reader(file_with(b, ".csv"), {"x", "y"}, true);
         while (reader.next()) {
         }
       }},
      {"configuration", configuration},
      {"override", override_of},
      {"study", study},
      {"formula", formula},
      {"journal", [](std::string_view b) { app::read_journal(file_with(b, ".jsonl")); }},
      {"csv", csv},
      {"json", json},
  };
  return all;
}

/// Runs a target; an Error of the library is an answer.
inline void ask(const Target& target, std::string_view bytes) {
  try {
    target.read(bytes);
  } catch (const Error&) {
  }
}

}  // namespace leastcost::fuzz
