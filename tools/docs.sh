#!/bin/sh
# docs.sh [BOOK]: makes the web pages of the book, BOOK/index.html (default build/book), and the reference of src/, BOOK/reference.
#
# tools/book makes the pages, with Python 3 and nothing else; Doxygen makes the reference, from copies of the headers in which
# formulas are MathML.  Where tools/engine.sh has made the engine, figures compute.  All works without network and from a memory
# stick.  Any warning of Doxygen and any complaint about a formula, a link or a number is an error.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
book=$(realpath -m "${1:-$root/build/book}")
work=$book.work
engine=$(dirname "$book")/engine/engine.js
for need in doxygen python3 perl; do
    command -v $need > /dev/null || { echo "docs.sh: not found: $need. Run: tools/setup.sh book" >&2; exit 2; }
done

rm -rf "$book" "$work"
mkdir -p "$book/reference" "$work"
if [ -f "$engine" ]; then
    cp "$engine" "$book/engine.js"
    [ -z "$(find "$root/src" "$root"/chapters/*/live -newer "$engine" -name '*.[ch]pp' | head -n 1)" ] ||
        echo "docs.sh: figures compute with an engine older than the sources: make engine"
fi

# 1. The reference.  The header of this very Doxygen without its scripts from other sites, a footer that says nothing.
python3 "$root/tools/book/contracts.py" "$root" "$work"
cd "$work"
doxygen -w html header.html footer.html style.css > /dev/null
perl -0pi -e 's/^\$(mathjax|mermaidjs)\n//mg; s{<div id="projectname">\$projectname}{<div id="projectname"><a href="../index.html">\$projectname</a>};
    s{</head>}{<script>document.documentElement.classList.add((() => { try { return localStorage.getItem("book-tone"); } catch { return null; } })() ??
(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light"));</script>\n</head>}' header.html
printf '%s\n' '<!--BEGIN GENERATE_TREEVIEW--><div id="nav-path" class="navpath"><ul>$navpath</ul></div><!--END GENERATE_TREEVIEW-->' \
    '</body></html>' > footer.html
sed -e "s#@ROOT@#$root#g" -e "s#@WORK@#$work#g" -e "s#@BOOK@#$book#g" "$root/docs/Doxyfile.in" > Doxyfile
doxygen -s -g - > all-tags 2> /dev/null    # settings that some versions do not know: a wrong tag would be a warning
option() { if grep -q "^$1 " all-tags; then echo "$1 = $2" >> Doxyfile; fi; }
option HTML_COLORSTYLE LIGHT    # reference.css has the dark one
option PAGE_OUTLINE_PANEL NO
option HTML_COPY_CLIPBOARD NO
option HTML_CODE_FOLDING NO
status=0
doxygen Doxyfile 2> warnings || status=$?
sed "s#$work/#$root/#g" warnings >&2
[ "$status" -eq 0 ] && [ ! -s warnings ] || exit 1
# Some Doxygens head a page with a link to classes that it does not list.
for page in "$book"/reference/*.html; do
    grep -Eq '(id|name)="nested-classes"' "$page" || perl -pi -e 's{<a href="#nested-classes">Classes</a>(?: &#124;)?}{}' "$page"
done

# 2. The pages.
python3 "$root/tools/book/book.py" "$root" "$book" "$work/tags"
