#!/bin/sh
# chapter.sh run PROGRAM OUT [CHAPTER]   runs the programs of a chapter, build/bin/chNN, into the emptied folder OUT, notes their
#                                        seconds; with CHAPTER OUT has its committed results and curves before, and what takes long is left out
# chapter.sh figures CHAPTER OUT         draws the chapter's figures from the curves in OUT into OUT, and checks
#                                        that the committed pictures were drawn from the committed curves
# chapter.sh show PROGRAM OUT CHAPTER    both, drawing only, and one line of what is done; what the programs print is in OUT.log
# CHAPTER is chapters/chNN_topic.  Exit status: that of the program that fails, or 1.
set -eu
tools=$(cd "$(dirname "$0")" && pwd)

number() { basename "$1" | sed 's/^ch0*\([0-9]*\)_.*/\1/'; }  # of a chapter, as its figures have it

case $1 in
run)
    rm -rf "$3"
    mkdir -p "$3"
    echo "$(basename "$2")"
    [ $# -lt 4 ] || cp "$4"/results/* "$(dirname "$4")"/../figures/fig_"$(number "$4")"_*.csv "$3"
    start=$(date +%s%N)
    "$2" --out "$3" ${4:+--quick} || { status=$?; echo "$(basename "$2") ends with status $status" >&2; exit "$status"; }
    end=$(date +%s%N)
    echo "$((end - start))" > "$3/nanoseconds"
    ;;
figures)
    number=$(number "$2")
    bad=0
    for script in "$(dirname "$(dirname "$2")")"/figures/fig_"$number"_*.gp; do
        [ -f "$script" ] || continue
        "$tools/figure.sh" "$script" "$3/$(basename "$script" .gp).svg" "$3" || bad=1
        [ "${FIGURES:-check}" = draw ] || "$tools/figure.sh" --check "$script" || bad=1
    done
    exit $bad
    ;;
show)
    log=$3.log
    mkdir -p "$(dirname "$3")"
    "$0" run "$2" "$3" "$4" > "$log" 2>&1 || { status=$?; cat "$log"; exit "$status"; }
    FIGURES=draw "$0" figures "$4" "$3"
    done=$(ls "$(dirname "$3")"/ch*/nanoseconds | wc -l)
    all=$(ls -d "$(dirname "$4")"/ch[0-9][0-9]_*/*.cpp | sed 's,/[^/]*$,,' | sort -u | wc -l)
    echo "$(basename "$2") has run, $done of $all chapters: figures in $3, what it prints in $log"
    ;;
*)
    sed -n '2,8s/^# *//p' "$0" >&2
    exit 2
    ;;
esac
