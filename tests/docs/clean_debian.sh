#!/bin/sh
# clean_debian.sh DEB FOLDER: a Debian of this machine's release with nothing but apt is made in FOLDER; the package is installed there and
# solves an example, a program of the library is compiled and run, and the package goes and leaves no file. Status 77 where no such Debian can be made:
# without mmdebstrap, the rights of root or a mirror.
set -eu
fail() { echo "clean_debian.sh: $*"; exit 1; }
[ $# = 2 ] || fail "expected one package and one folder, got $#: $*"
deb=$1 root=$2
[ -f "$deb" ] || fail "no package $deb"
[ ! -e "$root" ] || [ -d "$root" ] || fail "$root is no folder"
command -v mmdebstrap > /dev/null 2>&1 || { echo 'clean_debian.sh: not found: mmdebstrap'; exit 77; }
[ "$(id -u)" = 0 ] || { echo 'clean_debian.sh: only root may make a Debian'; exit 77; }
release=$(. /etc/os-release && echo "${VERSION_CODENAME:-stable}")
rm -rf "$root"
trap 'rm -rf "$root"' EXIT
mmdebstrap --quiet --variant=minbase "$release" "$root" > /dev/null || { echo "clean_debian.sh: no clean $release can be made here"; exit 77; }
cp "$deb" "$root/signorini.deb"
within() { chroot "$root" env DEBIAN_FRONTEND=noninteractive LC_ALL=C sh -euc "$*"; }
get='apt-get install -y -qq --no-install-recommends -o Dpkg::Use-Pty=0'

within 'apt-get update -qq' || { echo 'clean_debian.sh: no mirror within'; exit 77; }
within "$get /signorini.deb > /log 2>&1 || { cat /log; exit 1; }" || fail 'the package does not install'
examples=/usr/share/doc/signorini/examples
within "signorini solve $examples/cantilever.toml" | grep -q 'peak pressure 11\.52' || fail 'the program does not solve cantilever.toml'
within "signorini solve $examples/dragged_block.toml --csv /steps.csv > /dev/null; test -s /steps.csv" || fail 'the program does not go through the steps of dragged_block.toml'

within "$get g++ libeigen3-dev pkg-config > /log 2>&1 || { cat /log; exit 1; }"
within "g++ -std=c++17 -O1 $examples/hundred_loads/hundred_loads.cpp -o /hundred_loads \$(pkg-config --cflags --libs signorini)" || fail 'the library does not link'
[ "$(within "/hundred_loads $examples/cantilever.toml" | tail -n 1)" = 1,17,71.5944 ] || fail 'hundred_loads has other forces'

within 'dpkg --purge signorini > /dev/null 2>&1' || fail 'the package does not go'
left=$(find "$root/usr" "$root/etc" -name '*signorini*')
[ -z "$left" ] || fail "the package leaves $left"
echo "clean_debian.sh: installed, run, compiled with and removed on a clean $release"
