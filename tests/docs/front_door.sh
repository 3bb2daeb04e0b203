#!/bin/sh
# front_door.sh ROOT: run.sh and the set-up explain themselves and refuse what they do not know with status 2.
set -u
cd "$1" || exit 1
bad=0
for words in "run.sh nonsense" "run.sh test test" "tools/setup.sh nonsense"; do
    said=$(./$words 2>&1)
    status=$?
    if [ "$status" -ne 2 ] || ! printf '%s' "$said" | grep -q "expected"; then
        echo "$words: status $status, said: $said"
        bad=1
    fi
done
./run.sh help | grep -q './run.sh test' || { echo "run.sh help does not tell of ./run.sh test"; bad=1; }
for target in test ch06 ex6.1 grade book book-pdf results; do
    make help | grep -q "make $target " || { echo "make help does not tell of $target"; bad=1; }
done
# cmake --install needs the library and the program `signorini`; what ./run.sh builds must do for that.
run=$(make -n run 2>&1)
for target in run_chapters signorini_command; do
    printf '%s\n' "$run" | grep -q -e "--build .*--target.* $target\>" || { echo "make run does not build $target"; bad=1; }
done
# The first chapter is run before the others are compiled.
printf '%s\n' "$run" | awk '/--target run_ch00/ { shown = 1 } /--target run_chapters/ { found = shown } END { exit !found }' ||
    { echo "make run does not show the first chapter before it compiles the others"; bad=1; }
# What is left out is said by make and make test, and not by what is called often.
for target in all test; do make -n $target 2>&1 | grep -q log-level=NOTICE || { echo "make $target does not say what is left out"; bad=1; }; done
make -n ch06 2>&1 | grep -q log-level=WARNING || { echo "make ch06 says what is left out"; bad=1; }
make -n ch06 2>&1 | tail -n 1 | grep -q "findings.pl build/out ch06" || { echo "make ch06 does not end with what the chapter found"; bad=1; }
# An exercise ends with a verdict and a status, without what make has to say about a command that fails.
scratch=$(mktemp -d)
said=$(make ex99.9 B="$scratch" 2>&1) && { echo "make ex99.9 succeeds"; bad=1; }
rm -rf "$scratch"
case $said in
*'***'*) echo "make ex99.9 says too much: $said"; bad=1 ;;
"no exercise ex99.9; there are: "*) ;;
*) echo "make ex99.9 says: $said"; bad=1 ;;
esac
exit $bad
