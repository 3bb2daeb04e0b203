#!/bin/sh
# ./run.sh       sets up a fresh Debian or Ubuntu, compiles, runs every chapter, draws its figures, and makes the book if Doxygen is there
# ./run.sh test  the same set-up, then compiles and runs every test
# ./run.sh help  this text; afterwards `make help` lists the daily commands
set -eu
cd "$(dirname "$0")"
case "$#:${1:-}" in
0:) target=run ;;
1:test) target=test ;;
1:help) sed -n '2,4s/^# *//p' run.sh; exit 0 ;;
*) echo "run.sh: expected nothing, 'test' or 'help', got '$*'" >&2; exit 2 ;;
esac
tools/setup.sh build
exec make --no-print-directory "$target"
