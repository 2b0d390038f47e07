# What the consumer tests share. Every variable comes from tests/consumer/CMakeLists.txt.

function(run what)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${what} failed (${code}):\n${output}")
  endif()
  message("${what}: ok")
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(skip what why)
  message("${what}: left out, ${why}")
  file(APPEND ${SKIP_RECORD} "consumer_${KIND}\t${what}\t${why}\n")
endfunction()

# A consumer's flags: what strict projects switch on, as errors, in our headers too (-I, not -isystem).
set(strict -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror)
separate_arguments(compile UNIX_COMMAND "${CXX_FLAGS}")
set(compile ${CXX} -std=c++20 -g0 ${strict} ${compile})

function(configure_and_build source build)
  list(JOIN strict " " flags)
  run("configure ${build}" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${source} -B ${build} -D CMAKE_BUILD_TYPE=Debug
    -D CMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${CXX_FLAGS} ${flags} -g0" -D CMAKE_NO_SYSTEM_FROM_IMPORTED=ON
    ${ARGN})
  set(only "")
  if(targets)  # of the caller
    set(only --target ${targets})
  endif()
  run("build ${build}" ${CMAKE_COMMAND} --build ${build} ${only})
endfunction()

function(run_hello program)
  run("run ${program}" ${program})
  if(NOT output MATCHES "^certified: 3\\.14")
    message(FATAL_ERROR "hello found another path: ${output}")
  endif()
endfunction()

function(find_package_consumer prefix build)
  configure_and_build(${SOURCE_DIR}/examples/hello ${build} -D CMAKE_PREFIX_PATH=${prefix} ${ARGN})
  run_hello(${build}/hello)
endfunction()

# Gravity 4 in the place of 1: half the time.
function(catalogue_consumer prefix build)
  file(REMOVE_RECURSE ${SCRATCH}/slide)
  configure_and_build(${SOURCE_DIR}/examples/load_run ${build} -D CMAKE_PREFIX_PATH=${prefix} ${ARGN})
  run("run load_run" ${build}/load_run ${SOURCE_DIR}/examples/load_run/slide.yaml ${SCRATCH}/slide)
  if(NOT output MATCHES "^certified: 1\\.5708" OR NOT EXISTS ${SCRATCH}/slide/result.json)
    message(FATAL_ERROR "load_run found another path, or wrote nothing: ${output}")
  endif()
endfunction()

# The program with a cost and a solver of its own: a study of all cells that ends, and its report.
function(app_consumer prefix build)
  file(REMOVE_RECURSE ${SCRATCH}/compare_own)
  configure_and_build(${SOURCE_DIR}/examples/own_program ${build} -D CMAKE_PREFIX_PATH=${prefix} ${ARGN})
  run("describe" ${build}/own_program describe cost ray_time)
  run("run own_program" ${build}/own_program study ${SOURCE_DIR}/examples/own_program/compare.yaml
    -o ${SCRATCH}/compare_own)
  if(NOT output MATCHES "gauss_newton" OR NOT EXISTS ${SCRATCH}/compare_own/report.html)
    message(FATAL_ERROR "own_program compared nothing, or made no report: ${output}")
  endif()
endfunction()

# The libraries of others that are hidden from find_package: only Eigen is left.
set(without "")
foreach(package IN ITEMS Boost nanoflann NLopt Ceres ompl GDAL tinyxml2 yaml-cpp fmt OpenSSL PNG CLI11 nlohmann_json)
  list(APPEND without -D CMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()

# find_package(leastcost COMPONENTS mesh): the program on a mesh has the default methods and the proof, and is linked
# with nothing else. A program without the library of a method says which one it needs, and with that one it has the method.
function(components_consumer prefix build)
  configure_and_build(${SOURCE_DIR}/tests/consumer/components ${build} -D CMAKE_PREFIX_PATH=${prefix} ${without})
  run("run geodesic" ${build}/geodesic ${SOURCE_DIR}/configs/data/hill.obj)
  if(NOT output MATCHES "^global_on_polyhedron: 1\\.54")
    message(FATAL_ERROR "geodesic found another path, or no proof: ${output}")
  endif()
  foreach(library IN ITEMS core mesh bounds)
    run("run chosen_${library}" ${build}/chosen_${library})
    set(chosen_${library} "${output}")
  endforeach()
  if(NOT chosen_core MATCHES "are in the library leastcost::bounds: link it"
      OR NOT chosen_core MATCHES "uses dijkstra, a method of the library leastcost::mesh: link it")
    message(FATAL_ERROR "chosen_core does not name the libraries that it needs: ${chosen_core}")
  endif()
  if(NOT chosen_bounds MATCHES "proof over all paths: bracket" OR NOT chosen_mesh MATCHES "first path: dijkstra")
    message(FATAL_ERROR "linked, and not chosen: ${chosen_bounds}\n${chosen_mesh}")
  endif()
  nothing_linked(${build}/geodesic
    "boost::geometry|leastcost::(FreeSpace|TautPostProcessor|BracketPostProcessor)|YAML::|nlopt_|ceres::")
  nothing_linked(${build}/chosen_core "boost::geometry|leastcost::(MeshManifold|FreeSpace|BracketPostProcessor)|YAML::")
endfunction()

function(nothing_linked program names)
  find_program(nm nm)
  if(NOT nm)
    skip("symbols of programs" "no nm")
    return()
  endif()
  run("symbols of ${program}" ${nm} -C ${program})
  if(output MATCHES "${names}")
    message(FATAL_ERROR "${program} is linked with ${CMAKE_MATCH_0}")
  endif()
endfunction()

# pkg_config_consumer(PREFIX NEEDS.. PROGRAM object [ARGUMENTS ..] [NOT words]): links an object with the flags of .pc
# files, and runs it.
function(pkg_config_consumer prefix)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PROGRAM;NOT" "ARGUMENTS")
  find_program(pkg_config pkg-config)
  if(NOT pkg_config)
    skip("pkg-config consumer" "no pkg-config")
    return()
  endif()
  file(GLOB_RECURSE found ${prefix}/*/leastcost-problems.pc)
  cmake_path(GET found PARENT_PATH folder)
  set(ENV{PKG_CONFIG_PATH} ${folder})
  list(JOIN arg_UNPARSED_ARGUMENTS " " needs)
  run("pkg-config ${needs}" ${pkg_config} --libs ${arg_UNPARSED_ARGUMENTS})
  if(arg_NOT AND output MATCHES "${arg_NOT}")
    message(FATAL_ERROR "pkg-config ${needs} should not ask for ${CMAKE_MATCH_0}, and has: ${output}")
  endif()
  separate_arguments(flags UNIX_COMMAND "${output}")
  set(executable ${SCRATCH}/pkg_config)
  run("link with pkg-config" ${CXX} ${arg_PROGRAM} -o ${executable} ${flags} -Wl,-rpath,${folder}/..)
  run("run ${arg_PROGRAM}" ${executable} ${arg_ARGUMENTS})
  run("pkg-config" ${pkg_config} --exists "leastcost-framework = ${VERSION}")
  set(output "${output}" PARENT_SCOPE)
endfunction()

# What a component says of itself, declared here: no header is parsed.
function(pkg_config_versions prefix)
  set(with ${BACK_ENDS})
  if(WITH_OMPL)
    list(APPEND with ompl)
  endif()
  find_program(pkg_config pkg-config)
  if(NOT pkg_config)
    return()
  endif()
  foreach(name IN LISTS with)
    set(source ${SCRATCH}/${name}.cpp)
    file(WRITE ${source} "#include <string>\nnamespace leastcost {\nstd::string ${name}_version();\n}\n"
      "int main() { return leastcost::${name}_version().empty(); }\n")
    run("compile ${source}" ${compile} -c ${source} -o ${SCRATCH}/${name}.o)
    pkg_config_consumer(${prefix} leastcost-${name} PROGRAM ${SCRATCH}/${name}.o)
  endforeach()
  # The flags for headers.
  file(WRITE ${SCRATCH}/flags.cpp "#include <leastcost/eigen_alignment.hpp>\n#include <leastcost/version.hpp>\n")
  run("pkg-config --cflags" ${pkg_config} --cflags leastcost-core)
  separate_arguments(flags UNIX_COMMAND "${output}")
  run("compile with pkg-config" ${compile} -fsyntax-only ${SCRATCH}/flags.cpp ${flags})
endfunction()
