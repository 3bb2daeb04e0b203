// Pictures drawn by gnuplot, in the style of the figures of the chapters.
#pragma once
#include <filesystem>
#include <string>

#include "command_line/quoting.hpp"

namespace command_line {

/// What gnuplot can be asked for, in the order of signorini::picture_endings.
enum class PictureKind { Svg, Png, Pdf };

/// \param file  that will hold a picture
/// \return the kind that its name ends with
/// \throws signorini::ProblemError unless that is .svg, .png or .pdf
PictureKind picture_kind(const std::string& file);

/// \param from  where the range of an axis begins \param to  where it ends, not below
/// \return the range for gnuplot, which refuses one without a length
std::string range(double from, double to);

/// \param wanted  a positive number \return 1, 2 or 5 times a power of ten, not above it
double round_down(double wanted);

/// The first lines of a script: style, kind and size of the picture, which is 96 pixels to an inch if it has no pixels.
/// \param file    to be drawn
/// \param kind    of it
/// \param width   [pixels]
/// \param height  [pixels]
/// \return lines for gnuplot; `set output` ends the picture
std::string picture_head(const std::filesystem::path& file, PictureKind kind, double width,
                         double height);

/// Runs gnuplot.
/// \param file    that the script draws
/// \param script  for gnuplot
/// \throws signorini::ProblemError if there is no gnuplot, or it says anything or draws nothing
void run_gnuplot(const std::filesystem::path& file, const std::string& script);

}  // namespace command_line
