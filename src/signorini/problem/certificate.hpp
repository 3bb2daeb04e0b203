/// \file
/// The certificate of a solution: a few figures, always recomputed from the original data.
#pragma once
#include <Eigen/Core>
#include <iosfwd>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini {

/// What a certificate lets pass [-]: a larger figure refutes a solution, a smaller one counts as zero.
constexpr double certificate_tolerance = 1e-12;

/// How far a claimed solution is from satisfying each condition, made free of units; 0 is perfect.
///
/// Lengths are divided by the largest |a_i||u| of a row, or by what the largest entry of p - A^T lambda would move the stiffest
/// unknown by, if that is larger. Forces are divided by the largest load or net contact force on an unknown; a residual also by
/// what its own unknown has, behind what the forces of equations could still balance: own_imbalance(). Rows of A are scaled to norm 1. So no
/// figure changes with units or with the scaling of a row, and what cancels or lies elsewhere hides nothing. Where no load acts,
/// contact forces of rounding size are measured by the forces that the displacements could make. Of a programme, each of the
/// unconnected_systems() is measured by itself, and the worst figures count. See chapters/notation.md.
struct Certificate {
  double penetration = 0;      ///< largest overlap / length
  double tension = 0;          ///< largest tensile contact force / force
  double complementarity = 0;  ///< largest |force * gap| / (length * force)
  double equilibrium = 0;      ///< largest of p - K u - A^T lambda / force, or own force
  double duality_gap = 0;      ///< |primal - dual energy| / their size, see certify()
  double cone = 0;  ///< largest |friction force| beyond its bound / force; 0 without friction
  /// What a pair slides without being resisted: the smaller of |slip| / length and |friction force minus
  /// that of its bound| / force, the largest over the pairs; 0 without friction
  double sliding = 0;
  /// Of a scene: by how much the resultants of its contacts differ from what the forces of all rows do to the bodies,
  /// see imbalance() in scene/balance.hpp; 0 of a programme
  double balance = 0;

  /// \return the worst of all
  [[nodiscard]] double worst() const;
  /// Whether this is good enough.
  /// \param tolerance  for all of them [-]
  /// \return whether none exceeds it
  [[nodiscard]] bool holds(double tolerance = certificate_tolerance) const {
    return worst() <= tolerance;
  }
};

/// The certificate of what was not solved, or holds a number that is not finite.
/// \return infinity in all
[[nodiscard]] Certificate uncertified();

/// A claimed solution of a quadratic programme; u is kept as the unevaluated sum of two vectors.
struct PrimalDual {
  Eigen::VectorXd displacement;      ///< u `n` [length], rounded to double
  Eigen::VectorXd displacement_low;  ///< what rounding took away, `n` [length]; empty means zero
  Eigen::VectorXd force;             ///< lambda `n_c` [force], compression > 0
  /// The part of u that moves whole bodies `n` [length], empty if there is none. That it strains nothing
  /// is known beforehand and not computed: K times a motion is rounding, which in a stiff body may exceed
  /// the loads of all others. So equilibrium is that of u without it.
  Eigen::VectorXd rigid = {};
};

/// u += change, keeping in `displacement_low` what does not fit into the leading double.
/// \param solution  whose displacement grows; both parts `n`
/// \param change    `n` [length]
void add_displacement(PrimalDual& solution, const Eigen::VectorXd& change);

/// The displacements that strain the bodies, which stresses are computed from: beside a large motion the
/// rounding of u may be larger than all the strain of a stiff body.
/// \param solution  u in two parts, and its rigid part
/// \return u without the rigid part `n` [length], rounded once
[[nodiscard]] Eigen::VectorXd strained(const PrimalDual& solution);

/// Certificate of (u, lambda) against K, p, A, g. \PaperEq{XuanLi2002, 6}, \PaperEq{XuanLi2002, 21},
/// \PaperEq{LinEtAl, 2} to \PaperEq{LinEtAl, 4}
///
/// Residuals are summed in twice the working precision. The equilibrium is measured against the
/// loads and not against |K||u|, which is far larger in a slender body: with u in plain doubles it
/// cannot be better than about 1e-16 |K||u| / |p|, whatever the solver; `displacement_low` removes
/// this floor. The energies are measured against the sum of |lambda g| and |p u|, or length * force
/// if that is larger.
/// \param programme  K, p, A, g as they were posed
/// \param solution   u and lambda, from any solver
/// \param equations  so many of the first rows are equations: both signs of their gap count as
///   penetration, and no force as tension
/// \return the figures; all infinite if any number, given or claimed, is not finite, or if the rigid
///   part strains a body: an entry of K times it exceeds certificate_tolerance of its terms
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] Certificate certify(const QuadraticProgramme& programme, const PrimalDual& solution,
                                  Eigen::Index equations = 0);

/// The same with friction: the last rows of A are slips, and their forces obey the law.
/// \PaperEq{LinEtAl, 6}, \PaperEq{LinEtAl, 9}, \PaperEq{LinEtAl, 10}
///
/// A pair with cohesion may be open or closed, whichever the numbers suit better: open, what presses it counts in
/// `cone`; closed, it has the bound mu lambda + c, and its gap counts there. Without, it has mu lambda. The
/// duality gap is that of contact with the friction forces as loads.
/// \param programme  K, p, A, g as they were posed, slips in the last rows of A
/// \param solution   u, and the forces of all rows
/// \param law        of the frictional pairs
/// \return the figures, see above
/// \throws std::invalid_argument if sizes do not fit, the pairs of the law are not in increasing order, or a
///   coefficient or cohesion is negative or not finite
[[nodiscard]] Certificate certify(const QuadraticProgramme& programme, const PrimalDual& solution,
                                  const FrictionLaw& law);

/// Forces and movements of all rows, gaps first, and what they are measured by.
struct RowNumbers {
  const Eigen::VectorXd& force;     ///< `n_c + n_s` [force]
  const Eigen::VectorXd& movement;  ///< `n_c + n_s`: gaps, then slips [length]
  /// `n_c + n_s` > 0: of all rows force * unit is in one unit, and so is movement / unit
  const Eigen::VectorXd& unit;
  double largest_force;  ///< that forces are measured by, in that unit
  double length;         ///< that movements are measured by, in that unit
};

/// What both certificates ask of pairs: no overlap, no tension, no force across a gap, the law of friction.
/// \param rows       as they were found
/// \param law        of the frictional pairs
/// \param equations  so many of the first rows are equations
/// \return penetration, tension, complementarity, cone and sliding; the other figures are 0
[[nodiscard]] Certificate pair_figures(const RowNumbers& rows, const FrictionLaw& law,
                                       Eigen::Index equations = 0);

/// A condensed problem by its blocks, see ContactProblem.
struct ProblemBlocks {
  const Eigen::MatrixXd& compliance;  ///< F
  const Eigen::VectorXd& free;        ///< d, then s
  const FrictionLaw& law;             ///< of the frictional pairs
  const Eigen::MatrixXd& rigid;       ///< R
  const Eigen::VectorXd& resultant;   ///< r
};

/// What is claimed of all rows, gaps first.
struct Claim {
  Eigen::VectorXd force;      ///< `n_c + n_s`
  Eigen::VectorXd movement;   ///< `n_c + n_s`
  Eigen::VectorXd amplitude;  ///< `n_r`
};

/// Certificate of forces, gaps, slips and amplitudes against a condensed problem.
///
/// Row i is measured in movement / sqrt(F_ii) and force sqrt(F_ii), which have one unit: lengths against the
/// largest overlap without contact, or what forces and rigid motions move in sum, forces against the largest
/// of them. Any matrix can stand in the place of G, see row_scales(). The movements are recomputed in twice the
/// working precision; `equilibrium` is the largest difference of the claimed from the recomputed ones, or the
/// largest entry of R^T f - r over r or what the largest force could add to it. With friction there is no duality
/// gap; open or closed as for a programme.
/// \param problem  by its blocks, wherever they are
/// \param claim    of all rows
/// \return the figures; all infinite if any number of F, d, s, R, r, given or claimed, is not finite
/// \throws std::invalid_argument if sizes do not fit, or as check_law()
[[nodiscard]] Certificate certify(const ProblemBlocks& problem, const Claim& claim);

/// The same for a state.
/// \param problem  as it was posed, or any M and q
/// \param state    forces, gaps, friction forces, slips and amplitudes; nothing else is looked at
/// \return the figures; all infinite if any number, given or claimed, is not finite
/// \throws std::invalid_argument if sizes do not fit, or as check_law()
[[nodiscard]] Certificate certify(const ContactProblem& problem, const ContactState& state);

/// What rounding may have done to numbers that a proof rests on.
inline constexpr double proof_rounding = 1e3 * epsilon;

/// Whether y proves that nothing solves a problem, checked on the original data in twice the working precision.
///
/// With y >= 0 on the gaps, \f$ F^T y \le 0 \f$, 0 where friction acts, R^T y = 0 and d^T y < 0 the gaps of any forces
/// and amplitudes sum to \f$ y^T(d + F f + R a) \le d^T y < 0 \f$. A symmetric F is positive semidefinite but for rounding, so
/// that F y = 0 is asked. Computed numbers give F^T y but for rounding, allowed here to
/// be 1e3 epsilon of the largest that it could be; so the forces that lift the sum to zero, at least
/// \f$ -d^T y / \max_i (F^T y)_i \f$, must be out of force_scale as well: beyond \f$ 1/\sqrt{\epsilon} \f$ times the
/// one that closes the deepest free overlap alone, all in the units of equilibrate(). And d^T y must exceed what
/// rounding did to d. The same is asked of a programme by proves_infeasible().
/// \param problem  as it was posed, or any M and q
/// \param y        `n_c`, or of another size, which proves nothing
/// \return whether it does
[[nodiscard]] bool verify_farkas(const ContactProblem& problem, const Eigen::VectorXd& y);

/// The forces that are missing in the equilibrium, summed in twice the working precision.
/// \param programme  K, p, A
/// \param solution   u in its two parts, and lambda; K is not applied to the rigid part
/// \return \f$ p - K u - A^T \lambda \f$ `n` [force]
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] Eigen::VectorXd equilibrium_residual(const QuadraticProgramme& programme,
                                                   const PrimalDual& solution);

/// The gaps that displacements leave, summed in twice the working precision.
/// \param programme  A and g
/// \param solution   u in its two parts
/// \return \f$ g - A u \f$ `n_c` [length], overlap < 0
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] Eigen::VectorXd gaps(const QuadraticProgramme& programme, const PrimalDual& solution);

/// Prints the figures on one line, those of friction if they are not zero.
/// \param out          where to
/// \param certificate  what
/// \return `out`
std::ostream& operator<<(std::ostream& out, const Certificate& certificate);

}  // namespace signorini
