#!/usr/bin/env bash
# run.sh [SECONDS [READER ...]]: the fuzzers of the readers, SECONDS each (600), on the texts of tests/data; prints what
# each has done.  Ends with 1 if one found something: the text is then in build/presets/fuzz/found.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-600}
shift || true
[ $# -gt 0 ] || set -- read_scene read_problem read_gmsh read_inp
fuzz=build/presets/fuzz
cmake --preset fuzz --log-level=NOTICE
# shellcheck disable=SC2046 # several targets
nice cmake --build --preset fuzz -j "${JOBS:-$(nproc)}" --target $(printf 'fuzz_%s ' "$@")
mkdir -p "$fuzz/found"
status=0
for reader in "$@"; do
    case $reader in
    read_scene) texts=fuzz_corpus_scene words=scene.dict ;;
    read_gmsh) texts=fuzz_corpus_gmsh words=gmsh.dict ;;
    read_inp) texts=inp words=inp.dict ;;
    *) texts=fuzz_corpus words=words.dict ;;
    esac
    mkdir -p "$fuzz/$reader"
    nice "$fuzz/bin/fuzz_$reader" -dict="tests/fuzz/$words" -max_total_time="$seconds" -timeout=60 -print_final_stats=1 \
        -artifact_prefix="$fuzz/found/$reader-" "$fuzz/$reader" "tests/data/$texts" > "$fuzz/$reader.log" 2>&1 || status=1
    echo "$reader: $(sed -n 's/^stat::number_of_executed_units: *//p' "$fuzz/$reader.log") texts, $(grep -o 'cov: [0-9]* ft: [0-9]*' \
        "$fuzz/$reader.log" | tail -n 1), $(find "$fuzz/found" -name "$reader-*" | wc -l) found"
done
exit $status
