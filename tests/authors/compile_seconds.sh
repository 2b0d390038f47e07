# compile_seconds.sh LIMIT COMMAND...: runs the command; fails when it does, or when it takes more than LIMIT seconds of
# the processor (not of the clock: tests run beside each other).
limit=$1
shift
"$@" || exit 1
# The last line of `times`: user and system time of the children, as 0m3.210s 0m0.250s. In a pipe it would be a child's.
record=$(mktemp)
times >"$record"
tail -n 1 "$record" | awk -v limit="$limit" '{
  for (i = 1; i <= 2; ++i) { split($i, part, "[ms]"); seconds += 60 * part[1] + part[2] }
  printf "%.1f CPU seconds, at most %d\n", seconds, limit
  exit seconds > limit
}'
result=$?
rm -f "$record"
exit $result
