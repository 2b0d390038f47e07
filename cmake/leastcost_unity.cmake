# A unity build (CMAKE_UNITY_BUILD, on in the presets release and asan-ubsan) compiles the sources of one folder
# together, at most eight at a time (the lint: all): headers are parsed once for all, which is most of the time. What it
# asks for: names in the unnamed namespaces of one folder differ. The lint also compiles file by file and finds the
# include that a neighbour would hide; the preset dev is not a unity build either.
set(LEASTCOST_UNITY_MOST 8 CACHE STRING "Most sources of a folder that are compiled together")
function(leastcost_unity target)
  set(most ${LEASTCOST_UNITY_MOST})
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC takes for a header what a unity source includes, and finds types of its unnamed namespaces in it.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
    # Let it keep its garbage: collecting took up to a sixth of the time of a large source.
    target_compile_options(${target} PRIVATE "SHELL:--param ggc-min-expand=400" "SHELL:--param ggc-min-heapsize=1000000")
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  set(folders "")
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    list(APPEND folders ${folder})
    list(APPEND sources_of_${folder} ${source})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder IN LISTS folders)
    list(LENGTH sources_of_${folder} count)
    math(EXPR groups "(${count} + ${most} - 1) / ${most}")  # of equal size
    set(index 0)
    foreach(source IN LISTS sources_of_${folder})
      math(EXPR group "${index} * ${groups} / ${count}")
      math(EXPR index "${index} + 1")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${group})
    endforeach()
  endforeach()
endfunction()
