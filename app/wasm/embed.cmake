# cmake -D MODULE=solver.wasm.gz -D SCRIPT=clicks.js -D OUTPUT=clicks_module.cpp -P embed.cmake: both as C++ strings.
file(READ ${MODULE} module HEX)
file(READ ${SCRIPT} script)
string(REGEX REPLACE "(..)" "\\\\x\\1" module "${module}")
set(line "")
foreach(i RANGE 1 64)
  string(APPEND line ".")  # four characters each byte
endforeach()
string(REGEX REPLACE "(${line}${line}${line}${line})" "\\1\"\n    \"" module "${module}")
file(WRITE ${OUTPUT} "// Made by embed.cmake; do not edit.
#include \"app/report/page/clicks_module.hpp\"

namespace leastcost::app {

std::string_view clicks_module() {
  static constexpr char bytes[] =
    \"${module}\";
  return {bytes, sizeof(bytes) - 1};
}

std::string_view clicks_script() {
  static constexpr char script[] = R\"leastcost(${script})leastcost\";
  return {script, sizeof(script) - 1};
}

}  // namespace leastcost::app
")
