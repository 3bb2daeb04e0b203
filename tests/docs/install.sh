#!/bin/sh
# install.sh BUILD FOLDER COMPILER EXAMPLES: the installed library is found by find_package and can be used, with nothing but
# Eigen beside it, as an example does, and the installed program runs.
set -eu
rm -rf "$2"
mkdir -p "$2/user"
cmake --install "$1" --prefix "$2/prefix" > /dev/null
cd "$2/user"
cat > CMakeLists.txt << 'END'
cmake_minimum_required(VERSION 3.22)
project(user LANGUAGES CXX)
find_package(signorini 0.1 CONFIG REQUIRED)
add_executable(user user.cpp)
target_link_libraries(user PRIVATE signorini::signorini)
END
cat > user.cpp << 'END'
#include <iostream>
#include "signorini/core/results.hpp"
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
cmake -S "$4/hundred_loads" -B loads -DCMAKE_PREFIX_PATH="$2/prefix" -DCMAKE_CXX_COMPILER="$3" -DCMAKE_BUILD_TYPE=Release --log-level=NOTICE > /dev/null
cmake --build loads > loads.log 2>&1 || { cat loads.log; exit 1; }
loads/hundred_loads "$4/cantilever.toml" > loads.csv
[ "$(wc -l < loads.csv)" -eq 101 ] && [ "$(tail -n 1 loads.csv)" = 1,17,71.5944 ] || { tail -n 2 loads.csv; exit 1; }
