# LEASTCOST_OBJECTS names a static build of these very sources, whose objects are taken instead of compiling them once
# more: the tests make shared libraries and packages of them in seconds. Static objects are position independent, so
# that both kinds compile the same.
set(LEASTCOST_OBJECTS "" CACHE PATH "A static build of these sources, to link its objects instead of compiling (tests)")
mark_as_advanced(LEASTCOST_OBJECTS)

# Sets `result` to the sources of a target: those given, or one without content.
function(leastcost_sources result)
  set(${result} ${ARGN} PARENT_SCOPE)
  if(LEASTCOST_OBJECTS)
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/objects.cpp CONTENT "")
    set(${result} ${CMAKE_CURRENT_BINARY_DIR}/objects.cpp PARENT_SCOPE)
  endif()
endfunction()

function(leastcost_link_objects target)
  if(NOT LEASTCOST_OBJECTS)
    return()
  endif()
  file(RELATIVE_PATH folder ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR})
  set(archive ${LEASTCOST_OBJECTS}/${folder}/${CMAKE_STATIC_LIBRARY_PREFIX}${target}${CMAKE_STATIC_LIBRARY_SUFFIX})
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "SHARED_LIBRARY")
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:$<LINK_LIBRARY:WHOLE_ARCHIVE,${archive}>>)
  else()
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:${archive}>)
  endif()
  set_target_properties(${target} PROPERTIES LINK_DEPENDS ${archive} DISABLE_PRECOMPILE_HEADERS ON)
endfunction()
