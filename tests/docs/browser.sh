#!/bin/sh
# browser.sh ROOT FOLDER: the check of the web pages accepts a small book, and finds each fault that is planted in it:
# in pages that it opens and, as far as links and images go, in those that it only reads.
set -u
check="python3 $1/tools/check-docs.py"
rm -rf "$2"
mkdir -p "$2"
cd "$2" || exit 1

page() { # name, body
    printf '<!DOCTYPE html><html><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"></head><body class="%s"><main>%s</main></body></html>\n' \
        "${1%%-*}" "$2" > "$1.html"
}
mkdir reference
index='<h1 id="top">Book</h1><input id="book-find"><p class="hit">notation</p>'
picture='<img alt="" src="data:image/gif;base64,R0lGODlhAQABAAAAACwAAAAAAQABAAA=">'
page index "$index<a href=\"chapter-01.html#first\">1</a>"
page chapter-01 "<h2 id=\"first\">One</h2>$picture<a href=\"index.html#top\">back</a><a href=\"reference/structB.html#member\">B</a><math><mi>x</mi></math>"
page reference/structA "<a href=\"../index.html\">back</a>"            # the first of its kind: opened
page reference/structB "<h2 id=\"member\">B</h2><a href=\"../chapter-01.html#first\">1</a>"  # read
said=$($check . notation 2>&1) || { echo "the clean book is not accepted: $said"; exit 1; }
case $said in
*"3 of 4 pages opened"*) ;;
*) echo "expected to open 3 of 4 pages: $said"; exit 1 ;;
esac

bad=0
expected=""
plant() { # page, body, part of the complaint
    page "$1" "$2"
    expected="$expected$1.html: $3
"
}
plant fault-anchor '<a href="reference/structB.html#gone">x</a>' "dead anchor: reference/structB.html#gone"
plant fault-comma '<p style="width: 3em">word word <a href="index.html">wordy</a> <math><mi>xxxxxx</mi></math>, more</p>' "a line begins with a comma"
plant fault-narrow '<div style="width:600px">x</div>' "wider than a window of 390 pixels"
plant chapter-02 '<figure class="code" style="overflow: hidden; width: 9em"><pre style="overflow: auto">a listing that is too long for its place</pre></figure>' "cut off at 1280 pixels"
plant fault-formula '<math><merror><mtext>wrong</mtext></merror></math>' "formula not shown: wrong"
plant fault-console '<script>console.error("broken")</script>' "console: broken"
plant fault-image '<img alt="" src="gone.svg">' "image does not load: gone.svg"
plant fault-link '<a href="gone.html">x</a>' "dead link: gone.html"
plant fault-outside '<script src="http://127.0.0.1:9/x.js"></script>' "fetches http://127.0.0.1:9/x.js"
plant fault-raw '<p>the gap \(g_0\) and \frac{1}{2}</p>' "raw TeX or command in the text"
plant fault-script '<script>nothing.here()</script>' "script error: ReferenceError"
plant fault-wide '<div style="width:5000px">x</div>' "the page is wider than the window"
plant reference/structC '<a href="gone.html">x</a>' "dead link: gone.html"
plant reference/structD '<a href="../chapter-01.html#gone">x</a>' "dead anchor: ../chapter-01.html#gone"
plant reference/structE '<img alt="" src="gone.svg">' "image does not exist: gone.svg"
said=$($check . notation 2>&1) && { echo "the faulty book is accepted"; bad=1; }
while read -r line; do
    [ -z "$line" ] || printf '%s\n' "$said" | grep -qF "$line" || { echo "not found: $line"; bad=1; }
done << END
$expected
END
page reference/structC '<p>the gap \(g_0\)</p>'
said=$($check --all . notation 2>&1)
printf '%s\n' "$said" | grep -qF "reference/structC.html: raw TeX" || { echo "--all does not open reference/structC.html"; bad=1; }
page index '<h1 id="top">Book</h1>'
printf '%s\n' "$($check . notation 2>&1)" | grep -qF "search: 'notation' is not found" || { echo "a search without hits is accepted"; bad=1; }
[ "$bad" = 0 ] || printf '%s\n' "the check said:" "$said"
exit $bad
