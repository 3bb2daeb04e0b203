/// \file
/// The solved field as a VTU file, for ParaView and other viewers.
#pragma once
#include <filesystem>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Writes mesh, displacements, stresses and contact quantities of a solution.
///
/// Point data: `displacement` [length], `stress` (xx, yy, xy) and `von_mises` [force/length^2, tension
/// positive], `contact_pressure` [force/length^2, compression positive], `contact_gap` [length, NaN off the
/// contact boundary]. Cell data: `cell_stress`.
/// \throws ProblemError if the file cannot be written, std::invalid_argument if the problem is not solved
void write_vtu(const std::filesystem::path& file, const Model& model, const Solution& solution);

}  // namespace signorini
