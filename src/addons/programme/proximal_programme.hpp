// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Dense programmes whose K is only positive semidefinite where the equations hold: proximal points.
#pragma once
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "addons/programme/dense_programme.hpp"

namespace signorini {

/// A method for a strictly convex programme, and what to start from: it fills `start` of the options, or leaves it empty.
using StrictMethod = std::function<DenseSolution(const DenseProgramme&, SolverOptions)>;

/// The least energy of a K that is only positive semidefinite where the equations hold, by proximal points [\ref Rockafellar1976b].
///
/// With a spring on each unknown, at rest at c, the programme is strictly convex: if c satisfies the rows, its solution u has less
/// energy than c, unless c is a solution already. The rows that it closes make a face, and on it the springs are taken away: refine()
/// goes on with the residuals of K alone, each sweep a proximal point of the face. Where that settles and no sign is wrong, it is a
/// solution. Otherwise c moves from u towards the least energy of the face, or along the last change where there is none, as long
/// as energy falls and no other row closes. So each round closes another row, or begins at the least energy of a face that it leaves for ever: there are
/// finitely many.
///
/// All is done in units in which no row and no column of [K A^T; A 0] has an entry beyond about 1, powers of two that round
/// nothing. There the springs have the stiffness \f$ \sqrt\epsilon \f$, so that K and springs share the digits of a double evenly.
/// \param programme  K positive semidefinite where A_e u = 0, p, A, g
/// \param method     solves it with springs
/// \return u, forces, gaps and status; of several solutions one
/// \throws NotDefinite if K has a negative eigenvalue, or if the energy falls for ever: then the message names the unknown that moves most
/// \throws ProblemError if the equations contradict each other, and as the method
[[nodiscard]] DenseSolution proximal_solution(const DenseProgramme& programme,
                                              const StrictMethod& method);

}  // namespace signorini
