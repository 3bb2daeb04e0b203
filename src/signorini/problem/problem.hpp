/// \file
/// Contact as pure algebra: with displacements and without them, and what a solver returns.
#pragma once
#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "signorini/core/alignment.hpp"
#include "signorini/problem/programme.hpp"

namespace signorini {

/// Which pairs have friction, and how much: \PaperEq{LinEtAl, 6}. Without friction all three are empty.
///
/// The bound of a friction force is \f$ b = \mu\lambda + c \f$, a straight line over the force that presses the pair:
/// Coulomb's law has c = 0, Tresca's mu = 0, and with both it is Coulomb's with cohesion. This is all that solvers and
/// certificates take; laws by name, which give these two numbers for each pair, are friction_laws().
struct FrictionLaw {
  std::vector<Eigen::Index> pair;  ///< `n_s` pairs whose slips are the last `n_s` rows of A
  Eigen::VectorXd coefficient;     ///< mu `n_s` >= 0 [-]
  Eigen::VectorXd cohesion;        ///< c times the weight `n_s` >= 0 [force], of closed pairs only
};

/// A law for pairs that all have friction.
/// \param coefficient  mu `n_c` >= 0 [-]
/// \param cohesion     c times the weight `n_c` >= 0 [force]
/// \return the law
[[nodiscard]] FrictionLaw law_of_all(const Eigen::VectorXd& coefficient,
                                     const Eigen::VectorXd& cohesion);

/// The same problem with the displacements eliminated: \PaperEq{XuanLi2002, 6} after condensation,
///
/// \f[ \begin{pmatrix} gap \\ slip \end{pmatrix} = \begin{pmatrix} d \\ s \end{pmatrix}
///     + F \begin{pmatrix} \lambda \\ \tau \end{pmatrix} + R a,\qquad
///     R^T \begin{pmatrix} \lambda \\ \tau \end{pmatrix} = r, \f]
///
/// with \f$ F = A K^{-1} A^T \f$ and \f$ d = g - A u^0 \f$: lambda >= 0, gap >= 0, lambda gap = 0. An empty
/// block is an absent effect: smooth pairs have no slips, held bodies no rigid modes, and what is left is G and
/// d. With any square matrix in the place of G that is the linear complementarity problem w = M z + q; the
/// solvers that do not list Trait::Asymmetric accept it.
///
/// Of a frictional pair, \f$ |\tau| \le b = \mu\lambda + c \f$ where it is closed, 0 where it is open; it slides only
/// against a friction force at its bound: slip > 0 needs tau = -b, slip < 0 needs tau = b.
/// \PaperEq{LinEtAl, 6}, \PaperEq{LinEtAl, 8}
///
/// With c > 0 a solution need not exist: a pair that only the friction force of its cohesion would
/// pull open has no force to stay closed with, and once open no friction force that pulls. With rigid
/// modes it need not exist either: pairs that could balance r may not be pressed hard enough. For held
/// bodies without cohesion and a positive definite F there is one for every mu, see lemke().
struct ContactProblem {
  Eigen::MatrixXd compliance;  ///< F `n_c + n_s` square, symmetric; gaps first [length/force]
  Eigen::VectorXd free_gap;    ///< d `n_c` [length]: the gap when contact is ignored, overlap < 0
  Eigen::VectorXd free_slip = {};  ///< s `n_s` [length] of the frictional pairs
  FrictionLaw law = {};            ///< of the frictional pairs
  Eigen::MatrixXd rigid = {};      ///< R `n_c + n_s` x `n_r` [length/amplitude]
  Eigen::VectorXd resultant = {};  ///< r `n_r` [force*length/amplitude]
};

/// The contact status of a pair, with the direction in which it slides: \PaperEq{LinEtAl, 13}, \PaperEq{LinEtAl, 14}
enum class ContactStatus : signed char {
  Open,         ///< no force at all
  Stick,        ///< closed and not sliding: no gap and, if the pair has friction, no slip
  SlipForward,  ///< slip > 0, tau = -b
  SlipBackward  ///< slip < 0, tau = b
};

/// A contact status in words.
/// \param contact_status  any
/// \return "open", "stick", "forward" or "backward"
[[nodiscard]] const char* to_string(ContactStatus contact_status);

/// \param contact_status  of a pair
/// \return the sign of tau at its bound, 0 where the pair does not slide
[[nodiscard]] inline double friction_sign(ContactStatus contact_status) {
  return contact_status == ContactStatus::SlipForward    ? -1
         : contact_status == ContactStatus::SlipBackward ? 1
                                                         : 0;
}

/// \param statuses  of pairs
/// \return the closed ones, in increasing order
[[nodiscard]] std::vector<Eigen::Index> closed_pairs(const std::vector<ContactStatus>& statuses);

/// How a solver ended. Nothing but `Solved` may be called a solution.
enum class SolveStatus {
  Solved,          ///< all conditions hold to rounding
  Feasible,        ///< nothing overlaps and forces balance, but the energy is not the least
  Infeasible,      ///< no forces satisfy the conditions
  Ray,             ///< the method ran off along a ray; a solution may or may not exist
  IterationLimit,  ///< stopped by the limit on iterations
  Breakdown,       ///< a system the method needs is singular to working precision
  Jump,            ///< pairs close only without their cohesion and open only with it; as for a ray
  SlidTooFar,  ///< all conditions hold, but pairs have slid too far for them to be those of the bodies
  TurnedTooFar  ///< all conditions hold, but a body has turned too far for strains to be small
};

/// A status in words.
/// \param status  any
/// \return "solved", "feasible, not optimal", "infeasible", "ray", "iteration limit", "breakdown", "jump", "slid too far" or "turned too far"
[[nodiscard]] const char* to_string(SolveStatus status);

/// One iteration of a solver.
struct Iteration {
  Eigen::Index active;     ///< pairs taken as closed
  Eigen::Index changes;    ///< pairs found on the wrong side, which are candidates for a change
  double penetration;      ///< largest overlap of a pair taken as open [length]
  double tension;          ///< largest tensile force of a pair taken as closed [force]
  double dual_energy = 0;  ///< \f$ -d^T\lambda - \tfrac12\lambda^T G\lambda \f$ [force*length]
  /// Size of what a method drives to zero, over its size without contact forces [-]; 0 if it has none
  double residual = 0;
};

/// What a solver says about its run.
struct Report {
  SolveStatus status = SolveStatus::Breakdown;  ///< how it ended
  Eigen::Index iterations = 0;      ///< steps of the method, for active sets: sets it looked at
  Eigen::Index factorisations = 0;  ///< dense factorisations, none for an empty set
  std::vector<Iteration> history;   ///< what a method shows of its iterations, in order; or empty
};

/// Adds a run to those before it.
/// \param[in,out] total  of the runs before: gets the status of `run`, the sum of the counts and both histories
/// \param run            the last run
void append(Report& total, const Report& run);

/// Whether there are other solutions of the same problem.
enum class Uniqueness {
  Proved,   ///< no other solution exists, see uniqueness()
  Unknown,  ///< no other solution was found, and none is excluded
  Doubtful  ///< others exist: a sign proves it, or one was found, see uniqueness()
};

/// What a warning of several solutions rests on, see uniqueness_warning().
///
/// The determinant of the equations of the pairs that slide is linear in the mu of each of them. Divided by its value
/// without the friction of this pair, it is \f$ 1 - \mu/\mu_c \f$: it changes its sign, and several solutions begin, at
/// \f$ \mu_c = \mu / (1 - determinant) \f$.
struct UniquenessWarning {
  std::optional<Eigen::Index> pair = {};  ///< its number; none: all sliding pairs together
  double determinant = 1;  ///< normalised as above, or by that without any friction [-]; < 0 warns
};

struct ActiveSetSystem;

/// Forces, gaps and status of all pairs. Unless `report.status` is Solved, these are the last ones
/// that the method looked at and no solution.
struct ContactState {
  Eigen::VectorXd force;                      ///< lambda `n_c` [force], compression > 0
  Eigen::VectorXd gap;                        ///< `n_c` [length], open > 0
  std::vector<ContactStatus> contact_status;  ///< `n_c` what the pairs do
  Report report;                              ///< how the solver got there
  std::vector<Eigen::Index> frictional_pairs = {};  ///< `n_s` pairs that the next two belong to
  Eigen::VectorXd friction = {};   ///< tau `n_s` [force], on the source along the tangent
  Eigen::VectorXd slip = {};       ///< `n_s` [length], of the source along the tangent
  Eigen::VectorXd amplitude = {};  ///< a `n_r`
  Uniqueness uniqueness = Uniqueness::Unknown;     ///< of a solution with friction
  UniquenessWarning uniqueness_warning = {};       ///< what `Doubtful` rests on
  std::string reason = {};  ///< what stopped the solver, in words; may be empty
  /// Proof that nothing solves the problem, or empty: y `n_c` >= 0 with G y = 0 and d^T y < 0. For any
  /// forces, \f$ y^T(d + G\lambda) = d^T y < 0 \f$, so some gap stays negative.
  Eigen::VectorXd farkas_certificate = {};
  /// Proof that no forces balance r, or empty: the body would move along a `n_r` for ever, see unbounded_direction().
  Eigen::VectorXd unbounded_direction = {};
  /// The equations of the last set, factored, for who refines it; null if the method has no such set
  std::shared_ptr<const ActiveSetSystem> system = {};

  /// \return closed pairs, in increasing order
  [[nodiscard]] std::vector<Eigen::Index> active() const { return closed_pairs(contact_status); }
};

/// \param contact  of a problem with friction
/// \param slip     row of `slip` and `friction`, below `n_s`
/// \return what that frictional pair does
[[nodiscard]] inline ContactStatus status_of_slip(const ContactState& contact, Eigen::Index slip) {
  const Eigen::Index pair = contact.frictional_pairs[static_cast<std::size_t>(slip)];
  return contact.contact_status[static_cast<std::size_t>(pair)];
}

struct ScaledProblem;

/// Choices that every solver understands.
struct SolverOptions {
  Eigen::Index iteration_limit = 0;  ///< 0: the solver's own bound, which grows with the problem
  /// Where a method that only comes closer and closer may stop [-]: its error relative to that of no
  /// contact force at all. Methods that end by themselves do not look at it.
  double tolerance = 1e-12;
  /// `n_c` what the pairs of a problem like this one do, to begin with; or empty. Methods that cannot do not look at
  /// it, and no method needs it to be near.
  std::vector<ContactStatus> start = {};
  const ContactProblem* known = nullptr;  ///< of which it is known how equilibrate() scales it; null: of none
  const ScaledProblem* scaled = nullptr;  ///< that problem, scaled: for a method that is asked for the very same
};

/// Checks a law of friction.
/// \param law    of the frictional pairs
/// \param pairs  n_c
/// \param slips  n_s
/// \throws std::invalid_argument unless it has n_s pairs below n_c in increasing order, and mu and c are >= 0
void check_law(const FrictionLaw& law, Eigen::Index pairs, Eigen::Index slips);

/// \param problem  any
/// \throws std::invalid_argument if sizes do not fit, or as check_law()
void check_sizes(const ContactProblem& problem);

/// Checks what every solver relies on: sizes and numbers.
/// \param problem    any
/// \param of_matrix  whether the numbers of F, which another problem may have had before, are looked at too
/// \throws std::invalid_argument unless all sizes fit, all numbers are finite, mu and c are >= 0, and the
///   numbers of F, its diagonal, d, s, mu and c are so far from overflow and underflow (2^-340 to 2^340, or 0; small numbers
///   beside the diagonal, and of d and s beside larger ones, do no harm) that forces and energies are too; those of r, the largest of
///   each column of R and all of its rows with F_ii = 0, whose quotients are forces as well, 2^-170 to 2^170
void check_finite(const ContactProblem& problem, bool of_matrix = true);

/// Checks what the solvers for symmetric problems rely on.
/// \param problem  any
/// \throws std::invalid_argument as check_finite(), or unless F is symmetric to rounding and without a negative
///   diagonal entry
void check_problem(const ContactProblem& problem);

/// Refuses what a solver for held bodies without friction would overlook.
/// \param problem  any
/// \param solver   what the message calls it
/// \throws std::invalid_argument if the problem has slips or rigid modes
void check_plain(const ContactProblem& problem, const char* solver);

/// Whether F equals its transpose to rounding.
/// \param problem  any
/// \return whether \f$ |F_{ij} - F_{ji}| \f$ is at most 1e3 epsilon times \f$ \sqrt{F_{ii}F_{jj}} \f$
[[nodiscard]] bool is_symmetric(const ContactProblem& problem);

/// \param problem  any
/// \return d, then s `n_c + n_s` [length]
[[nodiscard]] Eigen::VectorXd free_movement(const ContactProblem& problem);

/// The scales of the rows of a problem, whatever its matrix: \f$ s_i = 1 / \sqrt{|M_{ii}|} \f$.
///
/// A row with M_ii = 0 gets the scale that makes its largest coupling with the rows that have a diagonal 1. If
/// no row is coupled with it, that is tried with the rigid modes, each measured by the rows that have a scale;
/// if there is none either, its own movement is as large as the largest of those rows. So the scaled rows do
/// not know in what units the rows were given, but those that are coupled and have no diagonal, which keep 1.
/// \param matrix  M `n x n`
/// \param rigid   R `n x n_r`, or nothing
/// \param free    d, then s `n`
/// \return s `n` > 0
[[nodiscard]] Eigen::VectorXd row_scales(const Eigen::MatrixXd& matrix,
                                         const Eigen::MatrixXd& rigid, const Eigen::VectorXd& free);

}  // namespace signorini
