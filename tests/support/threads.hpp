// A number of threads for the length of a block.
#pragma once
#include "signorini/core/parts.hpp"

namespace signorini_test {

class Threads {
 public:
  explicit Threads(int count) : before_(signorini::threads()) { signorini::set_threads(count); }
  ~Threads() { signorini::set_threads(before_); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

 private:
  int before_;
};

}  // namespace signorini_test
