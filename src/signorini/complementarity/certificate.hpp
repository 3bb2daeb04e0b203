/// \file
/// The certificate of a solution: five figures recomputed from the original data, whoever solved it.
#pragma once
#include <Eigen/Core>
#include <iosfwd>

#include "signorini/complementarity/problem.hpp"

namespace signorini {

/// How far a claimed solution is from satisfying each condition, made free of units; 0 is perfect.
///
/// Lengths are divided by the largest |g_i| + |a_i||u| and forces by the largest load or contact force
/// (rows of A scaled to norm 1), so that no figure changes with units or with the scaling of a row.
struct Certificate {
  double penetration = 0;      ///< largest overlap / length
  double tension = 0;          ///< largest tensile contact force / force
  double complementarity = 0;  ///< largest |force * gap| / (length * force)
  double equilibrium = 0;      ///< largest entry of p - K u - A^T lambda / force
  double duality_gap = 0;      ///< |primal - dual energy| / sum of the magnitudes of their terms

  /// The worst of the five.
  [[nodiscard]] double worst() const;
  /// Whether all five are at most `tolerance`.
  [[nodiscard]] bool holds(double tolerance = 1e-12) const { return worst() <= tolerance; }
};

/// A claimed solution of a quadratic programme; u is kept as the unevaluated sum of two vectors.
struct PrimalDual {
  Eigen::VectorXd displacement;      ///< u `n` [length], rounded to double
  Eigen::VectorXd displacement_low;  ///< what rounding took away, `n`; empty means zero
  Eigen::VectorXd force;             ///< lambda `n_c` [force]
};

/// Certificate of (u, lambda) against K, p, A, g. \PaperEq{XuanLi2002, 6}, \PaperEq{XuanLi2002, 21}
///
/// Residuals are summed in twice the working precision. The equilibrium is measured against the loads and
/// not against |K||u|, which is far larger in a slender body: with u in plain doubles it cannot be
/// better than about 1e-16 |K||u| / |p|, whatever the solver; `displacement_low` removes this floor.
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] Certificate certify(const QuadraticProgramme& programme, const PrimalDual& solution);

/// Certificate of (lambda, gap) against G and d; `equilibrium` then is the largest
/// |gap - d - G lambda|, as a length.
/// \throws std::invalid_argument if sizes do not fit
[[nodiscard]] Certificate certify(const ContactProblem& problem, const ContactState& state);

/// p - K u - A^T lambda `n` [force], summed in twice the working precision.
[[nodiscard]] Eigen::VectorXd equilibrium_residual(const QuadraticProgramme& programme,
                                                   const PrimalDual& solution);

/// g - A u `n_c` [length], summed in twice the working precision.
[[nodiscard]] Eigen::VectorXd gaps(const QuadraticProgramme& programme, const PrimalDual& solution);

/// Prints the five figures on one line.
std::ostream& operator<<(std::ostream& out, const Certificate& certificate);

}  // namespace signorini
