#!/usr/bin/env bash
# same_sets.sh [COUNT] [VARIANT ...]: whether compilers and their options change what pairs do, and repetition any bit.
# Builds random_scenes and the program `signorini` by every variant into build/same_sets/VARIANT, and compares how COUNT random
# scenes of each kind end and every example, with the motions of all pairs, to those of the first variant; that one runs twice,
# and then bit by bit.  Differences are listed; with any it ends with 1.  What is built already is not built again.
set -euo pipefail
cd "$(dirname "$0")/../.."
count=${1:-100}
shift || true
[ $# -gt 0 ] || set -- g++-O3 g++-O0 g++-native clang++-O3 clang++-O0
out=$PWD/build/same_sets
kinds="frictionless frictional varied revolved triangles paths"
jobs=${JOBS:-$(nproc)}

options() { # of cmake, for a variant COMPILER-LEVEL
    case $1 in
    *-native) echo "-DSIGNORINI_NATIVE=ON" ;;
    *-O3) ;;
    *) echo "-DCMAKE_CXX_FLAGS_RELEASE=-${1##*-}" ;;
    esac
    case $1 in clang++*) echo "-DCMAKE_CXX_STANDARD=20 -DSIGNORINI_WERROR=ON" ;; esac
}
build() { # variant
    # shellcheck disable=SC2046 # several options
    if ! { cmake -S . -B "$out/$1" --log-level=NOTICE -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="${1%-*}" $(options "$1") \
        > "$out/$1.log" 2>&1 &&
        nice cmake --build "$out/$1" -j "$jobs" --target random_scenes signorini_command >> "$out/$1.log" 2>&1; }; then
        echo "same_sets: $1 was not built, see $out/$1.log" >&2
        exit 2
    fi
}
run() { # variant, file
    for kind in $kinds; do "$out/$1/bin/random_scenes" "$kind" default 0 "$count" motions; done > "$2"
    for scene in examples/*.toml; do
        "$out/$1/bin/signorini" solve "$scene" --csv "$out/pairs.csv" > /dev/null
        # The words of open, closed, stick and slide, pair by pair.
        awk -F, -v scene="$scene" '/^#/ { next } !n { n = NF; for (i = 1; i <= NF; ++i) if ($i == "status" || $i == "motion") use[i] = 1; next }
            { for (i = 1; i <= NF; ++i) if (i in use) word = word " " $i } END { print scene, "solved", "-", word }' "$out/pairs.csv"
    done >> "$2"
}
without_bits() { awk '$2 != "solved" { $4 = "" } { print }' "$1"; }

mkdir -p "$out"
status=0
first=$1
for variant in "$@"; do
    build "$variant"
    run "$variant" "$out/$variant.txt"
    if [ "$variant" = "$first" ]; then
        run "$variant" "$out/again.txt"
        if cmp -s "$out/$variant.txt" "$out/again.txt"; then said="the same bits again"; else said="OTHER BITS when run again" status=1; fi
        echo "$variant: $(wc -l < "$out/$variant.txt") scenes, $said"
        continue
    fi
    different=$(diff <(without_bits "$out/$first.txt") <(without_bits "$out/$variant.txt") | grep -c '^>' || true)
    echo "$variant: $different of $(wc -l < "$out/$variant.txt") scenes end otherwise than with $first"
    [ "$different" -eq 0 ] || status=1
    diff <(without_bits "$out/$first.txt") <(without_bits "$out/$variant.txt") | grep '^[<>]' | cut -c1-160 | sort -k2,3 -s || true
done
exit $status
