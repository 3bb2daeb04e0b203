#!/bin/sh
# exercise.sh check ex6.1 BUILD                   compiles your answer to an exercise in the folder BUILD and judges it
# Exit status: 0 if the answer is right, 1 if not, 2 if there is no such exercise or no compiler.
set -u
exercise=${2:-}

not_yet() { # file, what is wrong
    echo "$exercise: $2; edit $1, then make $exercise again"
    exit 1
}

case ${1:-} in
check)
    cd "$(dirname "$0")/.." || exit 2
    known="" folder=""
    for each in chapters/ch*/exercises/ex*; do
        chapter=$(basename "$(dirname "$(dirname "$each")")" | sed 's/^ch0*\([0-9][0-9]*\)_.*/\1/')
        name=ex$chapter.$(basename "$each" | sed 's/^ex\([0-9]*\)_.*/\1/')
        [ "$name" != "$exercise" ] || folder=$each
        known="$known $name"
    done
    [ -n "$folder" ] || { echo "no exercise $exercise; there are:$known" >&2; exit 2; }
    unset MFLAGS MAKELEVEL  # of the make that asks are not for the one that compiles, nor are its flags
    export MAKEFLAGS=--no-print-directory
    cmake --preset release --log-level=WARNING > /dev/null || exit 2
    compile() { cmake --build "$3" -j "${JOBS:-$(nproc)}" --target "$exercise"; }
    # Shows what the compiler says, and progress where the library has to be compiled as well.
    { compile "$@" 2>&1 || echo "exercise.sh: stopped"; } | awk '
        /^exercise.sh: stopped$/ { bad = 1; next }
        / Built target | Linking CXX | Building CXX object CMakeFiles\/ex[0-9]|^Consolidate compiler / { next }
        /^g?make(\[[0-9]+\])?: \*\*\* (\[.* Error|Waiting)/ { next }
        { print; fflush() }
        END { exit bad }' || not_yet "$folder/attempt.cpp" "does not compile"
    heldout=$3/bin/$exercise.answer-heldout
    [ -f "$folder/test_heldout.cpp" ] || heldout=""
    perl tools/judge.pl "$exercise" "$folder/attempt.cpp" "$3/bin/$exercise.answer" $heldout || exit
    exec perl tools/borrowed.pl "$exercise" "$folder/attempt.cpp" "$3"
    ;;
*)
    sed -n '2,3s/^# *//p' "$0" >&2
    exit 2
    ;;
esac
