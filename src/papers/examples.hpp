/// \file
/// Problems whose solution is known beforehand, for chapters, benchmarks and tests.
#pragma once
#include <cstdint>

#include "signorini/problem/problem.hpp"

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

/// Another random programme built backwards, of whole numbers and with few entries: for statements that are to hold for
/// more than one way to draw.
///
/// K = B^T B + I with entries of B in -2, ..., 2. One entry of a row of A, in column i mod n, is not zero, the others are
/// drawn with the probability 1/3, from -5, ..., 5, and zero else. u in -4, ..., 4. From 1 to min(n, m) rows, any number of them as
/// likely as another, are closed with forces in 1, ..., 9; the others are open by 1, ..., 9. All data are whole numbers,
/// and exact. Closed rows may depend on each other, so that other forces solve the problem, too; u is the only one.
/// \param n     unknowns, at least 1
/// \param m     rows, at least 1
/// \param seed  of the random numbers
/// \return programme and solution
/// \throws std::invalid_argument if a size is not positive
[[nodiscard]] KnownProgramme whole_number_programme(Eigen::Index n, Eigen::Index m,
                                                    std::uint64_t seed);

/// What is pressed into a half-plane.
enum class Punch {
  Parabola,  ///< x^2 / 2R: it touches over a part of the pairs, with Hertz's pressure
  Flat       ///< with sharp edges at the ends: it touches everywhere
};

/// A half-plane under a rigid punch, with the exact solution of the continuum.
struct Indentation {
  ContactProblem problem;    ///< G and d, for forces per unit thickness
  Eigen::VectorXd position;  ///< `n` of the pairs, in (-1, 1) [half-width of the candidates]
  Eigen::VectorXd force;     ///< `n` exact pressure, summed over the length of each pair
  double half_width = 0;     ///< exact: pairs with |x| below it are closed
  double total_force = 0;    ///< exact
};

/// A rigid punch pressed into an elastic half-plane: n equal elements of constant pressure between
/// -1 and 1, gaps at their midpoints [\ref Johnson1985].
///
/// With E/(1 - nu^2) = 1 and r = |x_i - x_j|, h = 2/n, a force spread over element j moves the surface
/// at x_i by
/// \f[ G_{ij} = -\frac{2}{\pi h} \int_{r-h/2}^{r+h/2} \ln\frac{|s|}{c}\,ds \f]
/// relative to the points at the distance c = 2: symmetric, positive definite because c exceeds a quarter
/// of the length, with a condition that grows like n. The parabola has R = 1 and is pressed in until
/// it touches for |x| < b = 0.6, by (ln(2c/b) + 1/2) b^2 / 2; the flat punch carries the force 1 and sinks
/// by ln(2c) 2/pi. The forces of the discrete problem differ from the exact ones by terms of the
/// order h.
/// \param n      pairs, at least 1
/// \param punch  its shape
/// \return problem and exact solution of the continuum
/// \throws std::invalid_argument if n is not positive
[[nodiscard]] Indentation half_plane_indentation(Eigen::Index n, Punch punch = Punch::Parabola);

/// A symmetric positive definite problem on which complementary pivoting takes 2^n pivots
/// [\ref Fathi1979]: G = L L^T with ones on the diagonal of L and twos below, all d = -1.
///
/// lemke() with a covering vector of ones passes 2^n bases, although a single closed pair is the
/// solution: force (1, 0, ..., 0), gap (0, 1, ..., 1).
/// \param n  pairs, at least 1
/// \return G and d
/// \throws std::invalid_argument if n is not positive
[[nodiscard]] ContactProblem fathi(Eigen::Index n);

/// A problem with an asymmetric matrix on which complementary pivoting takes 2^n pivots
/// [\ref Murty1978]: M has ones on the diagonal, twos above it and zeros below, and
/// \f$ q_i = 2^i - 2^{n+1} \f$ for i = 1, ..., n.
///
/// The only solution is force (0, ..., 0, 2^n), gap (2, 4, ..., 2^{n-1}, 0).
/// \param n  pairs, from 1 to 50
/// \return M and q
/// \throws std::invalid_argument if n is out of range
[[nodiscard]] ContactProblem murty(Eigen::Index n);

}  // namespace signorini
