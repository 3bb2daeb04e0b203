// Bodies that supports leave free to move: a rigid bar, and programmes with a known answer.
#pragma once
#include "addons/programme/floating_programme.hpp"
#include "support/random.hpp"

namespace signorini_test {

/// A rigid bar over springs: its point x moves up by a_1 + a_2 x, spring i at x_i has compliance c_i, and
/// the weight w acts at x_w. gap_i = d_i + c_i lambda_i + a_1 + a_2 x_i, sum lambda = w, sum x lambda = x_w w.
signorini::ContactProblem bar(const Eigen::VectorXd& x, const Eigen::VectorXd& compliance,
                              const Eigen::VectorXd& gap, double w, double at);

/// A body with rigid modes and a solution that is known: K = Z B Z^T with Z orthogonal to N.
struct KnownFloating {
  signorini::DenseProgramme programme;
  Eigen::MatrixXd null_vectors;
  Eigen::VectorXd displacement;
  Eigen::VectorXd force;
};

/// A random one.
/// \param softest  smallest stiffness of the body itself; the others are about 1
/// \param far      how far it moves
KnownFloating known_floating(Random& random, double softest, double far);

}  // namespace signorini_test
