#!/bin/sh
# print.sh ROOT FOLDER: a small book is printed with the right page numbers, formulas shown, links that work, broken words and
# figures that float; each fault that is planted in it is found, and then there is no file.
set -u
print="python3 $1/tools/book-pdf.py"
rm -rf "$2"
mkdir -p "$2/book/figures"
cd "$2" || exit 1
bad=0

page() { # name, title, body
    printf '<!DOCTYPE html><html><head><meta charset="utf-8"></head><body><main><header class="title"><h1>%s</h1></header>%s</main></body></html>\n' \
        "$2" "$3" > "book/$1.html"
}
lines() { yes "<p>$1</p>" | head -n "$2"; }
wrong() { echo "$1"; bad=1; }

# A picture with a pattern and a box behind letters, which browsers alone would print as bitmaps, and one that fits no foot of a page.
cat > book/figures/hatch.svg << 'END'
<svg viewBox="0 0 480 90" xmlns="http://www.w3.org/2000/svg"><defs><pattern id="p" patternUnits="userSpaceOnUse" x="0" y="0" width="8" height="8">
<path style="fill:none; stroke:#222222" d="M-4,0 L8,12"/></pattern>
<filter id="box"><feFlood flood-color="#FFFFFF" result="white"/><feComposite in="SourceGraphic" in2="white" operator="atop"/></filter></defs>
<polygon fill="url(#p)" points="10,10 470,10 470,80 10,80"/><g style="filter:url(#box)"><text x="50" y="50">label</text></g></svg>
END
cat > book/figures/tall.svg << 'END'
<svg viewBox="0 0 480 480" xmlns="http://www.w3.org/2000/svg"><path style="stroke:#222222" d="M0,0 L480,480"/></svg>
END
tall='<figure class="picture"><img src="figures/tall.svg" alt="tall"></figure>'
long=$(yes 'complementarity displacements' | head -n 60)
page index Signorini '<p class="lead">A book.</p><a href="chapter-01.html">1</a><a href="chapter-02.html">2</a>'
page use Book '<p>About it.</p><h2 id="commands">Commands</h2><p>make</p><h2 id="more">More</h2><p>left out</p>'
page chapter-01 "1 One" "<p>The gap <math><msub><mi>g</mi><mn>0</mn></msub></math>, <a href=\"chapter-02.html#late\">later</a>, <a href=\"use.html#more\">more</a>, \
<a href=\"gone_8hpp.html\">a header</a>.</p><p>$long</p><figure class=\"picture\"><img src=\"figures/hatch.svg\" alt=\"hatch\"></figure>"
page exercise-01-1 "Exercise 1.1" '<p>Do it.</p><figure class="code"><pre>make ex1.1 # test</pre></figure><p>Edit <a href="source-ch01_one-exercises-ex1_do-attempt-cpp.html">attempt.cpp</a> only; exercise.hpp has the questions.</p><p>Edit no more.</p><details><summary>Hint 1</summary><p>Think.</p></details>'
page chapter-02 "2 Two" "$(lines Before 36)$tall$(lines After 40)<h2 id=\"late\">Late</h2><div class=\"eq\"><math display=\"block\"><mi>ζ</mi></math></div>"
said=$($print book book.pdf 2>&1) || { echo "the clean book is not printed: $said"; exit 1; }
case $said in # title, contents, about it, chapter 1, three sheets of chapter 2, hints
*": 8 pages, 2 formulas, "*) ;;
*) wrong "expected 8 pages and 2 formulas: $said" ;;
esac
on() { pdftotext -f "$1" -l "$1" -layout book.pdf - | tr -s ' '; }
on 1 | grep -q "The Signorini authors" || wrong "the title page has no authors: $(on 1)"
on 1 | grep -q "Version [0-9.]*$" || wrong "the title page has no version: $(on 1)"
on 1 | grep -q "MIT License" || wrong "the title page has no licence: $(on 1)"
on 2 | grep -q 'Late 7' || wrong "the contents do not have Late on sheet 7: $(on 2)"
on 7 | grep -q '^ *Late' || wrong "Late is not on sheet 7: $(on 7)"
on 4 | grep -q 'later p. 7, more, a header' || wrong "a link to sheet 7 does not say so: $(on 4)"
on 4 | tr '\n' ' ' | grep -q 'Do it. · make ex1.1 · exercises/ex1_do · hints p. 8 Edit no more' || wrong "an exercise does not say its command and where its hints are: $(on 4)"
on 4 | grep -q '[a-z].*‐$' || wrong "no word is broken: $(on 4)"
on 4 | grep -q ' complementarity displacements ' || wrong "no whole word can be searched: $(on 4)"
on 5 | grep -q After || wrong "no text goes before a figure that does not fit: $(on 5)"

faulty() { # what, complaints ...: the book is not printed, and each complaint is there
    what=$1
    shift
    said=$($print book book.pdf 2>&1) && wrong "$what: printed"
    [ ! -e book.pdf ] || wrong "$what: a file is left"
    for complaint in "$@"; do
        printf '%s\n' "$said" | grep -qF "$complaint" || wrong "$what: not found: $complaint, but: $said"
    done
}
page chapter-01 "1 One" '<p><a href="chapter-02.html#gone">x</a> <math><merror><mtext>wrong</mtext></merror></math> <img src="figures/gone.svg" alt="gone"></p>'
page chapter-02 "2 Two" "<table><tr><td>$(yes wide | head -n 60 | tr '\n' '_')</td><td>$(yes wide | head -n 60 | tr -d '\n')</td></tr></table>"
page exercise-01-1 "Exercise 1.1" "<p>Do it.</p><div class=\"eq\"><div class=\"scroll\"><math display=\"block\"><mspace width=\"100mm\"/><mi>a</mi></math></div></div>"
faulty "what is joined" "wider than its column: a" "the place #chapter-02-gone exists 0 times" "formula not drawn: wrong" "image does not load" "chapter-02: wider than the paper: TABLE"

page chapter-01 "1 One" "<p><math><mphantom><mi>ζ</mi></mphantom></math></p>"
page exercise-01-1 "Exercise 1.1" "<p>Do it.</p>"
page chapter-02 "2 Two" "<p><img alt=\"\" src=\"data:image/gif;base64,R0lGODlhAQABAAAAACwAAAAAAQABAAA=\"></p>$(lines Before 20)<blockquote>$(lines Kept 35)</blockquote><h2>Foot</h2>"
faulty "what is printed" "of 1 signs ζ in formulas a search finds 0" "page 5: bitmaps" "page 5: 4" "% of it are white" \
    "page 6: a heading at its foot: Foot"
CHROMIUM='' PATH=/nowhere /usr/bin/python3 "$1/tools/book-pdf.py" book book.pdf 2>&1 | grep -q 'tools/setup.sh print' ||
    wrong "without a browser the tool does not name the set-up"
printf '<?xml version="1.0"?><fontconfig><dir>%s/none</dir><cachedir>%s/none</cachedir></fontconfig>\n' "$2" "$2" > faceless.conf
FONTCONFIG_FILE=$2/faceless.conf $print --ready 2>&1 | grep -q 'no face has these letters: .*接.*: tools/setup.sh print' ||
    wrong "without faces the tool does not name them and the set-up"
exit $bad
