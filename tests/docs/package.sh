#!/bin/sh
# package.sh BUILD FOLDER COMPILER ROOT [book]: the package for Debian has what it should and nothing of this machine, and what is in it works where
# it is unpacked: the program, its manual page, the examples, and the library by pkg-config, without CMake. The book is left out
# unless the last word asks for it. Status 77 without dpkg-dev or pkg-config.
set -eu
for needed in dpkg-deb dpkg-shlibdeps pkg-config cpack; do
    command -v $needed > /dev/null 2>&1 || { echo "package.sh: not found: $needed"; exit 77; }
done
build=$1 folder=$2 compiler=$3 root=$4 book=${5:-}
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
parts=Unspecified
[ -z "$book" ] || parts='Unspecified;book'
cpack --config "$build/CPackConfig.cmake" -D "CPACK_COMPONENTS_ALL=$parts" -B "$folder/made" > cpack.log 2>&1 || { cat cpack.log; exit 1; }
deb=$(echo made/*.deb)
field() { dpkg-deb -f "$deb" "$1"; }
fail() { echo "package.sh: $*"; exit 1; }
[ "$(field Package)" = signorini ] || fail "the package is called $(field Package)"
version=$("$build/bin/signorini" --version)
[ "signorini $(field Version)" = "$version" ] || fail "version $(field Version), of the program $version"
field Depends | grep -q 'libc6 (>= .*libstdc++6' || fail "depends on $(field Depends)"
! field Depends | grep -Eq 'mpi|mumps|cholmod' || fail "depends on other back ends: $(field Depends)"
dpkg-deb -x "$deb" image
usr=$folder/image/usr
for file in bin/signorini share/man/man1/signorini.1 share/doc/signorini/copyright share/doc/signorini/examples/cantilever.toml \
    share/doc/signorini/examples/stamp.inp share/signorini/signorini.schema.json share/signorini/med2inp.py lib/cmake/signorini/signoriniConfig.cmake; do
    [ -f "$usr/$file" ] || fail "no $file"
done
[ -z "$book" ] || [ -f "$usr/share/doc/signorini/book/index.html" ] || fail 'no book'
[ ! -e "$usr/bin/signorini-backends" ] || fail 'the program with other back ends is in it'
! grep -rIlF --exclude-dir=book -e "$build" -e "$root" image || fail 'paths of this machine in these files'

# The program, where its examples are.
cd "$usr/share/doc/signorini/examples"
for scene in *.toml; do
    "$usr/bin/signorini" plan "$scene" > "$folder/said" 2>&1 || { cat "$folder/said"; fail "$scene"; }
done
"$usr/bin/signorini" solve cantilever.toml --csv "$folder/a.csv" | grep -q 'peak pressure 11\.52' || fail 'cantilever.toml'
"$usr/bin/signorini" mesh stamp.inp | grep -q "^body 'stamp': 24 nodes" || fail 'stamp.inp'
"$usr/bin/signorini" --man | cmp - "$usr/share/man/man1/signorini.1"

# The library without CMake.
cd "$folder"
PKG_CONFIG_PATH=$(dirname "$(find "$usr" -name signorini.pc)"):$(pkg-config --variable pc_path pkg-config)
export PKG_CONFIG_PATH
[ "$(pkg-config --modversion signorini)" = "$(field Version)" ] || fail "signorini.pc is of $(pkg-config --modversion signorini)"
pkg-config --exists 'signorini >= 0.1' eigen3 || fail 'pkg-config does not find signorini and Eigen'
example=$usr/share/doc/signorini/examples
# shellcheck disable=SC2046 # several flags
"$compiler" -std=c++17 -O1 "$example/hundred_loads/hundred_loads.cpp" -o hundred_loads $(pkg-config --cflags --libs signorini) > log 2>&1 ||
    { cat log; fail 'hundred_loads.cpp does not compile by pkg-config'; }
[ "$(./hundred_loads "$example/cantilever.toml" | tail -n 1)" = 1,17,71.5944 ] || fail 'hundred_loads'
echo "$(basename "$deb"): $(dpkg-deb -c "$deb" | wc -l) files"
cd / && rm -rf "$folder"
