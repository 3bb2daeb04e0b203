#!/bin/sh
# engine.sh [FOLDER]: compiles the library and the live figures for browsers: FOLDER/engine.js (default build/engine), one
# script that a page loads from disk too.  Needs emscripten, a few minutes the first time.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
folder=$(realpath -m "${1:-$root/build/engine}")
eigen=${EIGEN:-/usr/include/eigen3}
toml=${TOML:-/usr/include}
command -v em++ > /dev/null || { echo "engine.sh: not found: em++. Run: tools/setup.sh live" >&2; exit 2; }
[ -d "$eigen/Eigen" ] || { echo "engine.sh: no folder $eigen/Eigen; EIGEN=... names the folder of Eigen's headers" >&2; exit 2; }
[ -f "$toml/toml++/toml.h" ] || { echo "engine.sh: no file $toml/toml++/toml.h; TOML=... names its folder" >&2; exit 2; }
toolchain=$(em-config EMSCRIPTEN_ROOT)/cmake/Modules/Platform/Emscripten.cmake
# Debian keeps the modules that emscripten asks node for where the node of Debian looks.
export NODE_PATH="${NODE_PATH:-/usr/share/nodejs}"
launcher=""
[ -n "${CCACHE_DISABLE:-}" ] || launcher=$(command -v ccache || true)
cmake -S "$root/cmake/engine" -B "$folder" -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DEIGEN="$eigen" -DTOML="$toml" \
    -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" --log-level=NOTICE > /dev/null
cmake --build "$folder" -j "${JOBS:-$(nproc)}"
packed() { gzip -9n < "$1" | base64 -w0; }
printf 'self.signoriniEngine = { glue: "%s",\nwasm: "%s" };\n' "$(packed "$folder/glue.js")" "$(packed "$folder/glue.wasm")" > "$folder/engine.part"
mv "$folder/engine.part" "$folder/engine.js"
echo "$folder/engine.js: $(($(wc -c < "$folder/engine.js") / 1024)) KiB"
