// The fuzzer of the problem reader: clang's libFuzzer invents texts, this must survive them.
// Build:  cmake --preset fuzz && cmake --build --preset fuzz --target fuzz_read_problem
// Run:    build/presets/fuzz/bin/fuzz_read_problem -dict=tests/fuzz/words.dict FOLDER tests/data/fuzz_corpus
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/check_text.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string wrong = signorini_test::check_text({reinterpret_cast<const char*>(data), size});
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "%s\n", wrong.c_str());
  std::abort();
}
