// Random condensed problems of every kind that breaks a solver, of which it is known whether something solves
// them: dependent, repeated and nearly repeated rows, ratios of 1e+-8, ties.
#pragma once
#include <cstdint>
#include <string>

#include "signorini/problem/problem.hpp"

namespace signorini_test {

/// One problem and whether it can be solved.
struct RandomCondensed {
  std::string name;                   ///< seed and kind, for messages
  signorini::ContactProblem problem;  ///< G = H^T H and d, 2 to 12 pairs
  bool feasible = true;               ///< whether some forces satisfy all conditions
};

/// The problem of a seed.
///
/// H holds whole numbers of -3 to 3 or any numbers, has often fewer rows than columns, and columns that
/// repeat others, turned round or not, or do so but for 1e-12 to 1e-4. Of a feasible problem d = gap - G force
/// with chosen forces and gaps, rounded once; what these forces move is at least 2^-26 of what one of them moves
/// alone. An infeasible one has y > 0 in whole numbers with H y = 0 on some
/// pairs and d^T y = -1 to -3, exactly. In the end every pair has its own unit, a power of two of 1e-8 to 1e8.
/// \param seed  of the problem
/// \return the same problem on every machine
RandomCondensed random_condensed(std::uint64_t seed);

/// How a solver's answer to such a problem counts.
enum class Verdict {
  Solved,   ///< feasible, and the certificate of the answer holds
  Refuted,  ///< infeasible, and its proof holds
  Failed,   ///< the solver says that it has no answer
  Wrong     ///< anything else
};

/// Judges an answer from the data: forces and gaps by their certificate, a proof in twice the precision.
/// \param problem  with the right answer
/// \param state    what the solver says
/// \return the outcome
Verdict verdict(const RandomCondensed& problem, const signorini::ContactState& state);

}  // namespace signorini_test
