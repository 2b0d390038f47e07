# compile_seconds.sh LIMIT COMMAND...: runs the command; fails when it does, or when it takes more than LIMIT seconds of
# the processor (not of the clock: tests run beside each other) in each of three tries: a busy machine takes up to twice
# the seconds of an idle one.
limit=$1
shift
record=$(mktemp)
before=0
for try in 1 2 3; do
  "$@" || { rm -f "$record"; exit 1; }
  # The last line of `times`: user and system time of the children, as 0m3.210s 0m0.250s. In a pipe it would be a
  # child's.
  times >"$record"
  after=$(tail -n 1 "$record" | awk '{
    for (i = 1; i <= 2; ++i) { split($i, part, "[ms]"); seconds += 60 * part[1] + part[2] }
    print seconds
  }')
  awk -v before="$before" -v after="$after" -v limit="$limit" 'BEGIN {
    printf "%.1f CPU seconds, at most %d\n", after - before, limit
    exit after - before > limit
  }' && { rm -f "$record"; exit 0; }
  before=$after
done
rm -f "$record"
exit 1
