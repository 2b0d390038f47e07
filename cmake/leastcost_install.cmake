# install, export, pkg-config, .deb. One export set per component, so that find_package(leastcost COMPONENTS framework)
# asks for what the framework needs and for nothing else.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/leastcost)
set(generated ${PROJECT_BINARY_DIR}/package)
file(RELATIVE_PATH pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})  # relocatable
get_property(components GLOBAL PROPERTY LEASTCOST_COMPONENTS)

foreach(component IN LISTS components)
  set(target leastcost_${component})
  install(TARGETS ${target} EXPORT leastcost-${component}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT leastcost-${component} NAMESPACE leastcost:: FILE leastcost-${component}-targets.cmake
    DESTINATION ${package_dir} COMPONENT development)
  get_target_property(headers ${target} LEASTCOST_HEADERS)
  foreach(header IN LISTS headers)
    file(RELATIVE_PATH place ${PROJECT_SOURCE_DIR} ${header})
    get_filename_component(place ${place} DIRECTORY)
    install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/leastcost/${place} COMPONENT development)
  endforeach()

  # leastcost-problems.cmake: first what it needs, then its targets.
  get_target_property(needs ${target} LEASTCOST_NEEDS)
  get_target_property(finds ${target} LEASTCOST_FINDS)
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
  install(FILES ${generated}/leastcost-${component}.cmake DESTINATION ${package_dir} COMPONENT development)
  install(FILES ${generated}/leastcost-${component}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)
endforeach()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/leastcostConfig.cmake.in ${generated}/leastcostConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${generated}/leastcostConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${generated}/leastcostConfig.cmake ${generated}/leastcostConfigVersion.cmake
  DESTINATION ${package_dir} COMPONENT development)
if(TARGET leastcost)
  install(TARGETS leastcost RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
endif()
foreach(notice IN ITEMS LICENSE LICENSES.md)
  install(FILES ${PROJECT_SOURCE_DIR}/${notice} DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
endforeach()

if(PROJECT_IS_TOP_LEVEL)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_CONTACT "The leastcost authors <leastcost@invalid>")
  set(CPACK_PACKAGE_VENDOR "The leastcost authors")
  set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
  set(CPACK_COMPONENTS_ALL runtime development)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME leastcost)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION math)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libleastcost-dev)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
  if(BUILD_SHARED_LIBS)
    string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", leastcost (= ${PROJECT_VERSION})")
  endif()
  find_program(dpkg_shlibdeps dpkg-shlibdeps)
  mark_as_advanced(dpkg_shlibdeps)
  if(dpkg_shlibdeps)
    set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
  endif()
  include(CPack)
endif()
