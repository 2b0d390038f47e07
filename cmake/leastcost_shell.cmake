# Man pages and completions for bash, zsh and fish, made by the program from the tables of --help, and their places.
# Where the program cannot run on the machine that builds it there are none.
if(CMAKE_CROSSCOMPILING)
  return()
endif()
set(shell ${PROJECT_BINARY_DIR}/shell)
add_custom_command(OUTPUT ${shell}/made
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${shell}
  COMMAND leastcost man ${shell}/man
  COMMAND leastcost completion bash > ${shell}/leastcost
  COMMAND leastcost completion zsh > ${shell}/_leastcost
  COMMAND leastcost completion fish > ${shell}/leastcost.fish
  COMMAND ${CMAKE_COMMAND} -E touch ${shell}/made
  DEPENDS leastcost COMMENT "Man pages and completions" VERBATIM)
add_custom_target(leastcost_shell ALL DEPENDS ${shell}/made)
install(DIRECTORY ${shell}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program OPTIONAL)
install(FILES ${shell}/leastcost DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program OPTIONAL)
install(FILES ${shell}/leastcost.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
  COMPONENT program OPTIONAL)
# Debian's zsh looks into vendor-completions of /usr and into site-functions of /usr/local.
install(CODE "
  set(folder site-functions)
  if(CMAKE_INSTALL_PREFIX STREQUAL \"/usr\")
    set(folder vendor-completions)
  endif()
  file(INSTALL \"${shell}/_leastcost\" DESTINATION
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/zsh/\${folder}\" OPTIONAL)" COMPONENT program)
