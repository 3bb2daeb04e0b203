#!/bin/sh
# rooms.sh ROOT FOLDER OBJECT...: every folder of the library includes and calls only those that src/plan gives it. Calls are read from the symbols of the objects; if one is not compiled, calls are left out. Then copies the
# library to FOLDER and plants includes in it, and calls in lists of symbols, to see that the faults among them are found.
set -u
root=$1 copy=$2
shift 2
[ $# -gt 0 ] || { echo "rooms.sh: no objects, expected those of the library" >&2; exit 2; }
mkdir -p "$(dirname "$copy")"
plan=$copy.plan
cp "$root/src/plan" "$plan"

# Which folder may use which, for awk: of names, the last part of a path.
folders='
    function last(path) { sub(/.*\//, "", path); return path }
    BEGIN {
        while ((getline line < plan) > 0) {
            if (line !~ /^[a-z].*:/) continue
            name = line
            sub(/:.*/, "", name)
            sub(/^[^:]*:/, "", line)
            of_path[name] = name = last(name)
            known[name] = 1
            for (k = split(line, other, " "); k > 0; --k) may[name " " last(other[k])] = 1
        }
    }
    function may_use(name, other) { return name == other || (name " " other) in may }
    function allowed(name,    edge, word, list) {
        for (edge in may) { split(edge, word, " "); if (word[1] == name) list = list " " word[2] }
        return list == "" ? " nothing else" : list
    }
'

check() ( # the library in $1/src; a line per fault
    cd "$1/src" || exit 1
    find signorini meshes closed_form papers addons -type f | sort | xargs awk -v plan="$plan" "$folders"'
        function fault(what) { print "src/" FILENAME ":" FNR ": " what; bad = 1 }
        FNR == 1 {
            path = FILENAME
            sub(/\/[^\/]*$/, "", path)
            name = of_path[path]
            if (name == "") fault("this is in no folder of src/plan")
        }
        name != "" && /^[ \t]*#[ \t]*include[ \t]*["<]/ {
            header = $0
            sub(/^[^"<]*["<]/, "", header)
            sub(/[">].*/, "", header)
            wanted = header
            if (!sub(/\/[^\/]*$/, "", wanted) || !(wanted in of_path)) {
                if (/"/ || header ~ /^(signorini|addons)\//) fault("write \"signorini/FOLDER/NAME.hpp\", as src/plan has it, not \"" header "\"")
                next
            }
            if (!may_use(name, of_path[wanted])) fault(name " must not include " header "; it may include:" allowed(name))
        }
        END { exit bad }'
)

check_calls() { # symbols of objects on the input, as `nm -A -P` lists them; a line per fault
    awk -v plan="$plan" "$folders"'
        function fault(what) { print what; bad = 1 }
        function folder_of(object,    name) { # that of .../signorini_NAME.dir/...
            if (object in seen_before) return seen_before[object]
            name = object
            sub(/\.dir\/.*/, "", name)
            sub(/.*signorini_/, "", name)
            if (!(name in known)) fault(object ": this is of no folder of src/plan")
            return seen_before[object] = name
        }
        match($0, /: [^ ]+ [A-Zuvw]( |$)/) { # OBJECT: SYMBOL TYPE; a small letter is one of its own, but for these
            object = substr($0, 1, RSTART - 1)
            split(substr($0, RSTART + 2), word, " ")
            name = folder_of(object)
            if (word[2] ~ /[Uvw]/)
                calls[name " " word[1]] = object
            else if (index(homes[word[1]] " ", " " name " ") == 0)
                homes[word[1]] = homes[word[1]] " " name
        }
        END {
            for (call in calls) {
                split(call, word, " ")
                name = word[1]
                if (!(word[2] in homes)) continue # of another library
                right = 0
                n = split(homes[word[2]], other, " ")
                for (k = n; k > 0; --k) {
                    if (may_use(name, other[k])) right = 1
                    if (name != other[k]) seen = 1
                }
                if (!right) fault(name " must not call " word[2] " of" homes[word[2]] ", as " calls[call] " does; it may call:" allowed(name))
            }
            if (!seen) fault("no folder calls another one: these are no symbols of the library")
            exit bad
        }'
}

check "$root" || exit 1
symbols=$copy.symbols
: > "$symbols"
missing=""
for object in "$@"; do [ -e "$object" ] || missing=$object; done
command -v nm > /dev/null || missing=nm
if [ -z "$missing" ]; then
    nm -A -P "$@" > "$symbols" || { echo "rooms.sh: nm ends with status $?" >&2; exit 1; }
    check_calls < "$symbols" > "$copy.faults" || { c++filt < "$copy.faults"; exit 1; }
else
    echo "calls are left out: there is no $missing"
fi

failures=0
expect() { # accepted or found, file, include
    rm -rf "$copy"
    mkdir -p "$copy/src"
    for part in signorini meshes closed_form papers addons; do cp -R "$root/src/$part" "$copy/src"; done
    mkdir -p "$copy/src/$(dirname "$2")"
    printf '#include %s\n' "$3" >> "$copy/src/$2"
    if said=$(check "$copy"); then got=accepted; else got=found; fi
    [ "$got" = "$1" ] || { echo "$2 with #include $3: $got, expected $1. $said"; failures=$((failures + 1)); }
}
expect accepted signorini/core/errors.hpp '<vector>'
expect accepted signorini/core/errors.hpp '"signorini/core/ledger.hpp"'
expect accepted signorini/scene/solve.cpp '"signorini/contact/obstacle.hpp"'
expect accepted addons/estimate/goal.cpp '"closed_form/hertz_fit.hpp"'
expect accepted addons/files/two_sided.hpp '"signorini/problem/problem.hpp"'
expect accepted signorini/solvers/lemke.cpp '"signorini/problem/active_set_factor.hpp"'
expect found signorini/core/errors.hpp '"signorini/fem/mesh.hpp"'                             # above
expect found signorini/contact/obstacle.cpp '<signorini/scene/scene.hpp>'
expect found signorini/problem/problem.hpp '"signorini/solvers/lemke.hpp"'
expect found signorini/scene/solve.cpp '"papers/surrogate_dual.hpp"'
expect found signorini/core/errors.hpp '<addons/certified/proofs.hpp>'
expect found meshes/disc.cpp '"addons/effects/springs.hpp"'
expect found signorini/problem/problem.hpp '"signorini/fem/mesh.hpp"'                         # beside
expect found addons/certified/certified_solve.cpp '"addons/frontal/frontal_factor.hpp"'
expect found closed_form/beam.cpp '"signorini/problem/problem.hpp"'
expect found signorini/contact/node_to_obstacle.hpp '"signorini/problem/problem.hpp"'
expect found addons/estimate/dual.cpp '"addons/vtu/vtu.hpp"'
expect found signorini/report/results.cpp '"../fem/mesh.hpp"'                                 # by another name
expect found signorini/report/results.cpp '"signorini/attic/old.hpp"'                         # what is in no folder
expect found signorini/attic/old.hpp '<vector>'
expect found addons/old.hpp '<vector>'

expect_calls() { # accepted or found, what they are, and on the input the symbols
    if said=$(check_calls); then got=accepted; else got=found; fi
    [ "$got" = "$1" ] || { echo "$2: $got, expected $1. $said"; failures=$((failures + 1)); }
}
expect_call() { # accepted or found, the folders of a call and of what it calls, type of the latter; beside a call that may be
    printf '%s: %s %s 0 1\n' "o/signorini_fem.dir/a.o" g U "o/signorini_core.dir/a.o" g T "a b/signorini_$2.dir/a.o" f U \
        "a b/signorini_$3.dir/Unity/unity_12_cxx.cxx.o" f "${4:-T}" > "$copy.call"
    expect_calls "$1" "$2 calls $3" < "$copy.call"
}
expect_call accepted solvers core
expect_call accepted scene scene
expect_call accepted files papers
expect_call accepted core fem t             # not the same f
expect_call found solvers papers
expect_call found core fem W
expect_call found scene files
expect_call found attic core                # in no folder
expect_calls found 'no symbols' < /dev/null
if [ -s "$symbols" ]; then
    sed 's|signorini_core\.dir|signorini_report.dir|' "$symbols" > "$copy.call"
    expect_calls found 'core above all folders' < "$copy.call"
fi
[ "$failures" -eq 0 ]
