#!/bin/sh
# faults.sh ROOT FOLDER: the checks of text, numbers and figures find the faults that they are there for.  Makes a
# chapter of a few lines in FOLDER, shows that the checks accept it, and then breaks one thing after the other.
set -u
tools=$1/tools
clean=$2.clean
rm -rf "$2" "$clean"
mkdir -p "$2/chapters/ch03_demo/results" "$2/chapters/ch03_demo/exercises/ex1_demo" "$2/figures" "$2/fresh" "$2/tests/reference"
cd "$2" || exit 1
failures=0
text=chapters/ch03_demo/README.md

cp "$1/figures/style.gp" figures/
exercise=chapters/ch03_demo/exercises/ex1_demo/README.md
printf '# Exercise\n\n<details><summary>Hint 1</summary>\n\nThink.\n\n</details>\n' > $exercise
: > chapters/ch03_demo/exercises/ex1_demo/solution.cpp
printf '# headline force 2.5 by hand\nforce 2.5000001 N\npairs 12 -\nseconds 0.3 s varies\n' > fresh/ch03.results
printf '# tolerance rel 1e-6 abs 1e-9\nx,p\n0,1.25\n1,2.5\n\n0,1\n1,2\n' > fresh/fig_3_1.csv
printf '| n | p |\n|--:|--:|\n| 4 | 1.25 |\n' > fresh/table.md
cat > figures/fig_3_1.gp << 'END'
load 'style.gp'
set xlabel 'position {/:Italic x} [m]'
plot data.'/fig_3_1.csv' using 'x':'p' with lines ls 1 title 'p'
END
printf '| n | s ≈ |\n|--:|--:|\n| 4 | 0.31 |\n' > fresh/seconds.md
printf '# tolerance rel 1e-6 abs 1e-9\nx,s ≈\n0,0.25\n1,0.5\n' > fresh/fig_3_1_seconds.csv
printf 'steps 7 -\n' > fresh/ch03_more.results
printf '// [block]\n  int n = 0;\n  // [block]\n' > chapters/ch03_demo/demo.cpp
printf 'pairs = 12\n' > chapters/ch03_demo/demo.toml
cat > $text << 'END'
# Demonstration

<!-- nav -->
<!-- /nav -->

The force of [(3)](#eq-3) is <!--= force %.2f --><!--/--> N with <!--= pairs %d --><!--/--> pairs, $`x_1^*`$ and $p_0$.

<a id="eq-3"></a>

```math
a = b \tag{3}
```

<!-- code demo.cpp#block -->
<!-- /code -->

<!-- code demo.toml -->
<!-- /code -->

<!-- table table.md -->
<!-- /table -->

![The pressure](../../figures/fig_3_1.svg)

<a id="box-3-1"></a>
> **Left open.** How to begin.

[Exercise](exercises/ex1_demo/README.md)
END
list=tests/reference/claims.md
cat > $list << 'END'
# Claims

| box-3-1 | Left open | [the step](../../chapters/ch03_demo/README.md#box-3-1) | no start is given | 1 | 2–3 | `任意 ... σn− ≥0` |
| note-1 | Left open | [(3)](../../chapters/notation.md) | no start is given | 1 | 2 | `任意` |
END
cat > chapters/notation.md << 'END'
# Notation

## Where we differ from the papers

| equation | kind | as printed |
|:--|:--|:--|
| (3) | Left open | any start |
END
printf 'paper\n从任意一点\n开始, \357\201\263 n\357\200\255  ≥ 0\n' > paper_1.txt # with sigma and minus of the font Symbol
: > paper_2.txt
printf '# Title\n\n[Demonstration](chapters/ch03_demo/README.md)\n' > README.md
printf '# Chapters\n\n[Demonstration](ch03_demo/README.md)\n' > chapters/README.md

expect() { # yes or no, what, command
    wanted=$1 what=$2
    shift 2
    if said=$("$@" 2>&1); then got=yes; else got=no; fi
    [ "$got" = "$wanted" ] || { echo "$what: accepted: $got, expected $wanted. $said"; failures=$((failures + 1)); }
}
compare() { perl "$tools/compare.pl" "$@" chapters/ch03_demo fresh; }
weave() { perl "$tools/weave.pl" "$@" README.md $text; }
lint() { perl "$tools/lint-md.pl" README.md $text $exercise; }
claims() { perl "$tools/claims.pl" .; }
quoted() { perl "$tools/claims.pl" . paper_1.txt paper_2.txt; }
draw() { "$tools/figure.sh" figures/fig_3_1.gp "$1" "${2:-figures}"; }
picture() { "$tools/figure.sh" --check figures/fig_3_1.gp; }
have_gnuplot() { command -v gnuplot > /dev/null 2>&1; }

expect no "nothing committed yet" compare
expect yes "results accepted" compare --update
expect yes "woven" weave
have_gnuplot && expect yes "drawn" draw figures/fig_3_1.svg || : > figures/fig_3_1.svg
cp -r . "$clean"

broken() { # yes or no, what, check, sed script, file: from a clean copy, after the change
    rm -rf ./* && cp -r "$clean/." . && sed -i "$4" "$5"
    expect "$1" "$2" $3
}
expect yes "clean numbers" compare
expect yes "clean text" weave --check
expect yes "clean Markdown" lint
expect yes "clean claims" claims
expect yes "clean quotations of the papers" quoted

broken no "a number that left the tolerance" compare 's/2.5000001/2.50001/' fresh/ch03.results
broken yes "a number within the tolerance" compare 's/2.5000001/2.5000002/' fresh/ch03.results
broken no "a changed integer" compare 's/pairs 12/pairs 13/' fresh/ch03.results
broken no "another unit" compare 's/2.5000001 N/2.5000001 kN/' fresh/ch03.results
broken no "a lost number" compare '/pairs/d' fresh/ch03.results
broken no "a new number" compare '$a new 1 -' fresh/ch03.results
broken no "another reference" compare 's/headline force 2.5/headline force 2.6/' fresh/ch03.results
broken yes "a time" compare 's/0.3 s/0.9 s/' fresh/ch03.results
broken no "a value that becomes unquotable" compare 's/12 -/12 - varies/' fresh/ch03.results
broken no "a curve that moved" compare 's/^1,2.5/1,2.6/' fresh/fig_3_1.csv
broken no "a lost row" compare '/^1,2.5/d' fresh/fig_3_1.csv
broken no "a renamed column" compare 's/x,p/x,q/' fresh/fig_3_1.csv
broken no "a looser tolerance" compare 's/rel 1e-6/rel 1e-1/' fresh/fig_3_1.csv
broken no "a table that changed" compare 's/1.25/1.35/' fresh/table.md
broken yes "the last digit of a table" compare 's/1.25/1.26/' fresh/table.md
broken yes "a measured column of a table" compare 's/0.31/0.62/' fresh/seconds.md
broken no "the column beside it" compare 's/4 |/5 |/' fresh/seconds.md
broken no "a table that is measured no more" compare 's/ ≈//' fresh/seconds.md
broken yes "a measured column of a curve" compare 's/0.25/0.75/' fresh/fig_3_1_seconds.csv
broken no "the curve beside it" compare 's/^1,/2,/' fresh/fig_3_1_seconds.csv
broken no "a number of the second program" compare 's/7/8/' fresh/ch03_more.results
broken no "a number that two programs write" "weave --check" 's/steps/force/' chapters/ch03_demo/results/ch03_more.results

broken no "a wrong number in the text" "weave --check" 's/-->2.50<!/-->2.51<!/' $text
broken no "a number that does not exist" "weave --check" 's/!--= force/!--= forse/' $text
broken no "a number without a format" "weave --check" 's/force %.2f/force/' $text
broken no "a quoted time" "weave --check" 's/!--= force %.2f/!--= seconds %.2f/' $text
broken no "code that changed" "weave --check" 's/n = 0/n = 1/' chapters/ch03_demo/demo.cpp
broken no "a file that changed" "weave --check" 's/12/13/' chapters/ch03_demo/demo.toml
broken no "a lost block" "weave --check" '1d' chapters/ch03_demo/demo.cpp
broken no "a table that was edited" "weave --check" 's/1.25/1.24/' $text
broken no "a quotation that is not closed" "weave --check" '/\/table/d' $text
broken no "a title that changed" "weave --check" '/^\[Contents/d' $text

broken no "a dead link" lint 's/ch03_demo/ch04_demo/' README.md
broken no "a front door that is too long" lint 's/^# Title/&'"$(printf '\\n%.0s' $(seq 120))/" README.md
broken no "a dead anchor" lint 's/(#eq-3)/(#eq-4)/' $text
broken no "a number beside its anchor" lint 's/tag{3}/tag{4}/' $text
broken no "a formula that Markdown damages" lint 's/`x_1^\*`/x_1^*/' $text
broken no "a dollar sign without partner" lint 's/\$p_0\$/$p_0/' $text
broken no "a picture that is not there" lint 's/fig_3_1.svg/fig_3_2.svg/' $text
broken no "an exercise nobody links to" lint '/^\[Exercise/d' $text
broken no "a hint that is not folded" lint 's/Think/*Hint 2.* Think/' $exercise
broken no "folded text that Markdown does not see" lint '4d' $exercise
broken no "a hint that is not closed" lint '$d' $exercise
broken no "a hint that is closed twice" lint '$p' $exercise
broken no "a refused macro" lint 's/a = b/\\operatorname{a} = b/' $text
broken no "a link to a solution" lint 's/^\[Exercise.*/&, [it](exercises\/ex1_demo\/solution.cpp)/' $text

broken no "a box without a row" claims '/box-3-1/d' $list
broken no "a row that stands there twice" claims '$p' $list
broken no "a box of another name" claims 's/Left open/Erratum/' $text
broken no "a box of another kind than its row" claims 's/Left open/Misprint/' $text
broken no "a box without an anchor" claims '/^<a id="box/d' $text
broken no "an anchor of another number" claims 's/id="box-3-1"/id="box-3-2"/' $text
broken no "a row without a box" claims '/^> /d' $text
broken no "a row that links elsewhere" claims 's/#box-3-1/#eq-3/' $list
broken no "a row without a line of the paper" claims 's/2–3/there/' $list
broken no "a row without a quotation" claims 's/`.*`//' $list
broken no "a row in the notation without a kind" claims 's/Left open/wrong/' chapters/notation.md
broken no "a row of the notation of another kind" claims 's/Left open/Misprint/' chapters/notation.md
broken no "a row of the notation without a row of its own" claims '/note-1/d' $list
broken no "a notation without the list" claims '/^|/d' chapters/notation.md
broken no "a quotation that is not in the paper" quoted 's/任意/随意/' $list
broken no "a quotation with another sign" quoted 's/σn−/σn+/' $list
broken no "a quotation that is elsewhere" quoted 's/2–3/3/' $list
broken no "lines that the paper does not have" quoted 's/2–3/2–9/' $list

if have_gnuplot; then
    broken yes "a clean picture" picture 's/a/a/' README.md
    broken no "a picture older than its data" picture 's/1.25/1.26/' figures/fig_3_1.csv
    broken no "a picture older than its script" picture 's/ls 1/ls 2/' figures/fig_3_1.gp
    broken no "a label that loses its blanks" picture 's/ xml:space="preserve"//' figures/fig_3_1.svg
    broken no "a column that is not there" "draw new.svg" "s/'p' with/'q' with/" figures/fig_3_1.gp
    broken no "data that are not there" "draw new.svg" 's/fig_3_1.csv/fig_3_9.csv/' figures/fig_3_1.gp
    broken no "a mistake in a script" "draw new.svg" 's/plot/plod/' figures/fig_3_1.gp
fi

# the text of labels: what is cut from a picture is never cut from its words
label="41.76 kN,  the paper's 'a' = 0.25, 1.05"
cat > label.svg << END
<path d='M12.34,56.78 L1.25,2.35 '/>
<polygon fill = 'red' points = '1.00,1.00 2.00,1.00 2.00,2.00 1.00,1.00'/>
<polygon fill = 'red' points = '2.00,1.00 3.00,1.00 3.00,2.50 3.00,2.50 2.00,1.00'/>
<text><tspan>$label</tspan></text>
END
perl "$tools/svgtidy.pl" label.svg
expect yes "the words of a label" grep -qF ">$label<" label.svg
expect yes "the second decimal of a line" grep -qF "'M12.3,56.7 L1.2,2.3'" label.svg
expect yes "two polygons of one colour" grep -qF "<path fill='red' d='M1.0,1.0l1,0 0,1zM2.0,1.0l1,0 0,1.5z'/>" label.svg
expect yes "a tidy picture" perl "$tools/svgtidy.pl" --check label.svg

# the programs of exercises tell the judge by a secret how many assertions of a test passed and failed
program() { # file, what it does
    {
        printf '#!/bin/sh\nread -r secret <&3\ntab=$(printf "\\t")\n'
        printf 'tell() { echo "$secret$tab$1$tab$2${tab}a test" >&4; echo "$secret${tab}end${tab}open" >&4; }\n%s\n' "$2"
    } > "$1" && chmod +x "$1"
}

# the starter of an exercise
starter() { program program "$1" && perl "$tools/judge.pl" starter ./program; }
expect yes "a starter that fails a check" starter 'tell 1 1; exit 1'
expect no "a starter that passes" starter 'tell 2 0'
expect no "a starter that passes with a status" starter 'echo "1 failed"; exit 1'
expect no "a starter that crashes" starter 'tell 0 1; kill -SEGV $$'
expect no "a starter that ends early" starter 'exit 3'
expect no "a starter that does not exist" perl "$tools/judge.pl" starter ./nowhere

# the answer to an exercise: its last line is a verdict, whatever the tests say
judged() { # last line, status, what, tests, held-out tests or nothing
    program seen "$4"
    program heldout "${5:-}"
    said=$(perl "$tools/judge.pl" ex3.1 attempt.cpp ./seen ${5:+./heldout} 2>&1)
    status=$?
    if [ "$status" -ne "$2" ] || [ "$(printf '%s\n' "$said" | tail -n 1)" != "$1" ]; then
        echo "$3: status $status, said: $said"
        failures=$((failures + 1))
    fi
}
again="edit attempt.cpp, then make ex3.1 again"
judged "ex3.1: right, also on the held-out tests" 0 "a right answer" 'tell 1 0' 'tell 1 0; echo passed'
[ "$said" = "ex3.1: right, also on the held-out tests" ] || { echo "a right answer takes more than a line: $said"; failures=$((failures + 1)); }
judged "ex3.1: right" 0 "a right answer in a hand-out" 'tell 1 0'
judged "ex3.1: not yet; $again" 1 "a wrong answer" 'echo "0 == 1"; tell 0 1; exit 1' 'tell 1 0'
case $said in "0 == 1"*) ;; *) echo "a wrong answer does not learn what failed: $said"; failures=$((failures + 1)) ;; esac
judged "ex3.1: right on the tests that you see, not yet on the held-out ones; $again" 1 "a memorised answer" 'tell 1 0' 'tell 1 1; exit 1'
judged "ex3.1: not yet; $again" 1 "an answer that crashes" 'tell 1 0; kill -SEGV $$' 'tell 1 0'
judged "ex3.1: not yet; $again" 1 "an answer that only says that it passes" 'echo "All tests passed"' 'tell 1 0'
judged "ex3.1: not yet; $again" 1 "an answer that does not know the secret" 'secret=1; tell 1 0' 'tell 1 0'

[ "$failures" -eq 0 ] || { echo "$failures faults were judged wrongly"; exit 1; }
