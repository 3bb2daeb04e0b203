// Pictures of a solved scene, drawn by gnuplot.
#pragma once
#include <filesystem>

#include "command_line/gnuplot.hpp"

namespace command_line {

struct SceneRun;

/// Draws the deformed meshes, coloured by von Mises' stress, and below them each contact: the pressure along its source,
/// and with friction the shear traction between its bounds.
/// \param file  to be written
/// \param kind  of it
/// \param run   that is solved
/// \throws signorini::ProblemError if there is no gnuplot, or it says anything or draws nothing
void draw(const std::filesystem::path& file, PictureKind kind, const SceneRun& run);

}  // namespace command_line
