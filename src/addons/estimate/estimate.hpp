/// \file
/// The error of discretisation: an estimate of the error of named goals, from one solution.
#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "addons/estimate/goal.hpp"
#include "signorini/core/ledger.hpp"

namespace signorini {

/// What the error of a goal is made of; parts have the sign of what is still missing, true value minus value.
struct ErrorParts {
  double interior =
      0;  ///< stresses inside the bodies, by recovery: error_products() with the dual solution
  /// What gaps between the nodes are besides the straight line: \f$ \langle\mu, g - I g\rangle \f$
  double gap = 0;
  /// What the goal itself overlooks between the nodes: \f$ \langle p, w - I w\rangle \f$, or the flattened top of a fit
  double quadrature_error = 0;
  double free_boundary = 0;  ///< that contact must end at a node
  double outline = 0;        ///< what sides cut off curved outlines, or add: outline_shares()

  /// \return their sum
  [[nodiscard]] double sum() const {
    return interior + gap + quadrature_error + free_boundary + outline;
  }
  /// \return the sum of their sizes
  [[nodiscard]] double sizes() const;
  /// \return the root of the sum of their squares
  [[nodiscard]] double norm() const;
};

/// What one side of a cell adds to an error.
struct SideShare {
  CellSide side;  ///< of a cell of one body
  double amount;  ///< with its sign [goal]
};

/// The error of one goal.
struct Estimate {
  std::string goal;  ///< its name
  double value = 0;  ///< of the goal, as solved
  ErrorParts parts;  ///< of the error of discretisation
  /// Estimate of the true value minus the value: the sum of the parts. Of a peak or a width, whose parts cancel by luck as
  /// often as not, the root of the sum of their squares, and no sign.
  double error = 0;
  bool is_signed = true;  ///< whether `error` has a sign
  /// What residuals of the equations can change the value by at most, to first order: the algebraic error
  double algebraic = 0;
  /// What each cell of each body adds to `parts.interior`: where to refine
  std::vector<Eigen::VectorXd> share;
  /// How much of that is for want of cells along the sides 0 and 2 of the cell, see anisotropic_indicator() [-]
  std::vector<Eigen::VectorXd> first_direction;
  /// What each side that a curved outline leaves adds to `parts.outline`, body by body
  std::vector<std::vector<SideShare>> of_sides;
};

/// Estimates the errors of goals, with the factor and the compliance in hand: nothing is factored but the dense system of
/// the closed pairs, and every goal costs at most two back substitutions and a look at every cell.
///
/// A dual solution [\ref BeckerRannacher2001] says what each residual counts for the goal; the residual is that of
/// recovered stresses. With \f$ \Delta\sigma = \sigma^* - \sigma \f$ and the closed pairs as they are,
///
/// \f[ J - J_h \approx \sum_K E_K + \langle\mu, g - I g\rangle + \langle p_h, w - I w\rangle + V + \Omega, \f]
///
/// where E_K is that of error_products(), without the differences of stresses around the ends of contact, and V is about the
/// *free boundary*: J does not change to first order when the end of the contact moves, so with the end one pair further
/// out, and one further in, a cubic says what it would be where the end belongs: free_boundary(). V is left out, and nothing
/// of E_K, where pairs slide against friction. \f$ \Omega \f$ is what the outline leaves its sides for: outline_shares(), also
/// without what friction does there.
///
/// *What is promised*, on meshes that resolve the contact (ten closed pairs or more): forces of contact and displacements
/// within a factor of about two, also where pairs stick or slide; half-widths and peaks of q4 the same, without a sign.
/// *What is not*: no estimate is a bound. On coarser meshes they are mostly too large, up to ten times. Half-widths of
/// q4_incompatible and q4_bbar are overestimated, mostly by less than two and up to five times where little is left: contact
/// that ends at a node acts as if it ended about a fifth of a pair further out, which neither recovery nor V sees. So are
/// peaks of elements other than q4, and errors of q8 and t6 on curved obstacles, of which V is the most. Errors of the energy norm, and of stresses and pressures at a point, such as at
/// corners, are not goals, because recovery knows nothing of singularities between its nodes; how far the domain and the
/// model are from the truth cannot be seen in one mesh. `make effectivity` measures all this and lists what fails.
/// \param model      from build()
/// \param condensed  from condense() of it
/// \param solution   of both, solved
/// \param goals      any
/// \param ledger     gets the phase `estimate`
/// \return one per goal
/// \throws ProblemError as value(); if the problem is not solved or has load steps, a pair is a Gauss point with a force of
///   its own, or contact forces are not unique
[[nodiscard]] std::vector<Estimate> estimates(const Model& model, const Condensed& condensed,
                                              const Solution& solution,
                                              const std::vector<Goal>& goals, Ledger& ledger);

/// The same for one goal. \param model  from build() \param condensed  from condense() of it
/// \param solution  of both, solved \param goal  any \param ledger  gets the phase `estimate` \return its estimate
/// \throws ProblemError as estimates()
[[nodiscard]] Estimate estimate(const Model& model, const Condensed& condensed,
                                const Solution& solution, const Goal& goal, Ledger& ledger);

/// One line of an error budget.
struct BudgetLine {
  std::string source;            ///< of the error, such as "element"
  std::optional<double> amount;  ///< in the unit of the goal; none: not estimated
  std::string meaning;           ///< what it is, or what would make it smaller
};

/// The same goal, where something other than the mesh was changed.
struct ComparedWith {
  std::optional<double> domain = {};  ///< its value on a larger domain, at the same fineness
  std::optional<double> model = {};   ///< its value by a better model, at the same fineness
};

/// Keeps apart what an answer may be wrong by.
/// \param estimate  of the goal
/// \param compared  values of other scenes, if there are any
/// \return lines: algebraic, gap, element, outline, domain, model
[[nodiscard]] std::vector<BudgetLine> error_budget(const Estimate& estimate,
                                                   const ComparedWith& compared = {});

}  // namespace signorini
