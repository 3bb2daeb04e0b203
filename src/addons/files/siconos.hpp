// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Problems as Siconos writes them: complementarity problems and plane friction problems.
#pragma once
#include <string_view>
#include <vector>

#include "addons/files/problem_file.hpp"
#include "addons/text/text_reader.hpp"

namespace signorini {

/// Reads one problem of Siconos, see parse_problem().
/// \param in     stands behind the first word
/// \param first  that word
/// \return the problem; those of friction have the law of all pairs
/// \throws ProblemError `NAME:LINE: expected ..., got ...` if the text is anything else
[[nodiscard]] std::vector<FiledProblem> read_siconos(TextReader& in, std::string_view first);

/// Most rows of a matrix that leaves zeros out: it is solved as a dense one, of 800 MB.
constexpr Eigen::Index largest_sparse_matrix = 10000;

}  // namespace signorini
