// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// The equations that saddle_point_newton() solves, in one unit: what they are at a point, and how they change.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "papers/saddle_point_newton.hpp"

namespace signorini {
/// The equations of saddle_point_newton().
namespace saddle_point {

/// What rows and unknowns are multiplied by to have one unit.
struct Units {
  Eigen::VectorXd row;    ///< of equilibrium; u / row has the unit of energy^1/2
  Eigen::VectorXd force;  ///< of lambda; gaps are divided by it
};

/// \param programme  K, p, A, g \param form  AsPrinted: all units are 1
/// \return the units of its rows and forces
[[nodiscard]] Units units_of(const QuadraticProgramme& programme, SaddlePointForm form);

/// An iterate, and F there: rows and arguments in one unit.
struct Point {
  PrimalDual solution;       ///< u and lambda
  Eigen::VectorXd gap;       ///< g - A u `n_c` [length]
  Eigen::VectorXd residual;  ///< F `n + n_c`
  double size = 0;           ///< |F|
};

/// Evaluates F. \param programme  K, p, A, g \param units  of it
/// \param[in,out] point  its solution is given
void evaluate(const QuadraticProgramme& programme, const Units& units, Point& point);

/// Evaluates J in the same units. \PaperEq{LinEtAl, 31}
/// \param programme  K, p, A, g \param units  of it \param point  as evaluate() left it
/// \return J `n + n_c` square
[[nodiscard]] Eigen::SparseMatrix<double> jacobian(const QuadraticProgramme& programme,
                                                   const Units& units, const Point& point);

/// Goes a part of a step. \param programme  K, p, A, g \param units  of it
/// \param from  any \param step  `n + n_c` in the units \param length  the part
/// \return the point there, evaluated
[[nodiscard]] Point moved(const QuadraticProgramme& programme, const Units& units,
                          const Point& from, const Eigen::VectorXd& step, double length);

}  // namespace saddle_point
}  // namespace signorini
