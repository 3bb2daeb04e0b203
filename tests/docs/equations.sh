#!/bin/sh
# equations.sh ROOT FOLDER: the index of equations misses nothing.  In a copy of the texts in FOLDER, takes away the last
# equation of each paper, and one tag in code and one in a test, and expects a complaint each time.
set -u
root=$1 copy=$2
rm -rf "$copy"
mkdir -p "$copy"
(cd "$root" && tar cf - --exclude=results --exclude='*.svg' --exclude='*.csv' --exclude='*.msh' --exclude=data chapters src tests tools) | tar xf - -C "$copy"
cd "$copy" || exit 1
perl tools/equations.pl --check || exit 1
failures=0

without() { # what is taken away, from which file
    cp "$2" kept
    sed "s@$1@@" kept > "$2"
    if cmp -s kept "$2"; then
        echo "equations.sh: '$1' is not in $2"
        failures=1
    elif perl tools/equations.pl --check > /dev/null 2>&1; then
        echo "equations.sh: nobody misses '$1' in $2"
        failures=1
    fi
    cp kept "$2"
}

without '<a id="eq-39"></a>' "$(grep -l 'id="eq-39"' chapters/ch04_*/README.md)"
without '<a id="eq-46"></a>' "$(grep -l 'id="eq-46"' chapters/ch13_*/README.md)"
without 'PaperEq{LinEtAl, 43}' src/closed_form/hertz.hpp
[ "$failures" -eq 0 ] || exit 1
cd / && rm -rf "$copy"
