# How Eigen aligns under this build's flags: eigen_default_align, eigen_static_align, eigen_malloc_aligned. The installed
# headers refuse a program that is compiled otherwise (eigen_alignment.hpp); so does the library, should this be wrong.
function(leastcost_alignment)
  set(probe ${CMAKE_CURRENT_BINARY_DIR}/eigen_alignment_probe.cpp)
  file(CONFIGURE OUTPUT ${probe} @ONLY CONTENT "#include <Eigen/Core>
leastcost_alignment: EIGEN_DEFAULT_ALIGN_BYTES EIGEN_MAX_STATIC_ALIGN_BYTES EIGEN_MALLOC_ALREADY_ALIGNED\n")
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  get_directory_property(options COMPILE_OPTIONS)
  get_directory_property(definitions COMPILE_DEFINITIONS)
  list(TRANSFORM definitions PREPEND "-D")
  get_target_property(folders Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  list(TRANSFORM folders PREPEND "-I")
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}}")
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${flags} ${options} ${definitions} ${folders} -E -P ${probe}
    OUTPUT_VARIABLE text ERROR_VARIABLE reason RESULT_VARIABLE code)
  if(NOT code EQUAL 0 OR NOT text MATCHES "leastcost_alignment: ([0-9]+) ([0-9]+) ([0-9]+)")
    message(FATAL_ERROR "Cannot find out how Eigen aligns:\n${reason}")
  endif()
  set(eigen_default_align ${CMAKE_MATCH_1} PARENT_SCOPE)
  set(eigen_static_align ${CMAKE_MATCH_2} PARENT_SCOPE)
  set(eigen_malloc_aligned ${CMAKE_MATCH_3} PARENT_SCOPE)
endfunction()
