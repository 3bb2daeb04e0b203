#!/bin/sh
# rooms.sh ROOT FOLDER [OBJECT...]: every room of the library includes only the rooms below it, and calls no others, as the
# symbols of its objects say; where these are not compiled, the calls are left out.  Then copies the library to FOLDER and
# plants includes in it, and calls in lists of symbols, to see that the faults among them are found.
set -u
root=$1 copy=$2
shift 2

rooms='
    BEGIN { # what a room may include and call besides itself
        below["core"] = ""
        below["mesh"] = below["closed_form"] = below["problem"] = below["factor"] = "core"
        below["gmsh"] = below["refinement"] = "core mesh"
        below["closing"] = below["problem_file"] = "core problem"
        below["solvers"] = "core problem closing"
        below["programme"] = "core problem closing solvers"
        below["as_printed"] = "core problem closing solvers programme"
        below["elasticity"] = "core mesh"
        below["contact"] = "core mesh elasticity"
        below["scene"] = "core mesh problem factor closing solvers programme elasticity contact"
        below["estimate"] = below["scene"] " closed_form refinement scene"
        below["scene_file"] = below["scene"] " gmsh as_printed scene"
        below["report"] = "core mesh closed_form problem factor closing solvers programme problem_file elasticity contact scene estimate"
    }
    function may_use(room, other) { return room == other || index(" " below[room] " ", " " other " ") > 0 }
    function all_below(room) { return below[room] == "" ? "no other room" : below[room] }
'

check() ( # the library in $1/src/signorini; a line per fault
    cd "$1/src/signorini" || exit 1
    find . -type f | sed 's|^\./||' | sort | xargs awk "$rooms"'
        function fault(what) { print "src/signorini/" FILENAME ":" FNR ": " what; bad = 1 }
        FNR == 1 {
            room = FILENAME
            if (!sub(/\/.*/, "", room) || !(room in below)) fault("this is in no room that rooms.sh knows")
        }
        room in below && /^[ \t]*#[ \t]*include[ \t]*["<]/ {
            header = $0
            sub(/^[^"<]*["<]/, "", header)
            sub(/[">].*/, "", header)
            if (header !~ /^signorini\//) {
                if (/"/) fault("write \"signorini/ROOM/NAME.hpp\", not \"" header "\"")
                next
            }
            wanted = substr(header, 11)
            sub(/\/.*/, "", wanted)
            if (!may_use(room, wanted)) fault(room " must not include " header "; it may include: " all_below(room))
        }
        END { exit bad }'
)

check_calls() { # symbols of objects on the input, as `nm -A -P` lists them; a line per fault
    awk "$rooms"'
        function fault(what) { print what; bad = 1 }
        # That of .../ROOM/NAME.cpp.o, or of .../unity_ROOM_cxx.cxx.o and .../unity_ROOM_NUMBER_cxx.cxx.o, its files in one
        function room_of(object,    room) {
            if (object in known) return known[object]
            room = object
            if (!sub(/.*\/unity_/, "", room)) sub(/\/[^\/]*$/, "", room)
            sub(/(_[0-9]+)?_cxx\.cxx\.o$/, "", room)
            sub(/.*\//, "", room)
            if (!(room in below)) fault(object ": this is of no room that rooms.sh knows")
            return known[object] = room
        }
        match($0, /: [^ ]+ [A-Zuvw]( |$)/) { # OBJECT: SYMBOL TYPE; a small letter is one of its own, but for these
            object = substr($0, 1, RSTART - 1)
            split(substr($0, RSTART + 2), word, " ")
            room = room_of(object)
            if (word[2] ~ /[Uvw]/)
                calls[room " " word[1]] = object
            else if (index(homes[word[1]] " ", " " room " ") == 0)
                homes[word[1]] = homes[word[1]] " " room
        }
        END {
            for (call in calls) {
                split(call, word, " ")
                room = word[1]
                if (!(word[2] in homes)) continue # of another library
                right = 0
                for (k = split(homes[word[2]], other, " "); k > 0; --k) {
                    right = right || may_use(room, other[k])
                    if (room != other[k]) seen = 1
                }
                if (!right) fault(room " must not call " word[2] " of" homes[word[2]] ", as " calls[call] " does; it may call: " all_below(room))
            }
            if (!seen) fault("no room calls another one: these are no symbols of the library")
            exit bad
        }'
}

check "$root" || exit 1

symbols=$copy.symbols
mkdir -p "$(dirname "$copy")"
: > "$symbols"
if [ -e "${1:-}" ] && command -v nm > /dev/null; then
    nm -A -P "$@" > "$symbols"
    check_calls < "$symbols" > "$copy.faults" || { c++filt < "$copy.faults"; exit 1; }
else
    echo "calls are left out: the library is not compiled, or there is no nm"
fi

failures=0
expect() { # accepted or found, file, include
    rm -rf "$copy"
    mkdir -p "$copy/src"
    cp -R "$root/src/signorini" "$copy/src"
    mkdir -p "$copy/src/signorini/$(dirname "$2")"
    printf '#include %s\n' "$3" >> "$copy/src/signorini/$2"
    if said=$(check "$copy"); then got=accepted; else got=found; fi
    [ "$got" = "$1" ] || { echo "$2 with #include $3: $got, expected $1. $said"; failures=$((failures + 1)); }
}
expect accepted core/errors.hpp '<vector>'
expect accepted core/errors.hpp '"signorini/core/ledger.hpp"'
expect accepted report/vtu.cpp '"signorini/closed_form/beam.hpp"'
expect accepted scene/solve.cpp '"signorini/contact/obstacle.hpp"'
expect accepted estimate/goal.cpp '"signorini/closed_form/hertz_fit.hpp"'
expect accepted problem_file/two_sided.hpp '"signorini/problem/problem.hpp"'
expect accepted solvers/lemke.cpp '"signorini/closing/closed_basis.hpp"'
expect found core/errors.hpp '"signorini/mesh/mesh.hpp"'                              # above
expect found contact/obstacle.cpp '<signorini/scene/scene.hpp>'
expect found elasticity/element.hpp '"signorini/contact/obstacle.hpp"'
expect found problem/problem.hpp '"signorini/closing/closed_basis.hpp"'
expect found closing/closed_basis.hpp '"signorini/solvers/lemke.hpp"'
expect found solvers/lemke.cpp '"signorini/programme/refine.hpp"'
expect found scene/solve.cpp '"signorini/as_printed/surrogate_dual.hpp"'
expect found problem/problem.hpp '"signorini/mesh/mesh.hpp"'                          # beside
expect found programme/refine.cpp '"signorini/factor/frontal_factor.hpp"'
expect found problem_file/two_sided.cpp '"signorini/mesh/mesh.hpp"'
expect found problem/problem.hpp '"signorini/problem_file/two_sided.hpp"'
expect found closed_form/beam.cpp '"signorini/problem/problem.hpp"'
expect found elasticity/assembly.cpp '"signorini/problem/problem.hpp"'
expect found contact/node_to_obstacle.hpp '"signorini/problem/problem.hpp"'
expect found estimate/dual.cpp '"signorini/report/vtu.hpp"'
expect found scene/solve.cpp '"signorini/estimate/estimate.hpp"'
expect found core/results.cpp '"../mesh/mesh.hpp"'                                    # by another name
expect found attic/old.hpp '<vector>'                                                 # in no room
expect found old.hpp '<vector>'

expect_calls() { # accepted or found, what they are, and on the input the symbols
    if said=$(check_calls); then got=accepted; else got=found; fi
    [ "$got" = "$1" ] || { echo "$2: $got, expected $1. $said"; failures=$((failures + 1)); }
}
expect_call() { # accepted or found, the objects of a call and of what it calls, type of the latter; beside a call that may be
    printf '%s: %s %s 0 1\n' "o/mesh/a.o" g U "o/core/a.o" g T "$2" f U "$3" f "${4:-T}" > "$copy.call"
    expect_calls "$1" "$2 calls $3" < "$copy.call"
}
expect_call accepted signorini/solvers/lemke.cpp.o signorini/core/dense.cpp.o
expect_call accepted signorini/scene/solve.cpp.o signorini/scene/plan.cpp.o
expect_call accepted 'a b/unity_scene_file_cxx.cxx.o' 'a b/unity_as_printed_12_cxx.cxx.o'
expect_call accepted signorini/core/dense.cpp.o signorini/mesh/mesh.cpp.o t             # not the same f
expect_call found signorini/solvers/solvers.cpp.o signorini/as_printed/solver_table.cpp.o
expect_call found signorini/core/dense.cpp.o signorini/mesh/mesh.cpp.o W
expect_call found 'a b/unity_scene_2_cxx.cxx.o' 'a b/signorini/as_printed/solver_table.cpp.o'
expect_call found 'a b/unity_scene_cxx.cxx.o' 'a b/unity_scene_file_1_cxx.cxx.o'
expect_call found signorini/attic/old.cpp.o signorini/core/dense.cpp.o                  # in no room
expect_call found a/unity_0_cxx.cxx.o signorini/core/dense.cpp.o
expect_calls found 'no symbols' < /dev/null
if [ -s "$symbols" ]; then
    sed 's|/core/|/report/|; s|/unity_core_|/unity_report_|' "$symbols" > "$copy.call"
    expect_calls found 'core above all rooms' < "$copy.call"
fi
[ "$failures" -eq 0 ]
