// This header is internal: chapters do not include it, and it is not installed.
/// \file
/// Indices of matrices as places in standard containers.
#pragma once
#include <Eigen/Core>
#include <cstddef>

namespace signorini {

/// \param index  of a row or column, not negative
/// \return the same as a place in a std::vector
inline std::size_t at(Eigen::Index index) { return static_cast<std::size_t>(index); }

}  // namespace signorini
