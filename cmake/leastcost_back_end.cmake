# A solver that stands on a third-party library. The folder solvers/<name>/ is a component of its own:
#
#   leastcost_back_end(nlopt CLASS Nlopt LIBRARY NLopt VERSION 2.7 TARGET NLopt::nlopt
#     DEBIAN libnlopt-cxx-dev LINKS " -lnlopt" SUMMARY "..")
#
# <name>_solver.hpp declares CLASS, its options CLASSOptions and `std::string <name>_version()`. Where LIBRARY (the
# CMake package) is not found, or LEASTCOST_WITH_<NAME> is off, the registry says which Debian package it comes in.
# LOADED: as a module, see leastcost_back_end_module(); its options and its version are then in a source of their own.
function(leastcost_back_end name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "LOADED" "CLASS;LIBRARY;VERSION;TARGET;DEBIAN;SUMMARY" "LINKS")
  string(TOUPPER LEASTCOST_WITH_${name} wanted)
  option(${wanted} "Build the ${arg_LIBRARY} solvers where ${arg_LIBRARY} is found" ON)
  if(${wanted})
    find_package(${arg_LIBRARY} ${arg_VERSION} QUIET NO_MODULE)
  endif()
  set_property(GLOBAL APPEND PROPERTY LEASTCOST_BACK_ENDS ${name})
  if(NOT ${arg_LIBRARY}_FOUND)
    set_property(GLOBAL APPEND_STRING PROPERTY LEASTCOST_BACK_END_ENTRIES
      "      absent(\"${name}\", \"${arg_SUMMARY}\", \"${arg_DEBIAN}\"),\n")
    return()
  endif()
  leastcost_library(${name} NEEDS solvers FINDS "${arg_LIBRARY} ${arg_VERSION}" PUBLIC ${name}_solver.hpp
    LINKS "${arg_LINKS}")
  target_link_libraries(leastcost_${name} PRIVATE ${arg_TARGET})
  set_property(GLOBAL APPEND PROPERTY LEASTCOST_BUILT_BACK_ENDS ${name})
  set_property(GLOBAL APPEND_STRING PROPERTY LEASTCOST_BACK_END_INCLUDES
    "#include <leastcost/solvers/${name}/${name}_solver.hpp>\n")
  set(made "made_of<SolverPlugin, ${arg_CLASS}, ${arg_CLASS}Options>(\"${name}\", \"${arg_SUMMARY}\")")
  if(arg_LOADED)
    leastcost_back_end_module(${name} LIBRARY ${arg_LIBRARY} CLASS ${arg_CLASS} OPTIONS ${arg_CLASS}Options
      HEADER leastcost/solvers/${name}/${name}_solver.hpp ARGUMENTS options)
    set(made "plugin<SolverPlugin, ${arg_CLASS}Options>(\"${name}\", \"${arg_SUMMARY}\",
                  [](const ${arg_CLASS}Options& o, const BuildContext& c) { return make_${name}(o, c.seed); })")
  endif()
  set_property(GLOBAL APPEND_STRING PROPERTY LEASTCOST_BACK_END_ENTRIES
    "      present(${made},\n              \"${arg_LIBRARY} \" + ${name}_version()),\n")
endfunction()

# A back end whose shared libraries take long to load is loaded when it is first asked for, by our program and by the
# Python package: each is linked with leastcost_loaded_back_ends, a registration that takes it from a module, and not
# with the back end. Programs of others are linked with the back end itself. So are ours where libraries are shared, and
# under sanitizers, which look for modules in other folders.
#
#   leastcost_back_end_module(ceres LIBRARY Ceres HEADER leastcost/.. CLASS Ceres OPTIONS CeresOptions ARGUMENTS options)
#
# ARGUMENTS of the constructor: of `options` and `seed`. Registrations call make_<name>(options, seed).
function(leastcost_back_end_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LIBRARY;HEADER;CLASS;OPTIONS;ARGUMENTS" "")
  set(file leastcost_${name}_${PROJECT_VERSION}.so)  # that of another version might have other classes
  set_property(GLOBAL APPEND_STRING PROPERTY LEASTCOST_BACK_END_MAKERS "
std::shared_ptr<const ${arg_CLASS}> make_${name}(const ${arg_OPTIONS}& options, [[maybe_unused]] int seed) {
#ifdef LEASTCOST_LOADS_BACK_ENDS
  return made_by_module<${arg_CLASS}>(\"${arg_LIBRARY}\", \"${file}\", options, seed);
#else
  return std::make_shared<const ${arg_CLASS}>(${arg_ARGUMENTS});
#endif
}
")
  if(BUILD_SHARED_LIBS OR NOT UNIX OR LEASTCOST_OBJECTS OR CMAKE_CXX_FLAGS MATCHES "-fsanitize"
      OR NOT LEASTCOST_BUILD_APP)
    return()
  endif()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}_module.cpp)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT "// Made by cmake/leastcost_back_end.cmake.
#include <memory>

#include <@arg_HEADER@>

using namespace leastcost;

extern \"C\" __attribute__((visibility(\"default\"))) void leastcost_make_back_end(
    const void* given, [[maybe_unused]] int seed, void* made) {
  const auto& options = *static_cast<const @arg_OPTIONS@*>(given);
  *static_cast<std::shared_ptr<const @arg_CLASS@>*>(made) = std::make_shared<const @arg_CLASS@>(@arg_ARGUMENTS@);
}
")
  set(module leastcost_${name}_module)
  add_library(${module} MODULE ${source})
  target_link_libraries(${module} PRIVATE leastcost::${name})
  target_link_options(${module} PRIVATE LINKER:--exclude-libs,ALL)  # nothing of it meets what others have loaded
  leastcost_warnings(${module})
  set_target_properties(${module} PROPERTIES PREFIX "" SUFFIX "" OUTPUT_NAME ${file}
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib/leastcost CXX_VISIBILITY_PRESET hidden UNITY_BUILD OFF)
  set_property(GLOBAL APPEND PROPERTY LEASTCOST_BACK_END_MODULES ${module})
endfunction()

# Links our program, or the Python module, with back ends that are loaded. `folders`: where it looks for them in the
# build folder, from its own.
function(leastcost_load_back_ends target folders)
  get_property(modules GLOBAL PROPERTY LEASTCOST_BACK_END_MODULES)
  if(NOT modules)
    return()
  endif()
  target_link_libraries(${target} PRIVATE leastcost_loaded_back_ends)
  target_link_options(${target} PRIVATE LINKER:--as-needed)  # the libraries of the back ends
  list(TRANSFORM folders PREPEND "\$ORIGIN")
  set_property(TARGET ${target} APPEND PROPERTY BUILD_RPATH ${folders})
  add_dependencies(${target} ${modules})
endfunction()

# The registration of all of them, as a source file.
function(leastcost_back_end_source file)
  get_property(makers GLOBAL PROPERTY LEASTCOST_BACK_END_MAKERS)
  get_property(includes GLOBAL PROPERTY LEASTCOST_BACK_END_INCLUDES)
  get_property(entries GLOBAL PROPERTY LEASTCOST_BACK_END_ENTRIES)
  get_property(planners GLOBAL PROPERTY LEASTCOST_PLANNER_ENTRIES)
  get_property(robots GLOBAL PROPERTY LEASTCOST_ROBOT_ENTRIES)
  get_property(obstacles GLOBAL PROPERTY LEASTCOST_OBSTACLE_ENTRIES)
  get_property(raster_reader GLOBAL PROPERTY LEASTCOST_RASTER_READER)
  get_property(crs_reader GLOBAL PROPERTY LEASTCOST_CRS_READER)
  get_property(geopackage_writer GLOBAL PROPERTY LEASTCOST_GEOPACKAGE_WRITER)
  get_property(geotiff_writer GLOBAL PROPERTY LEASTCOST_GEOTIFF_WRITER)
  file(CONFIGURE OUTPUT ${file} @ONLY CONTENT "// Made by cmake/leastcost_back_end.cmake from solvers/*/CMakeLists.txt, ompl, gdal, urdf and octomap.
#include \"catalogue/back_ends/back_ends.hpp\"
#include \"catalogue/back_ends/load_back_end.hpp\"

@includes@
namespace leastcost {
namespace {
@makers@
}  // namespace
}  // namespace leastcost

std::vector<leastcost::SolverPlugin> leastcost::back_ends() {
  return {
@entries@  };
}

std::vector<leastcost::InitializerPlugin> leastcost::planners() {
  return {
@planners@  };
}

std::vector<leastcost::RobotPlugin> leastcost::robots_of_libraries() {
  return {
@robots@  };
}

std::vector<leastcost::ObstaclePlugin> leastcost::obstacles_of_libraries() {
  return {
@obstacles@  };
}

leastcost::RasterReader leastcost::raster_reader_of_libraries() { return @raster_reader@; }

leastcost::CrsReader leastcost::crs_reader_of_libraries() { return @crs_reader@; }

leastcost::GeoPackageWriter leastcost::geopackage_writer_of_libraries() { return @geopackage_writer@; }

leastcost::GeoTiffWriter leastcost::geotiff_writer_of_libraries() { return @geotiff_writer@; }
")
endfunction()
