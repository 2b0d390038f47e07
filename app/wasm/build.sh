#!/bin/sh
# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
#
# build.sh EMXX SOURCES HEADERS OUTPUT: compiles solver.cpp and what it needs of the library to WebAssembly and writes it, compressed, to OUTPUT. HEADERS: the
# folder that holds eigen3 and boost, /usr/include in Debian. Takes a minute; works beside OUTPUT.
set -eu
emxx=$1
root=$2
headers=$3
output=$4
work=$output.parts
# Debian's compiler does not find its own modules without.
[ -d /usr/share/nodejs ] && export NODE_PATH="${NODE_PATH:-/usr/share/nodejs}"

rm -rf "$work"
mkdir -p "$work/include/leastcost" "$work/system"
# Not /usr/include itself, which is another system's.
ln -s "$headers/eigen3" "$headers/boost" "$work/system/"
for layer in framework problems; do ln -s "$root/$layer" "$work/include/leastcost/"; done
echo '#pragma once' >"$work/include/leastcost/eigen_alignment.hpp" # of the host

flags="-std=c++20 -O2 -DNDEBUG -fwasm-exceptions -w -include $root/app/wasm/bit.hpp -I$work/include -I$root -isystem $work/system/eigen3 -isystem $work/system"
compile() {
  unit=$work/$1.cpp
  shift
  for source in "$@"; do echo "#include \"$source\""; done >"$unit"
  # shellcheck disable=SC2086 # a list
  "$emxx" $flags -c "$unit" -o "$unit.o"
}
taut=$root/problems/taut
obstacles=$root/problems/obstacles
compile mesh "$root"/problems/mesh/*.cpp
compile straighten "$root"/problems/straighten/*.cpp
compile exact "$root"/problems/exact/*.cpp
compile taut "$taut/string_pull.cpp" "$taut/tangent_path.cpp" "$taut/tangent_search.cpp" "$taut/taut_path.cpp"
compile obstacles "$obstacles/ball.cpp" "$obstacles/polygon.cpp" "$obstacles/obstacle_walls.cpp" "$obstacles/broad_phase.cpp" "$obstacles/outlines.cpp" \
  "$obstacles/crossing_word.cpp"
compile base "$root"/framework/base/*.cpp "$root/framework/domain/in_parts.cpp"
compile solver "$root/app/wasm/solver.cpp"
"$emxx" -O2 -fwasm-exceptions "$work"/*.o -o "$work/solver.wasm" --no-entry -sSTANDALONE_WASM -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=2GB \
  -sEXPORTED_FUNCTIONS=_give,_take_back,_answer,_fault,_load_mesh,_on_mesh,_load_plan,_room_at,_in_plane
gzip -9nc "$work/solver.wasm" >"$output"
rm -rf "$work"
