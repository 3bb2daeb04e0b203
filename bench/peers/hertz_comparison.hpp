/// \file
/// The cylinder on a plate by all programs, on the same meshes and in one run.
#pragma once
#include <filesystem>
#include <vector>

#include "bench/peers/hertz_programs.hpp"

namespace signorini::bench {

/// Meshes that are compared.
struct HertzSize {
  Eigen::Index part;  ///< cells of the example's mesh are cut into so many along each side
  int rounds;         ///< in which every program has its turn
};

/// Runs every program on every mesh, prints one table, and writes it as hertz.md and, for a figure, hertz.csv. Seconds
/// and memory are those of the whole program, from its start to its end; q0 and b are read from the forces it wrote as
/// chapter 11 reads them; a program that fails has a row that says so.
/// \param programs  ours is the first; those that are missing are named
/// \param sizes     rising
/// \param out       folder for the tables
/// \return whether our program solved all of them, and on the first wrote the forces that the library finds here
[[nodiscard]] bool compare_hertz(const std::vector<Program>& programs,
                                 const std::vector<HertzSize>& sizes,
                                 const std::filesystem::path& out);

}  // namespace signorini::bench
