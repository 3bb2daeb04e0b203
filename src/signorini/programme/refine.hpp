/// \file
/// The last step of every exact method: the equations of a known set, from the original data.
#pragma once
#include <functional>

#include "signorini/closing/closing.hpp"
#include "signorini/problem/certificate.hpp"

namespace signorini {

/// u += change, keeping in `displacement_low` what does not fit into the leading double.
/// \param solution  whose displacement grows; both parts `n`
/// \param change    `n` [length]
void add_displacement(PrimalDual& solution, const Eigen::VectorXd& change);

/// u += change by a motion that strains nothing: the part of u that is kept as such grows too.
/// \param solution  whose displacement grows
/// \param change    `n` [length]
void add_rigid(PrimalDual& solution, const Eigen::VectorXd& change);

/// What refine() did.
struct Refinement {
  PrimalDual solution;        ///< u in two parts, and the forces of all rows of A
  Eigen::VectorXd movement;   ///< initial_gap - A u of all rows of A: gaps, then slips [length]
  Eigen::VectorXd amplitude;  ///< how much of each rigid mode went into u `n_r`
  Eigen::Index solves = 0;    ///< with K
  bool settled = false;       ///< whether corrections have become as small as rounding
};

/// Refines \f$ K u + A^T f = p,\ A_W u = g_W \f$ for known motions: rows W that do not move, friction forces at
/// their bounds, no force anywhere else.
///
/// A sweep adds K^-1 times the residual of equilibrium to u, then the forces that close what W still
/// moves, and what these move in turn,
///
/// \f[ M\,\Delta f_W = A_W u - g_W,\qquad u \mathrel{+}= -K^{-1} A^T \Delta f, \f]
///
/// where M is the matrix of Closing. Residuals come from the original data in twice the working
/// precision, so the factor and the compliance may carry relative errors up to about 1/cond. u and the
/// forces are kept as sums of two doubles: on a slender body the last digit of a force moves the far end by
/// many digits. Sweeps end when the next correction will be of rounding size, or when corrections
/// shrink no more. What forces move in turn is left to the next sweep, whose residual feels it, as long as two
/// sweeps are enough; only on badly conditioned problems does it get a solve of its own, which makes the
/// corrections shrink by the error of the forces in place of that of the factor.
///
/// With rigid modes K is singular, and `solve_stiffness` and `condensed` belong to the grounded K_g of
/// add_rigid_modes(). Residuals are still those of K; the amplitudes take up what only a rigid
/// motion feels of them, so that no spring takes part.
/// \param programme        K, p, A, g as they were posed; with friction A has rows of slips, -T, at its end
/// \param solve_stiffness  K^-1 applied to a vector [force] -> [length]; need not be accurate
/// \param condensed        of which compliance, law and rigid modes are used; these need not be accurate
/// \param start            where to start: u may still be that without contact; forces that the motions
///                         exclude are dropped
/// \param motions          `n_c`
/// \param null_vectors     N, or nothing if K is regular
/// \return the refined numbers; whether all signs are right is for judge() to say
/// \throws std::invalid_argument if the sizes of `programme`, `start` and N do not fit
[[nodiscard]] Refinement refine(
    const QuadraticProgramme& programme,
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& solve_stiffness,
    const ContactProblem& condensed, PrimalDual start, const std::vector<Motion>& motions,
    const Eigen::MatrixXd& null_vectors = {});

/// What refined numbers say of every pair.
struct Judgement {
  std::vector<Motion> motions;  ///< what the pairs would rather do
  Eigen::Index wrong = 0;       ///< pairs that would rather do something else
  bool confirmed = false;       ///< refined, balanced and no pair wrong: the solution
};

/// Looks at all signs beyond rounding: closed pairs press, open ones do not overlap, friction forces of
/// sticking pairs keep their bound, sliding ones resist.
/// \param programme     as refine()
/// \param law           of the pairs that rub
/// \param refined       from refine() for `motions`
/// \param motions       `n_c` what was assumed
/// \param null_vectors  N, or nothing
/// \return the verdict
[[nodiscard]] Judgement judge(const QuadraticProgramme& programme, const FrictionLaw& law,
                              const Refinement& refined, const std::vector<Motion>& motions,
                              const Eigen::MatrixXd& null_vectors = {});

}  // namespace signorini
