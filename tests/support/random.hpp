// Random numbers for the tests: those of the library.
#pragma once
#include "signorini/core/random.hpp"

namespace signorini_test {

using signorini::Random;

}  // namespace signorini_test
