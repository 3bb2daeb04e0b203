#!/bin/sh
# install.sh BUILD FOLDER COMPILER ROOT: the installed library is found by find_package and can be used, with nothing but
# Eigen beside it, as an example does, its headers are those of src/public, and the installed program runs.
set -eu
rm -rf "$2"
mkdir -p "$2/user"
cmake --install "$1" --prefix "$2/prefix" > /dev/null
(cd "$2/prefix/include/signorini" && find . -name '*.hpp' | sed 's|^\./||' | LC_ALL=C sort) > "$2/installed"
grep -v '^#' "$4/src/public" | diff - "$2/installed" || { echo "src/public lists other headers (<) than are installed (>)"; exit 1; }
cd "$2/user"
cat > CMakeLists.txt << 'END'
cmake_minimum_required(VERSION 3.22)
project(user LANGUAGES CXX)
find_package(signorini 0.1 CONFIG REQUIRED COMPONENTS core report)
add_executable(user user.cpp)
target_link_libraries(user PRIVATE signorini::report)
add_library(every_header OBJECT every_header.cpp)
target_link_libraries(every_header PRIVATE signorini::signorini)
find_package(signorini 0.1 CONFIG QUIET COMPONENTS attic)
if(signorini_FOUND OR NOT signorini_NOT_FOUND_MESSAGE MATCHES "no component 'attic'")
  message(FATAL_ERROR "a component that there is not is found")
endif()
END
sed 's/.*/#include "&"/' "$2/installed" > every_header.cpp # each alone: the target `alone`
cat > user.cpp << 'END'
#include <iostream>
#include "signorini/report/results.hpp"
int main() {
  signorini::Results results("user");
  results.add("force", 2.5, "N");
  std::cout << results.value("force") << '\n';
}
END
cmake -S . -B build -DCMAKE_PREFIX_PATH="$2/prefix" -DCMAKE_CXX_COMPILER="$3" --log-level=NOTICE > /dev/null
cmake --build build > build.log 2>&1 || { cat build.log; exit 1; }
[ "$(build/user)" = 2.5 ]
"$2/prefix/bin/signorini" --list | grep -q enumerate
"$2/prefix/bin/signorini" --man | cmp - "$2/prefix/share/man/man1/signorini.1"

# The example: a hundred loads, and under all of the load the force of chapter 6.
example=$4/examples/hundred_loads
build() { # folder, flags: status 1 if it does not build
    cmake -S "$example" -B "$1" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS="$2" \
        --log-level=NOTICE > /dev/null
    cmake --build "$1" > "$1.log" 2>&1
}
right() { # folder
    "$1/hundred_loads" "$scene" > "$1.csv"
    [ "$(wc -l < "$1.csv")" -eq 101 ] && [ "$(tail -n 1 "$1.csv")" = 1,17,71.5944 ] || { tail -n 2 "$1.csv"; exit 1; }
}
prefix=$2/prefix compiler=$3 scene=$4/examples/cantilever.toml
build loads '' || { cat loads.log; exit 1; }
right loads

# Flags with which the program aligns otherwise than the library: the linker says what to do.
name=compile_with_the_march_that_signorini_was_built_with
aligned=$(nm -C "$prefix"/lib*/libsignorini_core.* "$prefix"/lib/*/libsignorini_core.* 2> /dev/null | sed -n "s/.* [TW] .*$name<\([0-9]*\), .*/\1/p")
refused() { # folder
    grep -q "undefined reference to .*$name<" "$1.log" || { cat "$1.log"; exit 1; }
}
! build other "-DEIGEN_MAX_ALIGN_BYTES=$((aligned > 0 ? 2 * aligned : 16))" || { echo "a program with another alignment was linked"; exit 1; }
refused other
if build native -march=native; then right native; else refused native; fi
cd / && rm -rf "$2"
