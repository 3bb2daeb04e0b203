/// \file
/// A claimed solution of a programme, and what it leaves of the programme's equations.
#pragma once
#include <Eigen/Core>

#include "signorini/problem/problem.hpp"

namespace signorini {

/// A claimed solution of a quadratic programme; u is kept as the unevaluated sum of two vectors.
struct PrimalDual {
  Eigen::VectorXd displacement;      ///< u `n` [length], rounded to double
  Eigen::VectorXd displacement_low;  ///< what rounding took away, `n` [length]; empty means zero
  Eigen::VectorXd force;             ///< lambda `n_c` [force], compression > 0
  /// The part of u that moves whole bodies `n` [length], empty if there is none. That it strains nothing
  /// is known beforehand and not computed: K times a motion is rounding, which in a stiff body may exceed
  /// the loads of all others. So equilibrium is that of u without it.
  Eigen::VectorXd rigid = {};
  /// What rounding took away of the forces that u belongs to, `n_c` [force]; empty means zero. Load steps extrapolate with it, and
  /// certificates do not look at it.
  Eigen::VectorXd force_low = {};
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

/// Checks a claim. \param programme  K, p, A, g \param solution  u and lambda
/// \throws std::invalid_argument if sizes do not fit
void check_sizes(const QuadraticProgramme& programme, const PrimalDual& solution);

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

}  // namespace signorini
