// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Something that is exchanged for a while.
#pragma once
#include <utility>

namespace signorini {

/// Exchanges two things now, and back at the end of its life, whatever is thrown meanwhile.
template <typename Exchange>
class Swapped {
 public:
  explicit Swapped(Exchange exchange) : exchange_(std::move(exchange)) { exchange_(); }
  ~Swapped() { exchange_(); }
  Swapped(const Swapped&) = delete;
  Swapped& operator=(const Swapped&) = delete;

 private:
  Exchange exchange_;
};

}  // namespace signorini
