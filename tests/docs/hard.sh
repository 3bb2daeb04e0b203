#!/bin/sh
# hard.sh PROGRAM SOURCE PLAY - every exhibit of tests/hard says how it is run: its command ends as the exhibit states,
# 0 if solved, 2 if the problem is refused, 1 if a solver ends without a solution.  Each takes less than ten seconds.
set -u
program=$1 source=$2 play=$3
mkdir -p "$play" && cd "$source" || exit 1
count=0 bad=0
for file in tests/hard/*/*.t*; do
    words=$(sed -n 's/^# command: signorini //p' "$file")
    stated=$(sed -n 's/^# ours: //p' "$file")
    timeout 10 "$program" $words > "$play/out" 2> "$play/err"
    code=$?
    case "$stated:$code" in
        solved*:0 | refused*:2) ;;
        refused*:1) grep -q ' refused' "$play/out" || { echo "$file: $stated, but it says otherwise"; bad=$((bad + 1)); } ;;
        solved*:* | refused*:* | *:0 | *:2 | *:124) echo "$file: $stated, but exit code $code"; bad=$((bad + 1)) ;;
        *:1) grep -q "${stated%% \"*}" "$play/out" "$play/err" || { echo "$file: does not say $stated"; bad=$((bad + 1)); } ;;
        *) echo "$file: exit code $code"; bad=$((bad + 1)) ;;
    esac
    count=$((count + 1))
done
echo "$count exhibits, $bad wrong"
[ "$count" -ge 80 ] && [ "$bad" -eq 0 ]
