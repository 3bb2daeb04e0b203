#!/bin/sh
# linked_alone.sh ROOT FOLDER COMPILER ARCHIVE...: links every folder of the library, all of it, with nothing but the folders that
# src/plan gives it: no symbol may be undefined. Then plants symbols that are nowhere, and some of folders above, to see that they are found. Works in FOLDER.
# COMPILER is the command that links, with flags, such as "g++ -fsanitize=address".
set -u
root=$1 work=$2 compiler=$3
shift 3
for archive in "$@"; do
    [ -e "$archive" ] || { echo "left out: $archive is not compiled"; exit 0; }
done
rm -rf "$work"
mkdir -p "$work"
echo 'int main() { return 0; }' > "$work/main.cpp"

# Of every folder a line: its name and those that it may use, the upper ones first, which is how archives are searched.
awk '
    function last(path) { sub(/.*\//, "", path); return path }
    /^[a-z].*:/ {
        colon = index($0, ":")
        name = last(substr($0, 1, colon - 1))
        uses = ""
        for (k = split(substr($0, colon + 1), other, " "); k > 0; --k) uses = uses " " last(other[k])
        print name uses
    }' "$root/src/plan" > "$work/alone"
[ -s "$work/alone" ] || { echo "src/plan: no folder"; exit 1; }

archive_of() { # a folder
    for one in $archives; do
        case $one in */libsignorini_"$1".a) echo "$one"; return ;; esac
    done
    echo "no archive of $1 among $archives" >&2
}

link() { # a folder, and those that it may use; with all of ARCHIVES that they are in
    whole=$(archive_of "$1")
    shift
    others=
    for other in "$@"; do others="$others $(archive_of "$other")"; done
    $compiler "$work/main.cpp" -o "$work/linked" -Wl,--whole-archive "$whole" -Wl,--no-whole-archive $others > "$work/said" 2>&1
}

archives=$*
failures=0
while read -r name used; do
    if ! link "$name" $used; then
        echo "$name cannot be linked with nothing but ${used:-itself}:"
        grep -o "undefined reference to.*\|undefined symbol.*" "$work/said" | sort -u | head -20 | grep . || tail -5 "$work/said"
        failures=$((failures + 1))
    fi
done < "$work/alone"

plant() { # a folder, and what a function in it calls, as a declaration; the folder must be found, or not
    cp "$(archive_of "$1")" "$work/libsignorini_$1.a"
    printf 'namespace signorini { %s }\n' "$2" > "$work/planted.cpp"
    $compiler -c "$work/planted.cpp" -o "$work/planted.o" && ar q "$work/libsignorini_$1.a" "$work/planted.o" || { failures=$((failures + 1)); return; }
    kept=$archives
    archives="$work/libsignorini_$1.a $archives"
    if link $(grep "^$1\( \|$\)" "$work/alone"); then got=accepted; else got=found; fi
    archives=$kept
    [ "$got" = "$3" ] || { echo "in $1, $2: $got, expected $3"; cat "$work/said"; failures=$((failures + 1)); }
}
top=$(tail -n 1 "$work/alone")
plant core 'void nowhere(); void planted() { nowhere(); }' found
plant core 'void planted() {}' accepted
plant "${top%% *}" 'void nowhere(); void planted() { nowhere(); }' found
if grep -q '^fem ' "$work/alone"; then
    plant fem 'struct Material; void check_material(const Material&); void planted(const Material& m) { check_material(m); }' accepted
    plant core 'struct Material; void check_material(const Material&); void planted(const Material& m) { check_material(m); }' found
fi
[ "$failures" -eq 0 ]
