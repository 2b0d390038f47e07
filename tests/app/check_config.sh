#!/bin/sh
# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
#
# check_config.sh PROGRAM CONFIG SKIP_RECORD: runs a configuration and checks its exit code and its files. A
# configuration whose installed model is missing is skipped, and the skip recorded.
set -u
program=$1
config=$2
record=$3

model=$(sed -n 's/.*file: *\(\/[^,} ]*\).*/\1/p' "$config" | head -n 1)
if [ -n "$model" ] && [ ! -e "$model" ]; then
  echo "skipped: $config needs $model"
  printf "configs/%s\t%s\tnot installed\n" "$(basename "$config" .yaml)" "$model" >>"$record"
  exit 0
fi

expected=$(sed -n 's/^x-expect-exit: *\([0-9]*\).*/\1/p' "$config")
expected=${expected:-0}
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT

"$program" run "$config" --output "$folder/out" --quiet
code=$?
if [ "$code" -ne "$expected" ]; then
  echo "$config: exit code $code, expected $expected"
  exit 1
fi
case $code in
  0 | 5 | 130) [ -s "$folder/out/result.json" ] || { echo "no result.json"; exit 1; } ;;
  *) [ ! -e "$folder/out" ] || { echo "an output folder in spite of exit code $code"; exit 1; } ;;
esac
