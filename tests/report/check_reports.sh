#!/bin/sh
# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
#
# check_reports.sh PROGRAM FOLDER VIEWER CLICKS SKIP_RECORD: makes reports of a few runs and of a study and opens them in Chromium, see
# open_reports.mjs, and asks some of them for paths between other ends, see solver_answers.mjs and click_reports.mjs. CLICKS is the module
# that answers, empty without. FOLDER keeps the packages, the results and the screenshots; VIEWER is ON when the program has its 3D view. Without
# Chromium, or without a way to get playwright-core, it is skipped, and the skip recorded.
set -u
program=$1
folder=$2
viewer=$3
module=$4
record=$5
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
configs=$here/../../configs

skip() {
  echo "skipped: $1 $2"
  printf 'report/browser\t%s\t%s\n' "$1" "$2" >>"$record"
  exit 0
}
mkdir -p "$folder" && cd "$folder" || exit 1
rm -rf results

# What answers clicks, without a browser: a small mesh, a cube, the bunny; a plan.
clicks=
if [ -n "$module" ] && command -v node >/dev/null 2>&1; then
  cat >cube.obj <<'END'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 1 3 2
f 1 4 3
f 5 6 7
f 5 7 8
f 1 2 6
f 1 6 5
f 2 3 7
f 2 7 6
f 3 4 8
f 3 8 7
f 4 1 5
f 4 5 8
END
  run() { "$program" run "$@" --quiet >/dev/null || exit 1; }
  for mesh in hill=0:80="$configs/data/hill.obj" cube=0:6="$folder/cube.obj"; do
    name=${mesh%%=*} file=${mesh##*=} ends=${mesh#*=}
    ends=${ends%%=*}
    printf 'manifold: {type: mesh, file: "%s"}\ncost: euclidean\nends: {source: {vertex: %s}, target: {vertex: %s}}\npath: {points: 20}\n' \
      "$file" "${ends%:*}" "${ends#*:}" >"$name.yaml"
    run "$name.yaml" --output "results/$name"
    clicks="$clicks results/$name=$ends"
  done
  run "$configs/plan_taut.yaml" --output results/plan
  clicks="$clicks results/plan=0,0:10,6"
  if [ -e /usr/share/glmark2/models/bunny.obj ]; then
    run "$configs/bunny_geodesic.yaml" --output results/bunny
    clicks="$clicks results/bunny=11812:20997"
  fi
  # shellcheck disable=SC2086 # a list
  node "$here/solver_answers.mjs" "$module" "$here/../../app/wasm/clicks.js" $clicks || exit 1
fi

browser=${LEASTCOST_CHROMIUM:-/usr/bin/chromium}
[ -x "$browser" ] || skip "$browser" "not installed"
command -v node >/dev/null 2>&1 && command -v npm >/dev/null 2>&1 || skip npm "not installed"

if ! cmp -s "$here/package-lock.json" fetched; then
  cp "$here/package.json" "$here/package-lock.json" . || exit 1
  npm ci --include=dev --ignore-scripts --no-audit --no-fund --loglevel=error >npm.log 2>&1 || skip playwright-core "npm ci failed, see $folder/npm.log"
  cp package-lock.json fetched
fi
cp "$here/browser.mjs" "$here/open_reports.mjs" "$here/click_reports.mjs" .

# A surface with a family of paths, a curve in the plane, a ring on an equation that goes on for ever, an arm among obstacles; and a study.
reports=
for name in torus_family brachistochrone plane_cut_gyroid arm_at_a_shelf; do
  "$program" run "$configs/$name.yaml" --output "results/$name" --quiet >/dev/null || exit 1
  kind=
  if [ "$viewer" = ON ] && [ "$name" != brachistochrone ]; then kind='=webgl'; fi
  reports="$reports results/$name/report.html$kind"
done
"$program" study "$here/study.yaml" --output results/study --quiet >/dev/null || exit 1
if [ -n "$clicks" ] && [ "$viewer" = ON ]; then
  bunny=
  [ ! -e results/bunny ] || bunny=results/bunny/report.html=mesh
  # shellcheck disable=SC2086 # a word or none
  node click_reports.mjs "$browser" screenshots results/hill/report.html=mesh results/plan/report.html=plan results/cube/report.html=mesh $bunny || exit 1
fi
# shellcheck disable=SC2086 # a list
exec node open_reports.mjs "$browser" screenshots $reports results/study/report.html
