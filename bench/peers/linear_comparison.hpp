/// \file
/// Contact by our library against plain solves, and compliances, by the factors of others.
#pragma once
#include <filesystem>

namespace signorini::bench {

/// The cylinder on a plate, on the meshes that the programs are given. Prints one table and writes it as linear.md.
/// \param full  up to 170 000 unknowns, otherwise a test
/// \param out   folder for the table
/// \return whether all is certified, and every answer of the others is one
[[nodiscard]] bool compare_linear(bool full, const std::filesystem::path& out);

}  // namespace signorini::bench
