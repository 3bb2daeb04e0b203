/// \file
/// The solved field as a VTU file, for ParaView and other viewers.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "signorini/scene/readings.hpp"

namespace signorini {

/// How numbers stand in a VTU file.
enum class VtuNumbers {
  Binary,  ///< as the machine has them, behind the text of the file: small, and read at once
  Ascii  ///< as text, with the digits that give back their bits: for people, and for programs that read text
};

/// Writes mesh, displacements, stresses and contact quantities of a solution, all bodies in one piece, every number to its last bit.
///
/// Point data: `displacement` [length], `stress` (xx, yy, xy, zz: across the plane, in axial symmetry the hoop
/// stress) and `von_mises` [force/length^2, tension positive]; at the nodes of the sources, and 0 everywhere else,
/// `contact_pressure` [force/length^2, compression positive], `contact_gap` [length] and the vector `contact_traction`
/// on the source [force/length^2], friction included; `contact_status` (1 closed, 0 open, -1 no pair). Cell data:
/// `cell_stress`, and with several bodies `body`, from 0, whose names are those of arrays of the field data, as `body 0: lower`.
/// Notes of the solution are comments in front.
///
/// With friction also, as in pair_columns(): `contact_shear_traction` [force/length^2], `contact_slip` and, with totals,
/// `contact_slip_total` [length], all 0 where no pair has friction, and `contact_motion` (0 open, 1 stick, 2 forward, 3 backward,
/// -1 no frictional pair). With several contacts: `contact_number`, from 0, -1 without a pair, and field data
/// named as `contact 0: block.left on floor`. A node with pairs of several contacts shows that with the largest force. Pairs at
/// Gauss points belong to no node and are not shown; a table has them, see pressure_csv().
/// \param file      to be written, in a folder that exists
/// \param model     that was solved
/// \param solution  of it
/// \param totals    after this step of a path, see totals(); nothing: the solution is no step
/// \param numbers   how they are written
/// \throws std::invalid_argument if the problem is not solved, or the totals are of another number of slips
/// \throws ProblemError if the file cannot be written
void write_vtu(const std::filesystem::path& file, const Model& model, const Solution& solution,
               const std::optional<PathTotals>& totals = {},
               VtuNumbers numbers = VtuNumbers::Binary);

}  // namespace signorini
