// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The rows of a dense programme as a basis of closed rows needs them: condensed one by one, on demand.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "signorini/core/dense.hpp"
#include "signorini/core/rounding.hpp"
#include "signorini/problem/active_set_factor.hpp"
#include "signorini/problem/certificate.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini {

/// Checks a programme. \param programme  K, p, A, g
/// \throws std::invalid_argument if sizes do not fit or a number is not finite
void check_sizes(const DenseProgramme& programme);

/// A dense programme, the factor of its K, and gaps relative to a solution that is known already.
///
/// With equations the factor is that of \f$ K + \rho A_e^T A_e \f$, which has the same solution where
/// A_e u = g_e and is positive definite where K is so only there.
class ProgrammeRows {
 public:
  /// Factors K and finds the gaps without contact. \PaperEq{XuanLi2002, 20}
  /// \param programme  K, p, A, g; must outlive this
  /// \throws std::invalid_argument if sizes do not fit or a number is not finite
  /// \throws NotDefinite if K is not positive definite to rounding where A_e u = 0
  explicit ProgrammeRows(const DenseProgramme& programme) : ProgrammeRows(programme, 0) {}
  /// The same where K is only semidefinite. The factor is that of K and a spring on each unknown, the residuals of refine() are those
  /// of K alone: each of its sweeps is a proximal point.
  /// \param programme  K positive semidefinite, p, A, g; must outlive this
  /// \param spring     stiffness of all springs
  /// \throws std::invalid_argument, NotDefinite as above, of K with the springs
  ProgrammeRows(const DenseProgramme& programme, double spring);

  /// \return number of unknowns n
  [[nodiscard]] Eigen::Index unknowns() const { return programme_.load.size(); }
  /// \return number of rows m
  [[nodiscard]] Eigen::Index count() const { return gap_.size(); }
  /// \return how many of the first rows are equations
  [[nodiscard]] Eigen::Index equations() const { return programme_.equations; }
  /// \return a basis of the equations, and of closed rows after them, but for those that depend on others
  /// \param closed  inequalities
  /// \throws ProblemError if the equations contradict each other
  [[nodiscard]] ActiveSetFactor basis_of(const std::vector<Eigen::Index>& closed);
  /// The same where a solution is known, from which later gaps are measured.
  /// \param closed    inequalities
  /// \param solution  u and lambda `m`
  /// \return the basis, as if its gaps were asked for last
  [[nodiscard]] ActiveSetFactor basis_at(const std::vector<Eigen::Index>& closed,
                                         const PrimalDual& solution);
  /// \return an empty basis for them
  [[nodiscard]] ActiveSetFactor empty_basis() const;
  /// \return about 1 / |h_i| of each row `m`, to compare rows with before they are condensed
  [[nodiscard]] const Eigen::VectorXd& weights() const { return weight_; }
  /// \return the factor of K, or of K and the equations
  [[nodiscard]] const CholeskyFactor& factor() const { return factor_; }
  /// \return |h_i| `m`; 0 for rows that have not been condensed yet
  [[nodiscard]] const Eigen::VectorXd& norms() const { return norm_; }

  /// The present gaps. \PaperEq{XuanLi2002, 22}
  /// \param basis     closed rows
  /// \param gap       set to g - A u `m`
  /// \param rounding  set to what rounding may have done to each
  void gaps(const ActiveSetFactor& basis, Eigen::VectorXd& gap, Eigen::VectorXd& rounding);

  /// \return u `n` of the basis whose gaps were asked for last
  [[nodiscard]] Eigen::VectorXd displacement() const { return displacement_ - moved_; }

  /// Condenses rows.
  /// \param gap         of all rows `m`
  /// \param rounding    of the gaps `m`
  /// \param candidates  whose `rows` say which ones; a row of A without entries has a column of zeros
  void fetch(const Eigen::VectorXd& gap, const Eigen::VectorXd& rounding,
             ActiveSetFactor::Candidates& candidates);

  /// u and lambda of a basis, refined from the original data.
  struct Refined {
    PrimalDual solution;      ///< u in two parts, and lambda `m`
    Eigen::VectorXd gap;      ///< g - A u `m`, 0 in the basis
    Eigen::VectorXd tension;  ///< `size` of the basis, lambda |h_i| where negative beyond rounding
    Eigen::Index violated = 0;    ///< open rows that overlap beyond rounding
    Eigen::Index sweeps = 0;      ///< corrections that were made
    bool settled = true;          ///< whether another one would change nothing
    Eigen::VectorXd change = {};  ///< of u `n` in the last sweep, or empty

    /// \return whether no row is on the wrong side
    [[nodiscard]] bool confirmed() const { return violated == 0 && largest(tension) == 0; }
  };
  /// Refines \f$ K u + A^T \lambda = p,\ A_W u = g_W \f$ with residuals in twice the working precision;
  /// later gaps are measured from the result if anything was corrected. \PaperEq{XuanLi2002, 21}
  ///
  /// Nothing is refined if the residuals are of rounding size already and no row is near enough to
  /// the wrong side for rounding to matter.
  /// \param basis  W, whose gaps were asked for last; its coordinates become those of the refined
  ///   forces
  /// \return the refined solution
  [[nodiscard]] Refined refine(ActiveSetFactor& basis);

  /// Forces of the rows of a basis that do to K^-1/2 A^T what a load does, as far as they can: they complete the balance of a
  /// solution, or a proof that nothing satisfies all rows.
  /// \param basis  rows, such as the equations
  /// \param load   `n`
  /// \return `m` forces of the rows as they were posed, 0 outside of the basis
  [[nodiscard]] Eigen::VectorXd carried(const ActiveSetFactor& basis, Eigen::VectorXd load) const;

 private:
  struct Work;
  ActiveSetFactor::Candidates append(const std::vector<Eigen::Index>& closed,
                                     const Eigen::VectorXd& gap, const Eigen::VectorXd& rounding,
                                     ActiveSetFactor& basis);
  void correct(const ActiveSetFactor& basis, Refined& refined, Work& work);
  [[nodiscard]] double force_size(const Eigen::VectorXd& force) const;
  [[nodiscard]] double one_rounding(Eigen::Index row, double stretch) const;
  [[nodiscard]] bool certain(const ActiveSetFactor& basis, Refined& refined,
                                  const Eigen::VectorXd& force);
  [[nodiscard]] bool presses(const ActiveSetFactor& basis, Refined& refined,
                             const Eigen::VectorXd& force) const;
  [[nodiscard]] bool balances(const ActiveSetFactor& basis, const PrimalDual& solution,
                              double size);
  void check_signs(const ActiveSetFactor& basis, Refined& refined, const Work& work);

  const DenseProgramme& programme_;
  Eigen::VectorXd rho_;  // what each equation adds to K
  CholeskyFactor factor_;
  Eigen::VectorXd displacement_;  // from which gap_ comes
  Eigen::VectorXd gap_;           // where Q y = base_
  Eigen::VectorXd base_;          // empty for zero
  Eigen::VectorXd floor_;         // rounding of gap_
  Eigen::VectorXd weight_;
  Eigen::VectorXd norm_;
  Eigen::VectorXd moved_;  // what contact takes from displacement_; work space of refine()
  Eigen::VectorXd root_;   // of the diagonal of K
  double spring_ = 0;
  double stretch_ = 0;  // |D^1/2 u|, or what forces make of the stiffest unknown
};

}  // namespace signorini
