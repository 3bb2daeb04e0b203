#!/bin/sh
# handout.sh ROOT FOLDER: what `make handout` packs has no solutions, no held-out tests and no instructor's sheet, configures, and its
# text passes the checks.
set -eu
rm -rf "$2"
mkdir -p "$2"
git -C "$1" archive --prefix=handout/ HEAD | tar xf - -C "$2"
cd "$2/handout"
found=$(find . -name 'solution.cpp' -o -name 'test_heldout.cpp' -o -name instructor.md)
[ -z "$found" ] || { echo "the hand-out contains: $found"; exit 1; }
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release --log-level=NOTICE > /dev/null
make lint
ctest --test-dir build -N | grep -q '/solution' && { echo "the hand-out has tests of solutions"; exit 1; }
for header in chapters/*/exercises/*/exercise.hpp; do
    [ -f "$header" ] || continue
    ctest --test-dir build -C answer -N | grep -q '/answer$' || { echo "no test of an answer"; exit 1; }
done
cd / && rm -rf "$2"
