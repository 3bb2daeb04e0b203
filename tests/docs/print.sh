#!/bin/sh
# print.sh ROOT FOLDER: a small book is printed with the right page numbers, formulas shown and links that work; each fault
# that is planted in it is found, and then there is no file.
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
# A picture with a pattern and a box behind letters, which browsers alone would print as bitmaps.
cat > book/figures/hatch.svg << 'END'
<svg viewBox="0 0 480 90" xmlns="http://www.w3.org/2000/svg"><defs><pattern id="p" patternUnits="userSpaceOnUse" x="0" y="0" width="8" height="8">
<path style="fill:none; stroke:#222222" d="M-4,0 L8,12"/></pattern>
<filter id="box"><feFlood flood-color="#FFFFFF" result="white"/><feComposite in="SourceGraphic" in2="white" operator="atop"/></filter></defs><polygon fill="url(#p)" points="10,10 470,10 470,80 10,80"/>
<g style="filter:url(#box)"><text x="50" y="50">label</text></g></svg>
END
lines=$(yes '<p>One line after another.</p>' | head -n 90)
page index Signorini '<p class="lead">A book.</p><a href="chapter-01.html">1</a><a href="chapter-02.html">2</a>'
page use Book '<p>About it.</p><h2 id="commands">Commands</h2><p>make</p><h2 id="more">More</h2><p>left out</p>'
page chapter-01 "1 One" "<p>The gap <math><msub><mi>g</mi><mn>0</mn></msub></math>, <a href=\"chapter-02.html#late\">later</a>, <a href=\"use.html#more\">more</a>, \
<a href=\"gone_8hpp.html\">a header</a>.</p><figure class=\"picture\"><img src=\"figures/hatch.svg\" alt=\"hatch\"></figure>"
page exercise-01-1 "Exercise 1.1" '<p>Do it.</p><details><summary>Hint 1</summary><p>Think.</p></details>'
page chapter-02 "2 Two" "$lines<h2 id=\"late\">Late</h2><div class=\"eq\"><math display=\"block\"><mi>a</mi></math></div>"
said=$($print book book.pdf 2>&1) || { echo "the clean book is not printed: $said"; exit 1; }
case $said in # title, contents, about it, chapter 1, three sheets of chapter 2, hints
*": 8 pages, 2 formulas, "*) ;;
*) echo "expected 8 pages and 2 formulas: $said"; bad=1 ;;
esac
if command -v pdftotext > /dev/null 2>&1; then
    pdftotext -f 2 -l 2 -layout book.pdf contents.txt
    tr -s ' ' < contents.txt | grep -q 'Late 7' || { echo "the contents do not have Late on sheet 7:"; cat contents.txt; bad=1; }
fi

page chapter-01 "1 One" '<p><a href="chapter-02.html#gone">x</a> <math><merror><mtext>wrong</mtext></merror></math> <img src="figures/gone.svg" alt="gone"></p>'
page chapter-02 "2 Two" "<table><tr><td>$(yes wide | head -n 60 | tr '\n' '_')</td><td>$(yes wide | head -n 60 | tr -d '\n')</td></tr></table>\
<pre>short</pre><img alt=\"\" src=\"data:image/gif;base64,R0lGODlhAQABAAAAACwAAAAAAQABAAA=\">"
said=$($print book book.pdf 2>&1) && { echo "the faulty book is printed"; bad=1; }
[ ! -e book.pdf ] || { echo "the faulty book leaves a file"; bad=1; }
for complaint in "the place #chapter-02-gone exists 0 times" "formula not drawn: wrong" "image does not load" "page 4: bitmaps" "page 5: bitmaps" "chapter-02: wider than the paper: TABLE"; do
    printf '%s\n' "$said" | grep -qF "$complaint" || { echo "not found: $complaint"; bad=1; }
done
[ "$bad" = 0 ] || printf '%s\n' "the tool said:" "$said"
CHROMIUM='' PATH=/nowhere /usr/bin/python3 "$1/tools/book-pdf.py" book book.pdf 2>&1 | grep -q 'tools/setup.sh print' ||
    { echo "without a browser the tool does not name the set-up"; bad=1; }
printf '<?xml version="1.0"?><fontconfig><dir>%s/none</dir><cachedir>%s/none</cachedir></fontconfig>\n' "$2" "$2" > faceless.conf
FONTCONFIG_FILE=$2/faceless.conf $print --ready 2>&1 | grep -q 'no face has these letters: .*接.*: tools/setup.sh print' ||
    { echo "without faces the tool does not name them and the set-up"; bad=1; }
exit $bad
