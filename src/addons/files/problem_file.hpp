/// \file
/// Problems in files: linear complementarity, friction, and quadratic programmes.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "addons/files/two_sided.hpp"
#include "signorini/problem/problem.hpp"

namespace signorini {

/// A linear complementarity problem of a file: \f$ z \ge 0,\ w = M z + q \ge 0,\ z^T w = 0 \f$; or a problem of
/// pairs that all have friction.
struct FiledProblem {
  std::size_t line = 0;  ///< where it begins, from 1
  /// M as the compliance of any kind, q as the free gap `n`; with friction W and q, gaps first, and mu
  ContactProblem problem;
  Eigen::VectorXd known_force;  ///< the z that the file gives `n`, or empty
  Eigen::VectorXd known_gap;    ///< the w that the file gives `n`, or empty
  /// \return whether pairs have friction
  [[nodiscard]] bool has_friction() const { return !problem.law.pair.empty(); }
};

/// What a file holds: one or more complementarity problems, one friction problem, or one quadratic programme.
using ProblemFile = std::variant<std::vector<FiledProblem>, TwoSidedProgramme>;

/// Reads problems. The format is recognised from the first words that are no comment.
///
/// A number first: Siconos [\ref AcaryEtAl2019] writes n, a matrix, and q. What follows is a remark. A matrix is
/// its storage, two sizes, and entries: all of them COLUMN by column (0), in blocks (1), or as CSparse prints
/// them, rounded to six digits (2).
///
/// 2, then a number that is not 0: a plane friction problem of Siconos is the dimension, the number of pairs, the
/// matrix W, q and mu, with u = W r + q, normal and tangential rows in turns. Our signs are the same. A linear
/// complementarity problem with two unknowns therefore needs storage 0.
///
/// `n` first, then `M`: blocks `n`, `M`, `q`, and if it is known the solution `z` and `w`, for any
/// number of problems.
///
/// `n` first, then `m`: blocks `n`, `m`, `r`, `P`, `q`, `A`, `l`, `u` of a TwoSidedProgramme, where
/// bounds of 1e20 and more in magnitude are no bounds.
///
/// In the two formats whose first word is `n` a row stands on one line, and `#` begins a comment.
/// \param content  the text of the file
/// \param name     of the file, for messages
/// \return the problems; all numbers are finite, all sizes fit
/// \throws ProblemError `NAME:LINE: expected ..., got ...` if the text is anything else
[[nodiscard]] ProblemFile parse_problem(std::string_view content, const std::string& name);

/// Reads problems from a file.
/// \param file  of at most `largest_problem_file` bytes
/// \return as parse_problem()
/// \throws ProblemError as parse_problem(), or if there is no such file or it is none
[[nodiscard]] ProblemFile read_problem(const std::filesystem::path& file);

/// Most bytes of a file that is read: far more than the solvers can be asked.
constexpr std::size_t largest_problem_file = std::size_t{1} << 28;

}  // namespace signorini
