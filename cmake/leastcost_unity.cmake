# A unity build (CMAKE_UNITY_BUILD, on in the presets release and asan-ubsan) compiles the sources of one folder
# together, at most LEASTCOST_UNITY_MOST at a time: headers are parsed once for all, which is most of the time. What it
# asks for: names in the unnamed namespaces of one folder differ. With LEASTCOST_UNITY_TOGETHER (.ci/lint) the folders of
# one line below go together as well, and names in their unnamed namespaces have to differ; where they do not, rename
# one, or take its folder out of the line. The lint also compiles file by file and finds the include that a neighbour
# would hide; the preset dev is not a unity build either.
set(LEASTCOST_UNITY_MOST 8 CACHE STRING "Most sources that are compiled together")
option(LEASTCOST_UNITY_TOGETHER "Compile folders together (cmake/leastcost_unity.cmake)" OFF)
mark_as_advanced(LEASTCOST_UNITY_TOGETHER)
set(leastcost_unity_together
  "framework/.*"
  "problems/(cells|distance|level_set|manifolds/data|obstacles|occupancy|readers|spline|tensor)"
  "problems/(costs|section|straighten)"
  "problems/(chart|exact|formula|raster|robots)"
  "problems/(costs/lagrangian|mesh|taut)"
  "problems/(initializers|layers)"
  "problems/(graph|post_processors)"
  "problems/(cloud|fields)"
  "catalogue/(config|inputs|options|output|plugins|registry|run)"
  "catalogue/(scene|yaml)"
  "app/(cli|distances|pairs|plot|report|report/page|run|study|study/cell)"
  "app/(reference|study/grid|study/rows)")
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
    foreach(line IN LISTS leastcost_unity_together)
      if(LEASTCOST_UNITY_TOGETHER AND folder MATCHES "^${line}$")
        string(REGEX REPLACE "/?\\(.*|/[.][*]" "" library "${line}")
        list(FIND leastcost_unity_together "${line}" index)
        set(folder "${library}_${index}")
      endif()
    endforeach()
    # The plug-ins of one subject are few in each folder (problems/CMakeLists.txt).
    if(target MATCHES "^leastcost_(mesh|planning|bounds)$" AND folder MATCHES
        "^(problems/(bracket|costs|initializers|manifolds/data|post_processors|readers|section)|recipes/offers)$")
      set(folder ${target}_plug_ins)
    elseif(folder MATCHES "^problems/(bracket|manifolds/data|methods|section)$")
      set(folder problems_few)
    endif()
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
