#!/bin/sh
# docs.sh [BOOK]: makes the web pages of the book, BOOK/index.html (default build/book).
#
# Needs doxygen and perl.  MathJax 2 comes from the package libjs-mathjax, the look from
# doxygen-awesome-css if that is installed; both are copied, so that the pages work without network and
# from a memory stick.  Any warning of Doxygen and any complaint of the filter is an error.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
book=$(realpath -m "${1:-$root/build/book}")
work=$book.work
engine=$(dirname "$book")/engine/engine.js
theme=/usr/share/doxygen-awesome-css
mathjax=/usr/share/javascript/mathjax
for need in "command -v doxygen" "test -f $mathjax/MathJax.js"; do
    $need > /dev/null || { echo "docs.sh: not found: $need. Run: tools/setup.sh book" >&2; exit 2; }
done

rm -rf "$book" "$work"
mkdir -p "$book/mathjax" "$work"
cd "$work"

# The page header of this very Doxygen.  Its own $mathjax (and $mermaidjs) lines load scripts from other
# sites; they make room for head.html.  Figures compute where tools/engine.sh has made the engine.
doxygen -w html header.html footer.html style.css > /dev/null
cp "$root/docs/head.html" head.html
extra="\"$root/docs/book.js\""
if [ -f "$engine" ]; then
    echo '<script type="text/javascript" src="$relpath^live.js"></script>' >> head.html
    extra="$extra \"$root/docs/live.js\" \"$engine\""
    [ -z "$(find "$root/src" "$root"/chapters/*/live -newer "$engine" -name '*.[ch]pp' | head -n 1)" ] ||
        echo "docs.sh: figures compute with an engine older than the sources: make engine"
fi
HEAD=head.html perl -0pi -e '
    BEGIN { open my $f, "<", $ENV{HEAD} or die "$ENV{HEAD}: $!"; local $/; $h = <$f> }
    s/^\$(mathjax|mermaidjs)\n//mg; s{</head>}{$h</head>} or die "no </head>"' header.html

# Of MathJax only what SVG output needs, 3 of 47 MB.
(cd "$mathjax" && tar chf - MathJax.js config/TeX-AMS_SVG.js jax/input/TeX jax/output/SVG/*.js jax/output/SVG/autoload \
    jax/output/SVG/fonts/TeX jax/element extensions/TeX extensions/*.js) | tar xf - -C "$book/mathjax"

css="\"$root/docs/book.css\" \"$root/docs/live.css\""
if [ -f "$theme/doxygen-awesome.css" ]; then
    css="\"$theme/doxygen-awesome.css\" \"$theme/doxygen-awesome-sidebar-only.css\" $css"
fi

# The order of the input is the order of the sidebar.
input="\"$root/README.md\""
for text in "$root"/chapters/README.md "$root"/chapters/sheets.md "$root"/docs/teaching.md "$root"/examples/README.md "$root"/chapters/notation.md "$root"/chapters/glossary.md \
    "$root"/chapters/words.md "$root"/chapters/equations.md; do
    [ ! -f "$text" ] || input="$input \"$text\""
done
chapters=$(sed -n 's,.*](\(chapters/ch[0-9][0-9]_[^/)]*/README\.md\)).*,\1,p' "$root/README.md" | awk '!seen[$0]++') # in the order of its table
for text in $chapters; do
    input="$input \"$root/$text\""
done
perl "$root/tools/evenings.pl" "$root" "$work/pages"
for text in "$work"/pages/src+evenings.md "$work"/pages/src+evening-*.md "$work"/pages/*pp.md; do
    input="$input \"$text\""
done
input="$input \"$root/docs/references.md\" \"$root/CONTRIBUTING.md\" \"$root/CHANGELOG.md\" \"$root/docs/library.dox\" \"$root/src\""
for file in "$root"/chapters/ch[0-9][0-9]_*/*.cpp "$root"/chapters/ch*/exercises/ex*/README.md; do
    [ ! -f "$file" ] || input="$input \"$file\""
done
sed -e "s#@ROOT@#$root#g" -e "s#@WORK@#$work#g" -e "s#@BOOK@#$book#g" -e "s#@INPUT@#$input#" -e "s#@CSS@#$css#" -e "s#@EXTRA@#$extra#" \
    "$root/docs/Doxyfile.in" > Doxyfile

# Settings that some versions do not know: a wrong tag would be a warning.
doxygen -s -g - > all-tags 2> /dev/null
option() { if grep -q "^$1 " all-tags; then echo "$1 = $2" >> Doxyfile; fi; }
option HTML_COLORSTYLE LIGHT    # book.js has the dark mode
option IMPLICIT_DIR_DOCS NO     # chapters/*/README.md are pages, not descriptions of folders
option PAGE_OUTLINE_PANEL NO
option HTML_COPY_CLIPBOARD NO
option HTML_CODE_FOLDING NO
option MARKDOWN_STRICT NO

(cd "$root" && find figures chapters \( -name '*.svg' -o -name '*.png' -o -name '*.gif' \)) | while read -r f; do
    mkdir -p "$book/$(dirname "$f")"
    cp "$root/$f" "$book/$f"
done

cd "$root"
status=0
BOOK_ROOT=$root BOOK_HTML=$book BOOK_PAGES=$work/pages doxygen "$work/Doxyfile" 2> "$work/warnings" || status=$?
cat "$work/warnings" >&2
[ "$status" -eq 0 ] && [ ! -s "$work/warnings" ]
