#!/bin/sh
# evenings.sh ROOT FOLDER: the sources of the library are checked as pages to read. In a copy of the texts in FOLDER, plants a fault
# after the other and expects a complaint each time; then looks at where functions lead.
set -u
root=$1 copy=$2
rm -rf "$copy"
mkdir -p "$copy"
(cd "$root" && tar cf - --exclude=results --exclude='*.svg' --exclude='*.csv' --exclude='*.msh' --exclude=data chapters docs src tests tools) |
    tar xf - -C "$copy"
cd "$copy" || exit 1
perl tools/evenings.pl --check || exit 1
failures=0

fault() { # what, sed script, file, part of the complaint
    cp "$3" kept
    sed -i "$2" "$3"
    if cmp -s "$3" kept; then
        echo "evenings.sh: $1: nothing to change in $3"
        failures=1
    fi
    said=$(perl tools/evenings.pl --check 2>&1)
    case $? in
    0) echo "evenings.sh: nobody misses: $1"; failures=1 ;;
    *) printf '%s\n' "$said" | grep -qF "$4" || { echo "evenings.sh: $1: expected '$4', got: $said"; failures=1; } ;;
    esac
    cp kept "$3"
}

list=src/evenings
errors=src/signorini/core/errors.hpp
fault "a file on no evening" '/^signorini\/core\/errors$/d' $list "signorini/core/errors.hpp stands on no evening"
fault "a file on two evenings" 's/^papers\/examples$/&\nsignorini\/core\/errors/' $list "signorini/core/errors.hpp stands twice"
fault "an entry without file" 's/^papers\/examples$/&\npapers\/nothing/' $list "there is no papers/nothing.hpp and no papers/nothing.cpp"
fault "a line that is none of these" 's/^papers\/examples$/&,/' $list "expected an evening or a name, got: papers/examples,"
fault "a header that comes too late" '/^signorini\/core\/errors$/d; s/^papers\/examples$/&\nsignorini\/core\/errors/' $list \
    "core/family.hpp includes signorini/core/errors.hpp, which comes later"
fault "a file of 251 lines" "\$s/\$/$(printf '\\n\/\/ line%.0s' $(seq $((251 - $(wc -l < $errors)))))/" $errors "$errors: 251 lines"
fault "a file without comments" 's/^ *\/\/.*//' $errors "$errors: fewer comments than one line of 4"
fault "a link that leads nowhere" '1s/^/\/\/ See [this](nowhere.hpp).\n/' $errors "$errors: there is no nowhere.hpp"
fault "an equation that does not exist" '1s/^/\/\/ \\PaperEq{XuanLi2002, 40}\n/' $errors "$errors: no chapter explains equation (40) of XuanLi2002"

# A function leads to its contract, its test, the chapters that use it and its equation.
perl tools/evenings.pl --leads . > leads || exit 1
leads() { # file, words that its line has, part of the line
    grep "^$1" leads | grep -F "$2" | grep -qF -- "$3" || { echo "evenings.sh: $2 in $1 does not lead to: $3"; failures=1; }
}
dual=src/papers/surrogate_dual.cpp ledger=src/signorini/core/ledger.cpp
leads $dual 'surrogate_dual_value()' '[`surrogate_dual_value()`](../../src/papers/surrogate_dual.hpp) · [test_surrogate_dual.cpp](../../tests/papers/test_surrogate_dual.cpp)'
leads $dual 'surrogate_dual_value()' ' · chapters [2](../../chapters/ch02_surrogate_dual/README.md), [3](../../chapters/ch03_simplex_updates/README.md)'
leads $dual 'surrogate_dual_value()' '\PaperEq{XuanLi2002, 24}'
leads $ledger 'Ledger::Phase' '[`Ledger::Phase`](../../../src/signorini/core/ledger.hpp)'    # a constructor
leads $ledger 'Ledger::count()' 'ledger.hpp'    # a member that follows a class within the class
leads $ledger 'part of [`Ledger`]' 'ledger.hpp' # a private function
# A lead stands at the line where its function begins.
while IFS='	' read -r file line lead; do
    name=$(printf '%s' "$lead" | sed -n 's/^\[`\([A-Za-z_:~]*::\)\{0,1\}\([A-Za-z_~]*\)[`(].*/\2/p')
    [ -z "$name" ] || sed -n "$line,$((line + 4))p" "$file" | grep -q "$name" || { echo "evenings.sh: $name does not begin at $file:$line"; failures=1; }
done < leads
[ "$failures" -eq 0 ] || exit 1
cd / && rm -rf "$copy"
