# Debian packages, by cpack in the build folder:
#   leastcost                                        the program
#   libleastcost-dev, libleastcost-<part>-dev        headers, CMake and pkg-config files, archives or links
#   libleastcost0, libleastcost-<part>0              shared libraries, of a build with BUILD_SHARED_LIBS
#   python3-leastcost                                the Python package, of a build with LEASTCOST_BUILD_PYTHON
# with <part> = nlopt, ceres, ompl, gdal, urdf, octomap, catalogue, app. What a binary needs dpkg-shlibdeps finds out, but for GDAL,
# which is loaded at run time; what a static archive needs is the -dev package of that library.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The leastcost authors <leastcost@invalid>")
set(CPACK_PACKAGE_VENDOR "The leastcost authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_COMPONENTS_ALL "")
set(soname ${PROJECT_VERSION_MAJOR})
set(same "(= ${PROJECT_VERSION})")
find_program(dpkg_shlibdeps dpkg-shlibdeps)
mark_as_advanced(dpkg_shlibdeps)

macro(leastcost_package part package section what depends)
  list(APPEND CPACK_COMPONENTS_ALL ${part})
  string(TOUPPER ${part} upper)
  list(JOIN ${depends} ", " joined)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${joined}")
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "Least-cost paths on manifolds: ${what}")
  if(dpkg_shlibdeps AND NOT ${section} STREQUAL "libdevel")
    set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS ON)
  endif()
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/${package} RENAME copyright
    COMPONENT ${part} EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSES.md DESTINATION share/doc/${package}
    COMPONENT ${part} EXCLUDE_FROM_ALL)
endmacro()

# Third parties: the -dev packages that a static archive asks of those who link it.
set(archive_needs_nlopt "libnlopt-cxx-dev (>= 2.7)")
set(archive_needs_ceres "libceres-dev (>= 2.1)")
set(archive_needs_catalogue "libyaml-cpp-dev (>= 0.7)" "libfmt-dev (>= 9.1)" "libssl-dev (>= 3.0)"
  "libpng-dev (>= 1.6)")
set(archive_needs_ompl "libompl-dev (>= 1.5)")
get_property(loaded_gdal GLOBAL PROPERTY LEASTCOST_GDAL_PACKAGE)
set(archive_needs_gdal ${loaded_gdal})
set(archive_needs_urdf "libtinyxml2-dev (>= 9.0)")
set(archive_needs_octomap "liboctomap-dev (>= 1.9)")
set(about_nlopt "the NLopt solvers")
set(about_ceres "the Ceres solvers")
set(about_catalogue "configurations, results")
set(about_app "the program as a library: studies, reports, the command line")
set(about_ompl "OMPL's plans polished, its planners")
set(about_gdal "rasters that GDAL reads")
set(about_urdf "robots of URDF files")
set(about_octomap "obstacles of OctoMap files")

# The libraries without back ends, then each of those apart on top of them.
set(libraries_needs "")
set(development_needs "libeigen3-dev (>= 3.4)")
set(all_libraries "libleastcost${soname} ${same}")
if(BUILD_SHARED_LIBS)
  leastcost_package(libraries libleastcost${soname} libs "shared libraries" libraries_needs)
  list(APPEND development_needs ${all_libraries})
endif()
leastcost_package(development libleastcost-dev libdevel "for programs" development_needs)

set(below_libraries ${all_libraries})
set(below_development "libleastcost-dev ${same}")
foreach(part IN LISTS apart)
  if(NOT part IN_LIST components)
    continue()
  endif()
  set(part_libraries "libleastcost${soname} ${same}")
  set(part_development "libleastcost-dev ${same}")
  if(part MATCHES "^(catalogue|app)$")  # they know the back ends
    set(part_libraries ${below_libraries})
    set(part_development ${below_development})
  endif()
  if(part STREQUAL "gdal")
    list(APPEND part_libraries ${loaded_gdal})
  endif()
  if(BUILD_SHARED_LIBS)
    leastcost_package(${part}_libraries libleastcost-${part}${soname} libs "${about_${part}}, shared library"
      part_libraries)
    list(APPEND part_development "libleastcost-${part}${soname} ${same}")
  else()
    list(APPEND part_development ${archive_needs_${part}})
  endif()
  if(BUILD_SHARED_LIBS)
    list(APPEND below_libraries "libleastcost-${part}${soname} ${same}")
  endif()
  list(APPEND below_development "libleastcost-${part}-dev ${same}")
  leastcost_package(${part}_development libleastcost-${part}-dev libdevel "${about_${part}}, for programs"
    part_development)
endforeach()

if(TARGET leastcost)
  set(program_needs ${loaded_gdal})
  if(BUILD_SHARED_LIBS)
    list(APPEND program_needs ${below_libraries})
  endif()
  leastcost_package(program leastcost math "the program" program_needs)
endif()

if(TARGET leastcost_python)
  math(EXPR next "${LEASTCOST_PYTHON_MINOR} + 1")
  set(python_needs "python3 (>= 3.${LEASTCOST_PYTHON_MINOR})" "python3 (<< 3.${next})" python3-numpy
    ${loaded_gdal})
  if(BUILD_SHARED_LIBS)
    list(APPEND python_needs ${below_libraries})
  endif()
  leastcost_package(python python3-leastcost python "the Python package" python_needs)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS python3-matplotlib)
endif()

# dpkg-shlibdeps reads our shared libraries where they are built.
get_property(folders GLOBAL PROPERTY LEASTCOST_COMPONENT_FOLDERS)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${folders})
include(CPack)
