# Shared libraries: as a subdirectory, and as Debian packages unpacked into a scratch root, found there by CMake and
# pkg-config; the packages of this static build beside them. Without the tools of Debian the same after a plain
# installation.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/consumer.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/packages.cmake)

set(from_objects -D BUILD_SHARED_LIBS=ON -D LEASTCOST_OBJECTS=${BUILD_DIR})
configure_and_build(${SOURCE_DIR}/tests/consumer/subdirectory ${SCRATCH}/subdirectory
  -D LEASTCOST_SOURCE_DIR=${SOURCE_DIR} ${from_objects})
run_hello(${SCRATCH}/subdirectory/hello)

run("configure" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE_DIR} -B ${SCRATCH}/build ${from_objects}
  -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  -D LEASTCOST_BUILD_TESTS=OFF -D LEASTCOST_VIEWER=OFF)
run("build" ${CMAKE_COMMAND} --build ${SCRATCH}/build)

find_program(dpkg_deb dpkg-deb)
find_program(dpkg_shlibdeps dpkg-shlibdeps)
find_program(file_program file)
file(REMOVE_RECURSE ${SCRATCH}/unpacked)
if(dpkg_deb AND dpkg_shlibdeps AND file_program)
  make_packages(${SCRATCH}/build ${SCRATCH}/packages)
  check_packages(${SCRATCH}/packages shared)
  unpack_packages(${SCRATCH}/packages ${SCRATCH}/unpacked)
  make_packages(${BUILD_DIR} ${SCRATCH}/static_packages)
  check_packages(${SCRATCH}/static_packages static)
  file(REMOVE_RECURSE ${SCRATCH}/unpacked_static)
  unpack_packages(${SCRATCH}/static_packages ${SCRATCH}/unpacked_static)
  catalogue_consumer(${SCRATCH}/unpacked_static/usr ${SCRATCH}/catalogue_static)  # stands on all of them
  pkg_config_consumer(${SCRATCH}/unpacked_static/usr leastcost-catalogue
    PROGRAM ${SCRATCH}/catalogue_static/CMakeFiles/load_run.dir/main.cpp.o
    ARGUMENTS ${SOURCE_DIR}/examples/load_run/slide.yaml ${SCRATCH}/slide)  # and so do its flags for pkg-config
  app_consumer(${SCRATCH}/unpacked_static/usr ${SCRATCH}/app_static)
  run("the program of archives" ${SCRATCH}/unpacked_static/usr/bin/leastcost --version)
else()
  skip("Debian packages" "no dpkg-shlibdeps (package dpkg-dev) or no file")
  run("install" ${CMAKE_COMMAND} --install ${SCRATCH}/build --prefix ${SCRATCH}/unpacked/usr)
endif()

# Nothing but Eigen has to be found by who uses the shared libraries.
set(prefix ${SCRATCH}/unpacked/usr)
find_package_consumer(${prefix} ${SCRATCH}/hello ${without} -D CMAKE_EXE_LINKER_FLAGS=-Wl,--as-needed)
# The methods that find_path(problem) chooses are there, whatever hello itself needs.
function(needs_all_libraries program)
  run("libraries of ${program}" ldd ${program})
  if(NOT output MATCHES "libleastcost_bounds" OR NOT output MATCHES "libleastcost_planning")
    message(FATAL_ERROR "the linker has dropped libraries that offer methods: ${output}")
  endif()
endfunction()
needs_all_libraries(${SCRATCH}/hello/hello)
catalogue_consumer(${prefix} ${SCRATCH}/catalogue ${without})
app_consumer(${prefix} ${SCRATCH}/app ${without})
set(hello ${SCRATCH}/hello/CMakeFiles/hello.dir/main.cpp.o)
set(load_run ${SCRATCH}/catalogue/CMakeFiles/load_run.dir/main.cpp.o)
set(slide ARGUMENTS ${SOURCE_DIR}/examples/load_run/slide.yaml ${SCRATCH}/slide)
set(CXX ${CXX} -Wl,--as-needed)
pkg_config_consumer(${prefix} leastcost-problems leastcost-solvers PROGRAM ${hello})
needs_all_libraries(${SCRATCH}/pkg_config)
pkg_config_consumer(${prefix} leastcost-catalogue PROGRAM ${load_run} ${slide})
pkg_config_versions(${prefix})
run("the program" ${prefix}/bin/leastcost --version)
