#!/bin/sh
# figure.sh FIGURE.gp OUT.svg [DATA]  draws one figure from the csv files in DATA (default: beside FIGURE.gp)
# figure.sh --check FIGURE.gp         fails unless FIGURE.svg was drawn by this script from the csv beside it
#                                     and is as svgtidy.pl leaves it
#
# gnuplot ends with status 0 even if a file or a column is missing, so anything it says is an error.  The
# picture carries a checksum of script, style and data; a picture is never compared with another picture.
set -eu
tools=$(cd "$(dirname "$0")" && pwd)

stamp() { # script, folder of its data: fig_6_1.gp goes with what it loads, fig_6_1.csv and fig_6_1_*.csv
    name=$(basename "$1" .gp)
    {
        cat "$1"
        sed -n "s/^load '\(.*\)'.*/\1/p" "$1" | while read -r loaded; do cat "$(dirname "$1")/$loaded"; done
        for f in "$2/$name".csv "$2/${name}"_*.csv; do [ ! -f "$f" ] || cat "$f"; done
    } | cksum | cut -d ' ' -f 1
}

if [ "$1" = --check ]; then
    picture=${2%.gp}.svg
    [ -f "$picture" ] || { echo "$picture: not drawn yet, run 'make figures'" >&2; exit 1; }
    grep -q "<!-- drawn from $(stamp "$2" "$(dirname "$2")") -->" "$picture" || {
        echo "$picture: older than its script or its data, run 'make figures' and look at it" >&2
        exit 1
    }
    perl "$tools/svgtidy.pl" --check "$picture" && exit 0
    echo "$picture: not tidied by this tools/svgtidy.pl, its labels may lose their blanks; run 'make figures'" >&2
    exit 1
fi

script=$(realpath "$1")
out=$(realpath -m "$2")
data=$(realpath "${3:-$(dirname "$1")}")
rm -f "$out"
cd "$(dirname "$script")"
said=$(gnuplot -e "out='$out'; data='$data'" "$(basename "$script")" 2>&1) || said="$said (gnuplot failed)"
if [ -n "$said" ] || [ ! -s "$out" ]; then
    printf '%s: %s\n' "$1" "${said:-nothing was drawn}" >&2
    rm -f "$out"
    exit 1
fi
case $out in *.svg)
    perl "$tools/svgtidy.pl" "$out"
    echo "<!-- drawn from $(stamp "$script" "$data") -->" >> "$out"
    ;;
esac
