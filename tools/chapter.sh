#!/bin/sh
# chapter.sh run PROGRAM OUT      runs the programs of a chapter, build/bin/chNN, into the emptied folder OUT, notes their seconds
# chapter.sh figures CHAPTER OUT  draws the chapter's figures from the curves in OUT into OUT, and checks
#                                 that the committed pictures were drawn from the committed curves
# CHAPTER is chapters/chNN_topic.  Exit status: that of the program that fails, or 1.
set -eu
tools=$(cd "$(dirname "$0")" && pwd)

case $1 in
run)
    rm -rf "$3"
    mkdir -p "$3"
    echo "$(basename "$2")"
    start=$(date +%s%N)
    "$2" --out "$3" || { status=$?; echo "$(basename "$2") ends with status $status" >&2; exit "$status"; }
    end=$(date +%s%N)
    echo "$((end - start))" > "$3/nanoseconds"
    ;;
figures)
    number=$(basename "$2" | sed 's/^ch0*\([0-9]*\)_.*/\1/')
    bad=0
    for script in "$(dirname "$(dirname "$2")")"/figures/fig_"$number"_*.gp; do
        [ -f "$script" ] || continue
        "$tools/figure.sh" "$script" "$3/$(basename "$script" .gp).svg" "$3" || bad=1
        [ "${FIGURES:-check}" = draw ] || "$tools/figure.sh" --check "$script" || bad=1
    done
    exit $bad
    ;;
*)
    sed -n '2,5s/^# *//p' "$0" >&2
    exit 2
    ;;
esac
