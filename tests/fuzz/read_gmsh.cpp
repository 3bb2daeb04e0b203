// The fuzzer of the reader of Gmsh files: clang's libFuzzer invents texts, this must survive them.
// Build:  cmake --preset fuzz && cmake --build --preset fuzz --target fuzz_read_gmsh
// Run:    build/presets/fuzz/bin/fuzz_read_gmsh -dict=tests/fuzz/gmsh.dict FOLDER tests/data/fuzz_corpus_gmsh
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/check_gmsh.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string wrong = signorini_test::check_gmsh({reinterpret_cast<const char*>(data), size});
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "%s\n", wrong.c_str());
  std::abort();
}
