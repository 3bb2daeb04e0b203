#!/bin/sh
# absent_effects.sh PROGRAM FOLDER: what is absent costs nothing and changes no bit. PROGRAM solves one problem by
# hand, as a scene, and as a scene that names every effect and wants none. All print the same bits. Where valgrind is
# installed and no sanitizer in the way (COUNT=no), instructions, allocations and the peak of memory are compared.
set -eu
program=$1
play=$2
cells=24
rm -rf "$play"
mkdir -p "$play"
cd "$play"

fail() { echo "absent_effects: $*" >&2; exit 1; }

for way in hand scene named; do "$program" $way $cells > $way.txt; done
[ "$(wc -l < hand.txt)" -gt 1000 ] || fail "the program printed $(wc -l < hand.txt) numbers only"
cmp hand.txt scene.txt || fail "a scene has other bits than the rooms called by hand"
cmp scene.txt named.txt || fail "effects that want nothing change bits"

if [ "${COUNT-}" = no ] || ! command -v valgrind > /dev/null 2>&1; then
    echo "absent_effects: same bits; nothing was counted, that needs valgrind and no sanitizer"
    exit 0
fi
# The ways one after another: the second and the third are compared with the first.
for way in hand scene named; do
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" $way $cells 2> $way.log > /dev/null
    valgrind --tool=dhat --dhat-out-file=/dev/null "$program" $way $cells 2> $way.heap > /dev/null
    instructions=$(sed -n 's/^==[0-9]*== Collected : //p' $way.log)
    blocks=$(sed -n 's/^==[0-9]*== Total: .* bytes in \(.*\) blocks/\1/p' $way.heap | tr -d ,)
    peak=$(sed -n 's/^==[0-9]*== At t-gmax: \(.*\) bytes in .*/\1/p' $way.heap | tr -d ,)
    echo "$way: $instructions instructions, $blocks allocations, $peak bytes at the peak"
    echo "$instructions $blocks $peak" >> counts
done
awk '{ for (k = 1; k <= 3; k++) x[NR, k] = $k }
     function check(ok, what) { if (!ok) { bad = 1; print "not so: " what } }
     function near(k, a, b, share) { return x[b, k] <= (1 + share) * x[a, k] && x[b, k] >= (1 - share) * x[a, k] }
     END {
         check(near(1, 1, 2, 0.01), "a scene takes the instructions of the same by hand, within 1 %")
         check(near(2, 1, 2, 0.05) && near(3, 1, 2, 0.05), "and its allocations and memory, within 5 %")
         check(near(1, 2, 3, 0.001), "effects that want nothing take no instructions, within 0.1 %")
         check(near(2, 2, 3, 0.001) && near(3, 2, 3, 0.001), "and no memory but that of their own names")
         exit bad
     }' counts || fail "what is absent was paid for"
