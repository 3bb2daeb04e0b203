/// \file
/// The certificate of a solution: a few figures, always recomputed from the original data.
#pragma once
#include <Eigen/Core>
#include <iosfwd>

#include "signorini/core/rounding.hpp"
#include "signorini/problem/problem.hpp"
#include "signorini/problem/residual.hpp"

namespace signorini {

/// What a certificate lets pass [-]: a larger figure refutes a solution, a smaller one counts as zero.
constexpr double certificate_tolerance = 1e-12;

/// How far a claimed solution is from satisfying each condition, made free of units; 0 is perfect.
///
/// Row i of a problem, a gap or a slip, has the claimed force f_i and the movement w_i, which the data give in twice the working
/// precision. \f$ \hat f_i = s_i f_i \f$ and \f$ \hat w_i = w_i / s_i \f$ have one unit each, whatever the scale of the row.
/// They are measured by one force \f$ \varphi \f$ and one length \f$ \ell \f$, which ClaimResiduals brings along with the rest:
/// \f[ \text{penetration} = \max_{gaps} \frac{(-\hat w_i)^+}{\ell},\qquad
///     \text{tension} = \max_{gaps} \frac{(-\hat f_i)^+}{\varphi},\qquad
///     \text{complementarity} = \max_{gaps} \frac{|\hat f_i \hat w_i|}{\ell\varphi}, \f]
/// \f[ \text{duality gap} =
///     \frac{|\sum_{gaps} f_i w_i - \sum_j q_j \rho_j|}
///          {\max(\sum_{gaps} |f_i g_i| + \sum_j |b_j q_j|,\ \ell\varphi)}. \f]
/// Of an equation \f$ |\hat w_i| \f$ counts as penetration, and no force as tension. The numerator of the duality gap is the
/// primal minus the dual energy, see ClaimResiduals for g, q, b and rho. Of a frictional pair with gap i, slip k,
/// \f$ \beta = s_k \mu f_i^+ \f$ and \f$ \gamma = s_k c \f$,
/// \f[ \text{cone} = \max\left(\frac{(|\hat f_k| - \beta)^+}{\varphi}, \text{status}\right),\qquad
///     \text{sliding} = \min\left(\frac{|\hat w_k|}{\ell},
///                               \frac{|\hat f_k + \beta\,\mathrm{sign}\,\hat w_k|}{\varphi}\right), \f]
/// twice: open, with status \f$ \hat f_i^+ / \varphi \f$ if c > 0, else 0; closed, with \f$ \beta + \gamma \f$ for
/// \f$ \beta \f$ and status \f$ \hat w_i^+ / \ell \f$. The two figures with the smaller maximum count.
///
/// No figure changes with units or with the scale of a row, and what cancels or lies elsewhere hides nothing.
/// See chapters/notation.md.
struct Certificate {
  double penetration = 0;      ///< largest overlap / length
  double tension = 0;          ///< largest tensile contact force / force
  double complementarity = 0;  ///< largest |force * gap| / (length * force)
  double equilibrium = 0;      ///< what forces and movements lack of their equations, see certify()
  double duality_gap = 0;      ///< |primal - dual energy| / their size
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

/// What a claim leaves of a problem, and what that is measured by: all that a certificate looks at.
struct ClaimResiduals {
  Eigen::VectorXd force;     ///< f `n_c + n_s` [force]
  Eigen::VectorXd movement;  ///< w `n_c + n_s`: gaps, then slips, from the data [length]
  /// s `n_c + n_s` > 0: of all rows force * unit is in one unit, and so is movement / unit
  Eigen::VectorXd unit;
  double force_size = 0;           ///< phi, that forces are measured by, in that unit
  double length = 0;               ///< l, that movements are measured by, in that unit
  double equilibrium = 0;          ///< the figure of that name
  Eigen::VectorXd free = {};       ///< g or d [length], which forces work on; empty: no duality gap
  Eigen::VectorXd load = {};       ///< b: p, with friction forces as loads, or r [force]
  Eigen::VectorXd position = {};   ///< q: u or a, which loads work on [length]
  Eigen::VectorXd imbalance = {};  ///< rho: what the equilibrium of each entry of q lacks [force]
};

/// The one certificate, of whatever was claimed.
/// \param left       what the claim leaves
/// \param law        of the frictional pairs
/// \param equations  so many of the first rows are equations
/// \return the figures, by the formulas at Certificate
[[nodiscard]] Certificate certify(const ClaimResiduals& left, const FrictionLaw& law,
                                  Eigen::Index equations = 0);

/// Equations among the rows of a programme. Their forces have any sign, so that what they leave out of balance is measured behind the
/// change of them that serves best: who has equations says how.
struct EquationRows {
  Eigen::Index count = 0;  ///< so many of the first rows
  /// Takes the columns of A^T that are equations, what every unknown has itself, see o_j below, and the residual rho; returns
  /// the largest share of the last in the second
  double (*imbalance)(Eigen::MatrixXd columns, const Eigen::VectorXd& own,
                      Eigen::VectorXd residual) = nullptr;
};

/// Certificate of (u, lambda) against K, p, A, g. \PaperEq{XuanLi2002, 6}, \PaperEq{XuanLi2002, 21},
/// \PaperEq{LinEtAl, 2} to \PaperEq{LinEtAl, 4}
///
/// The numbers of ClaimResiduals are
/// \f[ s_i = |a_i|,\quad w = g - A u,\quad \rho = p - K u - A^T\lambda,\quad q = u,\quad b = p - A_s^T\lambda_s \f]
/// with the slips s, sums in twice the working precision, and
/// \f[ \varphi = \max(|p|_\infty, |A^T\lambda|_\infty),\qquad
///     \ell = \max\left(\max_i \frac{1}{s_i}\sum_j |a_{ij} u_j|,
///                      \frac{|p - A^T\lambda|_\infty}{\max_j K_{jj}}\right), \f]
/// \f[ \text{equilibrium} = \max\left(\frac{|\rho|_\infty}{\varphi},\ \max_j \frac{|\rho_j|}{o_j}\right),\qquad
///     o_j = |p_j| + \sum_i |a_{ij}\lambda_i| + \sqrt{K_{jj}} \max_i \sqrt{K_{ii}} |u_i|, \f]
/// where own_imbalance() says what equations and rounding change in the last one. Where p - A^T lambda is nothing but rounding,
/// phi takes its place in the length. That second length is at most the largest \f$ |u_j| \f$, or, if u is rounding of it, the larger
/// of that and the least \f$ |g_i| / s_i > 0 \f$. Without loads, contact forces below what u in two doubles resolves are measured by
/// \f$ \max_j K_{jj}|u_j| \f$. Of each of the unconnected_systems() all this is taken by itself, and the worst figures count.
///
/// Where u counts from a place that was reached, \f$ \hat u \f$ with internal forces whose magnitudes sum to t, what is left of
/// the loads there is small: \f$ |u_j| \f$ becomes \f$ |u_j| + |\hat u_j| \f$ in the length, \f$ o_j \f$ gets \f$ t_j \f$ as well, and the
/// equilibrium is measured by \f$ \max(\varphi, |t|_\infty) \f$, see QuadraticProgramme::reached.
///
/// The equilibrium is measured against the loads and not against |K||u|, which is far larger in a slender body: with u in plain
/// doubles it cannot be better than about 1e-16 |K||u| / |p|, whatever the solver; `displacement_low` removes this floor.
/// \param programme  K, p, A, g as they were posed
/// \param solution   u and lambda, from any solver
/// \param equations  the first rows, as far as they are some: both signs of their gap count as penetration, and no force as tension
/// \return the figures; all infinite if any number, given or claimed, is not finite, or if the rigid
///   part strains a body: an entry of K times it exceeds certificate_tolerance of its terms
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] Certificate certify(const QuadraticProgramme& programme, const PrimalDual& solution,
                                  const EquationRows& equations = {});

/// The same with friction: the last rows of A are slips, and their forces obey the law.
/// \PaperEq{LinEtAl, 6}, \PaperEq{LinEtAl, 9}, \PaperEq{LinEtAl, 10}
///
/// A pair with cohesion may be open or closed, whichever the numbers suit better: open, what presses it counts in
/// `cone`; closed, it has the bound mu lambda + c, and its gap counts there. Without, it has mu lambda. The
/// duality gap is that of contact with the friction forces as loads.
/// \param programme  K, p, A, g as they were posed, slips in the last rows of A
/// \param solution   u, and the forces of all rows
/// \param law        of the frictional pairs
/// \param known      known_matrices() of K, A and the law; null if they are not known
/// \return the figures, see above
/// \throws std::invalid_argument if sizes do not fit, the pairs of the law are not in increasing order, or a
///   coefficient or cohesion is negative or not finite
[[nodiscard]] Certificate certify(const QuadraticProgramme& programme, const PrimalDual& solution,
                                  const FrictionLaw& law, const KnownMatrices* known = nullptr);

/// How far loads would move a body that contact, or equations, hold at 0: \f$ |p - A^T\lambda|_\infty / \max_j K_{jj} \f$, phi in the
/// place of its numerator if that is rounding, and within the bounds that certify() states. Gaps are measured by it, and equations.
/// \param load      p `n` [force] \param contact  A^T lambda `n` [force] \param diagonal  of K `n` [force/length]
/// \param u         [length] \param nearest  the least of the gaps, or right sides, that are not 0 [length]; infinity: all are
/// \return that way [length]
[[nodiscard]] double way_of_loads(const Eigen::VectorXd& load, const Eigen::VectorXd& contact,
                                  const Eigen::VectorXd& diagonal, const Eigen::VectorXd& u, double nearest);

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
/// The numbers of ClaimResiduals are
/// \f[ s_i = \sqrt{|F_{ii}|},\quad w = w^0 + F f + R a,\quad \rho = R^T f - r,\quad q = a,\quad b = r \f]
/// with the free gaps and slips w^0 and sums in twice the working precision; where F_ii = 0, s_i is that of row_scales(), and any
/// matrix can stand in the place of F. With the claimed movements v, and \f$ o_i = (-w^0_i)^+ \f$ of a gap, \f$ |w^0_i| \f$ of a
/// slip,
/// \f[ \varphi = \max_i s_i |f_i|,\qquad \ell = \max_i \frac{\max(o_i, |F f|_i, |R a|_i)}{s_i}, \f]
/// \f[ \text{equilibrium} = \max\left(
///     \max_j \frac{|\rho_j|}{\max(|r_j|,\ \varphi \max_i |R_{ij}| / s_i)},
///     \max_i \frac{|w_i - v_i|}{\max(s_i\ell, |w_i|)}\right). \f]
/// If rigid modes leave no more than rounding of that length, the smaller of \f$ \max_{ij} |F_{ij} f_j| / s_i \f$ and
/// \f$ \max_j |r_j| / \max_i (|R_{ij}| / s_i) \f$ takes its place. With friction there is no duality gap.
/// \param problem  by its blocks, wherever they are; sizes fit, and the law passes check_law()
/// \param claim    of all rows
/// \return the figures; all infinite if any number of F, d, s, R, r, given or claimed, is not finite
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

/// \param one    figures
/// \param other  more of them
/// \return the larger of each
[[nodiscard]] Certificate worst_of(Certificate one, const Certificate& other);

/// Prints the figures on one line, those of friction if they are not zero.
/// \param out          where to
/// \param certificate  what
/// \return `out`
std::ostream& operator<<(std::ostream& out, const Certificate& certificate);

}  // namespace signorini
