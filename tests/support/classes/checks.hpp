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

/// A proof that nothing solves a problem: y >= 0 with G y = 0 to rounding and d.y < 0 beyond rounding;
/// without symmetry, M^T y <= 0 is enough.
std::string check_farkas(const signorini::ContactProblem& problem, const Eigen::VectorXd& y);

/// A state that is called feasible: no overlap, no tension, gaps and forces that belong together.
std::string check_feasible(const signorini::Certificate& certificate);

}  // namespace signorini_test
