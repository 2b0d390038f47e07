# install, export, pkg-config, .deb. One export set per component, so that find_package(leastcost COMPONENTS framework)
# asks for what the framework needs and for nothing else.
#
# Components of the installation: `program`, `libraries` (shared) and `development` (headers, archives, links); back ends,
# catalogue and app have `<name>_libraries` and `<name>_development` of their own. study and report are with app.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/leastcost)
set(generated ${PROJECT_BINARY_DIR}/package)
file(RELATIVE_PATH pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})  # relocatable
get_property(components GLOBAL PROPERTY LEASTCOST_COMPONENTS)

# What is public is what the public header of a component reaches through <leastcost/...>.
set(public ${LEASTCOST_INCLUDE_DIR}/leastcost/leastcost.hpp)
foreach(component IN LISTS components)
  get_target_property(header leastcost_${component} LEASTCOST_PUBLIC)
  file(RELATIVE_PATH header ${PROJECT_SOURCE_DIR} ${header})
  list(APPEND public ${LEASTCOST_INCLUDE_DIR}/leastcost/${header})
endforeach()
set(reached "")
while(public)
  list(POP_FRONT public header)
  list(APPEND reached ${header})
  file(STRINGS ${header} includes REGEX "^#include <leastcost/")
  list(TRANSFORM includes REPLACE "^#include <(.*)>.*" "${LEASTCOST_INCLUDE_DIR}/\\1")
  list(REMOVE_ITEM includes ${reached} ${public})
  list(REMOVE_DUPLICATES includes)
  list(APPEND public ${includes})
endwhile()
set(apart nlopt ceres ompl gdal urdf octomap catalogue app)  # components with packages of their own
function(leastcost_part result component kind)
  set(${result} ${kind} PARENT_SCOPE)
  if(component MATCHES "^(study|report)$")
    set(component app)
  endif()
  if(component IN_LIST apart)
    set(${result} ${component}_${kind} PARENT_SCOPE)
  endif()
endfunction()

foreach(header IN LISTS reached)
  cmake_path(GET header PARENT_PATH component)
  string(REGEX REPLACE "^${LEASTCOST_INCLUDE_DIR}/leastcost/(solvers/)?([^/]*).*$" "\\2" component ${component})
  leastcost_part(development "${component}" development)
  file(RELATIVE_PATH place ${LEASTCOST_INCLUDE_DIR} ${header})
  get_filename_component(place ${place} DIRECTORY)
  file(REAL_PATH ${header} header)
  install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${place} COMPONENT ${development})
endforeach()

foreach(component IN LISTS components)
  set(target leastcost_${component})
  leastcost_part(libraries ${component} libraries)
  leastcost_part(development ${component} development)
  install(TARGETS ${target} EXPORT leastcost-${component}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${libraries}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${libraries} NAMELINK_COMPONENT ${development}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${development})
  install(EXPORT leastcost-${component} NAMESPACE leastcost:: FILE leastcost-${component}-targets.cmake
    DESTINATION ${package_dir} COMPONENT ${development})

  # leastcost-mesh.cmake: first what it needs, then its targets.
  get_target_property(needs ${target} LEASTCOST_NEEDS)
  get_target_property(finds ${target} LEASTCOST_FINDS)
  get_target_property(links ${target} LEASTCOST_LINKS)
  get_target_property(offers ${target} LEASTCOST_OFFERS)
  get_target_property(type ${target} TYPE)
  set(private_links "")
  set(flags "-L\${libdir} -lleastcost_${component}")
  if(offers AND BUILD_SHARED_LIBS)
    string(REPLACE " -l" " -Wl,--no-as-needed,-l" flags "${flags}")  # one word: pkg-config drops repeated ones
  elseif(offers)
    string(APPEND flags " -Wl,-u,${offers}")
  endif()
  if(type STREQUAL "INTERFACE_LIBRARY")  # its parts have them
    set(finds "")
    set(links "")
    set(flags "")
  elseif(BUILD_SHARED_LIBS)  # the library itself knows what it needs
    set(finds "")
    set(private_links "${links}")
    set(links "")
  endif()
  set(lines "")
  set(requires "eigen3 >= 3.4")
  foreach(need IN LISTS needs)
    string(APPEND lines "include(\${CMAKE_CURRENT_LIST_DIR}/leastcost-${need}.cmake)\n")
    string(APPEND requires ", leastcost-${need} = ${PROJECT_VERSION}")
  endforeach()
  foreach(find IN LISTS finds)
    string(APPEND lines "find_dependency(${find})\n")
  endforeach()
  string(APPEND lines "include(\${CMAKE_CURRENT_LIST_DIR}/leastcost-${component}-targets.cmake)\n")
  file(CONFIGURE OUTPUT ${generated}/leastcost-${component}.cmake CONTENT "include_guard()\n${lines}" @ONLY)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/leastcost.pc.in ${generated}/leastcost-${component}.pc @ONLY)
  install(FILES ${generated}/leastcost-${component}.cmake DESTINATION ${package_dir} COMPONENT ${development})
  install(FILES ${generated}/leastcost-${component}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT ${development})
endforeach()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/leastcostConfig.cmake.in ${generated}/leastcostConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${generated}/leastcostConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${generated}/leastcostConfig.cmake ${generated}/leastcostConfigVersion.cmake
  DESTINATION ${package_dir} COMPONENT development)
if(TARGET leastcost)
  install(TARGETS leastcost RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  include(${CMAKE_CURRENT_LIST_DIR}/leastcost_shell.cmake)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/LICENSES.md DESTINATION ${CMAKE_INSTALL_DOCDIR}
  COMPONENT notices)

if(PROJECT_IS_TOP_LEVEL)
  include(${CMAKE_CURRENT_LIST_DIR}/leastcost_packages.cmake)
endif()
