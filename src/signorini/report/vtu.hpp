/// \file
/// The solved field as a VTU file, for ParaView and other viewers.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "signorini/scene/scene.hpp"

namespace signorini {

/// Writes mesh, displacements, stresses and contact quantities of a solution, one piece per body,
/// with 9 digits.
///
/// Point data: `displacement` [length], `stress` (xx, yy, xy, zz: across the plane, in axial symmetry the hoop
/// stress) and `von_mises` [force/length^2, tension positive], `contact_pressure` [force/length^2, compression
/// positive, 0 where there is no pair], `contact_gap` [length, 0 where there is no pair], `contact_status` (1 closed,
/// 0 open, -1 no pair). Cell data: `cell_stress`. Field data: `notes` of the solution, if it has any.
/// \param file      to be written, in a folder that exists
/// \param model     that was solved
/// \param solution  of it
/// \throws std::invalid_argument if the problem is not solved
/// \throws ProblemError if the file cannot be written
void write_vtu(const std::filesystem::path& file, const Model& model, const Solution& solution);

/// A file of the fields at one time.
struct TimedFile {
  double time = 0;   ///< of the load step [time]
  std::string file;  ///< its name, in the folder of the collection
};

/// Writes which files belong to which times: a PVD collection, which ParaView opens as one animation.
/// \param file   to be written, in a folder that exists
/// \param files  in the order of their times
/// \throws ProblemError if the file cannot be written
void write_pvd(const std::filesystem::path& file, const std::vector<TimedFile>& files);

/// \param content  of a file that write_pvd() wrote \return its files; none of another content
[[nodiscard]] std::vector<TimedFile> read_pvd(const std::string& content);

}  // namespace signorini
