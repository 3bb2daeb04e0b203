// The fuzzer of the reader of input files: clang's libFuzzer invents texts, this must survive them.
// Build:  cmake --preset fuzz && cmake --build --preset fuzz --target fuzz_read_inp
// Run:    build/presets/fuzz/bin/fuzz_read_inp -dict=tests/fuzz/inp.dict FOLDER tests/data/inp
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/check_inp.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string wrong = signorini_test::check_inp({reinterpret_cast<const char*>(data), size});
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "%s\n", wrong.c_str());
  std::abort();
}
