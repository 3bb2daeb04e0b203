/// \file
/// Who is compared has its turn in each round, so that a change of the machine's speed meets all.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "bench/measure.hpp"

namespace signorini::bench {

/// Seconds that one turn may take.
inline constexpr double longest_turn = 120;

/// What one turn took.
struct Turn {
  double seconds = 0;  ///< processor time [s]
  double also = 0;     ///< what else is compared
};

/// Asks all in turn, round after round. The first turn is not counted unless it is the only one: it warms up, and
/// who needs more than a tenth of longest_turn for it, or failed in it, is asked once only.
/// \param count   how many are compared
/// \param rounds  that count; 1 is the first turn
/// \param ask     `(who, whether it is the first turn)`, sets whether it failed
/// \return medians over the turns of each
inline std::vector<Turn> in_turn(
    std::size_t count, int rounds,
    const std::function<Turn(std::size_t who, bool first, bool& failed)>& ask) {
  std::vector<std::vector<double>> seconds(count), also(count);
  const auto count_in = [&](std::size_t i, const Turn& turn) {
    seconds[i].push_back(turn.seconds);
    also[i].push_back(turn.also);
  };
  for (std::size_t i = 0; i < count; ++i) {
    bool failed = false;
    const Turn turn = ask(i, true, failed);
    if (turn.seconds >= 0.1 * longest_turn || rounds == 1 || failed) count_in(i, turn);
  }
  std::vector<bool> once(count);
  for (std::size_t i = 0; i < count; ++i) once[i] = !seconds[i].empty();
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < count; ++i) {
      bool failed = false;
      if (!once[i]) count_in(i, ask(i, false, failed));
    }
  std::vector<Turn> medians(count);
  for (std::size_t i = 0; i < count; ++i) medians[i] = {median(seconds[i]), median(also[i])};
  return medians;
}

}  // namespace signorini::bench
