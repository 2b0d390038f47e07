# One rule for the libraries: every .cpp of the folder is part of it, so that a plug-in is its source file alone.
#
#   leastcost_library(gdal NEEDS core FINDS "GDAL 3.4" LINKS " -lgdal")
#   leastcost_library(ceres NEEDS solvers FINDS "Ceres 2.1" PUBLIC ceres_solver.hpp LINKS " -lceres -lglog")
#   leastcost_library(solvers NEEDS framework EXCEPT nlopt ceres)
#
# PUBLIC: the header from which all public ones are reached; default: <name>.hpp. Only these are installed.
# NEEDS: components whose targets appear in our headers (they are linked and exported with the target).
# EXCEPT: folders, and files without their ending, that are not part of it. ONLY: those that are, and no others. ALSO:
#   those that are, beside the folder.
# OFFERS: a symbol of the library that every program has to be linked with, also where none of its own objects asks for
#   it (recipes/offers).
# LINKS: of a static build, for pkg-config.
# FINDS: packages that a consumer has to find as well, the private ones of a static build included.
# PRECOMPILES: headers that it precompiles for itself; PRECOMPILED_BY: the library whose precompiled headers it takes;
#   default: numbers.
include(GNUInstallDirs)
include(${CMAKE_CURRENT_LIST_DIR}/leastcost_alignment.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/leastcost_objects.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/leastcost_unity.cmake)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)

# <leastcost/...> in the tree, as it will be installed: <leastcost/framework/path/path.hpp> is framework/path/path.hpp.
set(LEASTCOST_INCLUDE_DIR ${PROJECT_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${LEASTCOST_INCLUDE_DIR}/leastcost)
foreach(folder IN ITEMS framework problems solvers recipes ompl gdal urdf octomap catalogue app)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${LEASTCOST_INCLUDE_DIR}/leastcost/${folder} SYMBOLIC)
endforeach()
leastcost_alignment()
foreach(header IN ITEMS leastcost.hpp version.hpp eigen_alignment.hpp)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${header}.in ${LEASTCOST_INCLUDE_DIR}/leastcost/${header} @ONLY)
endforeach()

# What is part of the project may also include internal headers, "framework/...", from the root of the tree.
function(leastcost_internal target)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
endfunction()

function(leastcost_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)  # false alarms inside Eigen (GCC 12)
  elseif(CMAKE_UNITY_BUILD)
    target_compile_options(${target} PRIVATE -Wno-shadow)  # Clang also means names of other sources of the unit
  endif()
  if(LEASTCOST_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# Nothing reads errno after a function of <cmath>, or floating-point flags: roots in line, a tenth of a proof's time.
function(leastcost_arithmetic target)
  target_compile_options(${target} PRIVATE -fno-math-errno -fno-trapping-math)
endfunction()

# Sets `result` to the sources in folders and to files named without their ending, each relative to this folder.
function(leastcost_parts result)
  set(sources "")
  foreach(part IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH part BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    string(REGEX REPLACE "/$" "" part ${part})
    if(IS_DIRECTORY ${part})
      file(GLOB_RECURSE found CONFIGURE_DEPENDS ${part}/*.cpp ${part}/*.hpp)
    else()
      file(GLOB found CONFIGURE_DEPENDS ${part}.cpp ${part}.hpp)
    endif()
    if(NOT found)
      message(FATAL_ERROR "There are no sources ${part}: remove it from ${CMAKE_CURRENT_LIST_FILE}")
    endif()
    list(APPEND sources ${found})
  endforeach()
  set(${result} ${sources} PARENT_SCOPE)
endfunction()

function(leastcost_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PUBLIC;OFFERS;PRECOMPILED_BY"
    "NEEDS;FINDS;EXCEPT;ONLY;ALSO;LINKS;PRECOMPILES")
  set(target leastcost_${name})
  if(NOT arg_ONLY)
    set(arg_ONLY .)
  endif()
  leastcost_parts(sources ${arg_ONLY} ${arg_ALSO})
  leastcost_parts(others ${arg_EXCEPT})
  list(REMOVE_ITEM sources ${others})
  if(NOT arg_PUBLIC)
    set(arg_PUBLIC ${name}.hpp)
  endif()
  leastcost_sources(sources ${sources})
  add_library(${target} ${sources})
  leastcost_link_objects(${target})  # before what they need: some linkers drop libraries that nothing before them needs
  add_library(leastcost::${name} ALIAS ${target})

  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${LEASTCOST_INCLUDE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  leastcost_internal(${target})
  leastcost_arithmetic(${target})
  target_link_libraries(${target} PUBLIC Eigen3::Eigen)
  foreach(need IN LISTS arg_NEEDS)
    target_link_libraries(${target} PUBLIC leastcost::${need})
  endforeach()
  if(arg_OFFERS)
    target_link_options(${target} INTERFACE LINKER:-u,${arg_OFFERS})
    if(BUILD_SHARED_LIBS)  # some compilers ask the linker to drop libraries that no object needs
      target_link_options(${target} INTERFACE LINKER:--no-as-needed)
    endif()
  endif()
  if(BUILD_SHARED_LIBS AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    target_link_options(${target} PRIVATE LINKER:--no-undefined)  # a layer that calls upwards must not link
  endif()
  if(BUILD_SHARED_LIBS)  # another library may hold functions of Eigen that were compiled from another version of it
    target_link_options(${target} PRIVATE LINKER:--version-script=${PROJECT_SOURCE_DIR}/cmake/hide_eigen.map)
    set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/hide_eigen.map)
  endif()

  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name}
    LINKER_LANGUAGE CXX
    DEFINE_SYMBOL ""
    POSITION_INDEPENDENT_CODE ON
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}
    INSTALL_RPATH "$ORIGIN"
    LEASTCOST_PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}/${arg_PUBLIC}"
    LEASTCOST_OFFERS "${arg_OFFERS}"
    LEASTCOST_LINKS "${arg_LINKS}"
    LEASTCOST_NEEDS "${arg_NEEDS}"
    LEASTCOST_FINDS "${arg_FINDS}")
  leastcost_warnings(${target})
  leastcost_unity(${target})
  # One precompiled header for nearly all: parsing Eigen is a third of the compile time. CI also compiles without it.
  if(name STREQUAL "numbers")
    set(arg_PRECOMPILES
      <Eigen/Core> <algorithm> <array> <cmath> <functional> <limits> <memory> <optional> <span> <string> <vector>)
  elseif(NOT arg_PRECOMPILED_BY)
    set(arg_PRECOMPILED_BY numbers)
  endif()
  if(arg_PRECOMPILES)
    target_precompile_headers(${target} PRIVATE ${arg_PRECOMPILES})
  else()
    target_precompile_headers(${target} REUSE_FROM leastcost_${arg_PRECOMPILED_BY})
  endif()
  set_property(GLOBAL APPEND PROPERTY LEASTCOST_COMPONENTS ${name})
  set_property(GLOBAL APPEND PROPERTY LEASTCOST_COMPONENT_FOLDERS ${CMAKE_CURRENT_BINARY_DIR})
endfunction()

# Several libraries under one name: leastcost_collection(problems NEEDS core mesh planning bounds)
function(leastcost_collection name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "NEEDS")
  set(target leastcost_${name})
  add_library(${target} INTERFACE)
  add_library(leastcost::${name} ALIAS ${target})
  foreach(need IN LISTS arg_NEEDS)
    target_link_libraries(${target} INTERFACE leastcost::${need})
  endforeach()
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name}
    LEASTCOST_PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}/${name}.hpp"
    LEASTCOST_NEEDS "${arg_NEEDS}")
  set_property(GLOBAL APPEND PROPERTY LEASTCOST_COMPONENTS ${name})
endfunction()
