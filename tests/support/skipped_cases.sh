#!/bin/sh
# skipped_cases.sh RECORD - prints how many cases left something out in this test run, and why.
# ctest hides what a passing test prints; `./leastcost test` therefore hands down its own standard output as descriptor 3.
set -eu
report() {
  if [ ! -s "$1" ]; then
    echo "No test case was skipped."
    return
  fi
  cases=$(cut -f 1 "$1" | sort -u | wc -l)
  echo "Skipped in part or whole: $cases test case(s)."
  # One line per case and reason: "case: file, file, ...: reason".
  sort -u "$1" | awk -F '\t' '
    { key = $1 "\t" $3 }
    !(key in what) { order[++n] = key; what[key] = $2; next }
    { what[key] = what[key] ", " $2 }
    END { for (i = 1; i <= n; ++i) { split(order[i], part, "\t"); print "  " part[1] ": " what[order[i]] ": " part[2] } }'
}
report "$1"
if [ "${LEASTCOST_REPORT_FD:-}" = 3 ]; then
  report "$1" >&3
fi
