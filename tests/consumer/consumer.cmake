# Builds and runs the examples as a stranger would (compare_solvers where this build has both back ends,
# load_run where it has the catalogue). KIND:
#   installed            this build is installed into SCRATCH/prefix; find_package, then pkg-config
#   subdirectory_shared  add_subdirectory with shared libraries; then that build is installed, and found
# Every variable comes from tests/consumer/CMakeLists.txt.
cmake_minimum_required(VERSION 3.25)

function(run what)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${what} failed (${code}):\n${output}")
  endif()
  message("${what}: ok")
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(configure_and_build source build)
  run("configure ${build}" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${source} -B ${build}
    -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS=${CXX_FLAGS} -g0" ${ARGN})
  cmake_host_system_information(RESULT jobs QUERY NUMBER_OF_LOGICAL_CORES)
  run("build ${build}" ${CMAKE_COMMAND} --build ${build} -j ${jobs})
endfunction()

function(run_hello program)
  run("run ${program}" ${program})
  if(NOT output MATCHES "^certified: 3\\.14")
    message(FATAL_ERROR "hello found another path: ${output}")
  endif()
endfunction()

function(find_package_consumer prefix build)
  configure_and_build(${SOURCE_DIR}/examples/hello ${build} -D CMAKE_PREFIX_PATH=${prefix})
  run_hello(${build}/hello)
endfunction()

# Gravity 4 in the place of 1: half the time.
function(run_load_run program)
  run("run ${program}" ${program} ${SOURCE_DIR}/examples/load_run/slide.yaml ${SCRATCH}/slide)
  if(NOT output MATCHES "^certified: 1\\.5708" OR NOT EXISTS ${SCRATCH}/slide/result.json)
    message(FATAL_ERROR "load_run found another path, or wrote nothing: ${output}")
  endif()
endfunction()

# A component that was not installed is reported, not ignored.
function(unknown_component_is_refused prefix)
  file(WRITE ${SCRATCH}/unknown/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)\nproject(unknown LANGUAGES CXX)
find_package(leastcost COMPONENTS framework teleport)
if(leastcost_FOUND)\n  message(FATAL_ERROR \"found without teleport\")\nendif()\n")
  run("find_package of an unknown component" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SCRATCH}/unknown
    -B ${SCRATCH}/unknown/build -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_PREFIX_PATH=${prefix})
endfunction()

function(pkg_config_consumer prefix)
  find_program(pkg_config pkg-config)
  if(NOT pkg_config)
    message("pkg-config consumer: left out, no pkg-config")
    return()
  endif()
  file(GLOB_RECURSE found ${prefix}/*/leastcost-problems.pc)
  cmake_path(GET found PARENT_PATH folder)
  set(ENV{PKG_CONFIG_PATH} ${folder})
  run("pkg-config" ${pkg_config} --cflags --libs leastcost-problems leastcost-solvers)
  separate_arguments(flags UNIX_COMMAND "${CXX_FLAGS} ${output}")
  run("compile with pkg-config" ${CXX} -std=c++20 ${SOURCE_DIR}/examples/hello/main.cpp -o ${SCRATCH}/hello_pkg_config
    ${flags})
  run_hello(${SCRATCH}/hello_pkg_config)
endfunction()

set(prefix ${SCRATCH}/prefix)
file(REMOVE_RECURSE ${prefix})
if(KIND STREQUAL installed)
  run("install" ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})
  find_package_consumer(${prefix} ${SCRATCH}/found)
  if(BACK_ENDS)
    configure_and_build(${SOURCE_DIR}/examples/compare_solvers ${SCRATCH}/compare -D CMAKE_PREFIX_PATH=${prefix})
    run("run compare_solvers" ${SCRATCH}/compare/compare_solvers)
  endif()
  if(CATALOGUE)
    configure_and_build(${SOURCE_DIR}/examples/load_run ${SCRATCH}/load_run -D CMAKE_PREFIX_PATH=${prefix})
    run_load_run(${SCRATCH}/load_run/load_run)
  endif()
  unknown_component_is_refused(${prefix})
  pkg_config_consumer(${prefix})
else()
  configure_and_build(${SOURCE_DIR}/tests/consumer/subdirectory ${SCRATCH}/subdirectory
    -D LEASTCOST_SOURCE_DIR=${SOURCE_DIR} -D BUILD_SHARED_LIBS=ON -D LEASTCOST_INSTALL=ON)
  run_hello(${SCRATCH}/subdirectory/hello)
  run("install" ${CMAKE_COMMAND} --install ${SCRATCH}/subdirectory --prefix ${prefix})
  find_package_consumer(${prefix} ${SCRATCH}/found)
endif()
