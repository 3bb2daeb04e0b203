// Pictures of a solved scene, drawn by gnuplot.
#pragma once
#include <filesystem>
#include <string>

namespace command_line {

struct SceneRun;

/// What gnuplot can be asked for.
enum class PictureKind { Svg, Png };

/// \param file  that will hold a picture
/// \return the kind that its name ends with
/// \throws signorini::ProblemError unless that is .svg or .png
PictureKind picture_kind(const std::string& file);

/// Draws the deformed meshes, coloured by von Mises' stress, and below them each contact: the pressure along its source,
/// and with friction the shear traction between its bounds.
/// \param file  to be written
/// \param kind  of it
/// \param run   that is solved
/// \throws signorini::ProblemError if there is no gnuplot, or it says anything or draws nothing
void draw(const std::filesystem::path& file, PictureKind kind, const SceneRun& run);

}  // namespace command_line
