/// \file
/// Exercise 10.2 - segments. Do not change this file.
#pragma once
#include <Eigen/Core>

namespace ex10_2 {

/// How the nodes of a target below a straight source count in the weighted gaps of the source.
///
/// Row i holds the integrals of psi_i N_j over the integral of psi_i, exactly. psi_i is the dual function of
/// node i of the source: on an edge whose coordinate s runs from -1 to 1, (1 - 3 s)/2 belongs to the first end
/// and (1 + 3 s)/2 to the second one. N_j is the linear shape function of node j of the target. So the weighted
/// gap of node i opens by u_i - sum_j P_ij u_j if nodes of source and target move up by u.
/// \param source  nodes along the interface, increasing [length], two or more
/// \param target  nodes along it, increasing, with the same first and last one [length]
/// \return P, `source.size() x target.size()` [-]
[[nodiscard]] Eigen::MatrixXd projection(const Eigen::VectorXd& source,
                                         const Eigen::VectorXd& target);

}  // namespace ex10_2
