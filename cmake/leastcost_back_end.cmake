# A solver that stands on a third-party library. The folder solvers/<name>/ is a component of its own:
#
#   leastcost_back_end(nlopt CLASS Nlopt LIBRARY NLopt VERSION 2.7 TARGET NLopt::nlopt
#     DEBIAN libnlopt-cxx-dev LINKS " -lnlopt" SUMMARY "..")
#
# <name>_solver.hpp declares CLASS, its options CLASSOptions and `std::string <name>_version()`. Where LIBRARY (the
# CMake package) is not found, or LEASTCOST_WITH_<NAME> is off, the registry says which Debian package it comes in.
function(leastcost_back_end name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "CLASS;LIBRARY;VERSION;TARGET;DEBIAN;SUMMARY" "LINKS")
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
  set_property(GLOBAL APPEND_STRING PROPERTY LEASTCOST_BACK_END_ENTRIES
    "      present(${made},\n              \"${arg_LIBRARY} \" + ${name}_version()),\n")
endfunction()

# The registration of all of them, as a source file.
function(leastcost_back_end_source file)
  get_property(includes GLOBAL PROPERTY LEASTCOST_BACK_END_INCLUDES)
  get_property(entries GLOBAL PROPERTY LEASTCOST_BACK_END_ENTRIES)
  get_property(planners GLOBAL PROPERTY LEASTCOST_PLANNER_ENTRIES)
  get_property(robots GLOBAL PROPERTY LEASTCOST_ROBOT_ENTRIES)
  get_property(obstacles GLOBAL PROPERTY LEASTCOST_OBSTACLE_ENTRIES)
  get_property(raster_reader GLOBAL PROPERTY LEASTCOST_RASTER_READER)
  get_property(crs_reader GLOBAL PROPERTY LEASTCOST_CRS_READER)
  get_property(geopackage_writer GLOBAL PROPERTY LEASTCOST_GEOPACKAGE_WRITER)
  file(CONFIGURE OUTPUT ${file} @ONLY CONTENT "// Made by cmake/leastcost_back_end.cmake from solvers/*/CMakeLists.txt, ompl, gdal, urdf and octomap.
#include \"catalogue/back_ends/back_ends.hpp\"

@includes@
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
")
endfunction()
