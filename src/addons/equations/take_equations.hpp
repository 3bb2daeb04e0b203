// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Equations between displacements, eliminated from the problem of a scene and from those of bodies that have moved.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "addons/equations/equations.hpp"

namespace signorini {

struct Displaced;

/// All unknowns by those that are not eliminated.
/// \param solved    equations \param unknowns  `n` \return T `n x n` [-], 1 but for the rows of eliminated unknowns
[[nodiscard]] Eigen::SparseMatrix<double> by_free_unknowns(const Eliminated& solved, Eigen::Index unknowns);

/// Rows of unknowns in which equations are put, without the entries that are rounding of what cancels.
/// \param rows  A `m x n` \param by_free  T `n x n`, see by_free_unknowns() \return A T
[[nodiscard]] NodalRows on_free_unknowns(const NodalRows& rows, const Eigen::SparseMatrix<double>& by_free);

/// Refuses springs in whose entries of K those of the bodies are lost. \param model  with the K of the bodies alone
/// \throws ProblemError that names the first one
void check_springs(Model& model);

/// Eliminates the equations from K, p, A and g: every u that minimises the new energy fulfils them.
///
/// With \f$ u_e = R u + s \f$ the energy of all others is that of \f$ T u + s \f$, T being 1 but for the rows R, and
/// a spring on \f$ u_e - R u - s \f$ makes the eliminated unknowns what the equations say: at the minimum it is at rest.
/// \param model  whose effects have all added what they have
void take_equations(Model& model);

/// What equations lack where bodies stand, if supports are at their ends.
/// \param at  where bodies stand \param model  whose `held` counts for what supports hold \return h - C u `m` [length]
[[nodiscard]] Eigen::VectorXd lacking_at(const Displaced& at, const Model& model);

/// The same for rows that were found where bodies have moved to, whose gaps and slips count from there: the way that is left
/// takes the equations to where they hold.
/// \param at  where bodies stand \param[in,out] model  gets new A and g
void take_equations_of_rows(const Displaced& at, Model& model);

/// The same for forces where bodies have moved to.
/// \param at       where bodies stand
/// \param tangent  whether K is that of the place, without equations; else it stays what it is
/// \param[in,out] model  with p less internal forces; gets new p, the terms that are summed there, and a new tangent
void take_equations_of_forces(const Displaced& at, bool tangent, Model& model);

/// \param model  as built \return K of its bodies without equations
[[nodiscard]] const Eigen::SparseMatrix<double>& stiffness_of_bodies(const Model& model);

}  // namespace signorini
