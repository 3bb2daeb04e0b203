#!/bin/sh
# new_members.sh write ROOT FOLDER: copies the tables of the families to FOLDER, with one more line each, and a file for
# each new member: an element, a wrong element, a gap operator, a solver, an effect and a back end.
# new_members.sh check CMAKE BUILD: links the conformance suite with them in front of the library and asks it for each
# of them; the suite without them does not know their names.
set -eu

write() { # $1: the repository, $2: the folder
    library=$1/src/signorini papers=$1/src/papers frontal=$1/src/addons/frontal out=$2
    mkdir -p "$out"
    sed 's/"q8"/"q8_again"/; s/Element q8()/Element q8_again()/' "$library/fem/q8.cpp" > "$out/q8_again.cpp"
    sed 's/q8_again/q8_wrong/; s/0\.5 \* (1 - xi \* xi)/0.4 * (1 - xi * xi)/' "$out/q8_again.cpp" > "$out/q8_wrong.cpp"
    sed 's/q8()/q8(), q8_again(), q8_wrong()/' "$library/fem/elements.cpp" > "$out/elements.cpp"
    sed '/#include/!s/node_to_segment/node_again/g' "$library/pairing/node_to_segment.cpp" > "$out/node_again.cpp"
    sed 's/ mortar()/ mortar(), node_again()/' "$library/pairing/gap_operators.cpp" > "$out/gap_operators.cpp"
    sed '/#include/!s/enumerate(/enumerate_again(/' "$library/solvers/enumerate.cpp" > "$out/enumerate_again.cpp"
    sed 's/^namespace {$/ContactState enumerate_again(const ContactProblem\&, const SolverOptions\&);\n&/
         s/^      split("friction_split",/      [] {\
        Solver every = member("enumerate_again", "tries every set once more", enumerate_again).may_fail_on({Trait::Infeasible});\
        every.largest = largest_enumeration;\
        return every;\
      }(),\n&/' \
        "$papers/solver_table.cpp" > "$out/solver_table.cpp"
    cat > "$out/several_contacts.cpp" << 'MEMBER'
#include "signorini/scene/effects.hpp"
namespace signorini::effect {
Effect several_contacts() {
  return {"several contacts",
          [](const Scene& scene, const Plan& /*draft*/) { return scene.contacts.size() > 1; },
          [](const Scene& /*scene*/, Plan& draft) { draft.on.push_back("several contacts"); },
          [](Model& /*model*/) {}};
}
}  // namespace signorini::effect
MEMBER
    sed 's/rigid_motions()/rigid_motions(), several_contacts()/' "$library/scene/effects.cpp" > "$out/effects.cpp"
    sed 's/frontal()$/frontal(), frontal_again()/' "$frontal/backends.cpp" > "$out/backends.cpp"
    sed 's/"frontal"/"frontal_again"/; s/Backend frontal()/Backend frontal_again()/' "$frontal/frontal.cpp" > "$out/frontal_again.cpp"
    sed "s|\"addons/steps\"|&, \"$out\"|" "$1/tests/support/effect_examples.cpp" > "$out/effect_examples.cpp"
    sed 's/^# adds: A g pairs/# changes: A g pairs/; s/ *# with$//' "$library/scene/contact.toml" > "$out/several_contacts.toml"
    cat >> "$out/several_contacts.toml" << 'CONTACT'

[[contact]]  # with
source = "top"  # with
target = { kind = "half_plane", point = [0, 10], normal = [0, -1] }  # with
CONTACT
}

check() { # $1: cmake, $2: the build tree
    "$1" --build "$2" --target test_new_members > "$2/new_members.log" 2>&1 || { cat "$2/new_members.log"; exit 1; }
    asked='every *,class/*'
    for name in q8_again q8_wrong node_again enumerate_again 'several contacts' frontal_again; do
        right=yes known=yes
        SIGNORINI_CONFORMANCE=$name "$2/bin/test_new_members" "$asked" > "$2/new_member.log" 2>&1 || right=no
        [ "$name" != q8_wrong ] || { # found out, and by what it is
            grep -q 'q8_wrong' "$2/new_member.log" && [ $right = no ] || { echo "nothing is wrong with q8_wrong"; exit 1; }
            right=yes
        }
        [ $right = yes ] || { cat "$2/new_member.log"; exit 1; }
        SIGNORINI_CONFORMANCE=$name "$2/bin/test_conformance" "$asked" > "$2/new_member.log" 2>&1 || known=no
        [ $known = no ] && grep -q "^no member '$name'" "$2/new_member.log" || { echo "$name is not gone"; exit 1; }
    done
}

"$@"
