/// \file
/// Programs that solve the cylinder on a plate from files: CalculiX, GetFEM and ours.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "bench/peers/hertz_files.hpp"

namespace signorini::bench {

/// What a program found at the nodes of the rim.
struct RimForces {
  std::vector<double> x;        ///< in rising order [mm]
  std::vector<double> force;    ///< on the half that is modelled [N/mm], compression > 0
  Eigen::Index iterations = 0;  ///< as the program counts them
};

/// A program, and its way from files to files.
struct Program {
  std::string name;     ///< in tables
  std::string key;      ///< in names of files and of columns of a figure
  std::string missing;  ///< what to install, or empty if it is there
  /// Writes the files that only this program reads; hertz.msh is there.
  std::function<void(const HertzCase& now)> prepare;
  /// \return its name and arguments
  std::function<std::vector<std::string>(const HertzCase& now)> command;
  /// \return what it wrote; throws ProblemError if that is no solution
  std::function<RimForces(const HertzCase& now)> read;
};

/// The nodes of the rim of the disc.
struct Rim {
  Eigen::MatrixX2d place;  ///< in the order of rising x [mm]
  Eigen::VectorXd weight;  ///< of each, half of the edges beside it [mm]
};

/// \param now  any \return its rim
[[nodiscard]] Rim rim_of(const HertzCase& now);

/// \param own     our program
/// \param script  getfem_hertz.py
/// \return ours, GetFEM, and CalculiX with both of its couplings
[[nodiscard]] std::vector<Program> hertz_programs(const std::string& own,
                                                  const std::string& script);

}  // namespace signorini::bench
