# The installed headers: nothing beside leastcost/, nothing internal, each compiles alone and without a warning.

function(no_header_elsewhere prefix)
  file(GLOB_RECURSE headers RELATIVE ${prefix} ${prefix}/*.hpp ${prefix}/*.h)
  list(FILTER headers EXCLUDE REGEX "^include/leastcost/")
  if(headers)
    message(FATAL_ERROR "headers outside include/leastcost: ${headers}")
  endif()
endfunction()

# An installed header includes installed ones, Eigen and the standard library, and is reached from a public header.
function(no_internal_header prefix)
  file(GLOB_RECURSE headers RELATIVE ${prefix}/include ${prefix}/include/*.hpp)
  set(reached leastcost/leastcost.hpp leastcost/version.hpp leastcost/framework/framework.hpp leastcost/framework/numbers/numbers.hpp
    leastcost/framework/check/check.hpp leastcost/recipes/recipes.hpp
    leastcost/problems/problems.hpp leastcost/solvers/solvers.hpp leastcost/catalogue/catalogue.hpp
    leastcost/ompl/ompl.hpp leastcost/gdal/gdal.hpp leastcost/urdf/urdf.hpp leastcost/octomap/octomap.hpp
    leastcost/app/study.hpp leastcost/app/report.hpp
    leastcost/app/app.hpp)
  foreach(back_end IN LISTS BACK_ENDS)
    list(APPEND reached leastcost/solvers/${back_end}/${back_end}_solver.hpp)
  endforeach()
  foreach(header IN LISTS headers)
    file(STRINGS ${prefix}/include/${header} includes REGEX "^ *# *include")
    foreach(include IN LISTS includes)
      if(include MATCHES "<(leastcost/[^>]*)>")
        list(APPEND reached ${CMAKE_MATCH_1})
        if(NOT CMAKE_MATCH_1 IN_LIST headers)
          message(FATAL_ERROR "${header}: ${include} is not installed")
        endif()
      elseif(NOT include MATCHES "<([a-z_0-9]+|Eigen/[A-Za-z]+)>")
        message(FATAL_ERROR "${header}: ${include} in an installed header")
      endif()
    endforeach()
  endforeach()
  list(REMOVE_ITEM headers ${reached})
  if(headers)
    message(FATAL_ERROR "installed, but no public header reaches them: ${headers}")
  endif()
endfunction()

# All headers together with a strict consumer's warnings, in one order and in the other: what one owes to another shows in
# one of the two. In .ci/nightly each alone as well, but for those that some source includes first, which the lint has
# compiled alone.
function(headers_compile prefix eigen)
  file(GLOB_RECURSE sources ${SOURCE_DIR}/framework/*.cpp ${SOURCE_DIR}/problems/*.cpp ${SOURCE_DIR}/solvers/*.cpp
    ${SOURCE_DIR}/recipes/*.cpp
    ${SOURCE_DIR}/ompl/*.cpp ${SOURCE_DIR}/gdal/*.cpp ${SOURCE_DIR}/urdf/*.cpp
    ${SOURCE_DIR}/octomap/*.cpp ${SOURCE_DIR}/catalogue/*.cpp
    ${SOURCE_DIR}/app/*.cpp)
  set(first "")
  foreach(source IN LISTS sources)
    file(STRINGS ${source} include REGEX "^#include" LIMIT_COUNT 1)
    if(include MATCHES "<(leastcost/[^>]*)>")
      list(APPEND first ${CMAKE_MATCH_1})
    endif()
  endforeach()
  file(GLOB_RECURSE headers RELATIVE ${prefix}/include ${prefix}/include/*.hpp)
  set(all "")
  set(backwards "")
  foreach(header IN LISTS headers)
    string(APPEND all "#include <${header}>\n")
    string(PREPEND backwards "#include <${header}>\n")
    if(DEFINED ENV{LEASTCOST_NIGHTLY} AND NOT header IN_LIST first)
      file(WRITE ${SCRATCH}/alone.cpp "#include <${header}>\n")
      run("${header} alone" ${compile} -fsyntax-only -I${prefix}/include -isystem ${eigen} ${SCRATCH}/alone.cpp)
    endif()
  endforeach()
  file(WRITE ${SCRATCH}/all.cpp "${all}")
  run("all headers" ${compile} -fsyntax-only -I${prefix}/include -isystem ${eigen} ${SCRATCH}/all.cpp)
  file(WRITE ${SCRATCH}/all.cpp "${backwards}")
  run("all headers backwards" ${compile} -fsyntax-only -I${prefix}/include -isystem ${eigen} ${SCRATCH}/all.cpp)
endfunction()

# A program that Eigen aligns otherwise does not compile, and is told what to do.
function(other_alignment_is_refused prefix eigen)
  execute_process(COMMAND ${CXX} -std=c++20 -DEIGEN_MALLOC_ALREADY_ALIGNED=2 -fsyntax-only
    -I${prefix}/include -isystem ${eigen} ${SOURCE_DIR}/examples/hello/main.cpp
    ERROR_VARIABLE output RESULT_VARIABLE code)
  if(code EQUAL 0 OR NOT output MATCHES "compile both with the same -m flags")
    message(FATAL_ERROR "another alignment was not refused:\n${output}")
  endif()
endfunction()
