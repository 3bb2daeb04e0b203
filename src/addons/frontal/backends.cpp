#include "addons/frontal/backend.hpp"

namespace signorini {

// The table: one line per function that returns a member. A program that is linked with other libraries compiles this file
// once more, with their members too.
#ifndef SIGNORINI_BACKENDS
#define SIGNORINI_BACKENDS frontal()
#endif

Backend SIGNORINI_BACKENDS;  // declares them

void register_backends() {
  static const std::vector<Backend> family = {SIGNORINI_BACKENDS};
  for (const Backend& member : family) add_backend(member);
}

}  // namespace signorini
