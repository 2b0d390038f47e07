#!/bin/sh
# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
#
# check_reports.sh PROGRAM FOLDER VIEWER SKIP_RECORD: makes reports of a few runs and of a study and opens them in Chromium, see
# open_reports.mjs. FOLDER keeps the packages, the results and the screenshots; VIEWER is ON when the program has its 3D view. Without
# Chromium, or without a way to get playwright-core, it is skipped, and the skip recorded.
set -u
program=$1
folder=$2
viewer=$3
record=$4
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
configs=$here/../../configs

skip() {
  echo "skipped: $1 $2"
  printf 'report/browser\t%s\t%s\n' "$1" "$2" >>"$record"
  exit 0
}
browser=${LEASTCOST_CHROMIUM:-/usr/bin/chromium}
[ -x "$browser" ] || skip "$browser" "not installed"
command -v node >/dev/null 2>&1 && command -v npm >/dev/null 2>&1 || skip npm "not installed"

mkdir -p "$folder" && cd "$folder" || exit 1
if ! cmp -s "$here/package-lock.json" fetched; then
  cp "$here/package.json" "$here/package-lock.json" . || exit 1
  npm ci --include=dev --ignore-scripts --no-audit --no-fund --loglevel=error >npm.log 2>&1 || skip playwright-core "npm ci failed, see $folder/npm.log"
  cp package-lock.json fetched
fi
cp "$here/open_reports.mjs" .

# A surface with a family of paths, a curve in the plane, a ring on an equation that goes on for ever; and a study.
rm -rf results
reports=
for name in torus_family brachistochrone plane_cut_gyroid; do
  "$program" run "$configs/$name.yaml" --output "results/$name" --quiet >/dev/null || exit 1
  kind=
  if [ "$viewer" = ON ] && [ "$name" != brachistochrone ]; then kind='=webgl'; fi
  reports="$reports results/$name/report.html$kind"
done
"$program" study "$here/study.yaml" --output results/study --quiet >/dev/null || exit 1
# shellcheck disable=SC2086 # a list
exec node open_reports.mjs "$browser" screenshots $reports results/study/report.html
