/// \file
/// Random numbers that are the same on every machine, whatever its standard library.
#pragma once
#include <cstdint>

namespace signorini {

/// The generator splitmix64 [\ref SteeleLeaFlood2014]: 64 bits of state, no transcendental function,
/// so that a seed names one problem everywhere.
class Random {
 public:
  /// Starts a sequence.
  /// \param seed  any number; every seed has its own sequence
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// The next number, equally likely everywhere in an interval.
  /// \param low   smallest value
  /// \param high  above the largest value
  /// \return a number in [low, high)
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  /// The next whole number, equally likely in a range that is small against 2^64.
  /// \param low   smallest value
  /// \param high  largest value
  /// \return a number in [low, high]
  int whole(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace signorini
