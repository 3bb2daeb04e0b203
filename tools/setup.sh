#!/bin/sh
# setup.sh GROUP ...: installs the Debian or Ubuntu packages of these groups that are missing.
#   build   compiler, libraries, gnuplot: all that ./run.sh needs
#   book    the web pages: Python, and Doxygen for the reference of src/
#   check   a browser that opens every page
#   formats what checks our documents and converts meshes of others: Python's jsonschema, VTK and meshio
#   live    a compiler for browsers, for make engine
#   package what builds a package for Debian, finds a library without CMake, and makes a clean Debian to install it in
#   print   the same browser, the letters of figures and Chinese words, where words break, and what looks at pages, for make book-pdf
#   strict  the second compiler of the stricter presets
#   peers   other people's programs and libraries, for make peers and make bench
#   parallel  other factors: CHOLMOD, and MUMPS with MPI
# Without the right to install it prints the command to type and stops with status 2.
set -eu
build="g++ make cmake catch2 libeigen3-dev libcli11-dev libtomlplusplus-dev gnuplot-nox perl"
book="doxygen python3"
check="chromium python3 fonts-dejavu-core"
formats="python3-jsonschema python3-vtk9 python3-meshio meshio-tools python3-h5py python3-netcdf4"
print="$check fonts-wqy-microhei hyphen-en-gb poppler-utils"
live="emscripten"
package="dpkg-dev pkg-config mmdebstrap"
strict="clang"
peers="calculix-ccx python3-getfem r-cran-quadprog libsiconos-numerics-dev libsuitesparse-dev libmumps-seq-dev libopenblas-dev python3-cvxopt"
parallel="libsuitesparse-dev libmumps-dev libopenmpi-dev openmpi-bin"

wanted=""
for group in "$@"; do
    case $group in
    build) wanted="$wanted $build" ;;
    book) wanted="$wanted $book" ;;
    check) wanted="$wanted $check" ;;
    formats) wanted="$wanted $formats" ;;
    live) wanted="$wanted $live" ;;
    package) wanted="$wanted $package" ;;
    print) wanted="$wanted $print" ;;
    strict) wanted="$wanted $strict" ;;
    peers) wanted="$wanted $peers" ;;
    parallel) wanted="$wanted $parallel" ;;
    *) echo "setup.sh: unknown group '$group', expected build, book, check, formats, live, package, print, strict, parallel or peers" >&2; exit 2 ;;
    esac
done

if ! command -v apt-get > /dev/null 2>&1; then
    echo "This system does not use apt. Please install what corresponds to these packages, then type make:$wanted" >&2
    exit 2
fi

installed() { # a program may have come another way than by its package
    case $1 in
    g++ | make | cmake | doxygen | chromium | python3) command -v "$1" ;;
    gnuplot-nox) command -v gnuplot ;;
    perl) perl -MJSON::PP -MFile::Copy -e 1 ;;  # every system has a part of it
    clang) command -v clang++ ;;
    poppler-utils) command -v pdftoppm && command -v pdftotext ;;
    emscripten) command -v em++ ;;
    *) false ;;
    esac > /dev/null 2>&1 || dpkg-query -W -f '${Status}\n' "$1" 2> /dev/null | grep -q "ok installed"
}

missing=""
for package in $wanted; do
    installed "$package" || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

# The browser and the peers do not exist in every release; what needs them leaves them out.
drop_unknown() {
    for package in chromium $peers; do
        case " $missing " in *" $package "*)
            [ -z "$(apt-cache madison make 2> /dev/null)" ] || [ -n "$(apt-cache madison "$package" 2> /dev/null)" ] || {
                echo "no package $package in this release, going on without it"
                missing=$(echo "$missing" | sed "s/ $package\>//")
            } ;;
        esac
    done
}

if [ "$(id -u)" = 0 ]; then
    sudo=""
elif command -v sudo > /dev/null 2>&1 && sudo -n true 2> /dev/null; then
    sudo="sudo"
else
    drop_unknown
    [ -n "$missing" ] || exit 0
    echo "Some packages are missing. Please type this once, then try again:" >&2
    echo "    sudo apt-get update && sudo apt-get install -y --no-install-recommends$missing" >&2
    exit 2
fi

echo "installing:$missing"
$sudo env DEBIAN_FRONTEND=noninteractive apt-get update -q
drop_unknown
[ -z "$missing" ] || $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
