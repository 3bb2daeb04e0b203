#!/bin/sh
# rooms.sh ROOT FOLDER: every room of the library includes only the rooms below it.  Then copies the library to FOLDER
# and plants includes in it, to see that the faults among them are found.
set -u
root=$1 copy=$2

check() ( # the library in $1/src/signorini; a line per fault
    cd "$1/src/signorini" || exit 1
    find . -type f | sed 's|^\./||' | sort | xargs awk '
        function fault(what) { print "src/signorini/" FILENAME ":" FNR ": " what; bad = 1 }
        BEGIN { # what a room may include besides itself
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
            below["report"] = "core mesh closed_form problem factor closing solvers programme as_printed problem_file elasticity contact scene estimate"
        }
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
            if (wanted != room && index(" " below[room] " ", " " wanted " ") == 0)
                fault(room " must not include " header "; it may include: " (below[room] == "" ? "no other room" : below[room]))
        }
        END { exit bad }'
)

check "$root" || exit 1

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
[ "$failures" -eq 0 ]
