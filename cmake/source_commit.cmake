# cmake -D SOURCE_DIR=.. -D OUTPUT=source_commit.cpp -P source_commit.cmake: the commit of a checkout as a source file,
# touched only when the commit is another one, so that a build without news compiles nothing.
cmake_minimum_required(VERSION 3.25)
set(commit "")
find_program(git git)
if(git AND EXISTS ${SOURCE_DIR}/.git)
  execute_process(COMMAND ${git} rev-parse HEAD WORKING_DIRECTORY ${SOURCE_DIR}
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${git} diff-index --quiet HEAD -- WORKING_DIRECTORY ${SOURCE_DIR}
    RESULT_VARIABLE changed OUTPUT_QUIET ERROR_QUIET)
  if(commit AND changed EQUAL 1)
    string(APPEND commit ", changed")
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT "// Made by cmake/source_commit.cmake.
#include \"catalogue/output/source_commit.hpp\"

std::string_view leastcost::source_commit() { return \"@commit@\"; }
")
