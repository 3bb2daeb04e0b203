// Contact problems for the tests of the solvers.
#pragma once
#include "signorini/problem/problem.hpp"
#include "support/random.hpp"

namespace signorini_test {

/// G = M M^T + 0.05 I with a random M, and a random d of both signs: positive definite, correlated pairs.
signorini::ContactProblem random_problem(Random& random, Eigen::Index n);

/// The same problem with gap i measured in units of 1 / row(i), as if row i of A were multiplied by it.
signorini::ContactProblem with_rows(const signorini::ContactProblem& problem,
                                    const Eigen::VectorXd& row);

/// The same problem with lengths and forces in units that are smaller by these factors.
signorini::ContactProblem in_units(const signorini::ContactProblem& problem, double length,
                                   double force);

/// Three pairs that run in circles when every wrong pair changes sides at once; force (0, 0.4, 0).
signorini::ContactProblem cycling_problem();

/// A stretched string over a rigid wave: G_ij = min(x_i, x_j) (1 - max(x_i, x_j)), no positive entry in
/// its inverse off the diagonal.
signorini::ContactProblem string_problem(Eigen::Index n);

}  // namespace signorini_test
