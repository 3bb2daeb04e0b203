#!/bin/sh
# public_headers.sh ROOT FOLDER: chapters, exercises, live figures, examples, README.md and docs/ include those headers of the library that
# src/public lists, and so do these headers themselves; each of the others says in its first line that it is internal. Then plants
# faults in a copy of the library in FOLDER, to see that they are found.
set -u
root=$1 copy=$2
internal='// This header is internal: chapters do not include it, and it is not installed.'

check() ( # the project in $1; a line per fault
    cd "$1" || exit 1
    folders=$(sed -n 's|^\([a-z][a-z_/]*\):.*|src/\1|p' src/plan)
    reference=no # a hand-out has no reference solutions, and includes fewer headers
    [ -z "$(find chapters -name solution.cpp)" ] || reference=yes
    { find $folders -name '*.hpp'; find chapters examples -name '*.[ch]pp'; ls README.md docs/*.md; } | LC_ALL=C sort |
        LC_ALL=C xargs -x -n 9999 awk -v reference="$reference" -v internal="$internal" '
        function fault(where, what) { print where ": " what; bad = 1 }
        function include(header) { included[++n] = header; by[n] = FILENAME; line[n] = FNR }
        BEGIN {
            while ((getline header < "src/public") > 0) {
                ++number
                if (header ~ /^#/) continue
                if (header <= before) fault("src/public:" number, header " stands after " before ": sort the list")
                public[before = header] = number
            }
        }
        { header = substr(FILENAME, 5) }
        FNR == 1 && /^\/\/ This header is internal/ && $0 != internal { fault(FILENAME ":1", "write exactly: " internal) }
        FNR == 1 && FILENAME ~ /^src\// {
            exists[header] = 1
            says = /^\/\/ This header is internal/
            if (says && header in public)
                fault(FILENAME ":1", header " is public: delete this line, or delete " header " from src/public")
            if (!says && !(header in public))
                fault(FILENAME ":1", header " is not in src/public. If only the library includes it, let it begin with: " internal \
                      " If a chapter or an example includes it, add it to src/public")
        }
        FILENAME ~ /^src\// && !(header in public) { next }
        /^[ \t]*#[ \t]*include[ \t]*["<]/ {
            header = $0
            sub(/^[^"<]*["<]/, "", header)
            sub(/[">].*/, "", header)
            include(header)
            next
        }
        FILENAME ~ /\.md$/ { # `addons/files/gmsh.hpp`
            for (rest = $0; match(rest, /`[a-z_0-9\/]+\.hpp`/); rest = substr(rest, RSTART + RLENGTH))
                include(substr(rest, RSTART + 1, RLENGTH - 2))
        }
        END {
            for (k = 1; k <= n; ++k) {
                header = included[k]
                where = by[k] ":" line[k]
                used[header] = 1
                if (header in exists && !(header in public))
                    fault(where, header " is internal. Include a header of src/public that gives the same" (by[k] ~ /^src\// \
                          ? ", or declare here what you need of it" : "") ". If readers need this one, add it to src/public " \
                          "and delete its first line")
                else if (header ~ /(^|\/)src\//)
                    fault(where, "write \"FOLDER/NAME.hpp\", as src/public has it, not \"" header "\"")
                else if (header ~ /^(command_line|backends|live)\// && !(header ~ /^live/ && by[k] ~ /^chapters\/[^\/]*\/live\//))
                    fault(where, header " is of a program. Include a header of src/public; only live figures include those of live/")
            }
            for (header in public)
                if (!(header in exists))
                    fault("src/public:" public[header], "src/ has no " header ": delete this line, or correct it")
                else if (reference == "yes" && !(header in used))
                    fault("src/public:" public[header], "neither a chapter nor an example nor a public header includes " header \
                          ": delete this line, and let the header begin with: " internal)
            exit bad
        }'
)

check "$root" || exit 1

failures=0
rm -rf "$copy"
mkdir -p "$copy"
(cd "$root" && find src chapters examples -name '*.[ch]pp' -o -path src/plan -o -path src/public) > "$copy.files"
(cd "$root" && tar cf - -T "$copy.files" README.md docs/library.md) | tar xf - -C "$copy"
expect() { # accepted or what the message begins with, and what it says later
    if said=$(check "$copy"); then got=accepted; else got=$said; fi
    case $got in
        "$1"*"${2:-}"*) ;;
        *) echo "expected '$1' and '${2:-}', got: $got"; failures=$((failures + 1)) ;;
    esac
}
plant() { # file, its new first line, what expect() takes
    file=$1
    { echo "$2"; [ ! -f "$root/$file" ] || cat "$root/$file"; } > "$copy/$file"
    shift 2
    expect "$@"
    cp "$root/$file" "$copy/$file" 2> /dev/null || rm "$copy/$file"
}
change() { # file, what sed does to it, what expect() takes
    file=$1
    sed "$2" "$root/$file" > "$copy/$file"
    shift 2
    expect "$@"
    cp "$root/$file" "$copy/$file"
}
public=signorini/core/errors.hpp internal_one=signorini/core/bytes.hpp new=src/signorini/core/brand_new.hpp
program=chapters/ch02_surrogate_dual/surrogate_dual.cpp
exercise=$(grep '/attempt\.cpp$' "$copy.files" | head -n 1)
figure=$(grep '^chapters/.*/live/.*\.cpp$' "$copy.files" | head -n 1)
for file in $program $exercise $figure examples/hundred_loads/hundred_loads.cpp; do
    plant "$file" "#include \"$public\"" accepted
    plant "$file" "#include <$internal_one>" "$file:1: $internal_one is internal" 'src/public that gives the same'
done
plant README.md "#include \"$internal_one\"" "README.md:1: $internal_one is internal"
plant docs/library.md "It is read by \`$internal_one\`." "docs/library.md:1: $internal_one is internal"
plant "src/$public" "#include \"$internal_one\"" "src/$public:1: $internal_one is internal" 'declare here'
plant "$program" "#include \"../../src/$public\"" "$program:1: write"
plant "$program" '#include "command_line/print.hpp"' "$program:1: command_line/print.hpp is of a program"
plant "$program" '#include "live/figure.hpp"' "$program:1: live/figure.hpp is of a program"
plant "$figure" '#include "live/figure.hpp"' accepted
change "src/$internal_one" 1d "src/$internal_one:1: $internal_one is not in src/public" "begin with: $internal"
change "src/$internal_one" '1s/installed/packed/' "src/$internal_one:1: write exactly"
plant "src/$public" "$internal" "src/$public:1: $public is public: delete this line"
plant $new '#pragma once' "$new:1: signorini/core/brand_new.hpp is not in src/public"
plant $new "$internal" accepted
plant src/public addons/a.hpp 'src/public:1: src/ has no addons/a.hpp'
plant src/public signorini/core/z.hpp 'src/public:' 'sort the list'
if grep -q '/solution\.cpp$' "$copy.files"; then
    change chapters/ch15_friction_remembers/partial_slip.hpp '/closed_form.cattaneo.hpp/d' 'src/public:' 'public header includes closed_form/cattaneo.hpp'
    find "$copy/chapters" \( -name solution.cpp -o -name test_heldout.cpp \) -delete
    expect accepted
fi
rm -rf "$copy" "$copy.files"
[ "$failures" -eq 0 ]
