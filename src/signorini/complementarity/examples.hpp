/// \file
/// Problems whose solution is known beforehand, for chapters, benchmarks and tests.
#pragma once
#include <cstdint>

#include "signorini/complementarity/problem.hpp"

namespace signorini {

/// A programme together with its solution.
struct KnownProgramme {
  DenseProgramme programme;      ///< K, p, A, g
  Eigen::VectorXd displacement;  ///< u `n`, the only minimiser
  Eigen::VectorXd force;         ///< lambda `m` >= 0
  double energy = 0;             ///< its potential energy
};

/// A random programme built backwards from its solution, after Rosen and Suzuki
/// [\ref RosenSuzuki1965].
///
/// K = B B^T + n I / 3 and A with entries of B and A in [-1, 1); u in [-1, 1); half of min(n, m) rows
/// are closed with forces in [0.5, 2), the others open with gaps in [0.1, 2). Then p = K u + A^T lambda
/// and g = A u + gap make u and lambda a solution, the only u for any K, the only lambda because closed
/// rows are independent.
/// \param n     unknowns, at least 1
/// \param m     rows, at least 1
/// \param seed  of the random numbers: the same seed is the same problem on every machine
/// \return programme and solution, both rounded: the data satisfy the conditions to about 1e-15
/// \throws std::invalid_argument if a size is not positive
[[nodiscard]] KnownProgramme rosen_suzuki(Eigen::Index n, Eigen::Index m, std::uint64_t seed);

}  // namespace signorini
