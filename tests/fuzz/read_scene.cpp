// The fuzzer of the reader of scene files: clang's libFuzzer invents texts, this must survive them.
// Build:  cmake --preset fuzz && cmake --build --preset fuzz --target fuzz_read_scene
// Run:    build/presets/fuzz/bin/fuzz_read_scene -dict=tests/fuzz/scene.dict FOLDER tests/data/fuzz_corpus_scene
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/check_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view content(reinterpret_cast<const char*>(data), size);
  if (signorini_test::may_be_large(content)) return 0;
  const std::string wrong = signorini_test::check_scene(content);
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "%s\n", wrong.c_str());
  std::abort();
}
