/// \file
/// Problems in files: linear complementarity and quadratic programmes, in three formats.
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "signorini/problem/problem.hpp"
#include "signorini/problem_file/two_sided.hpp"

namespace signorini {

/// A linear complementarity problem of a file: \f$ z \ge 0,\ w = M z + q \ge 0,\ z^T w = 0 \f$.
struct FiledProblem {
  std::size_t line = 0;         ///< where it begins, from 1
  ContactProblem problem;       ///< M as the compliance `n x n` of any kind, q as the free gap `n`
  Eigen::VectorXd known_force;  ///< the z that the file gives `n`, or empty
  Eigen::VectorXd known_gap;    ///< the w that the file gives `n`, or empty
};

/// What a file holds: one or more complementarity problems, or one quadratic programme.
using ProblemFile = std::variant<std::vector<FiledProblem>, TwoSidedProgramme>;

/// Reads problems. The format is recognised from the first words that are no comment.
///
/// A number first: Siconos [\ref AcaryEtAl2019] writes n, the storage 0 of a dense matrix, its two
/// sizes, both once more on one line, the matrix COLUMN by column, and q. What follows is a remark.
///
/// `n` first, then `M`: blocks `n`, `M`, `q`, and if it is known the solution `z` and `w`, for any
/// number of problems.
///
/// `n` first, then `m`: blocks `n`, `m`, `r`, `P`, `q`, `A`, `l`, `u` of a TwoSidedProgramme, where
/// bounds of 1e20 and more in magnitude are no bounds.
///
/// In the last two formats a row stands on one line, and `#` begins a comment.
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
