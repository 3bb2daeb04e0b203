#!/bin/sh
# chapter.sh run PROGRAM OUT [CHAPTER]   runs the programs of a chapter, build/bin/chNN, into the emptied folder OUT, and notes their
#                                        processor seconds. With CHAPTER those that take long are left out: the committed files that they
#                                        would write are copied to OUT, and OUT/left_out lists both. After a failure OUT has no results
# chapter.sh figures CHAPTER OUT         draws the chapter's figures from the curves in OUT into OUT, and checks
#                                        that the committed pictures were drawn from the committed curves
# chapter.sh show PROGRAM OUT CHAPTER    both, drawing only, and one line of what is done; what the programs print is in OUT.log
# CHAPTER is chapters/chNN_topic.  Exit status: that of the program that fails, or 1.
set -eu
tools=$(cd "$(dirname "$0")" && pwd)

number() { basename "$1" | sed 's/^ch0*\([0-9][0-9]*\)_.*/\1/'; }  # of a chapter, as its figures have it

# Copies committed files of a chapter to OUT, for each line "NAME FILE ..." of OUT/left_out.
copy_committed() { # CHAPTER OUT
    while read -r _ files; do
        for file in $files; do # perhaps a pattern, fig_1_2*.csv
            for committed in "$1"/results/$file "$(dirname "$1")"/../figures/$file; do
                [ ! -f "$committed" ] || cp "$committed" "$2"
            done
        done
    done < "$2/left_out"
}

case $1 in
run)
    program=$2 out=$3 chapter=${4:-}
    name=$(basename "$program")
    rm -rf "$out"
    mkdir -p "$out"
    echo "$name"
    status=0
    if [ -n "$chapter" ]; then
        "$program" --quick --out "$out" > "$out.printed" || status=$?
        cat "$out.printed"
        sed -n "s/^$name: \([^ ]*\) takes longer than 5 s and is left out: /\1 /p" "$out.printed" > "$out/left_out"
        rm "$out.printed"
    else
        "$program" --out "$out" || status=$?
    fi
    if [ $status -ne 0 ]; then
        rm -f "$out"/*.results "$out/left_out"
        echo "$name ends with status $status" >&2
        exit $status
    fi
    times > "$out/times" # of this shell, then of what it ran, as 0m1.25s 0m0.01s
    awk 'NR == 2 { gsub(/[ms]/, " "); print 60 * ($1 + $3) + $2 + $4 }' "$out/times" > "$out/seconds"
    rm "$out/times"
    [ -z "$chapter" ] || copy_committed "$chapter" "$out"
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
    program=$2 out=$3 chapter=$4
    log=$out.log
    mkdir -p "$(dirname "$out")"
    "$0" run "$program" "$out" "$chapter" > "$log" 2>&1 || { status=$?; cat "$log"; exit "$status"; }
    FIGURES=draw "$0" figures "$chapter" "$out"
    n_run=$(ls "$(dirname "$out")"/ch[0-9][0-9]/seconds | wc -l)
    n_chapters=$(ls -d "$(dirname "$chapter")"/ch[0-9][0-9]_*/*.cpp | sed 's,/[^/]*$,,' | sort -u | wc -l)
    left_out=$(sed 's/ .*//' "$out/left_out" | paste -s -d , | sed 's/,/, /g')
    echo "$(basename "$program") has run, $n_run of $n_chapters chapters${left_out:+; $left_out left out: committed results};" \
        "figures in $out, what it prints in $log"
    ;;
*)
    sed -n '2,9s/^# *//p' "$0" >&2
    exit 2
    ;;
esac
