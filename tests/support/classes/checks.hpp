// The parts of complaint(): each returns what is wrong in words, or nothing.
#pragma once
#include <string>

#include "signorini/problem/certificate.hpp"
#include "support/problem_classes.hpp"

namespace signorini_test {

/// What every certificate must keep.
inline constexpr double certificate_tolerance = 1e-12;

/// The largest error against what is known, relative to the largest known entry, or to `otherwise` if
/// all are zero. Nothing is known if `known` is empty.
std::string differs(const char* what, const Eigen::VectorXd& got, const Eigen::VectorXd& known,
                    double otherwise, double accuracy);

/// A state that is called solved: sizes, signs, order of the closed pairs, certificate, known answer.
std::string check_solved(const Instance& instance, const signorini::ContactState& state);

/// A proof that nothing solves a problem: y >= 0 with G y = 0 and R^T y = 0 to rounding, d.y < 0 beyond;
/// without symmetry, M^T y <= 0 is enough.
std::string check_farkas(const signorini::ContactProblem& problem, const Eigen::VectorXd& y);

/// A proof that no forces balance the load: an amplitude a whose motion opens each gap by at least mu times its
/// slip, while the load works more than cohesion can take up, \f$ -r^T a > \sum c_i |slip_i| \f$.
std::string check_unbounded_direction(const signorini::ContactProblem& problem,
                                      const Eigen::VectorXd& amplitude);

/// A state that is called feasible: no overlap, no tension, gaps and forces that belong together.
std::string check_feasible(const signorini::Certificate& certificate);

}  // namespace signorini_test
