#!/bin/sh
# chapter_show.sh ROOT FOLDER: how tools/ run and show a toy chapter, in FOLDER: one whose programs succeed, one with a program that fails, one with a
# program that is left out, and one with nothing committed; and what tools/batch.pl makes of its sources.
set -u
tools=$1/tools folder=$2
rm -rf "$folder"
mkdir -p "$folder/chapters/ch01_toy/results" "$folder/chapters/ch02_bare" "$folder/figures" "$folder/bin"
cd "$folder" || exit 1
bad=0
fault() { echo "$*"; bad=1; }

cat > chapters/ch01_toy/toy.cpp << 'END'
// Chapter 1 - A toy.
// Run:  make ch01     Reads: nothing     Writes: ch01.results, toy.md, fig_1_1.csv
#include <vector>
  #include<map>
int main() {}
END
cat > chapters/ch01_toy/slow.cpp << 'END'
// Chapter 1 - What takes long.
// Run:  make ch01     Reads: nothing     Writes: ch01_slow.results, slow.md,
//                                                fig_1_2*.csv, slow.vtu
// Takes longer than 5 s: ./run.sh shows its committed results.
#  include <set>
#include <vector>
int main() {}
END
cp chapters/ch01_toy/toy.cpp chapters/ch02_bare/bare.cpp
for file in ch01.results ch01_slow.results toy.md slow.md; do echo "# committed" > "chapters/ch01_toy/results/$file"; done
printf 'tip 2 mm exact\n# headline tip 2 by hand\n' >> chapters/ch01_toy/results/ch01.results
for file in fig_1_1 fig_1_2 fig_1_2_more; do echo x > "figures/$file.csv"; done

# The program ch01 in the place of a compiled one: what it writes and prints is in WRITES and SAYS, how it ends in ENDS.
cat > bin/ch01 << 'END'
#!/bin/sh
[ "$1" = --quick ] && shift
for file in $WRITES; do
    case $file in ch0?.results) printf 'tip 2 mm exact\n# headline tip 2 by hand\n' ;; *.csv) echo x ;; *) echo "# fresh" ;; esac > "$2/$file"
done
echo "$SAYS"
exit "$ENDS"
END
cp bin/ch01 bin/ch02
chmod +x bin/ch01 bin/ch02

show() { # status, program, chapter, what it writes, what it says, its status
    said=$(WRITES=$4 SAYS=$5 ENDS=$6 "$tools/chapter.sh" show "bin/$2" "out/$2" "chapters/$3" 2>&1)
    status=$?
    [ $status -eq "$1" ] || fault "show $2: status $status instead of $1: $said"
}
said_line() { printf '%s\n' "$said" | grep -q -e "$1" || fault "no line '$1' in: $said"; }
summary() { # status, arguments
    wanted=$1
    shift
    said=$(perl "$tools/summary.pl" "$@" 2>&1)
    status=$?
    [ $status -eq "$wanted" ] || fault "summary.pl $*: status $status instead of $wanted: $said"
}
all="ch01.results ch01_slow.results toy.md slow.md fig_1_1.csv fig_1_2.csv fig_1_2_more.csv"
compare() { perl "$tools/compare.pl" chapters/ch01_toy out/ch01 2>&1; }

# All right.
show 0 ch01 ch01_toy "$all" hello 0
said_line '^ch01 has run, 1 of 2 chapters; figures in out/ch01, what it prints in out/ch01.log$'
grep -qx hello out/ch01.log || fault "the log does not have what the program prints"
grep -q fresh out/ch01/slow.md || fault "committed results replace those that were written"
summary 0 out
said_line '^chapter .*| processor seconds |'
said_line '^ch01 .*| tip = 2 mm .*| *[0-9.]* |'

# With a program left out: the files that it names are committed ones, no others.
left_out="ch01: slow takes longer than 5 s and is left out: ch01_slow.results slow.md fig_1_2*.csv slow.vtu"
show 0 ch01 ch01_toy "ch01.results toy.md fig_1_1.csv" "$left_out" 0
said_line '^ch01 has run, 1 of 2 chapters; slow left out: committed results; figures'
grep -q committed out/ch01/slow.md || fault "the committed results of what is left out are missing"
[ -f out/ch01/fig_1_2_more.csv ] || fault "the committed curves of what is left out are missing"
summary 0 out
said_line '^ch01 .*| *[0-9.]* |'
show 0 ch01 ch01_toy "ch01.results fig_1_1.csv" "$left_out" 0
compare | grep -q 'toy.md: is no longer written' || fault "a quick program writes no toy.md, and compare.pl takes the committed one: $(compare)"
show 0 ch01 ch01_toy "ch01_slow.results" "$(echo "$left_out" | sed 's/_slow.results/.results/')" 0
summary 0 out
said_line '^ch01 .*| tip = 2 mm .*| *committed |'

# With a program that fails after another one has written: nothing is shown as a result.
show 3 ch01 ch01_toy "ch01.results toy.md" "$left_out" 3
said_line '^ch01 ends with status 3$'
[ -z "$(ls out/ch01/*.results 2> /dev/null)" ] || fault "a failed chapter has results: $(ls out/ch01)"

# With neither results nor curves committed; and one line each, also for what has failed or has not run.
show 0 ch02 ch02_bare ch02.results "$(echo "$left_out" | sed 's/ch01/ch02/g')" 0
summary 1 out
said_line '^ch01 .*| failed '
said_line '^ch02 .*| tip = 2 mm'
rm out/ch02/seconds # of a run before this one
summary 1 out ch01 ch02 ch03
said_line '^ch02 .*| failed '
said_line '^ch03 .*| failed '

# What a chapter found, in words: fresh numbers with their units, the headline first, and the picture that shows it.
cat > chapters/ch01_toy/README.md << 'END'
# 1 A toy

![Figure 1.2: how the tip moves](../../figures/fig_1_2.svg)
END
cat > chapters/ch01_toy/findings << 'END'
# a comment
figure fig_1_2
The tip moves by {tip %.2f}, by hand {reference %.0f}: {deviation}.
Once more {tip}.
That is all.
END
cp chapters/ch01_toy/findings chapters/ch02_bare/findings
echo '# 2 Bare' > chapters/ch02_bare/README.md
: > figures/fig_1_2.svg
: > figures/fig_1_1.svg
findings() { # status, arguments
    wanted=$1
    shift
    said=$(perl "$tools/findings.pl" "$@" 2>&1)
    status=$?
    [ $status -eq "$wanted" ] || fault "findings.pl $*: status $status instead of $wanted: $said"
}
sed -i 's/tip 2 mm exact/tip 2.5 mm/' bin/ch01
show 0 ch01 ch01_toy "$all" hello 0
findings 0 out ch01
said_line '^Chapter 1: A toy$'
said_line '^  The tip moves by 2.50 mm, by hand 2 mm: +25 %.$'
said_line '^  Once more 2.5 mm.$'
said_line '^Open first: figures/fig_1_2.svg$'
said_line '^  Figure 1.2: how the tip moves$'
: > out/ch01/fig_1_1.svg
: > out/ch01/fig_1_2.svg
findings 0 out ch01
said_line '^Open first: out/ch01/fig_1_2.svg$'
summary 0 out ch01
said_line '| out/ch01/fig_1_2.svg$'
rm out/ch01/*.results
findings 1 out ch01
said_line '^ch01 has failed'
rm -r chapters/ch02_bare
sed -i '/^tip/d; /^# headline/d' chapters/ch01_toy/results/ch01.results
printf 'tip 2 mm exact\n# headline tip 2 by hand\nlost 1 s varies\n' >> chapters/ch01_toy/results/ch01.results
findings 0 --check
spoil() { # what, sed script, file, what is said
    cp "$3" kept
    sed -i "$2" "$3"
    findings 1 --check
    printf '%s\n' "$said" | grep -qF -e "$4" || fault "$1: expected '$4', got: $said"
    mv kept "$3"
}
words=chapters/ch01_toy/findings
spoil "no picture" '/^figure/d' $words 'names no picture'
spoil "a picture that is not there" 's/fig_1_2$/fig_1_9/' $words 'there is no picture figures/fig_1_9.svg'
spoil "a picture that the text does not show" 's/fig_1_2$/fig_1_1/' $words 'does not show fig_1_1.svg'
spoil "a sentence without the headline" 's/{tip %.2f}/2.50 mm/' $words 'does not have the headline, {tip}'
spoil "a value that is not there" 's/{tip}/{top}/' $words "no value 'top'"
spoil "a value that varies" 's/{tip}/{lost}/' $words "'lost' varies"
spoil "a format that is none" 's/%.2f/%.2s/' $words "'%.2s' is no format"
spoil "a value that is not closed" 's/{tip}/{tip/' $words 'is not closed'
spoil "too few sentences" '$d' $words 'three to six'
spoil "no full stop" '$s/\.$//' $words 'is no sentence'
spoil "a reference of zero" 's/headline tip 2 /headline tip 0 /' chapters/ch01_toy/results/ch01.results 'no deviation from zero'

# The file that is compiled: every include comes once and first, and what takes long says what it writes.
batch="perl $tools/batch.pl"
$batch deep/er/ch01.cpp --main ch01 chapters/ch01_toy/toy.cpp chapters/ch01_toy/slow.cpp || fault "batch.pl makes no folder"
for line in '// Made by tools/batch.pl from ch01_toy/toy.cpp, ch01_toy/slow.cpp: edit those.' '#include <vector>' '#include <map>' '#include <set>' \
    '#include "signorini/report/program.hpp"' '    {"toy", batch_toy::main, ""},' \
    '    {"slow", batch_slow::main, "ch01_slow.results slow.md fig_1_2*.csv slow.vtu"},'; do
    [ "$(grep -cxF -e "$line" deep/er/ch01.cpp)" -eq 1 ] || fault "the batch does not have one line '$line'"
done
awk '/^namespace/ { inside = 1 } /^#include [<"][a-z]/ && inside { exit 1 }' deep/er/ch01.cpp || fault "the batch includes headers late"
[ "$($batch --long chapters/ch01_toy/*.cpp)" = chapters/ch01_toy/slow.cpp ] || fault "batch.pl --long does not list slow.cpp"
sed -i 's/Writes:/writes/' chapters/ch01_toy/slow.cpp
said=$($batch --long chapters/ch01_toy/slow.cpp 2>&1) && fault "what takes long need not say what it writes"
said_line 'slow.cpp takes longer than 5 s, but its heading does not say what it writes'

# A chapter 0 has figures like any other: one that nothing draws is found.
mkdir -p chapters/ch00_zero out/ch00
echo x > figures/fig_0_1.csv
: > figures/fig_0_1.gp
"$tools/chapter.sh" figures chapters/ch00_zero out/ch00 > /dev/null 2>&1 && fault "figure 0.1 cannot be drawn, and nobody complains"
exit $bad
